// What plans cost at least where change costs depend on what is replaced: docs/theorems.md,
// Theorem 20.
//
// What comes in pays for what goes out: with a price w_x on the place of every part x, and a price
// z_S on entering a set S of parts from outside, a list costs no less than one at the prices π of
// parts that these leave, and something more. Any prices will do; those that are taken are proposed
// by the linear program of Theorem 18 with a column for each exchange.
#pragma once

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// Takes this bound, if it is better, with its reason. For jobs with Job::replace_costs and pairs;
/// bound.tests must be right. Costs two or three bounds at fixed prices and at most two seconds
/// more. Stopped if the scope of this thread (run/control.hpp) wants to stop; the bound is then as
/// good as it was by then.
void raise_by_exchanges(const Job& job, CostBound& bound);

}  // namespace changeover
