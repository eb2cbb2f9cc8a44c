// Plans if what a change costs depends on what is replaced.
#pragma once

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// make_run_plan() for a job with replace_costs, without first set-ups and without defects: what
/// the search for ordinary jobs finds at the mean price of each part, and a search among lists
/// under the true costs from there. @throws BadInput for a job that weighs its pairs.
[[nodiscard]] RunPlan plan_for_replacing(const Job& job, const PlanOptions& options,
                                         RunControl& control);

}  // namespace changeover
