// Load orders: after all steps every pair of P items has been in memory together, with room for C
// items.
//
//     LoadOrder order = plan_load_order(64, 16);
//     order.facts().loads;                    // facts().bound.loads = 144 are needed
//     Step step;
//     while (order.next(step)) {              // one by one; nothing is kept
//       std::cout << step.number << ": " << step.load.size() << '\n';
//     }
//
// *Definition.* A step evicts some items and loads some; at most C items are in memory. The cost of
// an order is its number of loads, including those of the first step; of orders with equal cost the
// one with fewer steps is better. An m-change covering design with b blocks of C elements is an
// order of b steps and C + m(b−1) loads: m = 1 is the natural choice, since its steps cover the
// most pairs per load.
//
// *The lower bound.* P ≤ C needs P loads. Otherwise any order has at least C + b₁ − 1 loads, where
// b₁ is a lower bound on the blocks of a linear single-change design SCCD(P,C). Proof: take any
// order, also one whose steps load several items. List its loads one by one, x₁, …, x_L. Evict only
// when memory is full, and then an item that the order has evicted by the end of the step; skip the
// load of an item that is still in memory. After each step memory then contains what the order has
// there, so all pairs still meet, with no load added. As P > C, memory fills up, and from then on
// it holds C items that change one at a time: a linear SCCD(P,C) with one block for each load from
// the C-th on. So L ≥ C + b₁ − 1.
//
// *Where orders come from.* The best of
//   registry   every construction for m = 1, 2, 3, circular ones read as linear
//              (P ≤ 2,000 or P < 16C)
//   rules      closure rules over the parameters around (P ≤ 120)
//   streamed   for any P and C, generated step by step: r rounds hold C−1 items while the others
//              pass, then the tight circular design on 2c(C−1)+1 items [ChafeeStevens2023] with
//              w ≤ C−1 further items that pass beside 2c of its unchanged subsets
//   improve    a function of the caller, such as a local search from the best order so far
//
// *Certificate.* For P ≤ `read_up_to` plan_load_order() checks every step before it returns
// (loadorder/schedule.hpp), in C(P,2) bits of memory. For more items it takes the streamed order,
// which is certified by its structure: the differences of its base blocks (verify/difference.hpp)
// and the argument of docs/loadorder.md. facts().certificate says which. A caller can also check
// such an order while streaming it (ScheduleCheck).
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "changeover/core/design.hpp"
#include "changeover/loadorder/schedule.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

/// A lower bound on the number of loads of any order.
struct LoadBound {
  std::uint64_t loads = 0;
  std::string reason;  ///< one line of plain mathematics
};

/// The loads that no order for these pairs can go below; load_lower_bound(64, 16): the bound of the
/// summary above. @throws BadInput if items = 0 or room < 2; ImpossibleParameters if all pairs of
/// more than 10⁷ items are wanted.
[[nodiscard]] LoadBound load_lower_bound(const WantedPairs& wanted, std::uint64_t room);

/// What is known about an order before its first step.
struct LoadOrderFacts : ScheduleFacts {
  std::uint64_t items = 0;
  std::uint64_t room = 0;   ///< of each worker
  LoadBound bound;          ///< a bound for the loads of all workers together
  std::string method;       ///< the name of a construction, "one-step", "streamed" or "improved"
  std::string explanation;  ///< one line: how the steps are made
  std::string certificate;  ///< one line: how the order was verified
  bool every_step_read = false;
  WantedPairs wanted = {};  ///< the pairs that must meet

  std::uint64_t lockstep =
      0;  ///< number of workers in lockstep (loadorder/workers.hpp); 0 if not in lockstep
  LoadBound makespan_bound = {};  ///< bound on the makespan, and so on the span, of these workers
  std::optional<std::uint64_t> fast_room =
      {};                         ///< room on an accelerator, for orders of two levels
  LoadBound transfer_bound = {};  ///< bound on the transfers to the accelerator
  std::uint64_t group_items = 0;  ///< items per group; 0 if items are not grouped
  std::shared_ptr<const ItemSizes> sizes =
      {};  ///< item sizes; if present, room is the largest number of items that fit
  LoadBound byte_bound = {};           ///< bound on the bytes loaded, if items have sizes
  LoadBound transfer_byte_bound = {};  ///< on those transferred to the accelerator
  LoadBound makespan_byte_bound = {};  ///< of workers in lockstep: on those of the busiest
  std::uint64_t epochs = 1;            ///< all pairs meet in each of them

