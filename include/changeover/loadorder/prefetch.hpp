// When what is computed and loaded, so that loads overlap computation.
//
//     PrefetchPlan plan = plan_prefetch(64, 16);
//     PrefetchSchedule schedule(plan.order.stream(), 64, 16);
//     PrefetchStep step, next;
//     for (bool more = schedule.next(step); more; std::swap(step, next)) {
//       wait_for(step.load);                       // these loads were started in the step before
//       compute(step.before);                      // all pairs with what has to go first
//       next = {};
//       more = schedule.next(next);
//       drop(next.evict_first);
//       start_loads(next.load);
//       compute(step.overlap);                     // meanwhile
//       drop(next.evict_late);
//     }
//
// *Two ways.* With a place to spare, an order for room C−1, the next load can start as soon as a step
// begins, and everything that is computed overlaps it. With the whole room for the order there are fewer
// loads, but the next one needs the place of the item y that goes: the pairs with y come first, and only
// the others overlap. If y came a while ago that is one pair of C−1, and this way wins. If y is what was loaded last,
// because items pass one by one through the same place, nothing overlaps, and the first way wins by far.
//
// plan_prefetch() compares both in a model: a load takes as long as C−1 pairs do, which is where overlap
// matters most; a step takes the time of its `before`, and then of its `overlap` or of the next loads,
// whichever is longer. For more than 2,000 items the spare place is taken, since streamed orders pass
// items one by one.
//
// *Each pair once.* A pair is computed in the first step that has both in memory. For more than 65,535 items
// pairs are not kept in mind; then every loaded item is computed against all in memory, and a pair may
// come again.
//
// PrefetchCheck simulates a schedule and trusts nothing else.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

class WantedSet;

/// One step, and how the loads that it begins with were made room for in the step before.
struct PrefetchStep {
  std::uint64_t number = 0;          ///< from 1
  std::vector<Element> evict_first;  ///< before these loads start
  std::vector<Element> evict_late;   ///< when the step before is over
  std::vector<Element> load;
  std::vector<ItemPair> before;   ///< computed before the next step's loads start
  std::vector<ItemPair> overlap;  ///< computed while they run
};

/// Steps with their pairs, one step of look-ahead.
class PrefetchSchedule {
 public:
  /// `room` counts what is on its way; it may exceed that of the order.
  PrefetchSchedule(std::unique_ptr<StepSource> steps, std::uint64_t items, std::uint64_t room,
                   const WantedPairs& wanted = {});
  ~PrefetchSchedule();
  PrefetchSchedule(PrefetchSchedule&&) noexcept;

  /// The next step; false at the end. O(C) a load.
  bool next(PrefetchStep& step);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// An order and the places that it leaves for loads on their way.
struct PrefetchPlan {
  LoadOrder order;
  std::uint64_t spare = 0;  ///< 0 or 1: the order is for room − spare
};

/// The better of the two ways. @throws as plan_load_order().
[[nodiscard]] PrefetchPlan plan_prefetch(std::uint64_t items, std::uint64_t room,
                                         const LoadOrderOptions& options = {});
[[nodiscard]] PrefetchPlan plan_prefetch(const WantedPairs& wanted, std::uint64_t room,
                                         const LoadOrderOptions& options = {});

struct PrefetchVerdict {
  std::string fault;  ///< the first step that is wrong; empty if none
  std::uint64_t steps = 0;
  std::uint64_t computed = 0;    ///< pairs, with repetition
  std::uint64_t overlapped = 0;  ///< of these, while a load runs
  std::uint64_t missing = 0;     ///< pairs that were not computed
  std::uint64_t repeated = 0;    ///< pairs that were computed more than once

  [[nodiscard]] bool valid() const {
    return fault.empty() && steps > 0 && missing == 0 && repeated == 0;
  }
};

/// Plays a schedule: never more than `room` items in memory or on their way, pairs only of items that
/// have arrived, every wanted pair exactly once. At most 65,535 items unless pairs are listed.
class PrefetchCheck {
 public:
  PrefetchCheck(std::uint64_t items, std::uint64_t room, const WantedPairs& wanted = {});
  ~PrefetchCheck();

  void read(const PrefetchStep& step);
  [[nodiscard]] PrefetchVerdict finish();

 private:
  void compute(const std::vector<ItemPair>& pairs, bool overlapped);
  void evict(const std::vector<Element>& items, std::uint64_t step);
  void fail(std::string fault);

  std::uint64_t room_;
  WantedPairs wanted_;
  std::unique_ptr<WantedSet> done_;
  std::vector<bool> there_;
  std::uint64_t count_ = 0;
  PrefetchStep held_;  // whose second part has not been played
  PrefetchVerdict verdict_;
};

}  // namespace changeover
