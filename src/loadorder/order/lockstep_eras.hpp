// Internal: lockstep orders for any number of items, made as they go.
//
// The items are in G groups of at most n ≤ C − 1 items. In an era W groups stay, group a + w at
// worker w.
//   1. All groups behind them pass: in round r worker w is passed by the (r + w)-th of them,
//      cyclically, item by item. So in each round the passing groups differ, and each group that
//      stays is passed by each of the others.
//   2. Those that stayed meet each other by halves: the first half of a block stays where it is,
//      the workers of the other half drop theirs and stand idle, and the other half passes the
//      first, one group at each in turn; then the same with both halves. Blocks begin at multiples
//      of their size, a power of two.
//   3. They are dropped for good.
// A pair in a group meets when the group is loaded to stay.
#pragma once

#include <cstdint>
#include <memory>

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

struct EraShape {
  std::uint64_t items = 0;
  std::uint64_t workers = 0;
  std::uint64_t groups = 0;
};

/// Steps and loads of all rounds: the span of the order and the loads of all workers.
struct EraCost {
  std::uint64_t span = 0;
  std::uint64_t loads = 0;
  std::uint64_t steps = 0;
};

[[nodiscard]] EraCost cost_of_eras(const EraShape& shape);

/// The numbers of groups with the least span, by C − 1 items a group or a few less.
[[nodiscard]] EraShape best_eras(std::uint64_t items, std::uint64_t room, std::uint64_t workers);

/// The steps of a worker.
[[nodiscard]] std::unique_ptr<StepSource> era_steps(const EraShape& shape, std::uint64_t worker);

}  // namespace changeover
