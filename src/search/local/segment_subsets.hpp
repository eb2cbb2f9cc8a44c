// The state of a local search for any strength t: a list of blocks, and the number of blocks that
// contain each t-subset.
//
//     SegmentSubsets state(design);                        // design.parameters().strength says t
//     anneal(state, {.moves = 1'000'000}, random, control);
//
// Like segment_pairs.hpp, but with one counter for each of the C(v,t) subsets. A move is evaluated
// by making it, and undone if it is refused: O(segment · C(k−1,t−1)). The scope of the thread
// (run/control.hpp) can stop the constructor.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"
#include "run/random.hpp"
#include "search/local/segment_pairs.hpp"
#include "search/local/segment_swap.hpp"
#include "search/subset_ranks.hpp"

namespace changeover {

/// Blocks during a search; see above.
class SegmentSubsets {
 public:
  /// The memory for b blocks. @throws ImpossibleParameters if that exceeds 64 bits.
  [[nodiscard]] static std::uint64_t bytes(const Parameters& p, std::uint64_t b);

  /// A list of one or more blocks; the first `frozen` < b never change.
  /// @throws MissingResource if C(v,t) exceeds 2²⁸.
  explicit SegmentSubsets(const Design& design, std::size_t frozen = 0);

  [[nodiscard]] std::uint32_t block_count() const { return b_; }
  /// The number of t-subsets that are in no block. O(1).
  [[nodiscard]] std::uint64_t missing() const { return coverage_.missing(); }
  /// The k elements of a block, in any order.
  [[nodiscard]] std::span<const std::uint16_t> block(std::uint32_t index) const {
    return std::span(elements_).subspan(std::size_t{index} * k_, k_);
  }
  [[nodiscard]] bool contains(std::uint32_t i, Element x) const {
    return members_[std::size_t{i} * v_ + x] != 0;
  }
  /// The number of blocks that contain all of these t increasing elements.
  [[nodiscard]] std::uint32_t count(std::span<const Element> subset) const {
    return coverage_.times(static_cast<std::size_t>(ranks_.rank(subset)));
  }

  /// The current blocks.
  [[nodiscard]] Design design() const;

  /// As SegmentPairs::segment().
  [[nodiscard]] SegmentSwap segment(std::uint32_t i, Element x, Element y) const {
    return segment(i, x, y, b_);
  }
  [[nodiscard]] SegmentSwap segment(std::uint32_t i, Element x, Element y,
                                    std::uint32_t longest) const;

  /// A move at a random place.
  [[nodiscard]] SegmentSwap propose(Random& random) const;
  /// A move that brings one more element of an uncovered subset into a block that has some of it;
  /// missing() must not be 0.
  [[nodiscard]] SegmentSwap propose_aimed(Random& random) const;

  /// As SegmentPairs::attempt(), in subsets.
  template <typename Accept>
  bool attempt(const SegmentSwap& move, Accept&& accept) {
    const auto before = static_cast<std::int32_t>(coverage_.missing());
    exchange(move);
    if (accept(static_cast<std::int32_t>(coverage_.missing()) - before)) {
      return true;
    }
    exchange(move);  // its own inverse
    return false;
  }

  /// Makes the move. Making it twice restores the state.
  void apply(const SegmentSwap& move) { exchange(move); }

 private:
  void exchange(const SegmentSwap& move);
  template <bool Adding>
  void count_with(Element x, std::uint32_t from, std::uint32_t chosen, std::uint32_t below,
                  std::uint64_t rank);

  Parameters parameters_;
  std::uint32_t v_, k_, t_, b_, frozen_, usual_;
  bool circular_;
  SubsetRanks ranks_;
  std::vector<std::uint8_t> members_;    // b rows of v
  std::vector<std::uint16_t> elements_;  // k of each block
  Coverage coverage_;                    // of the subsets
  std::vector<Element> others_;          // scratch: a block without x, increasing
};

}  // namespace changeover
