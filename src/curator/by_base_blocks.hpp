// Circular designs that have an automorphism, by fewer blocks.
//
//     const auto short_one = by_base_blocks(design);
//     short_one->recipe->blocks;              // 5 base blocks instead of 65, a recipe "developed"
#pragma once

#include <optional>

#include "changeover/core/design.hpp"

namespace changeover {

/// The same list of sets, and the recipe that makes it by developing the first of them under an automorphism of core/developed.hpp with at
/// most two fixed elements, that of largest order; nullopt if none turns the list by a part of its length, or it is linear. Elements are
/// not renamed. O(v + d·b·k log k) for d automorphisms whose order divides b.
[[nodiscard]] std::optional<Design> by_base_blocks(const Design& design);

}  // namespace changeover
