// The course of a plan of one list, which the planners of pairs, triples, models and replacement
// costs share: first lists, the rest of the current one, a search, and what a budget pays for.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "changeover/plan/run_plan.hpp"
#include "changeover/run/control.hpp"
#include "plan/search/candidates.hpp"
#include "plan/search/starts/starts.hpp"

namespace changeover {

/// What differs between the planners.
struct ListWork {
  /// Complete lists that are made even if the control requests a stop; at least one.
  std::function<std::vector<Start>(const RunPlan& plan)> sure;
  /// The rest of the current list with what it lacks and without what is needless; nothing if
  /// stopped.
  std::function<std::optional<std::vector<Block>>(const std::vector<Block>& rest)> mended;
  /// Adds better lists to the plan by add_complete().
  std::function<void(RunPlan& plan)> search;
  /// The best lists within the budget, at least as good as `best`, which is within it. Adds its
  /// moves to those of the plan.
  std::function<std::vector<Start>(RunPlan& plan, Amount budget, const Candidate& best)> within;
  /// An upper bound on the weight of a list within the budget, if pairs have weights.
  std::function<Amount(Amount budget)> most_weight = {};
  /// A better order of the best complete plan, at no extra cost.
  std::function<Start(const Candidate& best)> at_last = {};
  CandidateOrder better = cheaper;
};

/// make_run_plan() for a job without first set-ups and without defects. Without a budget, or if it
/// pays for a complete list, the candidates are the complete lists, the best one first; else lists
/// within the budget, the one that tests most first.
[[nodiscard]] RunPlan plan_one_list(const Job& job, const PlanOptions& options, RunControl& control,
                                    const ListWork& work);

}  // namespace changeover
