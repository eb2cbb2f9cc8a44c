// The integer program over introductions and occurrences.
//
// In a design of b blocks let i_x be the introductions of x and r_x the blocks that hold it. Then
//   linear    Σ i_x = k + m(b−1), Σ r_x = kb, 1 ≤ i_x ≤ r_x ≤ b + 1 − i_x (runs are apart);
//   circular  with f elements in every block, over the v − f others: Σ i_x = mb, Σ r_x = (k−f)b,
//             1 ≤ i_x ≤ r_x ≤ b − i_x, and mb ≥ v − f if f ≥ 1;
//   both      i_x(k−1) + m(r_x − i_x) ≥ v − 1, and for every s ≥ 1 the inequality of stays
//             (bounds/stays.hpp): linear    Σ max(0, s+1−i_x) ≤ (s²−s+1)k; circular  cut open after
//             the last block, where the k−m−f elements that stay, but are not in every
//                       block, are introduced once more:
//                       Σ max(0, s+1−i_x) + f·s − (k−m−f) ≤ (s²−s+1)k.
// If no such numbers exist, there is no design of b blocks. For k = 3, m = 2 this is the bound
// ⌈v/3·⌈(v−1)/2⌉⌉ of Fort and Hedlund, because no pair survives a change.
//
// Given Σ i_x, what counts is the least Σ r_x. The least r_x for i_x, max(i_x,
// ⌈(v−1−i_x(k−1−m))/m⌉), is convex along steps of m, and its slopes do not depend on the residue
// but through i_x; so moving two elements whose i_x are more than m apart towards each other by m
// never makes the sum larger. Nor does it make the sums of stays larger, which are convex in i_x.
// So only m + 1 neighbouring values of i_x need be tried. How many elements have each of them is
// settled by the two sums but for m − 1 of these numbers: a point with whole coordinates in a
// polygon of the plane, for m ≤ 3.
#pragma once

#include <cstdint>
#include <optional>

#include "changeover/core/parameters.hpp"

namespace changeover {

/// The least b ≥ from for which such numbers exist. nullopt if the program is not tried (m > 3,
/// v > 2000, strength above 2, v = k) or nothing is found up to from + 10,000. O(v²/k) a value
/// of b, for each of the k − m + 1 values of f if circular.
[[nodiscard]] std::optional<std::uint64_t> degree_program(const Parameters& p, std::uint64_t from);

}  // namespace changeover
