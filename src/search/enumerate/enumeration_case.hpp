// The cases of an enumeration; each is one search tree.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "changeover/core/parameters.hpp"

namespace changeover {

/// Designs on v elements that one tree contains. Masks are sets of elements, bit x for element x.
struct EnumerationCase {
  std::size_t v = 0;
  std::size_t k = 0;
  std::size_t change = 0;
  std::size_t b = 0;
  bool circular = false;
  std::int64_t excess = 0;  ///< exact number of repeated coverings
  std::size_t fixed = 0;  ///< elements of every block, which are removed; no others are fixed then
  std::size_t longest_run = 0;  ///< circular: the design begins with a run of this length; 0: any

  [[nodiscard]] std::uint64_t all() const { return first_elements(v); }
  [[nodiscard]] std::uint64_t first_block() const { return first_elements(k); }
  /// Circular: the elements introduced in the first block, and those that stay there from the last
  /// one.
  [[nodiscard]] std::uint64_t first_introduced() const { return first_elements(change); }
  [[nodiscard]] std::uint64_t last_unchanged() const { return first_block() & ~first_introduced(); }

 private:
  // Elements 0, …, n − 1; n ≤ 64.
  [[nodiscard]] static constexpr std::uint64_t first_elements(std::size_t n) {
    return n == 0 ? 0 : ~std::uint64_t{0} >> (64 - n);
  }
};

/// Every design with b blocks in standard form belongs to exactly one case and is found once there.
/// With `one_rotation` this holds for at least one rotation of every circular design: each one that
/// begins with a longest run. Trivial parameters (v = k, or none by counting) have no case. @throws
/// ImpossibleParameters as enumerate_designs().
[[nodiscard]] std::vector<EnumerationCase> enumeration_cases(const Parameters& p, std::uint64_t b,
                                                             bool one_rotation);

// The least excess that an element causes, given its missing pairs and the blocks left.
//
// Each introduction of x covers k−1 pairs at x, and each stay covers m. So the missing pairs at x
// and the blocks left determine an unavoidable excess e_x; Σe_x is twice the total excess. The
// total number a of introductions in the blocks left is also known, so for every price λ
//     Σ_x min (e_x + λ a_x) ≤ 2·excess + λ·a,
// where the minimum is over the ways to be in or out of each remaining block. Four prices λ = 0, 1,
// 2, 3 share one word, 16 bits each. Values are capped at 511, so that no sum over 64 elements
// reaches 2¹⁵.

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

// Checks whether every missing pair can still meet within the remaining excess.
//
// Two elements that were covered together and then separated are a *dead* pair: when they meet
// again, this adds to the excess. So each missing pair needs a set of k elements that contains it
// and has no more dead pairs than the remaining excess; every later block is such a set. In a
// circular design the last unchanged subset must also meet again.

/// The part of a partial design that matters for later blocks.
struct Position {
  std::uint64_t block = 0;
  std::int64_t excess = 0;                   ///< excess that remains
  std::span<const std::uint64_t> missing{};  ///< by element: the elements that it must still meet
};

/// The largest excess for which the check saves time.
inline constexpr std::int64_t reach_excess = 2;

/// False only if some missing pair cannot be covered any more. The number of steps is limited; if
/// it runs out, the result is true.
[[nodiscard]] bool all_within_reach(const EnumerationCase& own, const Position& position);

// Sets of at most 64 elements as words.

using Mask = std::uint64_t;

/// The set of x alone, below 64.
inline Mask bit(std::size_t x) { return Mask{1} << x; }
/// The least element; 64 of the empty set.
inline std::size_t lowest(Mask mask) { return static_cast<std::size_t>(std::countr_zero(mask)); }
/// The number of elements.
inline std::size_t count(Mask mask) { return static_cast<std::size_t>(std::popcount(mask)); }

}  // namespace changeover
