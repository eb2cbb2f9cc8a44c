// Internal: initial orders of closing items.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"

namespace changeover {

/// Generates orders of all items, each with its name:
///
///   frontier   of the items that have been touched, the one with the fewest untouched partners is
///              closed next, which touches them [King1970]
///   numbered   by number
///   lacking    the item in memory that lacks the fewest partners is closed next, and the one that
///              met no partner for longest is evicted: two orders, which break ties by the
///              item that met a partner last, or by the other one
///   breadth    breadth first from an end of each component, fewest partners first, reversed
///              [CuthillMcKee1969]
///
/// Passes them to `visit` one after another while it returns true; each is made only when it is
/// needed. An order that give_up() interrupts is not passed on.
void each_start(
    const PairGraph& graph, std::uint64_t room,
    const std::function<bool(const std::string& name, std::vector<Element> order)>& visit,
    const std::function<bool()>& give_up = {});

}  // namespace changeover
