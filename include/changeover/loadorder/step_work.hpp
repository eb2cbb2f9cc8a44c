// What each step of a load order computes, without a schedule of loads beside it (loadorder/prefetch.hpp has one).
//
//     LoadOrder order = plan_load_order(24, 6);
//     StepWork work(24, 6, {}, {.ordered = true, .self = true});
//     work.start(order.stream());
//     WorkStep step;
//     while (work.next(step)) {
//       move(step.loads.evict, step.loads.load);
//       compute(step.pairs);                       // (i,j), (j,i) and (i,i), each once in all
//     }
//
// A pair belongs to the first step after whose loads both items are in memory, and an item with itself to the step that
// first loads it; workers come one after another. For more than 65,535 items whose pairs are not listed, pairs are not kept in
// mind: then every loaded item is computed against all in memory, and a pair may come again.
//
// WorkCheck plays steps and trusts nothing else.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

class WantedSet;

struct StepWorkOptions {
  bool ordered = false;  ///< (i,j) and (j,i), as for the edges from partition i to partition j
  bool self = false;     ///< (i,i), too
  std::optional<std::uint64_t> shuffle = {};  ///< a seed: the pairs of a step in random order
};

struct WorkStep {
  LoadStep loads;
  std::vector<ItemPair> pairs;  ///< smaller item first unless they are ordered
};

class StepWork {
 public:
  StepWork(std::uint64_t items, std::uint64_t room, const WantedPairs& wanted = {},
           const StepWorkOptions& options = {});
  ~StepWork();
  StepWork(StepWork&&) noexcept;

  /// The steps to come, from an empty memory; what was computed stays computed.
  void start(std::unique_ptr<StepSource> steps);

  /// The next step; false at the end.
  bool next(WorkStep& step);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

struct WorkVerdict {
  std::string fault;           ///< the first step that is wrong; empty if none
  std::uint64_t computed = 0;  ///< pairs, with repetition, and items with themselves
  std::uint64_t missing = 0;   ///< that were not computed
  std::uint64_t repeated = 0;  ///< that were computed more than once

  [[nodiscard]] bool valid() const { return fault.empty() && missing == 0 && repeated == 0; }
};

/// Each wanted pair exactly once, when both items are in memory; each item with itself, if asked for, once. At most
/// 65,535 items unless pairs are listed.
class WorkCheck {
 public:
  WorkCheck(std::uint64_t items, const WantedPairs& wanted, const StepWorkOptions& options);
  ~WorkCheck();

  /// Another worker's steps follow, from an empty memory.
  void start_over();

  void read(const WorkStep& step);
  [[nodiscard]] WorkVerdict finish() const;

 private:
  void compute(const ItemPair& pair, std::uint64_t step);

  WantedPairs wanted_;
  StepWorkOptions options_;
  std::unique_ptr<WantedSet> upward_;    // smaller item first
  std::unique_ptr<WantedSet> downward_;  // larger item first, if they are ordered
  std::vector<bool> alone_;              // computed with itself
  std::vector<bool> loaded_;
  std::vector<bool> there_;
  WorkVerdict verdict_;
};

}  // namespace changeover
