// Internal: searches orders of two levels.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "changeover/loadorder/load_order.hpp"
#include "loadorder/shares/step_lists.hpp"

namespace changeover {

/// Longer lists are not searched.
inline constexpr std::uint64_t most_pairs_searched = 1'000'000;

/// Changes the order in which items are closed, and how memory follows it, as long as `over` allows
/// it: an order that costs no more than one of some rounds ago is kept. Returns the order with the
/// least loads / bound + transfers / bound that came by; empty if none costs less than `start`. The
/// room of both levels and both bounds are those of `facts`.
[[nodiscard]] std::vector<Move> search_levels(const PairGraph& graph, const LoadOrderFacts& facts,
                                              const std::vector<Move>& start, std::uint64_t seed,
                                              const std::function<bool()>& over);

}  // namespace changeover
