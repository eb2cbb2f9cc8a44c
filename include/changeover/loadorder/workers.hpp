// A load order for several workers, each with its own memory.
//
//     WorkerSplit split = split_load_order(64, 16, 4);
//     split.facts().makespan;                  // loads of the busiest worker
//     split.facts().most_pairs;                // pairs that the worker with most of them computes
//     for (std::uint64_t w = 0; w < 4; ++w) {
//       auto steps = split.stream(w);          // numbered from 1; the first loads a full memory
//     }
//
// *How.* The best of three kinds, compared by makespan and then by all loads:
//   stretches   an order is cut into W stretches; each worker first loads what is in memory at the
//               start of its stretch. A stretch costs the loads of its steps, and C − (the loads of
//               its first step) more, so the makespan is about L/W + C. The items of that order may
//               be groups of items: P items in G groups, with room for C·G/P groups
//   shares      for rooms of P/(2√W) or more: the items are in groups; each worker holds some of
//               them all the time and streams others past them. Planes, difference covers, and
//               pairs of sets (A,S) of Z_n, found by search
//   blocks      two sets, each cut into parts: one part of each for a worker
//
// *The bound on the makespan.* A worker that loads ℓ items brings at most C(ℓ,2) pairs together if
// ℓ ≤ C, and C(C,2) + (ℓ−C)(C−1) otherwise. W times this must reach C(P,2), and all items are
// loaded somewhere, so ℓ ≥ ⌈P/W⌉. The sets of all workers, end to end, are a list in which all
// pairs meet: W·ℓ ≥ (s+1)P − (s²−s+1)C for every s [docs/theorems.md, Theorem 5]. For few workers
// there is a bound that holds for any room: P/√W loads each are not enough [Theorem 17].
//
// *Pairs.* Several workers may have the same pair in memory. By default pairs are spread over the
// workers that have them so that the worker with the most pairs, counted or weighed by cost, has as
// few as possible; owners() says which worker computes what. The mean is the lower bound. For up to
// 5,000 items and for listed pairs, a worker does not load an item that brings it no pair.
//
// *Verified.* For P ≤ 65,535 the steps of all workers are read, and all pairs meet at some worker.
// Above that the stretches belong to an order that is certified by its structure.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

/// The largest number of workers of a split.
inline constexpr std::uint64_t most_workers = 65'536;

/// Says which of the pairs in its memory one worker computes.
class PairRule {
 public:
  virtual ~PairRule() = default;
  PairRule(const PairRule&) = delete;
  PairRule& operator=(const PairRule&) = delete;

  /// Whether the worker computes {x,y}, a pair that came together in its memory in its step `step`;
  /// x = y stands for the item alone, which that step loads. O(1), or O(log) of the workers that
  /// have the pair.
  [[nodiscard]] virtual bool computes(std::uint64_t step, Element x, Element y) const = 0;

 protected:
  PairRule() = default;
};

/// Assigns each pair to one worker, and says what a worker computes without reading the steps of
/// the others.
class PairOwners {
 public:
  virtual ~PairOwners() = default;
  PairOwners(const PairOwners&) = delete;
  PairOwners& operator=(const PairOwners&) = delete;

  /// The rule of one worker, which must not outlive this object.
  [[nodiscard]] virtual std::unique_ptr<const PairRule> of(std::uint64_t worker) const = 0;

 protected:
  PairOwners() = default;
};

/// The share of one worker.
struct WorkerFacts {
  std::uint64_t first_step = 0;  ///< in the common order, from 1; 0 if the worker has no steps
  std::uint64_t steps = 0;
  std::uint64_t loads = 0;
  std::uint64_t bytes = 0;  ///< loaded, if items have sizes
  std::uint64_t pairs = 0;  ///< computed by the worker
  double cost = 0;          ///< of these pairs, if pairs have costs
};

