// Base blocks that cover each difference of Z_w once but for a few, the *leave*: what the
// construction held-factors begins with [docs/theorems.md, Theorem 33].
//
// With n = k−2 and N = 2k−3 there are c base blocks A ∪ {x, y}, A = {0, …, n−1}, over Z_w. Their
// new pairs have cN differences, each once. δ differences below w/2 are left, and of w/2:
//
//     Half::none      w = 2cN + 2δ + 1, there is no w/2
//     Half::left      w = 2cN + 2δ + 2, w/2 is left
//     Half::covered   w = 2cN + 2δ, w/2 is covered, so pairs with that difference are covered twice
//
// For all base blocks but one x and y are x_p = pN+n and x_q, where the pairs {p, q} have the
// differences 1, …, c−1.
//
//     CyclicLeave leave(4, {.rounds = 3, .left = 1, .half = CyclicLeave::Half::none});   // Z_33
//     leave.points(2);                                                                   // {2, 12}
//     leave.differences();                                                               // {13}
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/developed.hpp"

namespace changeover {

class CyclicLeave {
 public:
  enum class Half : std::uint8_t { none, left, covered };
  struct Shape {
    std::uint64_t rounds = 0;  ///< c
    std::uint64_t left = 0;    ///< δ
    Half half = Half::none;
  };

  /// Whether there are base blocks of that shape for k ≥ 4 and c ≥ 1.
  [[nodiscard]] static bool serves(std::uint64_t k, const Shape& shape);

  /// Needs serves(), and w < 2³².
  CyclicLeave(std::uint64_t k, const Shape& shape);

  [[nodiscard]] std::uint64_t elements() const { return w_; }
  [[nodiscard]] std::uint64_t base_blocks() const { return shape_.rounds; }
  [[nodiscard]] Half half() const { return shape_.half; }

  /// The elements besides A of base block i, 0 ≤ i < c, the smaller first. The last base block
  /// contains n, so that A + 1 is kept on the way to the next round. O(1).
  [[nodiscard]] std::array<Element, 2> points(std::uint64_t i) const;

  /// points() for IntervalDevelopedSource.
  [[nodiscard]] IntervalDevelopedSource::Points all_points() const;

  /// The δ differences that are left, without w/2, increasing. O(δ).
  [[nodiscard]] std::vector<std::uint64_t> differences() const;

 private:
  [[nodiscard]] bool lacks_zero() const { return shape_.rounds % 4 < 2; }
  [[nodiscard]] std::uint64_t beyond() const;
  [[nodiscard]] std::array<std::int64_t, 2> pair(std::uint64_t i) const;
  [[nodiscard]] std::uint64_t linking() const;

  std::uint64_t n_, step_, w_;
  Shape shape_;
};

}  // namespace changeover
