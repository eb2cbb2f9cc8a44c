// The blocks of a single-change design put together, g at a time: a g-change design with blocks
// of k+g−1.
//
//     auto coarse = coarsened(design, 3, 3);        // ⌈b/3⌉ blocks, rarely a few more
//
// With B_0, B_1, … the blocks of a single-change design, let C_i be the union of B_{gi}, …,
// B_{gi+g−1}. It has k+g−1 elements, and C_{i+1} has g that C_i lacks, if whatever leaves stays
// away for at least 2g−1 blocks. Every pair that was in a block still is in one. Where an element
// comes back sooner, the group being made ends before that block, and what the union lacks is
// filled with elements that neither the union nor the group before holds, those that are needed
// last; so is a last group that is short.
#pragma once

#include <cstdint>
#include <optional>

#include "changeover/core/design.hpp"

namespace changeover {

/// The g-change design on (v, k+g−1), of the same kind, the first group having `first` blocks, 1
/// ≤ first ≤ g; nullopt if some group cannot be completed, if the last and the first group of a
/// circular one do not differ in g elements, if the design is not one with change 1, or if k+g−1
/// ≥ v. O(bk log k).
[[nodiscard]] std::optional<Design> coarsened(const Design& design, std::uint64_t g,
                                              std::uint64_t first);

}  // namespace changeover
