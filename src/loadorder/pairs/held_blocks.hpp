// Internal: two sets for several workers: both are cut, and each worker has a part of the one with
// a part of the other.
//
// One worker after another, as one order: where the next one begins, all that is in memory is
// evicted, even what it loads again. So cut there, the order is one of each worker alone.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"
#include "loadorder/pairs/held_order.hpp"

namespace changeover {

struct HeldBlocks {
  std::uint64_t first_parts = 0;  ///< of the first set
  std::uint64_t other_parts = 0;
  std::vector<HeldShape>
      shapes;  ///< one a worker; workers without any come last and are not listed

  [[nodiscard]] std::uint64_t makespan() const;
};

/// The parts with the smallest makespan of all p·q ≤ workers, as far as estimates tell; nothing
/// where there would be more than a million groups.
[[nodiscard]] std::optional<HeldBlocks> best_held_blocks(const WantedPairs& between,
                                                         std::uint64_t room, std::uint64_t workers);

/// The steps of all workers, one worker after another.
[[nodiscard]] std::unique_ptr<StepSource> block_steps(std::shared_ptr<const HeldBlocks> blocks,
                                                      std::uint64_t items);

}  // namespace changeover
