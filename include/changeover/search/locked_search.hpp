// Designs with a property that constructions need, by local search with locked cells.
//
//     RunControl control({.time = std::chrono::seconds(20)});
//     LockedResult found = search_locked({.v = 12, .k = 4, .change = 1}, {.first = {0, 1, 2}, .expansion_set = true}, {.blocks = 21}, control);
//     found.design->block_count();          // 21
//     found.parts.size();                   // 3: unchanged subsets that hold the nine other elements
//
// Concatenation, rings and expansion ask for more than few blocks: disjoint unchanged subsets that
// hold all elements but some of the first or of the last block. Places for such subsets are drawn,
// the blocks beside them hold them, and moves leave these cells as they are; all others are
// annealed (search/local_search.hpp). When that fails, other places are drawn.
//
// Bound by: the rate of moves, about 10 million a second a core at (20,5).
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/run/control.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover {

/// What a design is to have, all of it.
struct Wanted {
  Block first{};  ///< elements of the first block, at most k; linear designs only
  Block last{};   ///< elements of the last block
  bool expansion_set =
      false;  ///< unchanged subsets partition the elements not in `first` or `last`
  std::vector<Block>
      contained{};  ///< consecutive blocks, in this order or, if circular, across the end
};

/// Why no design with these parameters has it, or it makes no sense, in one line; else empty.
/// O(vk).
[[nodiscard]] std::string wanted_defect(const Parameters& p, const Wanted& wanted);

/// The unchanged subsets that partition the elements not in `first` or `last`, in order of
/// position; nullopt if `design` has not all that is wanted. `positions`: where the subsets are;
/// without expansion_set they are ignored. O(bk).
[[nodiscard]] std::optional<std::vector<UnchangedSubset>> parts_as_wanted(
    const Design& design, const Wanted& wanted, const std::vector<std::size_t>& positions);

struct LockedOptions {
  std::optional<std::uint64_t>
      blocks{};  ///< so many are enough, and no more are tried; nothing: as few as possible
  std::optional<std::uint64_t> moves{};  ///< the most moves, over all threads
};

struct LockedResult {
  std::optional<VerifiedDesign> design;
  std::vector<UnchangedSubset> parts;  ///< of the design, with expansion_set
  std::uint64_t lower_bound = 0;
  std::uint64_t moves = 0;     ///< proposals, over all threads
  std::uint64_t attempts = 0;  ///< anneals
  std::chrono::duration<double> elapsed{};
  WhyStopped why_stopped = WhyStopped::running;
};

/// Searches until `blocks`, or the lower bound, is reached or `control` or the limit of moves says
/// stop. With one thread and a limit of moves the answer depends on the arguments and the seed
/// alone. v ≤ 4096.
/// @throws BadInput if wanted_defect() finds one or v is larger; ImpossibleParameters as check(),
/// or if there is no design at all; MissingResource if the counters do not fit into the memory that
/// `control` allows; InternalError if a result is not as wanted.
[[nodiscard]] LockedResult search_locked(const Parameters& p, const Wanted& wanted,
                                         const LockedOptions& options, RunControl& control);

}  // namespace changeover
