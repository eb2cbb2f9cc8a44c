// Load orders: after all steps every pair of P items has been in memory together, with room for C.
//
//     LoadOrder order = plan_load_order(64, 16);
//     order.facts().loads;                    // facts().bound.loads = 144 are needed
//     Step step;
//     while (order.next(step)) {              // one by one; nothing is kept
//       std::cout << step.number << ": " << step.load.size() << '\n';
//     }
//
// *What an order is.* In a step some items are evicted and some loaded; at most C are in memory.
// Its cost is the number of loads, those of the first step included; orders with equally many are
// told apart by their steps. An m-change covering design with b blocks of C elements is an order of
// b steps and C + m(b−1) loads: m = 1 is the natural choice, since its steps cover most pairs a
// load.
//
// *The lower bound.* P ≤ C needs P loads. Otherwise any order has at least C + b₁ − 1, b₁ a lower
// bound on the blocks of a linear single-change design SCCD(P,C). For let an order be given, also
// one whose steps load several items. Write its loads one by one, x₁, …, x_L, and be lazy: evict
// only when memory is full, then an item that the order has evicted by the end of the step, and
// skip a load of what is still there. What is in memory after a step then contains what the order
// has there, so all pairs still meet, and no load was added. As P > C, memory fills up, and from
// then on it holds C items that change one at a time: a linear SCCD(P,C) of as many blocks as there
// are loads from the C-th on. So L ≥ C + b₁ − 1.
//
// *Where orders come from.* The best of
//   registry   every construction for m = 1, 2, 3, circular ones read as linear
//              (P ≤ 2,000 or P < 16C)
//   rules      closure rules over the parameters around (P ≤ 120)
//   streamed   for any P and C, made as it goes: r rounds hold C−1 items while the others pass,
//              then the tight circular design on 2c(C−1)+1 items [ChafeeStevens2023] with w ≤ C−1
//              further items that pass beside 2c of its unchanged subsets
//   improve    whatever you plug in: a local search, say, started from the best so far
//
// *Certificate.* For P ≤ `read_up_to` every step is read before plan_load_order() returns
// (loadorder/schedule.hpp): C(P,2) bits of memory. For more items the streamed order is taken and
// certified by its structure: the differences of its base blocks (verify/difference.hpp) and the
// argument of docs/loadorder.md; facts().certificate says which. A caller that streams such an
// order can have it audited on the way (ScheduleCheck).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/loadorder/schedule.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

/// A number of loads that no order can go below.
struct LoadBound {
  std::uint64_t loads = 0;
  std::string reason;  ///< one line of plain mathematics
};

/// The loads that no order for these pairs can go below; load_lower_bound(64, 16): the bound of the
/// summary above. @throws BadInput if items = 0 or room < 2; ImpossibleParameters if all pairs of
/// more than 10⁷ items are wanted.
[[nodiscard]] LoadBound load_lower_bound(const WantedPairs& wanted, std::uint64_t room);

/// What is known of an order before its first step.
struct LoadOrderFacts : ScheduleFacts {
  std::uint64_t items = 0;
  std::uint64_t room = 0;   ///< of each worker
  LoadBound bound;          ///< no order of any workers has fewer loads together
  std::string method;       ///< name of a construction, "one-step", "streamed" or "improved"
  std::string explanation;  ///< one line: how the steps are made
  std::string certificate;  ///< one line: how it was verified
  bool every_step_read = false;
  WantedPairs wanted = {};  ///< the pairs that meet

  std::uint64_t lockstep = 0;  ///< workers (loadorder/workers.hpp); 0: one, or one after another
  LoadBound makespan_bound =
      {};  ///< no order of these workers has a smaller makespan, nor a smaller span
  std::optional<std::uint64_t> fast_room = {};  ///< of an accelerator (loadorder/load_order.hpp)
  LoadBound transfer_bound = {};                ///< no order transfers less to it
  std::uint64_t group_items = 0;                ///< of its groups; 0 if items are not grouped
  std::shared_ptr<const ItemSizes> sizes = {};  ///< of items; then room is the most that fit
  LoadBound byte_bound = {};                    ///< no order loads fewer bytes, if items have sizes
  std::uint64_t epochs = 1;                     ///< in each of which all pairs meet

