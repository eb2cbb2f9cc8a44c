// What each step of a schedule computes and stores.
//
//     const ComputeRules both{.ordered = true, .self = true};
//     ScheduleRules rules{.items = 24, .room = 6, .compute = both};
//     rules.store = true;                          // items change while they are held
//     StepWork work(plan_load_order(24, 6).stream(), rules);
//     for (Step step; work.next(step);) {
//       store(step.store);                         // what was changed and goes now
//       move(step.evict, step.load);
//       compute(step.compute);                     // (i,j), (j,i) and (i,i), each once in all
//     }
//
// *Pairs.* A pair belongs to the first step after whose loads a worker has both items in memory,
// and an item with itself to the step that first loads it. For more than 65,535 items whose pairs
// are not listed, pairs are not kept in mind: then every loaded item is computed against all in
// memory, and a pair may come again. Steps of two levels say themselves which pairs meet on the
// accelerator for the first time.
//
// *Overlap* (loadorder/prefetch.hpp): what the next step evicts goes early as far as its loads need
// the places, the pairs with it are computed first, and the others while the loads run.
//
// *Stores.* Computing a pair changes both of its items, computing an item alone changes it. What
// was changed is stored when it is evicted, before anything is loaded, and at the end, in a last
// step in which everything goes. So an item is stored once for each *stay* in memory in which it is
// computed with. Workers one after another cannot change items: two of them would hold one.
//
// *The bound on stores* is that on loads: load_lower_bound(). For take any order with its pairs and
// leave out each stay in which nothing is computed with its item. All pairs are still computed with
// both items in memory, and every stay that is left has one load and one store. An item that
// belongs to no pair need not be stored, and counts for nothing.
#pragma once

#include <memory>

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

class StepWork final : public StepSource {
 public:
  /// Steps that say what is evicted and loaded, with the work that `rules` ask for. Without
  /// rules.compute no pairs are said, so nothing changes and nothing is stored.
  StepWork(std::unique_ptr<StepSource> steps, const ScheduleRules& rules);
  ~StepWork() override;

  /// The next step; false at the end. O(C) a load.
  bool next(Step& step) override;

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// Stores that no order of these loads can go below, given the bound on loads; `alone` says that
/// items are computed alone, too.
[[nodiscard]] LoadBound store_lower_bound(const LoadBound& loads, const WantedPairs& wanted,
                                          std::uint64_t items, bool alone);

}  // namespace changeover
