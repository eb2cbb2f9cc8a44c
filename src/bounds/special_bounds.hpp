// Bounds for large change numbers: elements that must come back at once, Steiner systems that no
// list of blocks with such steps can be, and two minima, for v = k+m and for v = 2k+1 with m = k.
#pragma once

#include <optional>

#include "changeover/bounds/lower_bound.hpp"

namespace changeover {

/// Where v < k + 2m, some of the elements that enter were in the block before the last, together
/// with elements that are there still; what they cover is not new [docs/theorems.md, Theorem 36].
/// nullopt if none need be, or if no design exists.
/// @throws ImpossibleParameters if a count exceeds 64 bits.
[[nodiscard]] std::optional<Bound> returning(const Parameters& p);

/// One block more than C(v,2) / C(k,2), where that is a whole number, m ≥ k − 1 and the blocks
/// would have to be those of a projective or an affine plane in an order that there is not, or of a
/// Steiner system with fewer blocks than elements [docs/theorems.md, Theorem 37]. nullopt
/// elsewhere.
/// @throws ImpossibleParameters if a count exceeds 64 bits.
[[nodiscard]] std::optional<Bound> steiner_system(const Parameters& p);

/// The minimum for strength 2 and v = k + m, m < k: 2⌈m/(k−m)⌉ + 1 [docs/theorems.md, Theorem 39].
/// nullopt elsewhere.
[[nodiscard]] std::optional<Bound> complements(const Parameters& p);

/// The minimum for strength 2, m = k ≥ 4 and v = 2k + 1: 2k + 3 linear, 2k + 4 circular
/// [docs/theorems.md, Theorem 40]. nullopt elsewhere.
[[nodiscard]] std::optional<Bound> one_left_out(const Parameters& p);

}  // namespace changeover