  /// loads / bound − 1; of items with sizes the same of bytes.
  [[nodiscard]] double gap() const;
};

class PairOwners;

struct LoadOrderOptions {
  /// Given the best linear SCCD(items, room) so far, a better one if there is any. Not asked if the
  /// bound is attained or for more than `improve_up_to` items. The result is verified.
  std::function<std::optional<Design>(const Design& start, std::uint64_t least_blocks)> improve;
  std::uint64_t improve_up_to = 2000;
  /// Orders of at most so many items are read, step by step, before they are handed out; at most
  /// 65,535.
  std::uint64_t read_up_to = 65'535;
  /// Whether they are read then. Otherwise the caller has the order read, by ScheduleCheck beside
  /// its own work, say: facts().every_step_read is false, and the order the same.
  bool read_first = true;
  bool constructions = true;  ///< whether the registry is asked
  bool closure_rules = true;  ///< and then the closure rules
  /// Of an order for listed pairs: given a search that goes on until the control of its thread
  /// (run/control.hpp) wants to stop, calls it. Without it the search does a fixed amount of work,
  /// a few seconds at most.
  std::function<void(const std::function<void()>& search)> search_pairs = {};
  std::uint64_t seed = 1;  ///< of that search
  /// Of workers: whether pairs are spread evenly over those that have them; otherwise the first
  /// worker that has a pair computes it.
  bool balance = true;
  /// What a pair costs to compute, smaller item first: then costs are spread evenly instead of
  /// numbers. None below 0.
  std::function<double(Element, Element)> pair_cost = {};
};

/// An order that starts at its first step. Movable; stream() gives independent readers.
class LoadOrder {
 public:
  using Maker = std::function<std::unique_ptr<StepSource>()>;

  /// An order of your own: `maker` makes readers that start at the first step. Nothing is checked.
  LoadOrder(LoadOrderFacts facts, Maker maker);

  [[nodiscard]] const LoadOrderFacts& facts() const { return facts_; }

  /// What the steps keep to, for StepWork and ScheduleCheck.
  [[nodiscard]] ScheduleRules rules(const std::optional<ComputeRules>& compute = {}) const {
    return {.items = facts_.items,
            .room = facts_.room,
            .fast_room = facts_.fast_room,
            .lockstep = facts_.lockstep,
            .wanted = facts_.wanted,
            .compute = compute,
            .sizes = facts_.sizes,
            .epochs = facts_.epochs};
  }

  /// The next step; false at the end. O(1) amortised a load for streamed orders, O(C) otherwise.
  bool next(Step& step) {
    if (!reader_) {
      rewind();
    }
    return reader_->next(step);
  }

  /// Back to the first step.
  void rewind() { reader_ = maker_(); }

  /// What makes readers.
  [[nodiscard]] const Maker& maker() const { return maker_; }

  /// Another reader, at the first step. It may be used on another thread and outlive this.
  [[nodiscard]] std::unique_ptr<StepSource> stream() const { return maker_(); }

  /// The steps from `step` on, numbered as in the order; the first of them loads all that is in
  /// memory then, and evicts nothing. O(C) of streamed orders, otherwise the steps before are read.
  /// Not of workers in lockstep. @throws BadInput if there is no such step.
  [[nodiscard]] std::unique_ptr<StepSource> stream_from(std::uint64_t step) const;

  /// The steps of one worker of those in lockstep. @throws BadInput if there is no such worker.
  [[nodiscard]] std::unique_ptr<StepSource> stream(std::uint64_t worker) const;

 private:
  LoadOrderFacts facts_;
  Maker maker_;
  std::unique_ptr<StepSource> reader_;  // none before the first step is asked for
};

