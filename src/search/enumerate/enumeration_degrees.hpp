// The least excess that an element causes, given its missing pairs and the blocks left.
//
// Each introduction of x covers k−1 pairs at x, and each stay covers m. So the missing pairs at x
// and the blocks left determine an unavoidable excess e_x; Σe_x is twice the total excess. The
// total number a of introductions in the blocks left is also known, so for every price λ
//     Σ_x min (e_x + λ a_x) ≤ 2·excess + λ·a,
// where the minimum is over the ways to be in or out of each remaining block. Four prices λ = 0, 1,
// 2, 3 share one word, 16 bits each. Values are capped at 511, so that no sum over 64 elements
// reaches 2¹⁵.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "search/enumerate/enumeration_case.hpp"

namespace changeover {

/// Where an element must be after the last block of a circular design: outside, if the first block
/// introduces it; inside, if it stays there.
enum class EndRole : std::uint8_t { anywhere, in, out };

class DegreeTable {
 public:
  explicit DegreeTable(const EnumerationCase& own);

  /// The memory of a table for b blocks.
  [[nodiscard]] static std::uint64_t bytes(std::uint64_t b) { return b * sizeof(Row); }

  /// The costs for one number of blocks left: 64 words for each of (role, in or out now), by
  /// missing pairs.
  using Row = std::array<std::uint64_t, std::size_t{6} * 64>;

  [[nodiscard]] const Row& row(std::size_t blocks_left) const { return rows_[blocks_left]; }

  [[nodiscard]] static std::size_t offset(EndRole role, bool in) {
    return (static_cast<std::size_t>(role) * 2 + (in ? 1 : 0)) * 64;
  }

  /// The right side of the inequality, one lane per price.
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
