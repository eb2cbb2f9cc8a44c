// Plans for pairs of different weights.
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// plan_by_pairs() for a job that weighs its pairs: heavy pairs early, and within a budget the
/// heaviest.
[[nodiscard]] RunPlan plan_for_weights(const Job& job, const PlanOptions& options,
                                       RunControl& control);

/// The same set-ups in another order, perhaps with parts exchanged that nothing but weights tells
/// apart, in which the weight waits less: Σ weight · (cost up to where the pair first meets) is no
/// larger, and neither is the cost.
[[nodiscard]] std::vector<Block> heavy_first(const Job& job, const std::vector<Block>& setups,
                                             RunControl& control);

/// No list within the budget tests more needed pairs of parts that do not stay mounted.
///
/// Let F be those parts, K the room for them, S those at the start, and take a list within the
/// budget that tests the most, of these one with fewest introductions and tests. The first step
/// introduces j parts and tests at most C(j,2) + j·s + C(s,2) pairs, s = min(|S|, K−j), any other
/// one C(j,2) + j(K−j), which is concave in j; every step after the first introduces something, and
/// an introduction of x meets a part that x has not met before, so there are at most d_x of them,
/// for the needed pairs d_x at x; parts of slots that need some may come more often. The money left
/// by the tests pays for no more introductions than the cheapest ones that this allows. Nor does
/// the i-th introduction, counted one by one, meet more than min(|S|+i−1, K−1) parts.
[[nodiscard]] std::uint64_t most_pairs_within(const Job& job, Amount budget);

/// No list within the budget tests more weight: the heaviest so many pairs of most_pairs_within(),
/// and all pairs with a part that stays mounted.
[[nodiscard]] Amount most_weight_within(const Job& job, Amount budget);

}  // namespace changeover
