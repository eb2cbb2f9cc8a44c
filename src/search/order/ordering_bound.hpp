// Lower bounds for order_for_least_change.
#pragma once

#include <cstdint>

#include "changeover/run/control.hpp"
#include "changeover/search/local_search.hpp"
#include "search/order/ordering_overlap.hpp"

namespace changeover {

/// A lower bound on the number of introduced elements of any order: the larger of the number of
/// distinct elements that must be introduced, and the spanning tree bound with multipliers. It
/// takes as many rounds as `effort` overlaps allow, and at least one, even if that needs up to ten
/// times as many. `cost` is the cost of some order, and sets the step size. The scope of this
/// thread can stop a round; the result is then the best bound so far.
[[nodiscard]] std::uint64_t order_lower_bound(std::span<const Block> blocks,
                                              const Overlaps& overlaps,
                                              const LeastChangeWanted& wanted, std::uint64_t cost,
                                              std::uint64_t effort, RunControl& control);

}  // namespace changeover
