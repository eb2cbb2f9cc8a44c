// Plans and bounds of jobs that were checked: the public doors check, and what is made of their
// jobs on the way to a plan has no defects either.
#pragma once

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// make_run_plan() of a job without defects.
[[nodiscard]] RunPlan plan_of_valid_job(const Job& job, const PlanOptions& options,
                                        RunControl& control);

/// cost_bound() of a job without defects.
[[nodiscard]] CostBound bound_of_valid_job(const Job& job);

}  // namespace changeover
