// Base blocks over Z_v that have an interval in common, held by their other points only.
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
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/developed.hpp"

namespace changeover {

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

/// Checks that start < v, length < k, and that there are k − n points, all below v, for each of one
/// or more base blocks; not that a base block has distinct elements. @throws BadInput if not;
/// ImpossibleParameters as check().
void check_shape(const IntervalBaseBlocks& base);

/// The development A ∪ P₀, …, A ∪ P_{c−1}, (A ∪ P₀) + 1, … as a stream of cv blocks. The interval
/// comes first in each block, then the points.
class IntervalDevelopedSource final : public BlockSource {
 public:
  /// Writes the points of base block `which` into `points`. Asked once for every base block and kept if
  /// all of them have 2¹⁶ points at most, else once for every block, so that base blocks with a formula need
  /// no memory; the same question must have the same answer.
  using Points = std::function<void(std::uint64_t which, std::span<Element> points)>;

  /// `base_blocks` base blocks whose points are told by `points`, which is trusted.
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
