// A load order for several workers, each with room of its own.
//
//     WorkerSplit split = split_load_order(64, 16, 4);
//     split.facts().makespan;                  // loads of the busiest worker
//     split.facts().most_pairs;                // pairs that the worker with most of them computes
//     for (std::uint64_t w = 0; w < 4; ++w) {
//       auto steps = split.stream(w);          // numbered from 1; the first loads a full memory
//     }
//
// *How.* The best of
//   stretches   an order is cut into W stretches; each worker begins by loading what is in memory
//               at its first step. A stretch costs what its steps load and C − (what its first step
//               loads) more, so the makespan is about L/W + C. The items of that order may be
//               groups of items: P items in G groups, room for C·G/P groups
//   shares      for rooms of P/(2√W) or more: the items are in groups; each worker holds some of
//               them all the time and streams others past them. Planes, difference covers, and
//               pairs of sets (A,S) of Z_n, found by search
//   blocks      two sets, each cut into parts: one part of each for a worker
// compared by makespan, then by all loads.
//
// *The bound on the makespan.* A worker that loads ℓ items brings at most C(ℓ,2) pairs together if
// ℓ ≤ C, and C(C,2) + (ℓ−C)(C−1) otherwise. W workers with at most ℓ loads bring all C(P,2)
// together only if W times that is enough, and all items are loaded somewhere: ℓ ≥ ⌈P/W⌉.
// Whatever several workers load, end to end, is a list of sets in which all pairs meet: W·ℓ ≥
// (s+1)P − (s²−s+1)C for every s [docs/theorems.md, Theorem 5]. And however much room there is, any
// two items meet at one of few workers, for which ℓ ≥ P/√W is not enough [Theorem 17].
//
// *Pairs.* Several workers may have a pair. Unless it is asked otherwise, pairs are spread over
// those that have them such that the worker with most of them has as few as can be, counted or
// weighed by a cost; owners() says who computes what. The bound is the mean. What is loaded and
// brings a worker no pair is not loaded there, if pairs are spread one by one: of up to 5,000
// items, and of listed pairs.
//
// *Verified.* For P ≤ 65,535 all workers' steps are read, and the pairs that met with any of them
// are all pairs. Above that the stretches are those of an order that is certified by its structure.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

/// No split is for more.
inline constexpr std::uint64_t most_workers = 65'536;

/// What one worker computes of the pairs that it has in memory.
class PairRule {
 public:
  virtual ~PairRule() = default;
  PairRule(const PairRule&) = delete;
  PairRule& operator=(const PairRule&) = delete;

  /// Whether it computes {x,y}, which came together in its memory by its step number `step`; x = y:
  /// the item alone, which that step loads. O(1) or O(log) of the workers that have them.
  [[nodiscard]] virtual bool computes(std::uint64_t step, Element x, Element y) const = 0;

 protected:
  PairRule() = default;
};

/// Who computes what: each pair is one worker's, and what a worker computes can be said without the
/// steps of others.
class PairOwners {
 public:
  virtual ~PairOwners() = default;
  PairOwners(const PairOwners&) = delete;
  PairOwners& operator=(const PairOwners&) = delete;

  /// It may not outlive this.
  [[nodiscard]] virtual std::unique_ptr<const PairRule> of(std::uint64_t worker) const = 0;

 protected:
  PairOwners() = default;
};

/// What one worker does.
struct WorkerFacts {
  std::uint64_t first_step = 0;  ///< of the common order, from 1; 0 if the worker has nothing to do
  std::uint64_t steps = 0;
  std::uint64_t loads = 0;
  std::uint64_t pairs = 0;  ///< that it computes
  double cost = 0;          ///< of these, if pairs have costs
};

struct SplitFacts {
  std::uint64_t items = 0;
  std::uint64_t room = 0;
  std::uint64_t groups = 0;      ///< G; equal to items if they are not grouped
  std::uint64_t group_room = 0;  ///< groups that are in memory at once
  std::uint64_t loads = 0;       ///< of all workers
  std::uint64_t makespan = 0;    ///< of the busiest one
  std::uint64_t transfers = 0;   ///< to the accelerators of all workers, of two levels
  LoadBound makespan_bound;      ///< no split has a smaller makespan
  std::string explanation;       ///< how the common order is made; says so if it is one of groups
  std::string
      certificate;  ///< one line: how it was verified; counts pairs of items, or says of what
  bool cut_by_loads =
      false;  ///< shares have even loads; otherwise even numbers of steps, or of pairs
  bool pairs_are_known =
      false;  ///< how many pairs workers compute: of more than 65,535 items not always
  std::uint64_t most_pairs = 0;  ///< of one worker
  std::uint64_t all_pairs =
      0;  ///< that are wanted; no split has fewer than ⌈all_pairs / W⌉ at some worker
  bool has_costs = false;  ///< pairs have costs, which are spread instead of their number
  double most_cost = 0;    ///< of one worker
  double all_costs = 0;    ///< no split has less than a W-th of it at some worker
  std::vector<WorkerFacts> workers;
  std::uint64_t epochs =
      1;  ///< in each of which all pairs meet; loads and pairs are of all of them
  std::vector<std::uint64_t> epoch_loads;  ///< of all workers; empty of one epoch
};

class OrderRelay;

/// Steps of each worker, where they are no stretches of one order.
class WorkerSteps {
 public:
  virtual ~WorkerSteps() = default;
  WorkerSteps(const WorkerSteps&) = delete;
  WorkerSteps& operator=(const WorkerSteps&) = delete;

  /// From the first step on; the stream may outlive this.
  [[nodiscard]] virtual std::unique_ptr<StepSource> of(std::uint64_t worker) const = 0;

