// Base blocks of three points besides an interval that cover each difference of Z_w once but for a
// few, and classes of triangles of these: what held-triangles consists of [docs/theorems.md,
// Theorem 34].
//
// With N = k−2 there are c base blocks {0, …, N−2} ∪ {x, y, z} over Z_w. Their new pairs have 3cN
// differences, j more than if each came once; t differences are left:
//
//     odd      w = 6cN + 2t − 2j + 1
//     doubled  w = 6cN + 2t − 2j, where w/2 is covered, so pairs with that difference come twice
//
// If t ≡ 1 (mod 3), w/3 is one of those left. The others are the differences of triangles {0, d, e}
// whose three elements are different modulo 3, and w ≡ 0 (mod 3). So there are t classes of w/3
// triangles each of which holds every element of Z_w.
//
//     const auto leave = TripleLeave::of(5, 77);   // Z_75, t = 1
//     leave->base_blocks();                        // 4
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/developed.hpp"
#include "construct/tools/leave/held_classes.hpp"

namespace changeover {

struct FormalLeave;

class TripleLeave final : public HeldClasses {
 public:
  using Triple = std::array<Element, 3>;

  /// With v = w + (k−3)t and t ≥ 1, those known with the fewest blocks; null if there are none.
  /// O(c) for each of those known.
  [[nodiscard]] static std::shared_ptr<const TripleLeave> of(std::uint64_t k, std::uint64_t v);
  /// With t = 0 and w = v.
  [[nodiscard]] static std::shared_ptr<const TripleLeave> without_leave(std::uint64_t k,
                                                                        std::uint64_t v);

  [[nodiscard]] std::uint64_t elements() const override { return w_; }
  [[nodiscard]] std::uint64_t base_blocks() const override { return base_.size(); }
  /// The last base block contains N−1, so that {1, …, N−1} is kept on the way to the next round.
  [[nodiscard]] IntervalDevelopedSource::Points points() const override;
  [[nodiscard]] std::uint64_t groups() const override { return t_; }
  [[nodiscard]] std::uint64_t count(std::uint64_t) const override { return w_ / 3; }
  /// The first triangle of the first class contains w−1, the last one of the last class 0.
  void write(std::uint64_t i, std::uint64_t j, std::span<Element> set) const override;

  [[nodiscard]] bool is_doubled() const { return w_ % 2 == 0; }
  /// The t differences that are left, increasing.
  [[nodiscard]] std::vector<std::uint64_t> differences() const;

 private:
  TripleLeave(std::uint64_t w, std::uint64_t t) : w_(w), t_(t) {}
  static std::shared_ptr<const TripleLeave> any_of(std::uint64_t k, std::uint64_t v, bool leaves);
  [[nodiscard]] std::uint64_t sets() const { return base_.size() * w_ + t_ * (w_ / 3); }
  bool make(const FormalLeave& known, std::uint64_t N);
  bool order_for_link();

  std::uint64_t w_, t_;
  std::vector<Triple> base_;
  std::vector<Triple> triangles_;  // {0, d, e}
};

}  // namespace changeover
