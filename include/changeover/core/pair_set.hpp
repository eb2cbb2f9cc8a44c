// A set of unordered pairs {x,y} of elements, one bit each.
//
//     PairSet covered(v);
//     covered.insert(3, 7);
//     covered.missing();                       // how many of the C(v,2) pairs are not in the set
//     covered.for_each_missing(20, print);  // twenty of them, smallest elements first
//
// Memory: C(v,2) bits, 268 MB at v = 65,535.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

/// Pairs of distinct elements below v.
class PairSet {
 public:
  /// @throws ImpossibleParameters if C(v,2) does not fit in 64 bits.
  explicit PairSet(std::uint64_t v);

  [[nodiscard]] std::uint64_t v() const { return v_; }

  /// The place of {x,y} among the C(v,2) pairs: the pairs below a larger element come first. x ≠ y.
  [[nodiscard]] static constexpr std::uint64_t rank(Element x, Element y) {
    const std::uint64_t low = x < y ? x : y;
    const std::uint64_t high = x < y ? y : x;
    return high * (high - 1) / 2 + low;
  }

  /// Adds {x,y}; x ≠ y, both below v.
  void insert(Element x, Element y) {
    const std::uint64_t r = rank(x, y);
    words_[static_cast<std::size_t>(r >> 6)] |= std::uint64_t{1} << (r & 63);
  }

  /// Adds {x,y} for every y < x whose bit is set in `below`, a set of elements with one bit each.
  /// O(x / 64).
  void insert_below(Element x, std::span<const std::uint64_t> below);

  /// Adds {x,y} for every y < x among the 64 elements from 64 · `word` on whose bit is set in
  /// `bits`. O(1).
  void insert_below(Element x, std::size_t word, std::uint64_t bits) {
    const std::uint64_t first = 64 * std::uint64_t{word};
    if (first >= x) {
      return;
    }
    if (const std::uint64_t most = x - first; most < 64) {
      bits &= (std::uint64_t{1} << most) - 1;
    }
    const std::uint64_t r = rank(0, x) + first;
    std::uint64_t* const into = words_.data() + r / 64;
    into[0] |= bits << r % 64;
    // The rest is in the next word, which exists if there is a bit for it.
    if (const std::uint64_t rest = r % 64 == 0 ? 0 : bits >> (64 - r % 64); rest != 0) {
      into[1] |= rest;
    }
  }

  /// For which y from 64 · `word` on, y < x, the pair {x,y} is in the set, a bit each. O(1).
  [[nodiscard]] std::uint64_t below(Element x, std::size_t word) const {
    const std::uint64_t first = 64 * std::uint64_t{word};
    if (first >= x) {
      return 0;
    }
    const std::uint64_t r = rank(0, x) + first;
    const std::uint64_t* const from = words_.data() + r / 64;
    std::uint64_t bits = from[0] >> r % 64;
    const std::uint64_t most = x - first;
    if (r % 64 != 0 && most > 64 - r % 64) {
      bits |= from[1] << (64 - r % 64);
    }
    return most < 64 ? bits & ((std::uint64_t{1} << most) - 1) : bits;
  }

  [[nodiscard]] bool contains(Element x, Element y) const {
    const std::uint64_t r = rank(x, y);
    return (words_[static_cast<std::size_t>(r >> 6)] >> (r & 63) & 1) != 0;
  }

  /// The number of pairs in the set. O(v²/64).
  [[nodiscard]] std::uint64_t size() const;

  /// The number of the C(v,2) pairs that are not in the set. O(v²/64).
  [[nodiscard]] std::uint64_t missing() const;

  /// Calls visit(x, y), x < y, for up to `limit` pairs that are not in the set, ordered by y and
  /// then by x. O(v²/64 + pairs visited).
  template <typename Visit>
  void for_each_missing(std::uint64_t limit, Visit&& visit) const {
    scan(~std::uint64_t{0}, limit, visit);
  }

  /// Calls visit(x, y), x < y, for up to `limit` pairs that are in the set, ordered by y and then
  /// by x.
  template <typename Visit>
  void for_each(std::uint64_t limit, Visit&& visit) const {
    scan(0, limit, visit);
  }

 private:
  // Visits the pairs whose bit is set after an exclusive or with `flip`.
  template <typename Visit>
  void scan(std::uint64_t flip, std::uint64_t limit, Visit&& visit) const {
    Element high = 1;
    std::uint64_t row = 0;  // rank of {0, high}
    for (std::uint64_t r = next(0, flip); r < pairs_ && limit > 0; r = next(r + 1, flip), --limit) {
      while (r >= row + high) {
        row += high++;
      }
      visit(static_cast<Element>(r - row), high);
    }
  }

  // The first such rank from r on.
  [[nodiscard]] std::uint64_t next(std::uint64_t r, std::uint64_t flip) const;

  std::uint64_t v_;
  std::uint64_t pairs_;  // C(v,2)
  std::vector<std::uint64_t> words_;
};

}  // namespace changeover
