// Internal: orders of closing items to start from.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"

namespace changeover {

/// Orders of all items, each with its name:
///
///   numbered   as they are numbered
///   breadth    breadth first from an end of each component, fewest partners first, reversed: [CuthillMcKee1969]
///   frontier   among the items that have been touched, the next one closed is the one that has fewest untouched
///              partners; closing it touches them [King1970]
[[nodiscard]] std::vector<std::pair<std::string, std::vector<Element>>> start_orders(
    const PairGraph& graph);

}  // namespace changeover
