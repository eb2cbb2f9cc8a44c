// Plans that begin with given set-ups: the rest is planned as a separate job, and they are put
// before it.
//
// A list that begins with the first set-ups costs as much as these and a list for after_first(job):
// a bound and a cheapest list for that job give those of the whole.
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// make_run_plan(), cost_bound(), shuffled() and what_if() for a job with first set-ups and without
/// defects.
[[nodiscard]] RunPlan plan_with_first(const Job& job, const PlanOptions& options,
                                      RunControl& control);
[[nodiscard]] CostBound bound_with_first(const Job& job);
[[nodiscard]] RunPlan shuffled_with_first(const Job& job, RunPlan plan, std::uint64_t seed,
                                          std::uint64_t& exchanged);
[[nodiscard]] WhatIf what_if_with_first(const Job& job, const RunPlan& plan,
                                        const PlanOptions& options, RunControl& control);

/// A list without these set-ups, each once, wherever they stand in it.
[[nodiscard]] std::vector<Block> without_first_of(std::vector<Block> list,
                                                  const std::vector<Block>& first);

}  // namespace changeover
