// What plans cost at least, counted by what each step changes in each slot: docs/theorems.md,
// Theorem 18.
//
// A step that puts in j of the c parts of one slot and i of the d of another brings at most
// cd − (c−j)(d−i) new pairs of theirs, and C(j,2) + j(c−j) within the first. How often a step puts
// in how many of which slots, how often each part comes, and how many tests there are, is a linear
// program; what it costs at least bounds every plan. Rows that say that a part which comes seldom
// must stay while others come are added when they are violated.
#pragma once

#include <string>

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// Takes this bound, if it is better, with its reason, which begins with `least_known`: how many
/// tests and changes there are at least, and why; bound.tests must be right. For jobs without
/// triples, with one price a part. The numbers that a linear program in floating point proposes
/// are taken for a proof in whole numbers, so rounding can only make the bound lower. At most about
/// a second. Stopped if the scope of this thread (run/control.hpp) wants to stop; the bound is then
/// as good as it was by then.
void raise_by_steps(const Job& job, const std::string& least_known, CostBound& bound);

}  // namespace changeover
