// The state of a local search with an imposed automorphism, strength 2.
//
//     const Automorphism pi{.n = 7, .cycles = 4};
//     SegmentOrbits state({.v = 28, .k = 6, .kind = Kind::circular}, pi, base_blocks);
//     state.missing();                                          // uncovered orbits of pairs
//     state.design();                                           // all c·7 blocks
//
// π has cycles of one length n and fixed elements (core/developed.hpp). The list is circular with b
// = cn blocks and B_{i+c} = π(Bᵢ), so c blocks determine it: a pair is covered if some pair of its
// orbit is in one of them. A segment swap of {x,y} is made together with its n images. Images that
// reach the same or consecutive blocks must have no element in common with the swap itself, so that
// they do not interfere; a segment that is too long for that is not a move.
//
// Evaluating a move costs O(segment · k): its counters are changed and changed back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/developed.hpp"
#include "changeover/core/parameters.hpp"
#include "run/random.hpp"
#include "search/local/segment_pairs.hpp"
#include "search/local/segment_swap.hpp"
#include "search/pair_orbits.hpp"

namespace changeover {

/// Base blocks during a search; see above.
class SegmentOrbits {
 public:
  /// The memory for c base blocks, at most. @throws ImpossibleParameters if that exceeds 64 bits.
  [[nodiscard]] static std::uint64_t bytes(const Parameters& p, const Automorphism& pi,
                                           std::uint64_t c);

  /// c ≥ 1 base blocks of k elements whose steps, including the one from the last to π(first),
  /// change m elements. v = pi.v() ≤ 65,535.
  SegmentOrbits(const Parameters& p, const Automorphism& pi, std::span<const Block> base_blocks);

  [[nodiscard]] std::uint32_t base_block_count() const { return c_; }
  [[nodiscard]] std::uint64_t missing() const { return coverage_.missing(); }
  /// How many pairs of base blocks lie in the orbit of {x,y}; x ≠ y.
  [[nodiscard]] std::uint32_t count(Element x, Element y) const {
    return coverage_.times(orbits_.of(x, y));
  }
  /// The k elements of a base block, in any order.
  [[nodiscard]] std::span<const std::uint16_t> block(std::uint32_t index) const {
    return std::span(elements_).subspan(std::size_t{index} * k_, k_);
  }

  /// All blocks, circular.
  [[nodiscard]] Design design() const;

  /// The move that exchanges x in base block i and y outside it. `first` may be a block before the
  /// base blocks: it is counted from block −n·c.
  [[nodiscard]] SegmentSwap segment(std::uint32_t i, Element x, Element y) const;

  /// A move at a random place.
  [[nodiscard]] SegmentSwap propose(Random& random) const;
  /// A move that brings an uncovered pair together in some base block; missing() must not be 0.
  [[nodiscard]] SegmentSwap propose_aimed(Random& random) const;

  /// As SegmentPairs::attempt(), in orbits.
  template <typename Accept>
  bool attempt(const SegmentSwap& move, Accept&& accept) {
    if (!accept(look(move))) {
      return false;
    }
    exchange(move);
    return true;
  }

  /// Makes the move, with its images.
  void apply(const SegmentSwap& move) { exchange(move); }

 private:
  [[nodiscard]] bool contains(std::uint32_t i, Element x) const {
    return members_[std::size_t{i} * v_ + x] != 0;
  }
  [[nodiscard]] Element image(Element x, std::uint32_t s) const {
    return images_[std::size_t{s} * v_ + x];
  }
  [[nodiscard]] std::int32_t look(const SegmentSwap& move);
  template <typename Visit>
  void visit_counters(const SegmentSwap& move, Visit&& visit);
  void exchange(const SegmentSwap& move);

  Parameters parameters_;
  Automorphism pi_;
  std::uint32_t n_, v_, k_, c_, usual_;
  std::vector<std::uint16_t> images_;  // n rows of v
  PairOrbits orbits_;
  std::vector<std::uint8_t> members_;    // c rows of v
  std::vector<std::uint16_t> elements_;  // k of each base block
  Coverage coverage_;                    // of the orbits
};

}  // namespace changeover
