// Plans in which every three parts have to meet.
#pragma once

#include "changeover/plan/run_plan.hpp"
#include "plan/search/starts/starts.hpp"

namespace changeover {

/// make_run_plan() for a job with triples, without first set-ups and without defects: known designs
/// of strength 3, a greedy list, the rest of the current list, and a local search
/// (lists/lists_search.hpp) that starts from the best of them.
[[nodiscard]] RunPlan plan_for_triples(const Job& job, const PlanOptions& options,
                                       RunControl& control);

/// Repeatedly takes the step that tests most triples for its cost. After the control requests a
/// stop, takes any steps, so that the list is complete soon.
[[nodiscard]] Start greedy_for_triples(const Job& job, RunControl& control);

/// cost_bound() for a job with triples and without first set-ups.
///
/// Proof. F, K, S and the other symbols are those of docs/theorems.md, Theorem 23; let N be the
/// number of needed triples within F. The needed pairs are those of the needed triples, so that
/// theorem holds. In addition:
///   (1) A step that introduces j parts of F newly covers at most q(j) = C(K,3) − C(K−j,3) triples
///   of
///       F; the first one at most C(j + s, 3), where s = min(|S|, K − j). q is concave, so I
///       introductions in T steps cover the most if the steps after the first are as equal as
///       possible.
///   (2) Per test, part x meets at most K − 1 others, and x and y at most K − 2: so x is in at
///   least
///       ⌈Σ_y ⌈d_xy/(K−2)⌉ / (K−1)⌉ tests, where d_xy is the number of needed triples of F with x
///       and y; and a test holds K parts.
///   (3) Of parts of F of which every three must meet, at most K have one stay, at most 2K have one
///       or two, and so on: for strength 3, Σ max(0, s+1−i_x) ≤ c_s·K with c_1 = 1, c_2 = 2 and
///       c_s = s²−s+1 for s > 2 [docs/theorems.md, Theorem 5]. As in stays_cost.hpp, the parts with
///       more than j stays are then at least n − K, n − K, n − 5K, n − 6K, n − 8K, … for j = 1, 2,
///       …
///   (4) If all triples of n > K parts are needed, I + |S| ≥ K − 1 + b for a lower bound b on the
///       blocks of a linear SCCD(n,K) of strength 3: the proof for pairs applies to triples, too.
///   (5) Every set-up after the first introduces something, and the first one three parts if
///   nothing
///       is there before and no triple has a mounted part. Every part is introduced once, and each
///       further introduction costs at least as much as the cheapest part.
[[nodiscard]] CostBound bound_for_triples(const Job& job);

}  // namespace changeover
