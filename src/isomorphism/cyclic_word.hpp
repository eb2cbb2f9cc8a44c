// Cheap invariants of the blocks of a circular design, to tell its rotations apart.
//
// The symbol of a block says how long the elements that are introduced in it stay, and how long
// they were and will be absent. Renaming elements does not change the word of the symbols, rotating
// the design rotates it. Two equal symbols may stand for different blocks: that costs time, never
// truth.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "changeover/core/design.hpp"

namespace changeover {

/// Ordered so that longer runs come first.
struct BlockSymbol {
  std::uint64_t shorter = 0;  ///< 2⁶⁴−1 less the longest run that begins here
  std::uint64_t mixed = 0;  ///< of the lengths of all runs that begin here and the gaps beside them

  auto operator<=>(const BlockSymbol&) const = default;
};

/// The word of the blocks 0, 1, …, b−1, and that of the same blocks read backwards around the
/// circle: symbol i of either is about block i.
struct CyclicWords {
  std::vector<BlockSymbol> forwards, backwards;
};

/// O(bk).
[[nodiscard]] CyclicWords cyclic_words(const Design& design);

/// Where the least rotation of a word begins, and the shortest rotation that leaves the word as it
/// is.
struct LeastRotation {
  std::size_t start = 0;
  std::size_t period = 0;
};

/// O(length).
[[nodiscard]] LeastRotation least_rotation(const std::vector<BlockSymbol>& word);

}  // namespace changeover
