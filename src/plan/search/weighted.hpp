// Plans for pairs of different weights.
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/plan/run_plan.hpp"

namespace changeover {

/// The same set-ups in another order, possibly with parts exchanged that are interchangeable except
/// for weights, in which the weight waits less: neither Σ weight · (cost up to where the pair first
/// meets) nor the cost increases.
[[nodiscard]] std::vector<Block> heavy_first(const Job& job, const std::vector<Block>& setups,
                                             RunControl& control);

/// An upper bound on the needed pairs, of parts that do not stay mounted, that a list within the
/// budget tests.
///
/// Let F be those parts, K the room for them, and S those at the start. Take a list within the
/// budget that tests the most pairs and, of these, one with the fewest introductions and tests. The
/// first step introduces j parts and tests at most C(j,2) + j·s + C(s,2) pairs, s = min(|S|, K−j);
/// any other step C(j,2) + j(K−j), which is concave in j. Every step after the first introduces
/// something. An introduction of x meets a part that x has not met before, so there are at most d_x
/// of them, the number of needed pairs at x; parts of slots that need parts may have more. The
/// budget left after the tests pays for no more introductions than the cheapest ones with these
/// limits. Also, the i-th introduction, counted one by one, meets at most min(|S|+i−1, K−1) parts.
[[nodiscard]] std::uint64_t most_pairs_within(const Job& job, Amount budget);

/// An upper bound on the weight that a list within the budget tests: the heaviest
/// most_pairs_within() pairs, and all pairs with a part that stays mounted.
[[nodiscard]] Amount most_weight_within(const Job& job, Amount budget);

}  // namespace changeover
