// The move of local search: exchange two elements in a run of consecutive blocks.
//
// Take a block with x and without y, and extend left and right while each block contains exactly
// one of x and y. Exchanging x and y in all blocks of that run keeps the change property: within
// the run both blocks of a step are relabelled in the same way; at its ends the block outside
// contains both or neither, so relabelling would not change it. The move is its own inverse.
//
//     x in block:   . x x . .          . . . x x
//     y in block:   . . . y y    →     . y y . .        (the blocks before and after hold neither)
//
// States of a search (segment_pairs.hpp, segment_subsets.hpp, segment_orbits.hpp) offer
//     propose(random), propose_aimed(random)   a move, of length 0 if it is not possible
//     attempt(move, accept)                    computes the change of missing(), asks
//                                              accept(change), makes the move if it says true
//     missing()                                what is uncovered; the search ends at 0
#pragma once

#include <cstdint>
#include <span>

#include "changeover/core/block.hpp"

namespace changeover {

/// Exchange x and y in `length` blocks from block `first` on, across the end of a circular list if
/// necessary. Length 0 means no move.
struct SegmentSwap {
  std::uint32_t first = 0;
  std::uint32_t length = 0;
  Element x = 0;
  Element y = 0;

  bool operator==(const SegmentSwap&) const = default;
};

/// This element stays in this block (blocks from 0).
struct LockedCell {
  std::uint32_t block = 0;
  Element element = 0;
};

/// These elements stay together from one block to the next. Where may change: at first it is from
/// `block` to the block after it, and a move may leave any two neighbours that hold all of them.
struct LockedPart {
  Block elements{};
  std::uint32_t block = 0;
};

/// What moves must leave as it is, strength 2 only.
struct Locks {
  std::span<const LockedCell> cells{};
  std::span<const LockedPart> parts{};  ///< disjoint
};

/// Successful moves exchange runs of about k/m blocks. Longer ones than this are rarely accepted
/// and cost most to evaluate, so searches try them only now and then.
[[nodiscard]] constexpr std::uint32_t usual_segment(std::uint64_t k, std::uint64_t change) {
  return static_cast<std::uint32_t>(2 * k / change + 2);
}

/// The longest run around block i of b blocks in which differ(block) holds, as it does at i, as a
/// move of x and y; of length 0 if the run is longer than `longest` or is the whole circular list.
template <typename Differ>
[[nodiscard]] SegmentSwap find_segment(std::uint32_t b, bool circular, std::uint32_t longest,
                                       std::uint32_t i, Element x, Element y, Differ&& differ) {
  SegmentSwap move{i, 1, x, y};
  while (move.length < b && move.length <= longest && (move.first > 0 || circular)) {
    const std::uint32_t before = move.first > 0 ? move.first - 1 : b - 1;
    if (!differ(before)) {
      break;
    }
    move.first = before;
    ++move.length;
  }
  std::uint32_t last = i;
  while (move.length < b && move.length <= longest && (last + 1 < b || circular)) {
    const std::uint32_t after = last + 1 < b ? last + 1 : 0;
    if (!differ(after)) {
      break;
    }
    last = after;
    ++move.length;
  }
  if (move.length > longest || (circular && move.length == b)) {
    move.length = 0;
  }
  return move;
}

}  // namespace changeover
