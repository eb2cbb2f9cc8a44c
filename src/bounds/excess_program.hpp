// How often elements meet more than once: which numbers of introductions the excess allows.
//
// In a design in which no element is in every block, or in a linear one, element x newly meets
// k − 1 others wherever it is introduced and m at each later block of a stay. With e_x more of
// these meetings than the v − 1 that there must be,
//
//     e_x = i_x(k−1) − (v−1) + m·s_x ≥ 0,   s_x ≥ 0,
//
// and s_x = 0 if k = m, where nothing stays; s_x = r_x − i_x. The pairs that are newly covered once
// more than they must are the edges of a multigraph without loops; e_x is the degree of x. So
// Σ e_x = 2E, where E is the excess, and no e_x is above E [docs/theorems.md, Theorem 35].
#pragma once

#include <cstdint>

namespace changeover {

/// What is asked of the introductions of n elements, n > k ≥ m ≥ 1.
struct ExcessProgram {
  std::int64_t n = 0;             ///< elements, none of them in every block of a circular design
  std::int64_t k = 0;             ///< block size
  std::int64_t m = 0;             ///< change number, at most largest_m
  std::int64_t i_sum = 0;         ///< Σ i_x
  std::int64_t twice_excess = 0;  ///< 2E
  std::int64_t r_most = 0;        ///< r_x ≤ r_most − i_x, where r_x blocks hold x

  static constexpr std::int64_t largest_m = 30;  ///< sums of excess below 2m are bits of a word

  /// Whether there are whole numbers i_x ≥ 1 and e_x as above. It does not ask for the last
  /// condition, that the e_x add up to 2E and not to less, if E ≥ m. O(m² log n), and O(m³ log n)
  /// if E < m.
  [[nodiscard]] bool feasible() const;
};

}  // namespace changeover
