// Plans in which pairs have to meet, by annealing one list (anneal/anneal.hpp).
#pragma once

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// make_run_plan() for a job of pairs without first set-ups and without defects: known designs, a
/// greedy list, the rest of the current list, an exhaustive search of a small job, and longer and
/// longer annealing runs from the best so far. Within a budget, as many pairs as possible; if they
/// have weights, the heaviest ones, or heavy pairs early.
[[nodiscard]] RunPlan plan_for_pairs(const Job& job, const PlanOptions& options,
                                     RunControl& control);

}  // namespace changeover
