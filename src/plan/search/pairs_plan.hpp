// Plans in which pairs have to meet, by annealing one list (anneal/anneal.hpp).
#pragma once

#include <functional>

#include "changeover/plan/run_plan.hpp"
#include "plan/search/starts/starts.hpp"

namespace changeover {

/// The differences between plans by pairs.
struct PairsWork {
  /// The best list within the budget, at least as good as this one, which is within it. Adds its
  /// moves to those of the plan.
  std::function<Start(RunPlan& plan, Amount budget, const Candidate& best)> within;
  /// An upper bound on the weight of a list within the budget.
  std::function<Amount(Amount budget)> most_weight = {};
  /// A better order of the cheapest plan, at no extra cost.
  std::function<Start(const Candidate& cheapest)> at_last = {};
};

/// make_run_plan() for a job of pairs without first set-ups and without defects: known designs, a
/// greedy list, the rest of the current list, an exhaustive search of a small job, and longer and
/// longer annealing runs from the best so far.
[[nodiscard]] RunPlan plan_by_pairs(const Job& job, const PlanOptions& options, RunControl& control,
                                    const PairsWork& work);

/// The same if all pairs have the same weight: within a budget, as many as possible.
[[nodiscard]] RunPlan plan_for_pairs(const Job& job, const PlanOptions& options,
                                     RunControl& control);

}  // namespace changeover
