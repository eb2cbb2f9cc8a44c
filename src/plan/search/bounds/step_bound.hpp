// A lower bound on the cost of plans, counted by the changes of each step in each slot:
// docs/theorems.md, Theorem 18.
//
// A step that puts in j of the c parts of one slot and i of the d parts of another brings at most
// cd − (c−j)(d−i) new pairs between them, and C(j,2) + j(c−j) within the first. The numbers of
// steps by kind (how many parts of which slots they put in), of introductions of each part, and of
// tests are the variables of a linear program; its minimum bounds the cost of every plan. Rows for
// parts with few introductions, which must stay while others come, are added when they are
// violated.
#pragma once

#include <string>

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// Takes this bound with its reason, if it is better. The reason begins with `least_known`: the
/// least numbers of tests and changes, and why; bound.tests must be right. For jobs without
/// triples, with one price per part. The floating-point solution is only used to construct a proof
/// in integers, so rounding can only make the bound lower. At most 200 parts, about a second, and
/// 64 MiB for each of two tables: if more rows are violated, those that have room are taken.
/// Stopped if the scope of this thread (run/control.hpp) requests it; the bound is then as good as
/// it was by then.
void raise_by_steps(const Job& job, const std::string& least_known, CostBound& bound);

}  // namespace changeover
