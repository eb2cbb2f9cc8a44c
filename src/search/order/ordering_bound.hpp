// Lower bounds for order_for_least_change.
#pragma once

#include <cstdint>

#include "changeover/run/control.hpp"
#include "changeover/search/local_search.hpp"
#include "search/order/ordering_overlap.hpp"

namespace changeover {

/// A number of introduced elements that no order goes below: the larger of what the distinct
/// elements force and of the spanning tree bound with multipliers, as many rounds as `effort`
/// overlaps allow, but one even if it needs up to ten times as many. `cost` is that of some order,
/// to measure steps by. A round listens to the scope of this thread; what is known when it is
/// stopped is the answer.
[[nodiscard]] std::uint64_t order_lower_bound(std::span<const Block> blocks,
                                              const Overlaps& overlaps,
                                              const LeastChangeWanted& wanted, std::uint64_t cost,
                                              std::uint64_t effort, RunControl& control);

}  // namespace changeover
