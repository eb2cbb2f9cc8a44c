// Plans and bounds of checked jobs: the public functions check, and jobs derived from theirs have
// no defects either.
#pragma once

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// make_run_plan() for a job without defects.
[[nodiscard]] RunPlan plan_of_valid_job(const Job& job, const PlanOptions& options,
                                        RunControl& control);

/// cost_bound() for a job without defects.
[[nodiscard]] CostBound bound_of_valid_job(const Job& job);

/// Where only changes cost something, the bound on the cost bounds their number, and where only
/// tests do, theirs.
void raise_numbers(const Job& job, CostBound& bound);

}  // namespace changeover
