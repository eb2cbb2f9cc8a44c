// Schedules: what is evicted, stored, loaded, transferred and computed in each step, and a check
// that it is right.
//
//     ScheduleRules rules{.items = 24, .room = 6, .compute = ComputeRules{}};
//     StepWork work(plan_load_order(24, 6).stream(), rules);
//     ScheduleCheck check(rules);
//     for (Step step; work.next(step);) {
//       check.read(step);
//     }
//     check.finish().valid();                  // true: each pair computed once, with both items
//
// *A schedule* is a stream of steps. All schedules have the same kind of step and the same check:
// load orders, their shares for workers, workers in lockstep, and loads that overlap computation
// (loadorder/workers.hpp); what is computed and stored, and two levels of memory
// (loadorder/load_order.hpp). The steps of a source are a claim; ScheduleCheck verifies it.
//
// *Checked in every step.* The steps of a worker are numbered 1, 2, …; evicted items are in memory;
// loaded items exist and are not in memory; at most `room` items are in memory or being loaded. For
// two levels: the same for the accelerator, whose items stay in memory. For workers in lockstep: no
// item is held twice. For items with sizes: their bytes fit into memory. Computed pairs are wanted,
// with both items in memory. Stored items were changed, and no change is lost.
// *Checked at the end.* Every wanted pair was together in a memory (for two levels, on the
// accelerator), or was computed exactly once. For several *epochs*: each worker's steps go through
// them in turn, memory stays as it is between them, and all of this holds in each.
//
// *Memory.* All pairs take C(P,2) bits, up to P = 65,535 (268 MB); listed pairs take two bits each.
// Above that, or on request, only *watched* items are tracked: for each of them, chosen by a seed,
// the check is whether all other items met it. A wrong order in which a share p of the items misses
// pairs escapes n watched items with probability (1−p)ⁿ; the other checks are complete either way.
//
// Complexity: O(C) per load if pairs have to meet, or one word per 64 pairs whose numbers are close
// to each other; O(watched) per load if items are watched; O(1) per computed pair.
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

/// The moves before one stretch of computation, and what is computed then. In this order: items
/// leave the accelerator, are stored, evicted, loaded, and transferred to the accelerator; pairs
/// are computed. A schedule fills the lists that it needs; the others are empty.
struct Step {
  std::uint64_t number = 0;            ///< of its worker, from 1
  std::vector<Element> evict = {};     ///< leave memory
  std::vector<Element> load = {};      ///< come into memory
  std::vector<ItemPair> compute = {};  ///< smaller item first unless pairs are ordered
  std::vector<ItemPair> overlap = {};  ///< computed while the loads of the next step run
  std::size_t late =
      0;  ///< the last ones of `evict`, which leave when the step before is over; the
          ///< others leave before the loads start
  std::vector<Element> store = {};  ///< the items of `evict` that have changed, in the same order
  std::vector<Element> fast_evict = {};  ///< leave the accelerator
  std::vector<Element> fast_load = {};   ///< come from memory onto the accelerator
  std::uint64_t worker = 0;              ///< from 0
  std::uint64_t epoch = 1;               ///< of its worker, from 1

  bool operator==(const Step&) const = default;
};

/// A stream of steps, read one at a time, so an order of 10⁹ steps needs no memory for them.
/// Workers follow one another or, in lockstep, alternate.
class StepSource {
 public:
  virtual ~StepSource() = default;
  StepSource(const StepSource&) = delete;
  StepSource& operator=(const StepSource&) = delete;

  /// Writes the next step into `step`, whose vectors are reused, and returns true; false at the
  /// end. Lists that this source does not fill stay as they are: pass a new step, or one that this
  /// source has filled.
  virtual bool next(Step& step) = 0;

  /// Makes step `step` (from 1) the next one without reading those before, in O(room), and writes
  /// what is in memory before it into `held`, in any order. Returns false, and changes nothing, if
  /// this source can only be read in sequence or has no such step.
  virtual bool jump(std::uint64_t step, std::vector<Element>& held) {
    static_cast<void>(step);
    static_cast<void>(held);
    return false;
  }

 protected:
  StepSource() = default;
};

/// Which pairs the steps compute.
struct ComputeRules {
  bool ordered = false;  ///< both (i,j) and (j,i), as for the edges from partition i to partition j
  bool self = false;     ///< also (i,i)
  std::optional<std::uint64_t> shuffle = {};  ///< a seed: the pairs of a step are in random order
  /// A seed: a pair is computed in a random one of the steps that have it, balanced over the steps;
  /// otherwise in the first of them.
  std::optional<std::uint64_t> spread = {};
};

/// Items of different sizes, and the size of the memory.
struct ItemSizes {
  std::vector<std::uint64_t> bytes;  ///< by item
  std::uint64_t memory = 0;          ///< in bytes, of each worker
  std::uint64_t fast_memory = 0;     ///< of two levels: in bytes, on the accelerator

  bool operator==(const ItemSizes&) const = default;
};