/// The best order that is known; for some pairs only, docs/loadorder.md says how. Bound by reading
/// it, see `read_up_to`: 10⁷ to 10⁸ pairs a second. Orders for listed pairs are kept in memory, 8
/// bytes a load, and always read. @throws BadInput if items = 0 or room < 2, one line that says so;
/// ImpossibleParameters if items exceeds 10⁷; InternalError if an order does not keep its promise.
[[nodiscard]] LoadOrder plan_load_order(const WantedPairs& wanted, std::uint64_t room,
                                        const LoadOrderOptions& options = {});

// Items of different size: what is in memory is counted in bytes.
//
//     auto sizes = std::make_shared<const ItemSizes>(ItemSizes{{400, 300, 300, 200, 100}, 900});
//     LoadOrder order = plan_sized_order(sizes, {});
//     order.facts().bytes;                                   // facts().byte_bound.loads are needed
//
// *Where orders come from.* The best of: orders of closing items (docs/loadorder.md), where as much
// is evicted as the next item needs, in the sequence of the numbers or of the sizes, or made better
// by search; and orders of groups that are packed so that K of them fit, for each K, in which what
// goes stays as long as its place is not needed.
//
// *The bounds*, with sizes s_x and memory M. Let a pair weigh the product of its sizes. What a load
// of x brings weighs s_x (M − s_x) at most, and what is loaded before memory can be full brings
// M (M − s)/2 less in all, s being the largest size (the same of the items from some size on, whose
// loads are an order for them): the i-th of these loads finds at most what was
// loaded before it, T, and a sum of s_i (M − T − s_i) is at least the integral of M − t less
// triangles s_i²/2. And if sizes are multiples of a unit, items are so many units that move
// together, of which all pairs meet: load_lower_bound() of the units, with room for M of them.

/// An order for all pairs, or those that are wanted, verified. @throws BadInput if items are none,
/// have no byte or do not fit, alone or with those that they must meet; ImpossibleParameters above
/// 65,535 items.
[[nodiscard]] LoadOrder plan_sized_order(std::shared_ptr<const ItemSizes> sizes,
                                         const WantedPairs& wanted,
                                         const LoadOrderOptions& options = {});

/// Bytes that no such order goes below. @throws as above
[[nodiscard]] LoadBound sized_lower_bound(const ItemSizes& sizes, const WantedPairs& wanted);

// Epochs: training goes over all pairs again and again.
//
//     LoadOrder order = repeat_order(plan_load_order(64, 16), 10);
//     order.facts().epoch_loads;               // 149, and then 133 in each epoch
//
// *How.* Epochs go forward and backward in turn. In a step that is undone the same items are held,
// so all pairs meet backward, too; and an epoch begins with a memory full of what it needs first.
// It loads what the epoch before evicted: C items fewer, if memory is full at the end.
//
// *The bound.* What W memories hold when an epoch begins and what is loaded in it make an order of
// one epoch, so an epoch has at least load_lower_bound() − W·C loads; and of all pairs at most
// W·C(C,2) are there, a load bringing C − 1 at most. The first epoch has load_lower_bound().

/// No order has more epochs.
inline constexpr std::uint64_t most_epochs = 100'000;

/// The order of one epoch again and again, of workers in lockstep and of two levels, too; read once
/// more unless that would take longer than a minute. Each reader keeps what moves in an epoch in
/// memory, 4 bytes a load and an eviction. @throws BadInput unless 1 ≤ epochs ≤ most_epochs and the
/// order has one epoch; ImpossibleParameters, also from readers, above 4·10⁸ loads and evictions;
/// InternalError if it does not keep its promise
[[nodiscard]] LoadOrder repeat_order(LoadOrder order, std::uint64_t epochs);

/// The loads that no order of so many epochs, of `pairs` pairs, can go below, given the bound for
/// one of them.
[[nodiscard]] LoadBound epochs_lower_bound(const LoadBound& once, std::uint64_t pairs,
                                           std::uint64_t room, std::uint64_t workers,
                                           std::uint64_t epochs);

/// A linear design as an order; steps load what a block introduces. @throws BadInput if it is
/// circular (set its kind to linear first) or has no block.
[[nodiscard]] LoadOrder load_order_of(std::shared_ptr<const Design> design, std::string method,
                                      std::string explanation);

