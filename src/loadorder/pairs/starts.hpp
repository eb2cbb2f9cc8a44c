// Internal: orders of closing items to start from.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"

namespace changeover {

/// Orders of all items, each with its name:
///
///   frontier   among the items that have been touched, the next one closed is the one that has
///              fewest untouched partners; closing it touches them [King1970]
///   numbered   as they are numbered
///   lacking    among what is in memory, what lacks fewest partners is closed next, and what met no
///              partner for longest goes: two orders, in which of equals the one is closed that
///              met a partner last, or the other one
///   breadth    breadth first from an end of each component, fewest partners first, reversed
///              [CuthillMcKee1969]
///
/// They are shown to `visit` one after another, as long as it says true; none is made before it is
/// asked for. What give_up() interrupts is not shown.
void each_start(
    const PairGraph& graph, std::uint64_t room,
    const std::function<bool(const std::string& name, std::vector<Element> order)>& visit,
    const std::function<bool()>& give_up = {});

}  // namespace changeover