  /// loads / bound − 1; for items with sizes, the same ratio of bytes.
  [[nodiscard]] double gap() const;
};

class PairOwners;

struct LoadOrderOptions {
  /// Given the best linear SCCD(items, room) so far, returns a better one if it finds one. Not
  /// called if the bound is attained, or for more than `improve_up_to` items. The result is
  /// verified.
  std::function<std::optional<Design>(const Design& start, std::uint64_t least_blocks)> improve;
  std::uint64_t improve_up_to = 2000;
  /// Orders of at most this many items (at most 65,535) are verified step by step before they are
  /// returned.
  std::uint64_t read_up_to = 65'535;
  /// Whether plan_load_order() verifies the order before it returns. If not, the caller verifies
  /// it, for example with ScheduleCheck during its own work; facts().every_step_read is false then,
  /// and the order is the same.
  bool read_first = true;
  bool constructions = true;  ///< whether to use the constructions of the registry
  bool closure_rules = true;  ///< whether to use the closure rules, too
  /// For listed pairs: a function that is given a search and calls it. The search runs until the
  /// control of its thread (run/control.hpp) stops it. A fixed amount of work, a few seconds at
  /// most, comes first, which the limit of that control does not cut short, and is all that is done
  /// without this function: a search never gives a worse order than none, nor one that goes on for
  /// longer than one that ends earlier.
  std::function<void(const std::function<void()>& search)> search_pairs = {};
  /// How long the fixed work of one order and its search may take together. Fixed work that would
  /// take longer, and can be cut short, ends with the best so far; then `on_cut_short` is called.
  std::optional<std::chrono::duration<double>> time_in_all = {};
  std::function<void()> on_cut_short = {};
  std::uint64_t seed = 1;  ///< of the search
  double effort = 1;       ///< a share of the fixed amount of work
  /// For workers: whether pairs are spread evenly over the workers that have them; otherwise the
  /// first worker that has a pair computes it.
  bool balance = true;
  /// The cost of computing a pair, smaller item first, not negative: costs are then spread evenly
  /// instead of numbers of pairs.
  std::function<double(Element, Element)> pair_cost = {};
};

/// An order, with a reader at its first step. Movable; stream() returns independent readers.
class LoadOrder {
 public:
  using Maker = std::function<std::unique_ptr<StepSource>()>;

  /// An order of the caller: `maker` makes readers that start at the first step. Nothing is
  /// verified.
  LoadOrder(LoadOrderFacts facts, Maker maker);

  [[nodiscard]] const LoadOrderFacts& facts() const { return facts_; }

  /// The rules of the steps, for StepWork and ScheduleCheck.
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

  /// Reads the next step; false at the end. Streamed orders: amortised O(1) per load; others: O(C).
  bool next(Step& step) {
    if (!reader_) {
      rewind();
    }
    return reader_->next(step);
  }

  /// Returns to the first step.
  void rewind() { reader_ = maker_(); }

  /// The function that makes readers.
  [[nodiscard]] const Maker& maker() const { return maker_; }

  /// Returns another reader at the first step, which may be used on another thread and outlive
  /// this.
  [[nodiscard]] std::unique_ptr<StepSource> stream() const { return maker_(); }

  /// Returns the steps from `step` on, with their numbers; the first of them loads all that is in
  /// memory then, and evicts nothing. O(C) for streamed orders; otherwise the earlier steps are
  /// read. Not for workers in lockstep. @throws BadInput if there is no such step.
  [[nodiscard]] std::unique_ptr<StepSource> stream_from(std::uint64_t step) const;

