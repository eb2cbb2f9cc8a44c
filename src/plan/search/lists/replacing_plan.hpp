// Plans for costs that depend on what is replaced.
#pragma once

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// make_run_plan() for a job with replace_costs, without first set-ups and without defects: the
/// ordinary search at the mean price of each part, and then a search among lists with the true
/// costs. @throws BadInput for a job that weighs its pairs.
[[nodiscard]] RunPlan plan_for_replacing(const Job& job, const PlanOptions& options,
                                         RunControl& control);

}  // namespace changeover
