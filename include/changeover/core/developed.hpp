// Base blocks developed into a stream: B₀, …, B_{c−1}, π(B₀), …, π(B_{c−1}), …, π^{n−1}(B_{c−1}).
//
//     DevelopedSource source({{.v = 11, .k = 4, .kind = Kind::circular}, {{0, 1, 2, 5}}});
//
// Memory is that of the base blocks; the list has cn blocks, over Z_v cv.
#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

// Permutations that designs are developed under: cycles of one length, and fixed points.
//
//     const Automorphism pi{.n = 7, .cycles = 4, .fixed = 1};  // (0 … 6)(7 … 13) … (21 … 27)(28)
//     pi.v();                                                   // 29
//     pi.image(6, 1);                                           // 0
//     pi.image(block, 3);                                       // π³ of each element
//
// Element on + r is the residue r of cycle o; the last f elements are fixed. π adds 1 to every
// residue: with one cycle and no fixed point it is x ↦ x + 1 over Z_v. Any permutation with such
// cycles is π with other names for the elements; π^u, for a unit u of Z_n, with those of renamed().

/// π: v = sn + f, and order n.
struct Automorphism {
  std::uint64_t n = 1;       ///< length of the cycles, at least 1
  std::uint64_t cycles = 0;  ///< s
  std::uint64_t fixed = 0;   ///< f

  /// With n-cycles and a number of fixed points on v elements; nullopt unless n ≥ 1 divides
  /// v − fixed ≥ 0.
  [[nodiscard]] static std::optional<Automorphism> on(std::uint64_t v, std::uint64_t n,
                                                      std::uint64_t fixed = 0) {
    if (n == 0 || fixed > v || (v - fixed) % n != 0) {
      return std::nullopt;
    }
    return Automorphism{n, (v - fixed) / n, fixed};
  }

  [[nodiscard]] std::uint64_t v() const { return moved() + fixed; }

  /// The elements below this number are in cycles.
  [[nodiscard]] std::uint64_t moved() const { return n * cycles; }
  [[nodiscard]] bool moves(Element x) const { return x < moved(); }

  /// The cycle of x, from 0; s + i for the i-th fixed point.
  [[nodiscard]] std::uint64_t cycle(Element x) const {
    return moves(x) ? x / n : cycles + (x - moved());
  }

  /// The place of x in its cycle, which it must have.
  [[nodiscard]] std::uint64_t residue(Element x) const { return cycles == 1 ? x : x % n; }

  /// π^power(x), power ≤ n; the power n − 1 is the inverse.
  [[nodiscard]] Element image(Element x, std::uint64_t power) const {
    if (!moves(x)) {
      return x;
    }
    const std::uint64_t sum = residue(x) + power;
    return static_cast<Element>(x + power - (sum >= n ? n : 0));
  }

  /// Writes π^power(x) for each element x of a block, in its place.
  void image(std::span<const Element> block, std::uint64_t power, std::span<Element> to) const {
    std::transform(block.begin(), block.end(), to.begin(),
                   [&](Element x) { return image(x, power); });
  }
  [[nodiscard]] Block image(const Block& block, std::uint64_t power) const {
    Block result(block.size());
    image(block, power, result);
    return result;
  }

  /// Renames residue r to ur, u < n, which turns π into π^u.
  [[nodiscard]] Element renamed(Element x, std::uint64_t unit) const {
    return moves(x) ? static_cast<Element>(x - residue(x) + residue(x) * unit % n) : x;
  }

  /// The least s ≥ 1 such that π^s{x,y} meets {x,y}, x ≠ y.
  [[nodiscard]] std::uint64_t meets_itself(Element x, Element y) const {
    if (!moves(x) || !moves(y)) {
      return 1;
    }
    const std::uint64_t apart = x > y ? x - y : y - x;
    return cycle(x) == cycle(y) ? std::min(apart, n - apart) : n;
  }

  /// The number of orbits of the pairs of elements. @throws ImpossibleParameters if it exceeds 64
  /// bits.
  [[nodiscard]] std::uint64_t pair_orbits() const;

  auto operator<=>(const Automorphism&) const = default;
};

/// A circular design given by base blocks over Z_v.
struct BaseBlocks {
  Parameters parameters;
  std::vector<Block> blocks;

  /// The number of blocks of the developed design, c·v. @throws ImpossibleParameters on overflow.
  [[nodiscard]] std::uint64_t block_count() const;

  bool operator==(const BaseBlocks&) const = default;
};

/// A circular design given by base blocks under a permutation with several cycles; automorphism.v()
/// is the v of the base blocks.
struct OrbitBaseBlocks {
  BaseBlocks base;
  Automorphism automorphism;
};

/// The development of base blocks as a stream.
class DevelopedSource final : public BlockSource {
 public:
  /// @throws BadInput unless there is a base block and each has k elements below v.
  explicit DevelopedSource(const BaseBlocks& base);