// Local search as what improves load orders.
//
//     RunControl control({.time = std::chrono::seconds(1)});
//     LoadOrderOptions options;
//     options.improve = improve_by_search(control);
//     LoadOrder order = plan_load_order(37, 9, options);  // no more loads than without the search
//
// See search/local_search.hpp for what it does with the time.

/// For LoadOrderOptions::improve. The control must outlive what is returned; a search that it has
/// stopped before is not begun.
[[nodiscard]] std::function<std::optional<Design>(const Design& start, std::uint64_t least_blocks)>
improve_by_search(RunControl& control);

// Load orders for two levels: items lie on a disk, C of them fit into memory, and c ≤ C of these on
// an accelerator, where every pair must be together at some time.
//
//     LoadOrder order = plan_two_levels(200, 40, 8);
//     order.facts().loads;                     // from the disk
//     order.facts().transfers;                 // from memory to the accelerator
//     check_schedule(*order.stream(), order.rules()).valid();                    // true
//
// *A step.* Items leave the accelerator; items leave memory; items are loaded from the disk; items
// are transferred to the accelerator; then the pairs are computed that are there together for the
// first time, which StepWork lists (loadorder/load_order.hpp). What is on the accelerator stays in
// memory.
//
// *Bounds.* What is in memory brings every pair together, too: loads are at least
// load_lower_bound(P, C), and transfers at least load_lower_bound(P, c).
//
// *How.* The items are in G groups of g. An order of groups, with room for ⌊C/g⌋ of them, says what
// is loaded. When it has loaded a group, the pairs of its items with those of the groups that it
// now meets for the first time are done at once: c − 1 of its items stay on the accelerator while
// all others pass (plan_load_order() for two sets, or for new items). What the accelerator still
// has is not transferred again. Groups of one item make loads few and transfers many, one a pair;
// groups of C/2 items the other way round. From g ≈ c − 1 on a transfer brings some c − 1 pairs,
// and as long as g is much less than C a load brings some C − 1. Of the sizes that are tried the
// one with the least loads / bound + transfers / bound is taken. Where c is not much less than C no
// size does well; then the order for the accelerator alone, plan_load_order(P, c), may be better,
// with memory as a cache from which goes what is needed last.

/// The best order that is known, verified by ScheduleCheck: every pair meets on the accelerator; of
/// up to 7,746 items the pairs that StepWork lists, too. @throws BadInput unless 2 ≤ fast_room ≤
/// room and items ≥ 1; ImpossibleParameters above 65,535 items.
[[nodiscard]] LoadOrder plan_two_levels(std::uint64_t items, std::uint64_t room,
                                        std::uint64_t fast_room);

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
// and an item with itself to the step that first loads it; or, if they are spread, to a random step
// in which a worker has it, evened over steps. Of several epochs that is so in each. For more than
// 65,535 items whose pairs are not listed, pairs are not kept in mind: then every loaded item is
// computed against all in memory, and a pair may come again. Steps of two levels say themselves
// which pairs meet on the accelerator for the first time.
//
// *Overlap* (loadorder/workers.hpp): what the next step evicts goes early as far as its loads need
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

class StepWork final : public StepSource {
 public:
  /// Steps that say what is evicted and loaded, with the work that `rules` ask for. Without
  /// rules.compute no pairs are said, so nothing changes and nothing is stored. Of workers one
  /// after another, or of one of them, `owners` say who computes what (loadorder/workers.hpp);
  /// without them it is the first that has it.
  StepWork(std::unique_ptr<StepSource> steps, const ScheduleRules& rules,
           std::shared_ptr<const PairOwners> owners = nullptr);
  ~StepWork() override;

  /// The next step; false at the end. O(C) a load.
  bool next(Step& step) override;

 private:
  std::unique_ptr<StepSource> steps_;
};

/// Stores that no order of these loads can go below, given the bound on loads; `alone` says that
/// items are computed alone, too.
[[nodiscard]] LoadBound store_lower_bound(const LoadBound& loads, const WantedPairs& wanted,
                                          std::uint64_t items, bool alone);

}  // namespace changeover
