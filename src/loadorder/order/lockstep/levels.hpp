// Internal: workers in lockstep, each with its own accelerator.
#pragma once

#include <cstdint>
#include <memory>

#include "loadorder/order/levels/group_levels.hpp"

namespace changeover {

/// The steps of all workers, where `groups` are those of an order in lockstep for the groups of the
/// shape. What a step of it brings together at a worker takes it several steps; workers that are
/// ready sooner have nothing to do until the next step of that order.
[[nodiscard]] std::unique_ptr<StepSource> levels_in_lockstep(
    const LevelShape& shape, std::unique_ptr<StepSource> groups, std::uint64_t workers,
    const std::shared_ptr<InnerOrders>& inner_orders);

/// The sums over all steps of what the slowest worker moves in each, in items, or in bytes.
struct LevelSpans {
  std::uint64_t loads = 0;
  std::uint64_t transfers = 0;

  /// Each over the bound of the busiest worker.
  [[nodiscard]] double over(std::uint64_t least_loads, std::uint64_t least_transfers) const {
    return static_cast<double>(loads) / static_cast<double>(least_loads) +
           static_cast<double>(transfers) / static_cast<double>(least_transfers);
  }
};
[[nodiscard]] LevelSpans spans_of(StepSource& steps, std::uint64_t workers,
                                  const ItemSizes* sizes = nullptr);

}  // namespace changeover
