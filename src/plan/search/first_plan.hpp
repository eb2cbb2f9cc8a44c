// Plans that begin with given set-ups: the rest is planned as a job of its own, and they are put
// before it.
//
// A list that begins with the first set-ups costs what these cost, and what a list for
// after_first(job) costs: a bound for that job, and its cheapest list, are those of the whole.
#pragma once

#include <cstdint>

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// make_run_plan(), cost_bound(), shuffled() and what_if() of a job with first set-ups and without
/// defects.
[[nodiscard]] RunPlan plan_with_first(const Job& job, const PlanOptions& options,
                                      RunControl& control);
[[nodiscard]] CostBound bound_with_first(const Job& job);
[[nodiscard]] RunPlan shuffled_with_first(const Job& job, RunPlan plan, std::uint64_t seed,
                                          std::uint64_t& exchanged);
[[nodiscard]] WhatIf what_if_with_first(const Job& job, const RunPlan& plan,
                                        const PlanOptions& options, RunControl& control);

}  // namespace changeover