/// The rules of a schedule, the same for its maker and its check.
struct ScheduleRules {
  std::uint64_t items = 0;
  std::uint64_t room = 0;                       ///< items in the memory of each worker
  std::optional<std::uint64_t> fast_room = {};  ///< items on an accelerator, where pairs must meet
  std::uint64_t lockstep = 0;  ///< number of workers that step together; 0 if not in lockstep
  WantedPairs wanted = {};
  std::optional<ComputeRules> compute =
      {};                ///< each pair is computed once; without it, every pair meets
  bool overlap = false;  ///< loads run while pairs of the step before are computed
  bool store = false;    ///< computing a pair changes both items
  std::shared_ptr<const ItemSizes> sizes = {};  ///< item sizes; the items in memory must fit
  std::uint64_t epochs = 1;  ///< every pair meets, or is computed, in each of them
  bool shares = false;       ///< whether workers follow one another in each of several epochs
};

/// Counts of a schedule.
struct ScheduleFacts {
  std::uint64_t steps = 0;  ///< of all workers; in lockstep, of each worker
  std::uint64_t loads = 0;
  std::uint64_t transfers = 0;  ///< to the accelerator
  std::uint64_t ahead =
      0;  ///< of two levels: loads in a step before the first transfer of the item
  std::uint64_t stores = 0;
  std::uint64_t computed = 0;    ///< pairs, including repeated ones, and items alone
  std::uint64_t overlapped = 0;  ///< of these, how many while loads run
  std::uint64_t span = 0;  ///< in lockstep: the sum over steps of the most loads of one worker
  std::uint64_t span_bytes = 0;  ///< the same sum of bytes, if items have sizes
  std::uint64_t most_in_memory = 0;
  std::uint64_t bytes = 0;                 ///< loaded, if items have sizes
  std::uint64_t most_bytes = 0;            ///< in memory, of one worker
  std::uint64_t transfer_bytes = 0;        ///< to the accelerator, if items have sizes
  std::uint64_t most_in_a_step = 0;        ///< pairs computed, of one worker
  std::vector<std::uint64_t> epoch_loads;  ///< of all workers
  std::vector<std::uint64_t> worker_loads;
  std::vector<std::uint64_t> worker_bytes;  ///< loaded by each, if items have sizes
  /// Pairs computed by each worker, including items alone. For workers one after another whose
  /// pairs only have to meet: the pairs that met first at each, if requested
  /// (CheckOptions::by_worker).
  std::vector<std::uint64_t> worker_pairs;

  /// Returns the loads of the busiest worker.
  [[nodiscard]] std::uint64_t makespan() const {
    return worker_loads.empty() ? loads
                                : *std::max_element(worker_loads.begin(), worker_loads.end());
  }
  /// Returns the most bytes that a worker loads, if items have sizes.
  [[nodiscard]] std::uint64_t makespan_bytes() const {
    return worker_bytes.empty() ? bytes
                                : *std::max_element(worker_bytes.begin(), worker_bytes.end());
  }
};

struct ScheduleVerdict : ScheduleFacts {
  std::string fault;           ///< the first wrong step, in one line; empty if there is none
  std::uint64_t missing = 0;   ///< tracked pairs that never met or were not computed
  std::uint64_t repeated = 0;  ///< pairs computed more than once
  std::string example;         ///< a pair that never met, such as "{3,7}"; empty if there is none
  std::uint64_t watched_items = 0;  ///< items whose pairs were tracked: all, or a few

  [[nodiscard]] bool valid() const {
    return steps > 0 && fault.empty() && missing == 0 && repeated == 0;
  }
};

/// How pairs are tracked.
struct CheckOptions {
  /// Needs items ≤ 65,535 unless pairs are listed; above that, computed pairs are not tracked.
  bool all_pairs = true;
  std::uint64_t watched = 64;  ///< number of items to track otherwise, if pairs have to meet
  std::uint64_t seed = 1;      ///< for choosing them
  /// A permutation that gives items that are in memory together numbers close to each other, so
  /// that the bits of their pairs share cache lines. It does not change the verdict. Empty for
  /// none.
  std::vector<Element> kept_as = {};
  bool by_worker = false;  ///< whether to count the pairs that first meet at each worker
};

/// Replays the steps and trusts nothing else.
class ScheduleCheck {
 public:
  /// @throws BadInput if items or room is 0, or kept_as is not a permutation of the items;
  /// MissingResource if all pairs of more than 65,535 items are to be tracked.
  explicit ScheduleCheck(const ScheduleRules& rules, const CheckOptions& options = {});
  ~ScheduleCheck();
  ScheduleCheck(ScheduleCheck&&) noexcept;

  /// Reads the next step. A change of the worker starts with an empty memory. After the first fault
  /// further steps are ignored.
  void read(const Step& step);

  /// The verdict on the steps that were read.
  [[nodiscard]] ScheduleVerdict finish();

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// Reads a whole stream; stops when the control of its thread (run/control.hpp) requests it.
/// @throws as ScheduleCheck
[[nodiscard]] ScheduleVerdict check_schedule(StepSource& steps, const ScheduleRules& rules,
                                             const CheckOptions& options = {});

}  // namespace changeover
