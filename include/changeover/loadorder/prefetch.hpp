// When what is computed and loaded, so that loads overlap computation.
//
//     PrefetchPlan plan = plan_prefetch(64, 16);
//     ScheduleRules rules{.items = 64, .room = 16, .compute = ComputeRules{}, .overlap = true};
//     StepWork schedule(plan.order.stream(), rules);
//     Step step, next;
//     for (bool more = schedule.next(step); more; std::swap(step, next)) {
//       wait_for(step.load);                       // these loads were started in the step before
//       compute(step.compute);                     // all pairs with what has to go first
//       next = {};
//       more = schedule.next(next);
//       const auto late = next.evict.end() - static_cast<std::ptrdiff_t>(next.late);
//       drop({next.evict.begin(), late});
//       start_loads(next.load);
//       compute(step.overlap);                     // meanwhile
//       drop({late, next.evict.end()});
//     }
//
// *Two ways.* With a place to spare, an order for room C−1, the next load can start as soon as a
// step begins, and everything that is computed overlaps it. With the whole room for the order there
// are fewer loads, but the next one needs the place of the item y that goes: the pairs with y come
// first, and only the others overlap. If y came a while ago that is one pair of C−1, and this way
// wins. If y is what was loaded last, because items pass one by one through the same place, nothing
// overlaps, and the first way wins by far.
//
// plan_prefetch() compares both in a model: a load takes as long as C−1 pairs do, which is where
// overlap matters most; a step takes the time of what it computes first, and then of its `overlap`
// or of the next loads, whichever is longer. For more than 2,000 items the spare place is taken,
// since streamed orders pass items one by one.
//
// *Each pair once.* A pair is computed in the first step that has both in memory. For more than
// 65,535 items pairs are not kept in mind; then every loaded item is computed against all in
// memory, and a pair may come again.
#pragma once

#include <cstdint>
#include "changeover/loadorder/step_work.hpp"
#include "changeover/loadorder/workers.hpp"

namespace changeover {

/// An order and the places that it leaves for loads on their way.
template <typename Order>
struct Prefetched {
  Order order;
  std::uint64_t spare = 0;  ///< 0 or 1: the order is for room − spare
};
using PrefetchPlan = Prefetched<LoadOrder>;
using PrefetchSplit = Prefetched<WorkerSplit>;  ///< for several workers

/// The better of the two ways. @throws as plan_load_order().
[[nodiscard]] PrefetchPlan plan_prefetch(std::uint64_t items, std::uint64_t room,
                                         const LoadOrderOptions& options = {});
[[nodiscard]] PrefetchPlan plan_prefetch(const WantedPairs& wanted, std::uint64_t room,
                                         const LoadOrderOptions& options = {});

/// The same for workers; of both ways the one whose busiest worker is ready first. @throws as
/// split_load_order().
[[nodiscard]] PrefetchSplit split_prefetch(std::uint64_t items, std::uint64_t room,
                                           std::uint64_t workers,
                                           const LoadOrderOptions& options = {});
[[nodiscard]] PrefetchSplit split_prefetch(const WantedPairs& wanted, std::uint64_t room,
                                           std::uint64_t workers,
                                           const LoadOrderOptions& options = {});

}  // namespace changeover
