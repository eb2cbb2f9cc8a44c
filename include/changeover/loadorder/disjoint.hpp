// Load orders for workers that step together and never hold one item twice: what training needs,
// where items change.
//
//     LoadOrder order = plan_disjoint_order(64, 8, 4);
//     order.facts().span;                      // what the slowest loads of all steps add up to
//     StepWork work(order.stream(), order.rules(ComputeRules{}));
//     check_schedule(work, order.rules(ComputeRules{})).valid();   // true: disjoint at every step
//
// *A step.* All workers evict; all wait for each other; all load; all compute. So one barrier a
// step is enough, the one between evicting and loading, and an item may go from one worker to
// another within a step. After the loads of a step no item is held by two workers, so what one of
// them computes touches nothing of another's. A worker may have nothing to do in a step; every
// worker has equally many.
//
// *The cost.* With a barrier a step takes as long as its slowest worker: the *span* is the sum over
// all steps of the most loads that one worker has in it. Orders are told apart by span, then by the
// loads of all workers.
//
// *Bounds.* The workers' lists of sets end to end are one list in which all pairs meet, so all
// loads together are at least load_lower_bound(P, C); the busiest worker has at least
// makespan_lower_bound(P, C, W), and the span is no less than that.
//
// *Where orders come from.* One worker: plan_load_order(). Else the best of
//   eras     W groups of n ≤ C−1 items stay, one at each worker, while all groups that are left pass, each at another worker in
//            turn; then those that stayed meet each other, half of them staying, and are dropped for good. Any P.
//   grown    one item of each worker is changed a step, the change that brings most new pairs together, or two workers
//            exchange items; the best of many is cut at random steps and grown again. P ≤ 1,000. The same with groups of items,
//            room for 2 to 8 of them, which is better if few items are left beside those that are held.
//   round robin   2W groups, two at each worker: the rounds of a tournament. Span P.
#pragma once

#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/step_work.hpp"

namespace changeover {

/// The best order that is known, verified by ScheduleCheck. With `options.search_pairs` it is grown
/// anew until the time is over, otherwise for a fixed amount of work. @throws as plan_load_order();
/// BadInput if there are less than W·C items, or W is 0 or exceeds 65,536; ImpossibleParameters
/// above 65,535 items.
[[nodiscard]] LoadOrder plan_disjoint_order(std::uint64_t items, std::uint64_t room,
                                            std::uint64_t workers,
                                            const LoadOrderOptions& options = {});

}  // namespace changeover
