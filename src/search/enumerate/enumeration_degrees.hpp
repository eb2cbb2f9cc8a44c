// What an element must cost, from how many pairs are missing at it and how many blocks are left.
//
// Each time x is introduced it covers k−1 pairs at x, each time it stays it covers m, so the
// missing pairs at x and the blocks left decide how much excess e_x is unavoidable; Σe_x is twice
// the total excess. The total number a of introductions in the blocks left is known too, so for
// every price λ
//     Σ_x min (e_x + λ a_x) ≤ 2·excess + λ·a,
// with the minimum over the ways to be in or out of each block that is left. Four prices λ = 0, 1,
// 2, 3 share one word, 16 bits each; values are cut at 511, so that no sum over 64 elements reaches
// 2¹⁵.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "search/enumerate/enumeration_case.hpp"

namespace changeover {

/// Where an element has to be after the last block: in a circular design what is introduced in the
/// first block must be out then, and what stays there must be in.
enum class EndRole : std::uint8_t { anywhere, in, out };

class DegreeTable {
 public:
  explicit DegreeTable(const EnumerationCase& own);

  /// What a table for b blocks takes.
  [[nodiscard]] static std::uint64_t bytes(std::uint64_t b) { return b * sizeof(Row); }

  /// The costs for one number of blocks left: 64 words for each of (role, in or out now), by
  /// missing pairs.
  using Row = std::array<std::uint64_t, std::size_t{6} * 64>;

  [[nodiscard]] const Row& row(std::size_t blocks_left) const { return rows_[blocks_left]; }

  [[nodiscard]] static std::size_t offset(EndRole role, bool in) {
    return (static_cast<std::size_t>(role) * 2 + (in ? 1 : 0)) * 64;
  }

  /// The right side of the inequality, one lane for each price.
  [[nodiscard]] std::uint64_t allowance(std::int64_t excess, std::size_t blocks_left) const;

  /// Whether no lane of `sum` exceeds that of `allowance`; all lanes below 2¹⁵.
  [[nodiscard]] static bool within(std::uint64_t sum, std::uint64_t allowance) {
    constexpr std::uint64_t tops = 0x8000'8000'8000'8000U;
    return (((allowance | tops) - sum) & tops) == tops;
  }

 private:
  std::size_t change_;
  std::vector<Row> rows_;
};

}  // namespace changeover
