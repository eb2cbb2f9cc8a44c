// Plans in which pairs have to meet, by annealing one list (anneal/anneal.hpp).
#pragma once

#include <functional>
#include <optional>

#include "changeover/plan/run_plan.hpp"
#include "plan/search/starts/starts.hpp"

namespace changeover {

/// What plans by pairs do differently.
struct PairsWork {
  /// The best list within the budget, no worse than this one, which is within it. Adds its moves to
  /// those of the plan.
  std::function<Start(RunPlan& plan, Amount budget, const Candidate& best)> within;
  /// A weight that no list within the budget exceeds.
  std::function<Amount(Amount budget)> most_weight = {};
  /// A better order of the cheapest plan, which costs no more.
  std::function<Start(const Candidate& cheapest)> at_last = {};
};

/// make_run_plan() for a job of pairs without first set-ups and without defects: designs that are
/// known, a greedy list, the rest of a list under way, all lists of a small job, and longer and
/// longer annealings from the best so far.
[[nodiscard]] RunPlan plan_by_pairs(const Job& job, const PlanOptions& options, RunControl& control,
                                    const PairsWork& work);

/// The same where all pairs are worth the same: within a budget as many as can be.
[[nodiscard]] RunPlan plan_for_pairs(const Job& job, const PlanOptions& options,
                                     RunControl& control);

}  // namespace changeover
