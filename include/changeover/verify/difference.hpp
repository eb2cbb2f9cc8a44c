// Difference certificates: designs developed from base blocks over Z_v, verified without
// developing.
//
// Base blocks B₀, …, B_{c−1} over Z_v stand for the circular list B₀, …, B_{c−1}, B₀+1, …,
// B_{c−1}+1, …, B_{c−1}+(v−1) of cv blocks. It is an m-change covering design if and only if
//   - consecutive base blocks, and B_{c−1} and B₀ + 1 (the *link*), differ in exactly m elements;
//   - every difference 1, …, ⌊v/2⌋ is, up to sign, a difference of two elements of some base block;
// and it is tight if and only if the differences newly covered in each base block, after its
// predecessor, are each of 1, …, (v−1)/2 exactly once (v odd) [ChafeeStevens2025, Section 3.2].
//
//     DifferenceVerdict verdict = verify_differences({{.v = 11, .k = 4}, {{0, 1, 2, 5}}});
//     verdict.valid() && verdict.tight;       // the tight circular DCCD(11,4,11)
//
// Do not forget the link: without it all pairs are covered, but the change property is broken once
// every c blocks.
//
// Complexity: O(ck·m) time and v bits of memory, against O(cv·k) for the developed list.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/core/developed.hpp"

namespace changeover {

/// The verdict on the developed design.
struct DifferenceVerdict {
  std::uint64_t b = 0;          ///< blocks of the developed design
  std::uint64_t bad_steps = 0;  ///< steps B₀→B₁, …, link, that do not change m elements
  std::optional<std::uint64_t> first_bad_step;  ///< 1-based; c is the link
  std::uint64_t uncovered = 0;  ///< differences 1..⌊v/2⌋, or orbits of pairs, not in a base block
  std::vector<std::uint64_t> uncovered_examples;  ///< the first most_examples, over Z_v
  static constexpr std::size_t most_examples = 20;
  std::uint64_t excess = 0;  ///< of the developed design, in pairs
  bool tight = false;

  [[nodiscard]] bool valid() const { return b > 0 && bad_steps == 0 && uncovered == 0; }
};

/// Decides the developed design by its differences. @throws BadInput if a base block is not k
/// distinct elements below v; ImpossibleParameters as check().
[[nodiscard]] DifferenceVerdict verify_differences(const BaseBlocks& base);

/// Decides the design developed under a permutation with several cycles of length n by its
/// differences: an orbit of pairs is a difference modulo n within a cycle, up to sign, or from one
/// cycle to another. Memory is a bit for each orbit. @throws as the above, and BadInput if pi.v()
/// is another v or an element is fixed.
[[nodiscard]] DifferenceVerdict verify_differences(const BaseBlocks& base, const Automorphism& pi);

// Difference certificates for base blocks that share an interval, in time that does not depend on
// k.
//
// Base blocks A ∪ P₀, …, A ∪ P_{c−1} with A = {a, …, a+n−1} are decided like any others by the
// differences that each newly covers (verify/difference.hpp). But a point x that is introduced
// beside a kept interval {s, …, s+l−1} covers an *interval* of differences x−s−l+1, …, x−s, so the
// differences of all base blocks are O(c) intervals: sorted and merged, they must leave no gap in
// 1, …, ⌊v/2⌋, and the design is tight if and only if they do not overlap either.
//
//     IntervalBaseBlocks base{{.v = 21, .k = 4, .kind = Kind::circular}, 0, 2, {4, 12, 2, 7}};
//     DifferenceVerdict verdict = verify_differences(base);
//     verdict.valid() && verdict.tight;       // the tight circular DCCD(21,4,42)
//
// Only that shape is assumed: consecutive base blocks may share more than A, and n may differ from
// k − m; the verdict is that of verify_differences() on the written-out base blocks.
//
// Complexity: O(cr² log(cr)) time and O(cr²) memory with r = k − n points in a base block (r = m in
// the cyclic families), against O(ck·m) time, O(ck) memory for the base blocks and v bits.

/// Decides the developed design by its differences. @throws BadInput as check_shape(), or if a base
/// block repeats a point or has a point inside the interval; ImpossibleParameters as check().
[[nodiscard]] DifferenceVerdict verify_differences(const IntervalBaseBlocks& base);

}  // namespace changeover
