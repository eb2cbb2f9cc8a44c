// Internal: two sets for several workers: both are cut into parts, and each worker has a part of
// one set with a part of the other.
//
// The workers, one after another, form one order: where the next one begins, all of memory is
// evicted, even items that are loaded again. Cut there, it gives an order for each worker alone.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"
#include "loadorder/pairs/held/held_order.hpp"

namespace changeover {

struct HeldBlocks {
  std::uint64_t first_parts = 0;  ///< of the first set
  std::uint64_t other_parts = 0;
  /// The part of each set, one pair per worker that has any.
  std::vector<std::pair<ItemRange, ItemRange>> parts;
  std::vector<HeldShape>
      shapes;  ///< one per worker; workers without any come last and are not listed

  [[nodiscard]] std::uint64_t makespan() const;
};

/// The parts with the smallest estimated makespan, for all p·q ≤ workers; nullopt if there would be
/// more than a million groups.
[[nodiscard]] std::optional<HeldBlocks> best_held_blocks(const WantedPairs& between,
                                                         std::uint64_t room, std::uint64_t workers);

/// The steps of all workers, one worker after another.
[[nodiscard]] std::unique_ptr<StepSource> block_steps(std::shared_ptr<const HeldBlocks> blocks,
                                                      std::uint64_t items);

}  // namespace changeover
