// Internal: what both levels move, each over its bound.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "changeover/loadorder/load_order.hpp"
#include "core/checked.hpp"
#include "loadorder/shares/step_lists.hpp"

namespace changeover {

/// Items, or bytes.
struct MovedAtLevels {
  std::uint64_t loaded = 0;
  std::uint64_t transferred = 0;

  /// Adds a step or a move; `sizes` are by item, or each is 1 if there are none.
  template <typename Moved>
  void add(const Moved& its, std::span<const std::uint64_t> sizes) {
    const auto add_to = [&](std::uint64_t& sum, const std::vector<Element>& items) {
      for (const Element x : items) {
        sum = checked_add(sum, sizes.empty() ? 1 : sizes[x]);
      }
    };
    add_to(loaded, its.load);
    add_to(transferred, its.fast_load);
  }

  [[nodiscard]] double over(const LoadOrderFacts& bounds) const {
    const bool bytes = bounds.sizes != nullptr;
    const auto part = [](std::uint64_t moved, const LoadBound& least) {
      return static_cast<double>(moved) / static_cast<double>(least.loads);
    };
    return part(loaded, bytes ? bounds.byte_bound : bounds.bound) +
           part(transferred, bytes ? bounds.transfer_byte_bound : bounds.transfer_bound);
  }
};

/// The sizes of the items, if they have any.
[[nodiscard]] inline std::span<const std::uint64_t> sizes_in(const LoadOrderFacts& facts) {
  return facts.sizes ? std::span<const std::uint64_t>(facts.sizes->bytes)
                     : std::span<const std::uint64_t>();
}

/// loads / bound + transfers / bound, in bytes if `bounds` has sizes.
[[nodiscard]] inline double cost_of(const std::vector<Move>& moves, const LoadOrderFacts& bounds) {
  MovedAtLevels moved;
  for (const Move& move : moves) {
    moved.add(move, sizes_in(bounds));
  }
  return moved.over(bounds);
}

/// The same of an order, whose items may be groups of these sizes.
[[nodiscard]] inline double cost_of(StepSource& steps, const LoadOrderFacts& bounds,
                                    std::span<const std::uint64_t> sizes) {
  MovedAtLevels moved;
  for (Step step; steps.next(step);) {
    moved.add(step, sizes);
  }
  return moved.over(bounds);
}

}  // namespace changeover