  /// The development under π^shift, shift < n, instead of x ↦ x + 1. pi.v() must be the v of the
  /// base blocks.
  DevelopedSource(BaseBlocks base, const Automorphism& pi, std::uint64_t shift = 1);

  [[nodiscard]] const Parameters& parameters() const override { return base_.parameters; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override { return block_count_; }
  std::span<const Element> read(std::span<Element> room) override;
  bool rewind() override {
    which_ = 0;
    times_ = power_ = 0;
    return true;
  }

  [[nodiscard]] const BaseBlocks& base() const { return base_; }

 private:
  BaseBlocks base_;
  Automorphism pi_;
  std::uint64_t shift_;
  std::uint64_t block_count_;
  std::size_t which_ = 0;
  std::uint64_t times_ = 0;  // that the base blocks were handed out
  std::uint64_t power_ = 0;  // times · shift, modulo n
};

// Base blocks over Z_v that have an interval in common. Only their other points are stored.
//
// The base blocks are A ∪ P₀, …, A ∪ P_{c−1} with A = {a, a+1, …, a+n−1} ⊂ Z_v and k − n points in
// each Pᵢ. The cyclic families are of this shape with n = k − m: A + j is what two blocks of a
// round have in common. Memory is c(k−n) numbers whatever k is, so that a million base blocks of a
// thousand elements take 8 MB and not 4 GB.
//
//     // The two base blocks {0,1,4,12}, {0,1,2,7} of the tight circular DCCD(21,4,42).
//     IntervalBaseBlocks base{{.v = 21, .k = 4, .kind = Kind::circular}, 0, 2, {4, 12, 2, 7}};
//     IntervalDevelopedSource source(base);   // the 42 blocks
//     verify_differences(base).tight;         // verify/difference.hpp, O(c log c)

/// A circular design given by base blocks over Z_v that share an interval.
struct IntervalBaseBlocks {
  Parameters parameters;
  std::uint64_t start = 0;      ///< a, below v
  std::uint64_t length = 0;     ///< n, less than k
  std::vector<Element> points;  ///< k − n of each base block, one base block after another

  /// k − n. Needs length < k, as all below.
  [[nodiscard]] std::uint64_t points_per_block() const { return parameters.k - length; }

  /// c.
  [[nodiscard]] std::size_t base_block_count() const {
    return points.size() / static_cast<std::size_t>(points_per_block());
  }

  /// The points of base block i, 0 ≤ i < c.
  [[nodiscard]] std::span<const Element> points_of(std::size_t i) const {
    const auto each = static_cast<std::size_t>(points_per_block());
    return std::span(points).subspan(i * each, each);
  }

  /// The number of blocks of the developed design, c·v. @throws ImpossibleParameters on overflow.
  [[nodiscard]] std::uint64_t block_count() const;

  /// All elements of the base blocks, those of the interval first. O(ck) memory.
  /// @throws as check_shape().
  [[nodiscard]] BaseBlocks written_out() const;

  bool operator==(const IntervalBaseBlocks&) const = default;
};

/// Checks that start < v, length < k, that there is a base block, and that each has k − n points,
/// all below v; does not check that its elements are distinct. @throws BadInput if not;
/// ImpossibleParameters as check().
void check_shape(const IntervalBaseBlocks& base);

/// The development A ∪ P₀, …, A ∪ P_{c−1}, (A ∪ P₀) + 1, … as a stream of cv blocks. The interval
/// comes first in each block, then the points.
class IntervalDevelopedSource final : public BlockSource {
 public:
  /// Writes the points of base block `which` into `points`, the same ones at every call. If all
  /// base blocks together have at most 2¹⁶ points, it is called once for each and the points are
  /// kept; otherwise it is called for every block, so that base blocks given by a formula need no
  /// memory.
  using Points = std::function<void(std::uint64_t which, std::span<Element> points)>;

  /// A design of `base_blocks` base blocks whose points come from `points`, which is trusted.
  /// @throws BadInput unless start < v, length < k and base_blocks ≥ 1; ImpossibleParameters as
  /// check(), or if cv does not fit in 64 bits.
  IntervalDevelopedSource(const Parameters& parameters, std::uint64_t start, std::uint64_t length,
                          std::uint64_t base_blocks, Points points);

  /// @throws as check_shape().
  explicit IntervalDevelopedSource(IntervalBaseBlocks base);

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return base_blocks_ * parameters_.v;
  }
  std::span<const Element> read(std::span<Element> room) override;
  bool rewind() override {
    which_ = 0;
    shift_ = 0;
    return true;
  }

 private:
  Parameters parameters_;
  std::uint64_t start_, length_, base_blocks_;
  void write_points(std::span<Element> points);

  Points points_;
  std::vector<Element> kept_points_;  // of all base blocks, if they are few
  std::uint64_t which_ = 0;
  std::uint64_t shift_ = 0;
};

}  // namespace changeover
