// Plans for jobs of models.
#pragma once

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// make_run_plan() for a job of a model without first set-ups and without defects: greedy lists,
/// one with few tests in a cheap order, the rest of the current list, and annealing from the best
/// of them. @throws BadInput for a job that weighs its pairs.
[[nodiscard]] RunPlan plan_for_choices(const Job& job, const PlanOptions& options,
                                       RunControl& control);

/// Improves the bound for jobs of models beyond cost_bound(), which holds for them, too; `bound` is
/// changed if it becomes better, and so is `known`, the least numbers of tests and changes and
/// their reasons.
///
/// Proof. Let R be the needed pairs whose values are both in range.
///  (1) *Tests.* A test has one pair of each two parameters, and tests pairs of R only if no value
///      of it is out of range; else those of this value alone. So the tests are at least max over
///      p, q of the pairs of R of p and q, or the sum over the values x of p of the most pairs of R
///      that x has with one other parameter; and for each value h that is out of range as many more
///      as it has needed pairs with one parameter.
///  (2) *Two values.* Choose two values of each of k parameters so that all pairs of R among them
///      are needed. Where a test has another value put the first of the two: a list in which any
///      two of k rows of N signs have all four pairs. There are none for k > C(N−1, ⌊N/2⌋−1)
///      [Katona1973; KleitmanSpencer1973]. Likewise with more values each: docs/theorems.md,
///      Theorem 21.
///  (3) *Rules.* Needed pairs, or triples, of which no two fit in one test, are in as many tests
///      (tests_apart.hpp).
///  (4) *Changes.* Cut the list where p or q changes: within a piece one pair of them is tested. If
///      p is set c_p times, and q c_q times, there are at most c_p + c_q − 1 pieces, one more for
///      each of them that has a value at the start. So c_p + c_q is at least the number of needed
///      pairs of p and q plus one, minus those at the start; and c_p is at least the number of its
///      values that must be set. What the changes beyond these cost at least, at the lowest price
///      of each parameter, is a linear program; its dual is a fractional matching of parameters,
///      found as a transport problem.
///  (5) *Of many.* If every two of some parameters change 2s − 1 times together, or more, by (4),
///      at most one of them changes less than s times. If that is s − d times, each other one
///      changes s − 1 + d times; so d = 1 is cheapest, if they cost together no less than it does.
///      (4) alone says 2s − 1 for two of them, and half of that for each. Of parameters with three
///      values at most two are set fewer than six times (docs/theorems.md, Theorem 24): one less
///      each, or one of them two less; if it is d ≥ 3 less, each other one is set 4 + d times.
///  (6) *In few tests.* Of parameters with two values each has five stays, but one that has two,
///      and so many with three and four as Theorem 25 allows in so many tests. Of three or more
///      parameters with three values each has eight stays, but so many that have seven, and six,
///      as Theorem 27 allows. By (5) one of these may have two less, or two one less each; or one
///      has three stays, and all others have seven or more. The cheapest number of tests is taken;
///      other parameters change as (4) and (5) say.
///  (7) *In each step.* k parameters have g values each, or more, of which g must meet all those g
///      of the others. Let parameter p have c_p stays in N tests, all of them I; the start is one
///      more test here, though it tests nothing, and a parameter with no value there is given its
///      first one. Let x_i parameters change in step i; the x_i are I − k together. Cut the list
///      where p or q changes: these are c_p + c_q − 1 pieces, one fewer for each step in which both
///      do, and at least g². For all two parameters together, (k−1)·I − C(k,2) − Σ C(x_i, 2) ≥
///      g²·C(k,2). The sum over the steps is least if the N−1 numbers x_i differ by one at most. So
///      I is at least the least number for which this holds. Each number g ≥ 4 of values is a
///      separate set, of three parameters or more, at its lowest price; in (6) each of these sets
///      costs at least that, or what (4) and (5) say of it, beyond one stay for each value.
void improve_choice_bound(const Job& job, CostBound& bound, std::string& known);

}  // namespace changeover
