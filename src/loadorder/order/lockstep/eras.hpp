// Internal: lockstep orders for any number of items, generated step by step.
//
// The items are in G groups of at most n ≤ C − 1 items. In an era W groups stay, group a + w at
// worker w.
//   1. All later groups pass: in round r the (r + w)-th of them (cyclically) passes worker w, item
//      by item. So the passing groups of a round are different, and each group that stays is passed
//      by each of the others.
//   2. The groups that stayed meet each other by halves. The first half of a block stays; the
//      workers of the other half drop their groups and are idle; the groups of the other half pass
//      those of the first, one group at each worker in turn. The same is then done in both halves.
//      Blocks begin at multiples of their size, a power of two.
//   3. The groups that stayed are finished.
//
// A pair within a group meets when the group is loaded to stay.
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

/// Steps and loads of all rounds: the span of the order, and the loads of all workers.
struct EraCost {
  std::uint64_t span = 0;
  std::uint64_t loads = 0;
  std::uint64_t steps = 0;
};

[[nodiscard]] EraCost cost_of_eras(const EraShape& shape);

/// The grouping with the least span, with C − 1 items per group or a few less.
[[nodiscard]] EraShape best_eras(std::uint64_t items, std::uint64_t room, std::uint64_t workers);

/// The steps of one worker.
[[nodiscard]] std::unique_ptr<StepSource> era_steps(const EraShape& shape, std::uint64_t worker);

}  // namespace changeover
