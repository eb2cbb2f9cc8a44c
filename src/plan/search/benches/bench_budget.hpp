// Plans for several benches within a budget.
#pragma once

#include "changeover/plan/benches.hpp"
#include "changeover/run/control.hpp"
#include "plan/search/benches/bench_field.hpp"

namespace changeover {

/// Replaces the candidates of a complete plan by lists within the budget that test as much as
/// possible, the best one first, and sets most_weight if the job weighs its pairs. @throws BadInput
/// if the first set-ups alone cost more.
void keep_within_budget(const BenchField& field, const BenchOptions& options, Amount budget,
                        RunControl& control, BenchPlan& plan);

}  // namespace changeover
