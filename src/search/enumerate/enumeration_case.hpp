// The cases into which an enumeration falls apart; each is one search tree.
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/core/parameters.hpp"

namespace changeover {

/// Designs on v elements that are found in one tree. Masks are of elements, bit x for element x.
struct EnumerationCase {
  std::size_t v = 0;
  std::size_t k = 0;
  std::size_t change = 0;
  std::size_t b = 0;
  bool circular = false;
  std::int64_t excess = 0;      ///< how often pairs are covered again, exactly
  std::size_t fixed = 0;        ///< elements of every block that were taken away; no others then
  std::size_t longest_run = 0;  ///< circular: a run of this length begins the design; 0: no matter

  [[nodiscard]] std::uint64_t all() const { return first_elements(v); }
  [[nodiscard]] std::uint64_t first_block() const { return first_elements(k); }
  /// Circular: what is introduced in the first block, and what stays there from the last block.
  [[nodiscard]] std::uint64_t first_introduced() const { return first_elements(change); }
  [[nodiscard]] std::uint64_t last_unchanged() const { return first_block() & ~first_introduced(); }

 private:
  // Elements 0, …, n − 1; n ≤ 64.
  [[nodiscard]] static constexpr std::uint64_t first_elements(std::size_t n) {
    return n == 0 ? 0 : ~std::uint64_t{0} >> (64 - n);
  }
};

/// Every design with b blocks, in standard form up to names, belongs to exactly one case and is
/// found once there; with `one_rotation` at least one rotation of every circular design is, namely
/// each that begins a longest run. Trivial parameters (v = k, or none by counting) have no case.
/// @throws ImpossibleParameters as enumerate_designs().
[[nodiscard]] std::vector<EnumerationCase> enumeration_cases(const Parameters& p, std::uint64_t b,
                                                             bool one_rotation);

}  // namespace changeover
