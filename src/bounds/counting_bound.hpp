// ⌈g₁⌉ and ⌈g₂⌉: the number of blocks that counting newly covered pairs requires.
//
//     counting_bound({.v = 61, .k = 4, .kind = Kind::circular});     // 366
//
// An *economical* design has exactly so many blocks [ChafeeStevens2025, Section 2.2]. Constructions
// use it for their promises; the verifier has its own count.
#pragma once

#include <cstdint>

#include "changeover/core/parameters.hpp"

namespace changeover {

/// For any m and t, with p = newly_covered_at_most(): linear ⌈(C(v,t) − C(k,t)) / p⌉ + 1, circular
/// ⌈C(v,t) / p⌉ [ChafeeStevens2025, Theorem 1]; 1 if v = k. A circular design with two or more
/// elements in every block may have fewer: see bounds/lower_bound.hpp.
/// @throws ImpossibleParameters if a count exceeds 64 bits.
[[nodiscard]] std::uint64_t counting_bound(const Parameters& p);

}  // namespace changeover
