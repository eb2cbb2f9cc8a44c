// The incidence graph of elements and blocks, for bliss.
//
// A second, independent way to decide what isomorphism/isomorphism.hpp decides by sorting columns,
// and the only way where the order of blocks is forgotten. How much of the order is kept is a
// matter of gadgets: block i of a sequence has its own colour; a circle has an arc of two
// vertices from each block to the next, one vertex if its direction is forgotten.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "changeover/core/design.hpp"

namespace changeover {

/// What is kept of the order of the blocks.
enum class BlockOrder : std::uint8_t {
  sequence,             ///< all of it
  reversible_sequence,  ///< up to reading backwards
  circle,               ///< up to rotation
  reversible_circle,    ///< up to both
  collection            ///< nothing; a block that occurs r times is one vertex with its own colour
};

struct GraphForm {
  /// Vertex v of the graph has the place label[v] in the canonical graph; elements are vertices 0,
  /// …, v−1.
  std::vector<unsigned> label;
  /// The canonical graph: (place, colour) of each vertex, then its edges (lesser place first);
  /// sorted.
  std::vector<std::pair<unsigned, unsigned>> colours, edges;
  std::string group_order;                        ///< exact, in decimal
  std::vector<std::vector<unsigned>> generators;  ///< on vertices
};

/// @throws MissingResource if there are 2³¹ or more vertices.
[[nodiscard]] GraphForm graph_form(const Design& design, BlockOrder order);

// Products of many small numbers, exact, in decimal: orders of groups.
//
//     Decimal order;                 // 1
//     order.multiply(366);
//     order.text();                  // "366"

class Decimal {
 public:
  /// O(number of digits).
  void multiply(std::uint32_t factor) {
    std::uint64_t carry = 0;
    for (std::uint32_t& limb : limbs_) {
      const std::uint64_t product = std::uint64_t{limb} * factor + carry;
      limb = static_cast<std::uint32_t>(product % base);
      carry = product / base;
    }
    while (carry > 0) {
      limbs_.push_back(static_cast<std::uint32_t>(carry % base));
      carry /= base;
    }
  }

  [[nodiscard]] std::string text() const {
    std::string text = std::to_string(limbs_.back());
    for (std::size_t i = limbs_.size() - 1; i-- > 0;) {
      const std::string digits = std::to_string(limbs_[i]);
      text += std::string(base_digits - digits.size(), '0') + digits;
    }
    return text;
  }

 private:
  static constexpr std::uint32_t base = 1'000'000'000;
  static constexpr std::size_t base_digits = 9;
  std::vector<std::uint32_t> limbs_{1};  // lowest first
};

}  // namespace changeover
