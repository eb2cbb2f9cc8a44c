// Internal: how many of the disjoint workers are busy.
//
// What one worker holds no other one has. Where all of them have room for more than all items, some
// of the workers take items from the others, and fewer workers may be ready sooner.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace changeover {

/// Workers that are busy, and the room that each of them uses.
struct Crew {
  std::uint64_t workers = 0;
  std::uint64_t room = 0;
};

/// The crews that are tried, the largest first. If W·C ≤ P, all workers with all their room.
/// Otherwise ⌊P/C⌋, ⌈P/C⌉, ⌊P/2⌋, and W, ⌊W/2⌋, ⌊W/4⌋, … down to the first that is at most ⌊P/C⌋ or
/// 1; of these the ones of at most W and ⌊P/2⌋ workers, or of one. Each worker has room for
/// min(C, ⌊P/workers⌋) items, a single one for C: together they have room for no more than all. So
/// the crews of ⌊W/2⌋ workers are among those of W workers, if these are crowded. At least one.
[[nodiscard]] std::vector<Crew> crews(std::uint64_t items, std::uint64_t room,
                                      std::uint64_t workers);

/// "3 of 5 workers have nothing to do. "; "" if all are busy.
[[nodiscard]] std::string say_idle(std::uint64_t busy, std::uint64_t workers);

}  // namespace changeover
