// Base blocks that cover each difference of Z_w once but for a few, the *leave*: what the
// construction held-factors begins with [docs/theorems.md, Theorem 33].
//
// With n = k−2 and N = 2k−3 there are c base blocks A ∪ {x, y}, A = {0, …, n−1}, over Z_w, w =
// 2cN + 2δ + 1 or 2cN + 2δ + 2. Their new pairs have cN differences, each once. δ of 1, …, cN+δ are
// left, and w/2 if w is even. For most base blocks x and y are x_p = pN+n and x_q, where the pairs
// {p, q} have the differences 1, 2, …: a Skolem sequence, or one with a hole.
//
//     CyclicLeave leave(4, {.rounds = 3, .left = 1, .even = false});   // Z_33
//     leave.points(2);                                                 // {2, 12}
//     leave.differences();                                             // {13}
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

class CyclicLeave {
 public:
  struct Shape {
    std::uint64_t rounds = 0;  ///< c
    std::uint64_t left = 0;    ///< δ
    bool even = false;         ///< w
  };

  /// Whether there are base blocks of that shape for k ≥ 4 and c ≥ 1.
  [[nodiscard]] static bool serves(std::uint64_t k, const Shape& shape);

  /// Needs serves(), and w < 2³².
  CyclicLeave(std::uint64_t k, const Shape& shape);

  [[nodiscard]] std::uint64_t elements() const { return w_; }
  [[nodiscard]] std::uint64_t base_blocks() const { return c_; }

  /// The elements besides A of base block i, 0 ≤ i < c, the smaller first. The last base block
  /// contains n, so that A + 1 is kept on the way to the next round. O(1).
  [[nodiscard]] std::array<Element, 2> points(std::uint64_t i) const;

  /// The δ differences that are left, without w/2, increasing. O(δ).
  [[nodiscard]] std::vector<std::uint64_t> differences() const;

 private:
  struct Indices {
    std::int64_t p = 0, q = 0;
  };
  [[nodiscard]] std::uint64_t ordinary() const { return holed() ? c_ - 1 : c_; }
  [[nodiscard]] bool holed() const { return c_ % 4 >= 2; }
  [[nodiscard]] std::uint64_t beyond() const;
  [[nodiscard]] Indices indices(std::uint64_t i) const;
  [[nodiscard]] std::uint64_t linking() const;
  [[nodiscard]] Element element(std::int64_t x) const;

  std::uint64_t n_, step_, c_, left_, w_;
  bool even_;
};

}  // namespace changeover
