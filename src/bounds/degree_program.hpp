// The integer program over introductions and occurrences.
//
// In a design of b blocks let i_x be the introductions of x and r_x the blocks that hold it. The
// f elements that are in every block of a circular design are left out: the rest is a circular
// design (v − f, k − f) without any, of as many blocks. So let no element be in every block. Then
//   linear    Σ i_x = k + m(b−1), Σ r_x = kb, 1 ≤ i_x ≤ r_x ≤ b + 1 − i_x (runs are apart);
//   circular  Σ i_x = mb, Σ r_x = kb, 1 ≤ i_x ≤ r_x ≤ b − i_x;
//   both      i_x(k−1) + m(r_x − i_x) = v − 1 + e_x, e_x ≥ 0, where the e_x are the degrees of a
//             multigraph of E edges (bounds/excess_program.hpp);
//   m ≤ 3     for every s ≥ 1 the inequality of stays (bounds/stays.hpp): linear
//             Σ max(0, s+1−i_x) ≤ (s²−s+1)k; circular cut open after the last block, where the
//             k−m elements that stay are introduced once more, k−m more than that.
// If no such numbers exist, there is no design of b blocks. For k = 3, m = 2 this is the bound
// ⌈v/3·⌈(v−1)/2⌉⌉ of Fort and Hedlund, because no pair survives a change.
//
// Given Σ i_x, what counts is the least Σ r_x. The least r_x for i_x, max(i_x,
// ⌈(v−1−i_x(k−1−m))/m⌉), is convex along steps of m, and its slopes do not depend on the residue
// but through i_x; so moving two elements whose i_x are more than m apart towards each other by m
// never makes the sum larger. Nor does it make the sums of stays larger, which are convex in i_x.
// So only m + 1 neighbouring values of i_x need be tried. How many elements have each of them is
// settled by the two sums but for m − 1 of these numbers: a point with whole coordinates in a
// polygon of the plane, for m ≤ 3. The multigraph and the stays are looked at one after the other.
#pragma once

#include <cstdint>
#include <optional>

#include "changeover/core/parameters.hpp"

namespace changeover {

/// The least b ≥ from for which such numbers exist. nullopt if the program is not tried (m > 30,
/// v > 2000, strength above 2, v = k) or nothing is found up to from + 10,000. O(v²/k) a value
/// of b for m ≤ 3, else O(m² log v) and for few b O(m³ log v); for each of the k − m + 1 values of
/// f if circular.
[[nodiscard]] std::optional<std::uint64_t> degree_program(const Parameters& p, std::uint64_t from);

}  // namespace changeover