 protected:
  WorkerSteps() = default;
};

class WorkerSplit {
 public:
  [[nodiscard]] const SplitFacts& facts() const { return facts_; }

  /// The order that was cut; or all shares, one after another, each beginning with an empty memory.
  [[nodiscard]] const LoadOrder& order() const { return order_; }

  /// The steps of a worker, 0 ≤ worker < W. Of shares, and of streamed orders, that takes O(C + its
  /// steps). Steps of other orders before its own are skipped by reading them, once for all workers
  /// if these are read in their order, each stream to its end.
  /// @throws BadInput if there is no such worker.
  [[nodiscard]] std::unique_ptr<StepSource> stream(std::uint64_t worker) const;

  /// The steps of all workers, one worker after another. It may not outlive this.
  [[nodiscard]] std::unique_ptr<StepSource> stream() const;

  /// Who computes which pairs. Null: a pair belongs to the first worker that has it, and what a
  /// worker computes depends on all before it.
  [[nodiscard]] const std::shared_ptr<const PairOwners>& owners() const { return owners_; }

  /// What the steps keep to, for StepWork and ScheduleCheck.
  [[nodiscard]] ScheduleRules rules(const std::optional<ComputeRules>& compute = {}) const;

 private:
  friend class SplitMaker;
  WorkerSplit(SplitFacts facts, LoadOrder order);

  SplitFacts facts_;
  LoadOrder order_;
  std::shared_ptr<OrderRelay> relay_;
  std::shared_ptr<const WorkerSteps> steps_;
  std::shared_ptr<const PairOwners> owners_;
};

/// The makespan that no split goes below. @throws as load_lower_bound(), BadInput if workers = 0.
[[nodiscard]] LoadBound makespan_lower_bound(const WantedPairs& wanted, std::uint64_t room,
                                             std::uint64_t workers);

/// Cuts an order of `groups` things into stretches for P items in as many groups, of ⌊P/G⌋ or ⌈P/G⌉
/// items with consecutive numbers; a pair belongs to the first worker that has it. Nothing is
/// verified. @throws BadInput if workers = 0 or exceeds 65,536, or if there are more groups than
/// items.
[[nodiscard]] WorkerSplit split_order(LoadOrder order, std::uint64_t items, std::uint64_t room,
                                      std::uint64_t workers);

/// The best split that is known, verified. Of some pairs only, items are not grouped; two sets may
/// be cut instead: then each worker has a part of one with a part of the other. @throws as
/// plan_load_order() and split_order().
[[nodiscard]] WorkerSplit split_load_order(const WantedPairs& wanted, std::uint64_t room,
                                           std::uint64_t workers,
                                           const LoadOrderOptions& options = {});

/// An order for two levels (loadorder/load_order.hpp) in stretches, each worker with memory and an
/// accelerator of its own: what both levels of the busiest worker move is as little as stretches
/// allow. Verified. @throws as plan_two_levels() and split_order().
[[nodiscard]] WorkerSplit split_two_levels(std::uint64_t items, std::uint64_t room,
                                           std::uint64_t fast_room, std::uint64_t workers,
                                           const LoadOrderOptions& options = {});

/// Shares of one epoch again and again, each worker going through its own back and forth
/// (loadorder/load_order.hpp), with what it holds staying from one epoch to the next, and with the
/// same pairs in each. Verified, as far as the pairs of all epochs can be followed at once. Of more
/// than 5,000 items, unless their pairs are listed, it is not said who computes what: owners() is
/// null. @throws as repeat_order()
[[nodiscard]] WorkerSplit repeat_shares(WorkerSplit split, std::uint64_t epochs);

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
//   eras     W groups of n ≤ C−1 items stay, one at each worker, while all groups that are left
//            pass, each at another worker in turn; then those that stayed meet each other, half of
//            them staying, and are dropped for good. Any P.
//   grown    one item of each worker is changed a step, the change that brings most new pairs
//            together, or two workers exchange items; the best of many is cut at random steps and
//            grown again. P ≤ 1,000. The same with groups of items, room for 2 to 8 of them, which
//            is better if few items are left beside those that are held.
//   round robin   2W groups, two at each worker: the rounds of a tournament. Span P.

/// The best order that is known, verified by ScheduleCheck. With `options.search_pairs` it is grown
/// anew until the time is over, otherwise for a fixed amount of work. @throws as plan_load_order();
/// BadInput if there are less than W·C items, or W is 0 or exceeds 65,536; ImpossibleParameters
/// above 65,535 items.
[[nodiscard]] LoadOrder plan_disjoint_order(std::uint64_t items, std::uint64_t room,
                                            std::uint64_t workers,
                                            const LoadOrderOptions& options = {});

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

/// An order and the places that it leaves for loads on their way.
template <typename Order>
struct Prefetched {
  Order order;
  std::uint64_t spare = 0;  ///< 0 or 1: the order is for room − spare
};
using PrefetchPlan = Prefetched<LoadOrder>;
using PrefetchSplit = Prefetched<WorkerSplit>;  ///< for several workers

/// The better of the two ways. @throws as plan_load_order().
[[nodiscard]] PrefetchPlan plan_prefetch(const WantedPairs& wanted, std::uint64_t room,
                                         const LoadOrderOptions& options = {});

/// The same for workers; of both ways the one whose busiest worker is ready first. @throws as
/// split_load_order().
[[nodiscard]] PrefetchSplit split_prefetch(const WantedPairs& wanted, std::uint64_t room,
                                           std::uint64_t workers,
                                           const LoadOrderOptions& options = {});

}  // namespace changeover
