// Schedules: what is evicted, stored, loaded, transferred and computed, step by step; and whether
// it is right.
//
//     ScheduleRules rules{.items = 24, .room = 6, .compute = ComputeRules{}};
//     StepWork work(plan_load_order(24, 6).stream(), rules);
//     ScheduleCheck check(rules);
//     for (Step step; work.next(step);) {
//       check.read(step);
//     }
//     check.finish().valid();                  // true: each pair computed once, with both items
//
// *A schedule* is a stream of steps. There is one kind of step, and one check of all schedules:
// load orders, their shares for workers (loadorder/workers.hpp), workers in lockstep
// (disjoint.hpp), what is computed and stored (step_work.hpp), loads that overlap computation
// (prefetch.hpp), two levels of memory (two_levels.hpp). What a source hands out is a claim;
// ScheduleCheck decides.
//
// *Checked of every step.* Steps of a worker are numbered 1, 2, …; what is evicted is there; what
// is loaded is an item and is not; at most `room` items are in memory or on their way. Of two
// levels: the same of the accelerator, and what is there stays in memory. Of workers in lockstep:
// nothing is held twice. If items have sizes, what is in memory has at most so many bytes. What is
// computed is wanted, and both its items are there. What is stored was changed, and no change is
// lost. *At the end:* every wanted pair was together in a memory, of two levels on the accelerator,
// or was computed exactly once. Of several *epochs*: each worker's steps go through them in turn,
// memory stays as it is between them, and all of this is so in each.
//
// *Memory.* Pairs cost C(P,2) bits, up to P = 65,535 (268 MB), listed ones two bits each. Above
// that, or if asked to, only *watched* items are followed: for each of them, chosen by a seed,
// whether all others met it. A wrong order that misses a share p of the items' rows escapes n
// watched items with probability (1−p)ⁿ; the rest of the checks is complete either way.
//
// Complexity: O(C) a load if pairs have to meet, or a word for 64 of them whose names are close to
// each other; O(watched) if some are watched, O(1) for what is computed.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/loadorder/wanted_pairs.hpp"

namespace changeover {

/// What happens before one stretch of computation, and what is computed then. In this order: items
/// leave the accelerator, are stored, are evicted; are loaded, are transferred to the accelerator;
/// pairs are computed. A schedule fills the lists that it is about; the others are empty.
struct Step {
  std::uint64_t number = 0;            ///< of its worker, from 1
  std::vector<Element> evict = {};     ///< leave memory
  std::vector<Element> load = {};      ///< come into memory
  std::vector<ItemPair> compute = {};  ///< smaller item first unless pairs are ordered
  std::vector<ItemPair> overlap = {};  ///< computed while the loads of the next step run
  std::size_t late = 0;  ///< so many of `evict`, the last ones, leave when the step before is over,
                         ///< the others before the loads start
  std::vector<Element> store = {};       ///< those of `evict`, in its order, that have changed
  std::vector<Element> fast_evict = {};  ///< leave the accelerator
  std::vector<Element> fast_load = {};   ///< come from memory to the accelerator
  std::uint64_t worker = 0;              ///< from 0
  std::uint64_t epoch = 1;               ///< of its worker, from 1

  bool operator==(const Step&) const = default;
};

/// A stream of steps: one at a time, so an order of 10⁹ steps needs no memory for them. Workers
/// come one after another, or, in lockstep, by turns.
class StepSource {
 public:
  virtual ~StepSource() = default;
  StepSource(const StepSource&) = delete;
  StepSource& operator=(const StepSource&) = delete;

  /// Writes the next step into `step`, whose vectors are reused, and returns true; false at the
  /// end. Lists that this source does not fill stay as they are: give it a step that is new or its
  /// own.
  virtual bool next(Step& step) = 0;

  /// Makes step `step` the next one, from 1, and writes what is in memory before it into `held`, in
  /// any order; without reading those between, which takes O(room) then. False if this source can
  /// only be read on, or has no such step: nothing has changed.
  virtual bool jump(std::uint64_t step, std::vector<Element>& held) {
    static_cast<void>(step);
    static_cast<void>(held);
    return false;
  }

 protected:
  StepSource() = default;
};

/// What the steps say of pairs.
struct ComputeRules {
  bool ordered = false;  ///< (i,j) and (j,i), as for the edges from partition i to partition j
  bool self = false;     ///< (i,i), too
  std::optional<std::uint64_t> shuffle = {};  ///< a seed: the pairs of a step in random order
  /// A seed: each pair goes to a random step of those that have it, evened over steps; otherwise to
  /// the first of them.
  std::optional<std::uint64_t> spread = {};
};

/// Items of different size, and how much fits into memory.
struct ItemSizes {
  std::vector<std::uint64_t> bytes;  ///< by item
  std::uint64_t memory = 0;          ///< bytes, of each worker