  /// Returns the steps of one of the workers in lockstep. @throws BadInput if there is no such
  /// worker.
  [[nodiscard]] std::unique_ptr<StepSource> stream(std::uint64_t worker) const;

 private:
  LoadOrderFacts facts_;
  Maker maker_;
  std::unique_ptr<StepSource> reader_;  // null until the first step is read
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
// *Where orders come from.* The best of two kinds. Orders of closing items (docs/loadorder.md)
// evict as much as the next item needs; the sequence is by number or by size, or improved by
// search. Orders of groups pack the items such that K groups fit, for each K; an evicted item stays
// as long as its space is not needed.
//
// *The bounds*, with sizes s_x and memory M. Let the weight of a pair be the product of its sizes.
// A load of x adds pairs of weight at most s_x (M − s_x). The loads before memory can be full add M
// (M − s)/2 less in all, where s is the largest size: such a load, with T bytes loaded before it,
// finds at most T bytes in memory, and a sum of s_i (M − T − s_i) is at least the integral of M − t
// less triangles s_i²/2. The same holds for the items from some size on, whose loads are an order
// for them. If all sizes are multiples of a unit, an item is a number of units that move together
// and of which all pairs meet: so load_lower_bound() of the units applies, with room for M of them.

/// Plans a verified order for all pairs, or for the wanted ones. @throws BadInput if there are no
/// items, an item has no bytes, or one does not fit, alone or with those that it must meet;
/// ImpossibleParameters above 65,535 items.
[[nodiscard]] LoadOrder plan_sized_order(std::shared_ptr<const ItemSizes> sizes,
                                         const WantedPairs& wanted,
                                         const LoadOrderOptions& options = {});

/// A lower bound on the bytes that any such order loads. @throws as above
[[nodiscard]] LoadBound sized_lower_bound(const ItemSizes& sizes, const WantedPairs& wanted);

// Epochs: orders for training, in which all pairs meet again and again.
//
//     LoadOrder order = repeat_order(plan_load_order(64, 16), 10);
//     order.facts().epoch_loads;               // 149, and then 133 in each epoch
//
// *How.* Epochs alternate between forward and backward. A reversed step holds the same items, so
// all pairs meet backward, too. An epoch begins with the items that it needs first already in
// memory: it loads what the epoch before evicted, which is C items fewer if memory is full at the
// end.
//
// *The bound.* The contents of the W memories at the start of an epoch, together with its loads,
// make an order of one epoch: so an epoch has at least load_lower_bound() − W·C loads. Also, at
// most W·C(C,2) pairs are in memory at the start, and a load adds at most C − 1. The first epoch
// has at least load_lower_bound() loads.

/// The limit for the number of epochs.
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

// Local search for improving load orders.
//
//     RunControl control({.time = std::chrono::seconds(1)});
//     LoadOrderOptions options;
//     options.improve = improve_by_search(control);
//     LoadOrder order = plan_load_order(37, 9, options);  // no more loads than without the search
//
// search/local_search.hpp describes how it uses the time.

/// For LoadOrderOptions::improve. The control must outlive the result; once it has stopped a
/// search, no further one is started.
[[nodiscard]] std::function<std::optional<Design>(const Design& start, std::uint64_t least_blocks)>
improve_by_search(RunControl& control);

// Load orders for two levels: items are on a disk, C of them fit into memory, and c ≤ C of these on
// an accelerator, where every pair must be together at some time.
//
//     LoadOrder order = plan_two_levels(200, 40, 8);
//     order.facts().loads;                     // from the disk
//     order.facts().transfers;                 // from memory to the accelerator
//     check_schedule(*order.stream(), order.rules()).valid();                    // true
//
// *A step.* Items leave the accelerator; items are evicted from memory; items are loaded from the
// disk; items are transferred to the accelerator; then the pairs that are there together for the
// first time are computed, which StepWork lists (see below). Items on the accelerator stay in
// memory.
//
// *Bounds.* All pairs also meet in memory: so there are at least load_lower_bound(P, C) loads, and
// at least load_lower_bound(P, c) transfers.
//
// *How.* The items are in G groups of g items. The loads follow an order of groups, with room for
// ⌊C/g⌋ of them. After the load of a group, the pairs of its items with those of the groups that it
// meets for the first time are computed at once: c − 1 of its items stay on the accelerator while
// all others pass (plan_load_order() for two sets, or for new items). Items that are still on the
// accelerator are not transferred again.
//
// Groups of one item give few loads and many transfers, one per pair; groups of C/2 items the
// opposite. From g ≈ c − 1 on a transfer brings about c − 1 pairs together and, as long as g is
// much less than C, a load about C − 1. Of several sizes the one with the least loads / bound +
// transfers / bound is taken. If c is close to C no size is good; then plan_load_order(P, c), the
// order for the accelerator alone, may be better, with memory as a cache that evicts the item
// needed last.
//
// Of some pairs only, memory follows an order for fewer places, b less: b loads are made at once,
// and all pairs that they bring together are done on the accelerator before anything is evicted.

/// Returns the best known order, verified by ScheduleCheck: every pair meets on the accelerator;
/// for up to 30·10⁶ pairs those of StepWork are checked, too. @throws BadInput unless 2 ≤ fast_room
/// ≤ room and items ≥ 1; ImpossibleParameters above 65,535 items, unless pairs are listed.
[[nodiscard]] LoadOrder plan_two_levels(const WantedPairs& wanted, std::uint64_t room,
                                        std::uint64_t fast_room,
                                        const LoadOrderOptions& options = {});

/// For items of different sizes, whose bytes are counted at both levels (ItemSizes::fast_memory).
/// The better of an order for the accelerator alone, with memory as a cache, and of orders as above
/// for groups of items. Verified. @throws as plan_sized_order(), for both memories
[[nodiscard]] LoadOrder plan_two_levels(std::shared_ptr<const ItemSizes> sizes,
                                        const WantedPairs& wanted,
                                        const LoadOrderOptions& options = {});

// The pairs that each step of a schedule computes, and the items that it stores.
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
// *Pairs.* A pair belongs to the first step after whose loads a worker has both items in memory; an
// item with itself belongs to the step that first loads it. If pairs are spread, a pair belongs to
// a random step in which a worker has it, balanced over the steps. For several epochs this holds in
// each. For more than 65,535 items whose pairs are not listed, pairs are not tracked: every loaded
// item is computed against all in memory, and a pair may be computed again. Steps of two levels
// themselves list the pairs that meet on the accelerator for the first time.
//
// *Overlap* (loadorder/workers.hpp): items that the next step evicts are evicted early if its loads
// need their places. Their pairs are computed first, and the others while the loads run.
//
// *Stores.* Computing a pair changes both of its items; computing an item alone changes it. A
// changed item is stored when it is evicted, before anything is loaded; a last step evicts
// everything. So an item is stored once for each *stay* in memory in which it is used. Workers one
// after another cannot change items, since two of them would hold the same item.
//
// *The bound on stores* is that on loads: load_lower_bound(). Proof: take any order with its pairs
// and leave out each stay in which the item is not used. All pairs are still computed with both
// items in memory, and every remaining stay has one load and one store. An item that belongs to no
// pair need not be stored, and is not counted.

class StepWork final : public StepSource {
 public:
  /// Adds to steps with evictions and loads what `rules` require. Without rules.compute there are
  /// no pairs, so nothing changes and nothing is stored. For workers one after another, or for one
  /// of them, `owners` assign the pairs (loadorder/workers.hpp); without them the first worker that
  /// has a pair computes it.
  StepWork(std::unique_ptr<StepSource> steps, const ScheduleRules& rules,
           std::shared_ptr<const PairOwners> owners = nullptr);
  ~StepWork() override;

  /// The next step; false at the end. O(C) per load.
  bool next(Step& step) override;

 private:
  std::unique_ptr<StepSource> steps_;
};

/// A lower bound on the stores, given the bound on loads; `alone`: items are also computed alone.
[[nodiscard]] LoadBound store_lower_bound(const LoadBound& loads, const WantedPairs& wanted,
                                          std::uint64_t items, bool alone);

}  // namespace changeover
