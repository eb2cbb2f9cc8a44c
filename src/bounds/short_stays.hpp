// How many elements can have few stays: the bound of stays for some of the elements, by counting
// pairs among them.
//
//     most_stays_short(4, 13)                  // 146: 4·n₁ + 3·n₂ + 2·n₃ + n₄ ≤ 146 for room 13
#pragma once

#include <cstdint>

namespace changeover {

/// An upper bound on Σ max(0, s + 1 − i_x) over any set of elements, for strength 2, s ≥ 1 and
/// k ≥ 2: the smaller of (s² − s + 1)k and ⌊s((s + 2)k − (s + 1))/2⌋, which counts pairs within
/// these elements [docs/theorems.md, Theorem 5]. The second is smaller from s = 4 on, and for s = 3
/// if k < 12. The increments from s to s + 1 do not decrease.
/// @throws ImpossibleParameters if it exceeds 64 bits.
[[nodiscard]] std::uint64_t most_stays_short(std::uint64_t s, std::uint64_t k);

}  // namespace changeover
