// The cases of an enumeration; each is one search tree.
#pragma once

#include <cstdint>
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

}  // namespace changeover
