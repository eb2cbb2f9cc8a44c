// Short recipes of circular designs that have an automorphism.
//
//     const auto short_one = by_base_blocks(design);
//     short_one->recipe->blocks;              // 5 base blocks instead of 65, a recipe "developed"
#pragma once

#include <optional>

#include "changeover/core/design.hpp"

namespace changeover {

/// The same list of sets with a recipe that develops the first of them under an automorphism of
/// core/developed.hpp with at most two fixed elements, that of largest order; nullopt if the design
/// is linear, or no such automorphism rotates the list by a part of its length. Elements are not
/// renamed. O(v + d·b·k log k) for d automorphisms whose order divides b.
[[nodiscard]] std::optional<Design> by_base_blocks(const Design& design);

}  // namespace changeover
