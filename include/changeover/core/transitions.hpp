// What happens between blocks: introduced and leaving elements, unchanged subsets.
//
// An element x of block Bᵢ is *introduced* in it if x is not in the block before, and *leaves* in it if
// x is not in the block after; all elements are introduced in the first block of a linear design and
// leave in its last [ChafeeStevens2025, Section 1]. Bᵢ ∩ Bᵢ₊₁ is the i-th *unchanged subset* Uᵢ.
//
//     DesignSource source(design);
//     for (Transitions steps(source); steps.next();) {
//       draw(steps.block(), steps.introduced(), steps.leaving());
//     }
//
// Nothing here assumes that the change property holds.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"

namespace changeover {

/// The elements of `block` that are not in `other`, in the order of `block`. O(k log k).
[[nodiscard]] Block difference(std::span<const Element> block, std::span<const Element> other);

/// The elements of `block` that are also in `other`, in the order of `block`. O(k log k).
[[nodiscard]] Block intersection(std::span<const Element> block, std::span<const Element> other);

/// Whether the block holds all these elements, none of them twice. O(k log k).
[[nodiscard]] bool holds_all(std::span<const Element> block, std::span<const Element> elements);

/// A stream of blocks with the marks of each, one block of look-ahead.
class Transitions {
 public:
  /// Starts on `source`, which must outlive this. A circular source is read once to its end first, to
  /// learn what precedes its first block. @throws BadInput if it is circular and cannot be rewound.
  explicit Transitions(BlockSource& source);

  /// Moves to the next block, the first at the first call; false at the end.
  bool next();

  [[nodiscard]] std::span<const Element> block() const { return block_; }
  [[nodiscard]] std::span<const Element> introduced() const { return introduced_; }
  [[nodiscard]] std::span<const Element> leaving() const { return leaving_; }

  /// The number of this block, from 0.
  [[nodiscard]] std::uint64_t index() const { return index_; }

 private:
  BlockSource* source_;
  std::optional<Block> first_;  // circular only: what follows the last block
  Block previous_, block_, ahead_;
  bool has_ahead_ = false, has_previous_ = false, started_ = false;
  Block introduced_, leaving_;
  std::uint64_t index_ = 0;
};

/// An unchanged subset and where it stands: position i is between block i and block i+1, blocks
/// numbered from 1; in a circular design of b blocks position b is between the last and the first.
struct UnchangedSubset {
  std::size_t position = 0;
  Block elements;  ///< increasing

  bool operator==(const UnchangedSubset&) const = default;
};

/// The unchanged subsets Bᵢ ∩ Bᵢ₊₁ of a design in order of position: b of them if it is circular and
/// has more than one block, else b − 1. In a linear design any (k−m)-subset of the first and of the
/// last block may serve as U₀ and U_b too; these are not listed. O(bk log k).
[[nodiscard]] std::vector<UnchangedSubset> unchanged_subsets(const Design& design);

}  // namespace changeover
