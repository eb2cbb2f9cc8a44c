// The state of a local search with an imposed automorphism, strength 2.
//
//     const ImposedAutomorphism pi{.order = 7, .fixed = 0};       // on 28 elements: four 7-cycles
//     SegmentOrbits state({.v = 28, .k = 6, .kind = Kind::circular}, pi, base_blocks);
//     state.missing();                                          // uncovered orbits of pairs
//     state.design();                                           // all c·7 blocks
//
// π has cycles of one length n, (0 1 … n−1)(n … 2n−1)…, and fixes the last f elements. The list is
// circular with b = cn blocks and B_{i+c} = π(Bᵢ), so c blocks say all: a pair is covered if some
// pair of its orbit is in one of them. A segment swap of {x,y} is made together with its n images.
// Images that reach the same blocks, or follow one another, must have no element in common with the
// move itself (then they do not disturb each other); a segment that is too long for that is no
// move.
//
// Looking at a move costs O(segment · k): its counters are changed and changed back.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"
#include "run/random.hpp"
#include "search/local/segment_swap.hpp"

namespace changeover {

/// A permutation of v elements: (v−f)/n cycles of length n on the first elements, the last f fixed.
struct ImposedAutomorphism {
  std::uint32_t order = 1;  ///< n ≥ 1
  std::uint32_t fixed = 0;  ///< f

  /// Whether n divides v − f.
  [[nodiscard]] bool fits(std::uint64_t v) const {
    return order > 0 && fixed <= v && (v - fixed) % order == 0;
  }

  /// πˢ(x), −n < s.
  [[nodiscard]] Element image(Element x, std::int64_t s, std::uint64_t v) const {
    if (x >= v - fixed) {
      return x;
    }
    const std::int64_t n = order;
    const std::int64_t at = x % order;
    return x - static_cast<Element>(at) + static_cast<Element>(((at + s) % n + n) % n);
  }

  bool operator==(const ImposedAutomorphism&) const = default;
};

/// Base blocks under search; see above.
class SegmentOrbits {
 public:
  /// The memory that c base blocks need, at most. @throws ImpossibleParameters if that exceeds 64 bits.
  [[nodiscard]] static std::uint64_t bytes(const Parameters& p, const ImposedAutomorphism& pi,
                                           std::uint64_t c);

  /// c ≥ 1 base blocks of k elements whose steps, the one from the last to π(first) included,
  /// change m elements. pi.fits(v), v ≤ 65,535.
  SegmentOrbits(const Parameters& p, const ImposedAutomorphism& pi,
                std::span<const Block> base_blocks);

  [[nodiscard]] std::uint32_t base_block_count() const { return c_; }
  [[nodiscard]] std::uint64_t missing() const { return uncovered_.size(); }
  [[nodiscard]] std::size_t orbit_count() const { return orbits_.size(); }
  /// How many pairs of base blocks lie in the orbit of {x,y}; x ≠ y.
  [[nodiscard]] std::uint32_t count(Element x, Element y) const {
    return counts_[orbit_of_[std::size_t{x} * v_ + y]];
  }
  /// The k elements of a base block, in no order.
  [[nodiscard]] std::span<const std::uint16_t> block(std::uint32_t index) const {
    return std::span(elements_).subspan(std::size_t{index} * k_, k_);
  }

  /// All blocks, circular.
  [[nodiscard]] Design design() const;

  /// The move that exchanges x in base block i and y outside it. `first` may stand for a block
  /// before the base blocks: it is counted from block −n·c.
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
  struct Pair {
    std::uint16_t x = 0;
    std::uint16_t y = 0;
  };

  [[nodiscard]] bool contains(std::uint32_t i, Element x) const {
    return members_[std::size_t{i} * v_ + x] != 0;
  }
  [[nodiscard]] Element image(Element x, std::uint32_t s) const {
    return images_[std::size_t{s} * v_ + x];
  }
  // The least s ≥ 1 such that πˢ{x,y} meets {x,y}.
  [[nodiscard]] std::uint32_t meets_itself(Element x, Element y) const;
  [[nodiscard]] std::int32_t look(const SegmentSwap& move);
  template <typename Visit>
  void visit_counters(const SegmentSwap& move, Visit&& visit);
  void exchange(const SegmentSwap& move);
  void add(std::uint32_t orbit);
  void remove(std::uint32_t orbit);

  Parameters parameters_;
  ImposedAutomorphism pi_;
  std::uint32_t v_, k_, c_, usual_;
  std::vector<std::uint16_t> images_;     // order rows of v
  std::vector<std::uint32_t> orbit_of_;   // v rows of v
  std::vector<Pair> orbits_;              // one pair of each
  std::vector<std::uint32_t> counts_;     // by orbit
  std::vector<std::uint8_t> members_;     // c rows of v
  std::vector<std::uint16_t> elements_;   // k of each base block
  std::vector<std::uint32_t> uncovered_;  // orbits, without order
  std::vector<std::uint32_t> place_;      // of an orbit in uncovered_
};

}  // namespace changeover
