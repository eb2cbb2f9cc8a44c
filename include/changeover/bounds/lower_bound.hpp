// Lower bounds on the number of blocks, each with its reason.
//
//     for (const Bound& bound : lower_bounds({.v = 8, .k = 5, .kind = Kind::circular})) {
//       std::cout << bound.blocks << "  " << bound.reason << '\n';  // one line of mathematics each
//     }
//     lower_bound({.v = 8, .k = 5, .kind = Kind::circular}).blocks;     // the largest
//
// With p = C(k,t) − C(k−m,t), the t-subsets that a block can newly cover, v > k and t = 2 unless
// said:
//   counting  linear ⌈(C(v,t) − C(k,t)) / p⌉ + 1, circular ⌈C(v,t) / p⌉
//             [ChafeeStevens2025, Theorem 1]. Pairs of elements that are in every block of a
//             circular design occur but are never newly covered, so the circular bound is the least
//             over the number f of such fixed elements of max(⌈(C(v,2) − C(f,2)) / p⌉,
//             ⌈C(v−f,2) / p(k−f,m)⌉, ⌈(v−f)/m⌉, 3).
//   degree    i_x(k−1) + m(r_x − i_x) = v − 1 + e_x forces every excess e_x up to the least residue
//             of −(v−1) modulo gcd(k−1, m); for m = 2, k odd, v even it gives linear
//             C(k,2) + (b−1)(2k−3) ≥ v²/2. It is taken into the counting bound.
//   stays     b ≥ ⌈((s+1)v − (s²−s+2)k)/m⌉ + 1 for every s ≥ 1: 2(v−k), 3v−4k, 4v−8k, …
//             introductions after the first block [docs/theorems.md, Theorem 5]; for strength t
//             also b ≥ ⌈t(v−k)/m⌉ + 1.
//   degree program  the least b for which whole numbers i_x, e_x with the right sums satisfy
//             i_x(k−1) + m(r_x − i_x) = v − 1 + e_x at every x, no e_x is more than half of their
//             sum, and for m ≤ 3 the inequality of stays holds for every s (m ≤ 30, v ≤ 2000)
//             [docs/theorems.md, Theorem 35]; for k = 3, m = 2 this is ⌈v/3·⌈(v−1)/2⌉⌉, the
//             covering bound of Fort and Hedlund.
//   returning elements  for v < k + 2m some of the elements that enter were there two blocks before
//             [docs/theorems.md, Theorem 36].
//   Steiner system  for m ≥ k − 1, where C(v,2) / C(k,2) blocks would be a plane in an order that
//             there is not, or fewer than v blocks [docs/theorems.md, Theorem 37].
//   checked proofs  for some small parameters fewer blocks were excluded by SAT, each number of
//             blocks with a DRAT proof that was checked; the reason names the command that writes
//             the proofs again. This bound and the next are not proofs on paper.
//   all lists  circular SCCD(14,5): a search through all lists of 23 blocks that may be one
//             [docs/theorems.md, Theorem 29].
//   end to end  b ≥ 2⌈(v−k)/m⌉ + 1: with p = ⌈(v−k)/m⌉, some x is in none of the first p blocks and
//             some y in none of the last p, so b ≤ 2p would leave {x,y} uncovered. For strength t
//             likewise b ≥ tp + 1 [docs/theorems.md, Theorem 7].
//
// Elements that are added to every block make a (v+f, k+f) design, and a blow-up one for s·m; the
// bounds for those never said more than these where it was looked at, so they are not asked.
//
// Deliberately not done here: the search.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "changeover/core/parameters.hpp"

namespace changeover {

/// A number of blocks such that no design with certain parameters has fewer.
struct Bound {
  std::uint64_t blocks = 0;
  std::string name;    ///< "counting", "degree", "degree program", "end to end", "stays",
                       ///< "returning elements", "Steiner system", "checked proofs", "all lists",
                       ///< "trivial"
  std::string reason;  ///< one line of plain mathematics with the numbers filled in

  bool operator==(const Bound&) const = default;
};

/// Every bound that applies, largest first. They claim nothing about existence; see
/// impossibility().
/// @throws ImpossibleParameters as check(), or if a count exceeds 64 bits. At most 2²⁰ values of f
/// are tried.
[[nodiscard]] std::vector<Bound> lower_bounds(const Parameters& p);

/// The largest of them.
[[nodiscard]] Bound lower_bound(const Parameters& p);

}  // namespace changeover
