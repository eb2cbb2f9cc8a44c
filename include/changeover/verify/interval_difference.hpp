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
// Nothing is assumed beyond that shape: consecutive base blocks may share more than A, or n may
// differ from k − m; what matters is counted, as verify_differences() of the written-out base
// blocks would.
//
// Complexity: O(cr² log(cr)) time and O(cr²) memory with r = k − n points in a base block (r = m in
// the cyclic families), against O(ck·m) time, O(ck) memory for the base blocks and v bits.
#pragma once

#include "changeover/core/interval_base_blocks.hpp"
#include "changeover/verify/difference.hpp"

namespace changeover {

/// Decides the developed design by its differences. @throws BadInput as check_shape(), or if a base
/// block repeats a point or has a point inside the interval; ImpossibleParameters as check().
[[nodiscard]] DifferenceVerdict verify_differences(const IntervalBaseBlocks& base);

}  // namespace changeover
