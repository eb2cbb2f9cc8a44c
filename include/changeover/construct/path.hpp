// The shortest way from one block to another by steps that change exactly m elements.
//
//     connecting_blocks({0, 1, 2, 3}, {6, 7, 8, 9}, 2, 10);      // one block between them
//     connecting_steps(4, 4, 2, 10);                             // 2, without naming elements
//
// Blocks that differ in d elements are (d, k, v) apart whatever their elements are, so the shortest way
// is found among distances: a step from distance d can lead to every distance d − a + h where a of the
// d wrong elements go, h elements outside both blocks come, and what is left over suffices.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

/// The least number of steps that change exactly `change` elements each and lead from a k-subset of a
/// v-set to another that differs from it in `distance` elements; 0 if distance is 0; nullopt if there is
/// no way (only for v < k + change, and for v = 2k, change = k). O(min(k, v−k)·m²).
[[nodiscard]] std::optional<std::uint64_t> connecting_steps(std::uint64_t distance, std::uint64_t k,
                                                            std::uint64_t change, std::uint64_t v);

/// The blocks strictly between `from` and `to` on a shortest way; deterministic. Empty if one step
/// leads there. @throws ImpossibleParameters if there is no way or the blocks are the same.
[[nodiscard]] std::vector<Block> connecting_blocks(const Block& from, const Block& to,
                                                   std::uint64_t change, std::uint64_t v);

}  // namespace changeover