  bool operator==(const ItemSizes&) const = default;
};

/// Which schedule is meant: makers and the check take the same rules.
struct ScheduleRules {
  std::uint64_t items = 0;
  std::uint64_t room = 0;                       ///< of each worker
  std::optional<std::uint64_t> fast_room = {};  ///< of these on an accelerator, where pairs meet
  std::uint64_t lockstep = 0;  ///< workers that step together; 0: one, or one after another
  WantedPairs wanted = {};
  std::optional<ComputeRules> compute = {};  ///< each pair once; otherwise every pair meets
  bool overlap = false;  ///< loads run while pairs of the step before are computed
  bool store = false;    ///< what is computed changes its items
  std::shared_ptr<const ItemSizes> sizes = {};  ///< what is held fits into that memory, too
  std::uint64_t epochs = 1;  ///< in each of which every pair meets, or is computed
  bool shares = false;       ///< of several epochs: whether workers come one after another
};

/// Counts of a schedule.
struct ScheduleFacts {
  std::uint64_t steps = 0;  ///< of all workers; in lockstep those of each
  std::uint64_t loads = 0;
  std::uint64_t transfers = 0;  ///< to the accelerator
  std::uint64_t stores = 0;
  std::uint64_t computed = 0;    ///< pairs, with repetition, and items alone
  std::uint64_t overlapped = 0;  ///< of these, while loads run
  std::uint64_t span = 0;        ///< in lockstep: the most loads of one worker in a step, added up
  std::uint64_t most_in_memory = 0;
  std::uint64_t bytes = 0;                 ///< loaded, if items have sizes
  std::uint64_t most_bytes = 0;            ///< in memory, of one worker
  std::uint64_t most_in_a_step = 0;        ///< computed, of one worker
  std::vector<std::uint64_t> epoch_loads;  ///< of all workers
  std::vector<std::uint64_t> worker_loads;
  /// Computed, items alone included. Of workers one after another whose pairs only have to meet:
  /// that met first at each, if it was asked for.
  std::vector<std::uint64_t> worker_pairs;

  /// The loads of the busiest worker.
  [[nodiscard]] std::uint64_t makespan() const {
    return worker_loads.empty() ? loads
                                : *std::max_element(worker_loads.begin(), worker_loads.end());
  }
};

struct ScheduleVerdict : ScheduleFacts {
  std::string fault;           ///< the first step that is wrong, in one line; empty if none
  std::uint64_t missing = 0;   ///< pairs that never met, or were not computed, of those followed
  std::uint64_t repeated = 0;  ///< pairs that were computed more than once
  std::string example;         ///< a pair that never met, "{3,7}"; empty if none
  std::uint64_t watched_items = 0;  ///< items whose pairs were followed: all of them, or a few

  [[nodiscard]] bool valid() const {
    return steps > 0 && fault.empty() && missing == 0 && repeated == 0;
  }
};

/// How pairs are followed.
struct CheckOptions {
  /// Needs items ≤ 65,535 unless pairs are listed. Of what is computed none are followed otherwise.
  bool all_pairs = true;
  std::uint64_t watched = 64;  ///< items to follow otherwise, if pairs have to meet
  std::uint64_t seed = 1;      ///< of their choice
  /// Other names of the items, by which what is in memory together has numbers close to each other:
  /// pairs are kept under these names, and their bits share cache lines. Every renaming leads to
  /// the same verdict. Empty: none.
  std::vector<Element> kept_as = {};
  bool by_worker = false;  ///< whether pairs that have to meet are counted where they meet first
};

/// Plays steps and trusts nothing else.
class ScheduleCheck {
 public:
  /// @throws BadInput if items or room is 0, or kept_as is not a permutation of the items;
  /// MissingResource if all pairs of more than 65,535 items are asked for.
  explicit ScheduleCheck(const ScheduleRules& rules, const CheckOptions& options = {});
  ~ScheduleCheck();
  ScheduleCheck(ScheduleCheck&&) noexcept;

  /// Takes the next step. Another worker than that of the step before begins with an empty memory.
  /// After the first fault nothing is looked at any more.
  void read(const Step& step);

  /// What is true of the steps that were read.
  [[nodiscard]] ScheduleVerdict finish();

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// Reads a whole stream; stops if the control of its thread (run/control.hpp) wants to. @throws as
/// ScheduleCheck
[[nodiscard]] ScheduleVerdict check_schedule(StepSource& steps, const ScheduleRules& rules,
                                             const CheckOptions& options = {});

}  // namespace changeover
