// A lower bound on the cost of introductions of parts that must all meet each other: the bound of
// stays, with prices.
//
//     StaysCost least = stays_cost({prices of the parts}, 4);
//     least.extra;                  // introductions beyond the first of each part
//     least.cost;                   // of these
//
// Let Q be n parts of which every two must meet, K the room for them, and i_x the number of stays
// of x in the list of set-ups, with the start as its first one. For every s, Σ max(0, s+1−i_x) ≤
// c_s over Q, where c_s = most_stays_short(s, K) [docs/theorems.md, Theorem 5]. Let Y_j be the
// number of parts with more than j stays: then Y_1 + … + Y_s ≥ s·n − c_s. The Y_j parts with more
// than j stays cost, once each, at least f(Y_j), the cost of the Y_j cheapest parts; f is convex
// and, with prices of at least 0, does not decrease. Over all Y_1 ≥ Y_2 ≥ … with at least these
// partial sums, Σ f(Y_j) is least where each partial sum is: Y_1 = n − K and Y_s = n − (c_s −
// c_{s−1}) for s > 1, each while positive, otherwise 0; c_s − c_{s−1} does not decrease.
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover {

struct StaysCost {
  std::uint64_t extra = 0;
  Amount cost;
};

/// For parts with these prices and this room. O(n log n + n/room).
/// @throws ImpossibleParameters if a cost overflows.
[[nodiscard]] StaysCost stays_cost(std::vector<Amount> prices, std::uint64_t room);

/// The same if every three of the parts must meet: Y_1 = Y_2 = n − K, Y_3 = n − 5K, and from s = 4
/// on as for pairs, since for strength 3 the factors of K are 1, 2, 7, 13, …
[[nodiscard]] StaysCost stays_cost_of_triples(std::vector<Amount> prices, std::uint64_t room);

}  // namespace changeover