struct SplitFacts {
  std::uint64_t items = 0;
  std::uint64_t room = 0;
  std::uint64_t groups = 0;  ///< G, the number of groups; equal to items if they are not grouped
  std::uint64_t group_room = 0;      ///< groups in memory at a time
  std::uint64_t loads = 0;           ///< of all workers
  std::uint64_t makespan = 0;        ///< loads of the busiest worker
  std::uint64_t transfers = 0;       ///< to the accelerators of all workers, for two levels
  LoadBound makespan_bound;          ///< no split has a smaller makespan
  std::uint64_t bytes = 0;           ///< loaded by all workers, if items have sizes
  std::uint64_t makespan_bytes = 0;  ///< of the worker that loads most bytes
  LoadBound makespan_bytes_bound;    ///< a lower bound for the busiest worker, for every split
  std::string
      explanation;  ///< one line: how the common order is made, and whether its items are groups
  std::string certificate;  ///< one line: how the split was verified, and which pairs were counted
  bool cut_by_loads = false;  ///< cut by loads; otherwise by numbers of steps or of pairs
  bool pairs_are_known =
      false;  ///< whether the numbers of computed pairs are known: above 65,535 items, not always
  std::uint64_t most_pairs = 0;  ///< at one worker
  std::uint64_t all_pairs =
      0;  ///< wanted pairs; in any split some worker has at least ⌈all_pairs / W⌉
  bool has_costs = false;  ///< pairs have costs, which are spread instead of their numbers
  double most_cost = 0;    ///< at one worker
  double all_costs = 0;    ///< in any split some worker has at least a W-th of it
  std::vector<WorkerFacts> workers;
  std::uint64_t epochs =
      1;  ///< all pairs meet in each of them; loads and pairs are sums over all epochs
  std::vector<std::uint64_t> epoch_loads;  ///< of all workers; empty for one epoch
};

class OrderRelay;

/// The steps of each worker, for splits that are not stretches of one order.
class WorkerSteps {
 public:
  virtual ~WorkerSteps() = default;
  WorkerSteps(const WorkerSteps&) = delete;
  WorkerSteps& operator=(const WorkerSteps&) = delete;

  /// The steps of a worker from the first on; the stream may outlive this object.
  [[nodiscard]] virtual std::unique_ptr<StepSource> of(std::uint64_t worker) const = 0;

 protected:
  WorkerSteps() = default;
};

class WorkerSplit {
 public:
  [[nodiscard]] const SplitFacts& facts() const { return facts_; }

  /// The order that was cut; or all shares one after another, each starting with an empty memory.
  [[nodiscard]] const LoadOrder& order() const { return order_; }

  /// The steps of a worker, 0 ≤ worker < W. O(C + its steps) for shares and streamed orders. For
  /// other orders the steps before those of the worker are read and skipped; if the streams are
  /// requested in the order of the workers and each is read to its end, this happens only once for
  /// all workers. @throws BadInput if there is no such worker.
  [[nodiscard]] std::unique_ptr<StepSource> stream(std::uint64_t worker) const;

  /// The steps of all workers, one worker after another. The stream must not outlive this object.
  [[nodiscard]] std::unique_ptr<StepSource> stream() const;

  /// Which worker computes which pairs. Null: the first worker that has a pair computes it, so what
  /// a worker computes depends on all workers before it.
  [[nodiscard]] const std::shared_ptr<const PairOwners>& owners() const { return owners_; }

