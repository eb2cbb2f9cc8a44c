// Designs verified by their fans (core/fans.hpp), without reading every block.
//
// A list of fans is an m-change covering design if and only if
//   - each step within a fan, from fan to fan and, of a circular design, from the last block to the
//     first changes m elements;
//   - every pair is in some block. The pairs in blocks of a fan are those of its kept elements, and
//     of each of these with an element of the interval.
// So it is enough to look at the first and the last block of each fan, and to keep for each element
// which smaller ones it has met: an interval 0, …, l−1, and ranges beyond it that wait until the
// interval reaches them. Larger elements that it meets in a fan are kept as ranges, too.
//
//     const Registry& registry = Registry::standard();
//     const auto offer = registry.best({.v = 1'000'000, .k = 5, .change = 1});
//     const FanVerdict verdict = verify_fans(*registry.fans(offer->recipe));
//     verdict.valid();                   // true
//     verdict.b;                         // 124999874999
//
// Complexity: O(k²) time for each fan and four bytes an element if elements meet smaller ones in
// order, as in concatenation. Otherwise O(k² log n) for each fan, n the ranges of an element, and
// some 100 bytes for each range; where elements meet larger ones, O((v + n) log v) time at the end.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "changeover/core/fans.hpp"

namespace changeover {

/// The verdict on the list of blocks.
struct FanVerdict {
  Parameters parameters;
  std::uint64_t counting_bound = 0;  ///< ⌈g₁⌉ or ⌈g₂⌉
  std::uint64_t b = 0;
  std::uint64_t fans = 0;
  std::uint64_t bad_steps = 0;  ///< steps that do not change m elements
  std::optional<std::uint64_t>
      first_bad_step;           ///< 1-based, from block i to block i+1; b is the step to the first
  std::uint64_t uncovered = 0;  ///< pairs in no block
  std::vector<std::pair<Element, Element>> uncovered_examples;  ///< the first most_examples
  static constexpr std::size_t most_examples = 20;
  /// Pairs of elements that are in every block of a circular design of two or more blocks.
  std::uint64_t never_newly_covered = 0;
  /// How many times, in all, pairs are newly covered after their first time.
  std::uint64_t excess = 0;

  [[nodiscard]] bool valid() const { return b > 0 && bad_steps == 0 && uncovered == 0; }
  [[nodiscard]] bool tight() const { return valid() && excess == 0 && never_newly_covered == 0; }
  [[nodiscard]] bool economical() const { return valid() && b == counting_bound; }
};

/// Reads the fans to their end. Strength 2 only. @throws BadInput if the parameters have another
/// strength, or a fan has other than k distinct elements below v in each block;
/// ImpossibleParameters as check(), or if the blocks exceed 64 bits.
[[nodiscard]] FanVerdict verify_fans(FanSource& source);

}  // namespace changeover
