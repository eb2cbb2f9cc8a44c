// The elements of a block and those it introduces as bits, to cover many subsets at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

/// Sets of elements below v, one bit each.
class ElementBits {
 public:
  /// Whether rows of bits are worth it for a block with that many introduced elements: subsets one
  /// by one take that many steps for each choice of all members but one, a row takes about v / 128.
  /// Below 16 the steps are too few to prepare for.
  [[nodiscard]] static bool pay(std::uint64_t introduced, std::uint64_t v) {
    return introduced >= 16 && introduced > v / 128;
  }

  /// The elements from `introduced_from` on are introduced.
  void assign(std::span<const Element> block, std::size_t introduced_from, std::uint64_t v) {
    all_.assign(static_cast<std::size_t>(v / 64 + 1), 0);
    introduced_.assign(static_cast<std::size_t>(v / 64 + 1), 0);
    for (std::size_t i = 0; i < block.size(); ++i) {
      const std::uint64_t bit = std::uint64_t{1} << (block[i] % 64);
      all_[block[i] / 64] |= bit;
      introduced_[block[i] / 64] |= i >= introduced_from ? bit : 0;
    }
  }

  [[nodiscard]] bool is_introduced(Element x) const {
    return (introduced_[x / 64] >> (x % 64) & 1) != 0;
  }

  /// The elements that complete a subset so that it has an introduced element, if it has one
  /// already or not.
  [[nodiscard]] std::span<const std::uint64_t> completing(bool has_introduced) const {
    return has_introduced ? all_ : introduced_;
  }

 private:
  std::vector<std::uint64_t> all_, introduced_;
};

}  // namespace changeover