  /// The rules of the steps, for StepWork and ScheduleCheck.
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

/// Cuts an order of G groups into stretches for P items, with ⌊P/G⌋ or ⌈P/G⌉ consecutive items per
/// group. The first worker that has a pair computes it. Nothing is verified. @throws BadInput if
/// workers = 0 or exceeds 65,536, or if there are more groups than items.
[[nodiscard]] WorkerSplit split_order(LoadOrder order, std::uint64_t items, std::uint64_t room,
                                      std::uint64_t workers);

/// The best split that is known, verified. Of some pairs only, items are not grouped; two sets may
/// be cut instead: then each worker has a part of one with a part of the other. @throws as
/// plan_load_order() and split_order().
[[nodiscard]] WorkerSplit split_load_order(const WantedPairs& wanted, std::uint64_t room,
                                           std::uint64_t workers,
                                           const LoadOrderOptions& options = {});

/// For items of different sizes (loadorder/load_order.hpp): the busiest worker loads as few bytes
/// as we know how. An order is cut so that bytes are even; or items are put into groups of even
/// bytes, of which each worker holds some and streams others; or of two sets each worker has a part
/// of both. A load that brings a worker none of its own pairs is left out. Up to 2 million pairs,
/// each
/// worker has its own order for its pairs. Verified. @throws as plan_sized_order() and
/// split_order()
[[nodiscard]] WorkerSplit split_sized_order(std::shared_ptr<const ItemSizes> sizes,
                                            const WantedPairs& wanted, std::uint64_t workers,
                                            const LoadOrderOptions& options = {});

/// The bytes that some worker loads, however the work is split. @throws as sized_lower_bound(),
/// BadInput if workers = 0
[[nodiscard]] LoadBound sized_makespan_bound(const ItemSizes& sizes, const WantedPairs& wanted,
                                             std::uint64_t workers);

/// For two levels (loadorder/load_order.hpp); each worker has its own memory and accelerator. An
/// order for all pairs is cut into stretches such that the transfers on both levels of the busiest
/// worker are few. Some pairs only are given to workers as by split_load_order(), and each worker
/// has an order for its own. Verified. @throws as plan_two_levels() and split_order().
[[nodiscard]] WorkerSplit split_two_levels(const WantedPairs& wanted, std::uint64_t room,
                                           std::uint64_t fast_room, std::uint64_t workers,
                                           const LoadOrderOptions& options = {});

/// Splits an order for two levels and items of different sizes (ItemSizes::fast_memory) among
/// workers; the order is always cut into stretches.
[[nodiscard]] WorkerSplit split_two_levels(std::shared_ptr<const ItemSizes> sizes,
                                           const WantedPairs& wanted, std::uint64_t workers,
                                           const LoadOrderOptions& options = {});

/// Returns the shares of one epoch, repeated. Each worker goes through its share forward and
/// backward in turn (loadorder/load_order.hpp), keeps its memory between epochs, and computes the
/// same pairs in each. The result is verified up to 2³⁴ pairs and 2·10⁸ loads in all epochs
/// together, and who computes which pair up to 3·10⁷ pairs; facts().certificate says what was
/// checked. Above 5,000 items owners() is null, except for listed pairs. @throws as repeat_order()
[[nodiscard]] WorkerSplit repeat_shares(WorkerSplit split, std::uint64_t epochs);

// Load orders for workers that step together and never hold one item twice: what training needs,
// where items change.
//
//     LoadOrder order = plan_disjoint_order(64, 8, 4);
//     order.facts().span;                      // what the slowest loads of all steps add up to
//     StepWork work(order.stream(), order.rules(ComputeRules{}));
//     check_schedule(work, order.rules(ComputeRules{})).valid();   // true: disjoint at every step
//
// *A step.* All workers evict; all wait for each other; all load; all compute. One barrier per step
// is enough, between evicting and loading, and an item can move from one worker to another within a
// step. After the loads of a step no two workers hold the same item, so they compute independently.
// All workers have the same number of steps; a worker may have nothing to do in a step.
//
// *The cost.* With a barrier a step takes as long as its slowest worker. The *span* is the sum,
// over all steps, of the most loads of one worker in the step. Orders are compared by span, then by
// the loads of all workers.
//
// *Bounds.* The sets of all workers, end to end, are one list in which all pairs meet: so all loads
// together are at least load_lower_bound(P, C). The busiest worker has at least
// makespan_lower_bound(P, C, W) loads, and the span is no less.
//
// *Where orders come from.* One worker: plan_load_order(). Otherwise the best of
//   eras     W groups of n ≤ C−1 items stay, one at each worker, while all other groups pass, each
//            at another worker in turn; then the groups that stayed meet each other, half of them
//            staying, and are finished. Any P.
//   grown    in each step one item of each worker is changed, by the change that brings most new
//            pairs together, or two workers exchange items; the best of many is cut at random
//            steps and grown again. P ≤ 1,000. The same with groups of items, room for 2 to 8
//            groups, which is better if few items are outside memory.
//   round robin   2W groups, two at each worker: the rounds of a tournament. Span P.
// Of some pairs only, either an order of one worker is cut into stretches, and a worker waits for
// an item that another one has; or the items are in parts, consecutive ones of such an order, and a
// worker has two parts at a time, which no other worker has, with an order for the pairs between
// them. All pairs of at most 300 items are planned in that way, too, if W·C > P.
//
// *More room than items.* If W·C > P, full workers would take items from each other, and fewer may
// be ready sooner. So orders are made for W, W/2, W/4, … workers, for P/C and for P/2, with room
// for P/workers items each, at most C, and the best one is used: the others have nothing to do. For
// all pairs, and without a search, the span is then at most that of W/2 workers; if C ≥ P, at most
// P, as for one worker.

/// Returns the best known order, verified by ScheduleCheck. With `options.search_pairs` it is
/// improved until the time is over, otherwise for a fixed amount of work. @throws as
/// plan_load_order(); BadInput if W is 0 or exceeds 65,536; ImpossibleParameters above 65,535
/// items, unless pairs are listed.
[[nodiscard]] LoadOrder plan_disjoint_order(const WantedPairs& wanted, std::uint64_t room,
                                            std::uint64_t workers,
                                            const LoadOrderOptions& options = {});

/// An order for disjoint workers at two levels (loadorder/load_order.hpp), each worker with its own
/// accelerator: an order as that of plan_disjoint_order(), of items in groups, and after each of
/// its steps what groups meet for the first time is done on the accelerators, in several steps.
/// Verified. @throws as plan_disjoint_order() and plan_two_levels()
[[nodiscard]] LoadOrder plan_disjoint_levels(const WantedPairs& wanted, std::uint64_t room,
                                             std::uint64_t fast_room, std::uint64_t workers,
                                             const LoadOrderOptions& options = {});

/// For items of different sizes, whose bytes are counted at both levels (ItemSizes::fast_memory).
/// Verified. @throws as plan_disjoint_order() and plan_two_levels() of such items
[[nodiscard]] LoadOrder plan_disjoint_levels(std::shared_ptr<const ItemSizes> sizes,
                                             const WantedPairs& wanted, std::uint64_t workers,
                                             const LoadOrderOptions& options = {});

/// For items of different sizes (loadorder/load_order.hpp), whose bytes are counted: the span in
/// bytes is as small as we know how. Items are packed into groups, of which some fit at each
/// worker, and these follow an order as above; or an order of one worker is cut into stretches.
/// Verified.
/// @throws as plan_sized_order(), BadInput if W is 0 or exceeds 65,536
[[nodiscard]] LoadOrder plan_disjoint_order(std::shared_ptr<const ItemSizes> sizes,
                                            const WantedPairs& wanted, std::uint64_t workers,
                                            const LoadOrderOptions& options = {});

// When pairs are computed and items loaded, so that loads overlap computation.
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
// *Two ways.* With an order for room C−1 one place is free, so the next load starts as soon as a
// step begins, and all computation overlaps it. An order for the whole room has fewer loads, but a
// load needs the place of the evicted item y: the pairs with y are computed first, and only the
// other pairs overlap. If y was loaded some steps before, there is one such pair of C−1, and this
// way is faster. If y was loaded last, because items pass through the same place one by one,
// nothing overlaps, and the first way is much faster.
//
// plan_prefetch() compares both in a model. A load takes as long as C−1 pairs, where overlap
// matters most. A step takes the time of the pairs computed first, plus that of its `overlap` or of
// the next loads, whichever is longer. Above 2,000 items the free place is used, since streamed
// orders pass items one by one.
//
// *Each pair once.* A pair is computed in the first step that has both items in memory. For more
// than 65,535 items computed pairs are not tracked: every loaded item is computed against all in
// memory, and a pair may be computed again.

// *Items with sizes.* Instead of a place the bytes of the largest item are free. A load of b bytes
// takes as long as b/s items of their mean size s, and these as long as the pairs that they can
// bring together.

/// An order, and what it leaves free for loads in progress.
template <typename Order>
struct Prefetched {
  Order order;
  std::uint64_t spare = 0;  ///< 0 or 1: the order is for room − spare; of items with sizes bytes
};
using PrefetchPlan = Prefetched<LoadOrder>;
using PrefetchSplit = Prefetched<WorkerSplit>;  ///< for several workers

/// The better of the two ways. @throws as plan_load_order().
[[nodiscard]] PrefetchPlan plan_prefetch(const WantedPairs& wanted, std::uint64_t room,
                                         const LoadOrderOptions& options = {});

/// A split that loads while pairs are computed, with or without a place that is kept for loads: the
/// way whose busiest worker finishes first. @throws as split_load_order().
[[nodiscard]] PrefetchSplit split_prefetch(const WantedPairs& wanted, std::uint64_t room,
                                           std::uint64_t workers,
                                           const LoadOrderOptions& options = {});

/// For items of different sizes. The order has the facts and bounds of the whole memory. @throws as
/// plan_sized_order() and split_sized_order()
[[nodiscard]] PrefetchPlan plan_prefetch(const std::shared_ptr<const ItemSizes>& sizes,
                                         const WantedPairs& wanted,
                                         const LoadOrderOptions& options = {});
[[nodiscard]] PrefetchSplit split_prefetch(const std::shared_ptr<const ItemSizes>& sizes,
                                           const WantedPairs& wanted, std::uint64_t workers,
                                           const LoadOrderOptions& options = {});

// Two levels: what is computed is on the accelerator, so any item of memory beside these can make
// way, and loads can start many steps before the transfer that needs them.
//
//     LoadOrder order = start_loads_early(plan_two_levels(200, 40, 8));
//     // each step: fast_evict, evict, start `load`, wait for what is transferred, fast_load,
//     // compute

/// The given order or split at two levels with the same transfers and pairs, and each load as early
/// as memory has room for it. What memory leaves free for loads is the best of some numbers, in the
/// model above with one disk that loads item by item. ScheduleFacts::ahead counts the loads of
/// earlier steps. Verified. @throws ImpossibleParameters above 5·10⁷ moves
[[nodiscard]] LoadOrder start_loads_early(LoadOrder order);
[[nodiscard]] WorkerSplit start_loads_early(WorkerSplit split);

}  // namespace changeover
