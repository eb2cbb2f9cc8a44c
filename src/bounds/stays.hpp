// How many stays elements need: the bound of stays.
//
//     most_meetings(2, 2)  // 3: 2·n₁ + n₂ ≤ 3k, n_j the number of elements with j stays
//     least_introductions(25, 10, 2)           // {45, 2}: Σ i_x ≥ 3·25 − 3·10
//
// A *stay* of x in a list of sets is a maximal run of consecutive sets that hold x; i_x is how many
// it has. If no set has more than k elements and every t elements are together in some set, then
// for every s ≥ 1
//
//     Σ_x max(0, s + 1 − i_x)  ≤  n·k,       n = s for s < t, and s² − s + 1 for any s,
//
// and so Σ i_x ≥ (s + 1)v − nk [docs/theorems.md, Theorem 5]. The steps between sets may be any:
// the list may be a linear design, a circular one cut open, the loads of one machine, or those of
// several, one after another.
#pragma once

#include <cstdint>

namespace changeover {

/// The n above, for strength t ≥ 2. @throws ImpossibleParameters if it exceeds 64 bits.
[[nodiscard]] std::uint64_t most_meetings(std::uint64_t s, std::uint64_t strength);

struct Introductions {
  std::uint64_t count = 0;  ///< Σ i_x is at least this
  std::uint64_t s = 1;      ///< by the inequality of this s

  bool operator==(const Introductions&) const = default;
};

/// The largest bound that the theorem gives for v elements, v ≥ k ≥ 1, over all s. O(1).
/// @throws ImpossibleParameters if it exceeds 64 bits.
[[nodiscard]] Introductions least_introductions(std::uint64_t v, std::uint64_t k,
                                                std::uint64_t strength = 2);

}  // namespace changeover
