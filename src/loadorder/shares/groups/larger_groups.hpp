// Internal: which groups of shares are the larger ones.
//
//     // 256 items in 57 groups: 28 of these have 5 items, the others 4.
//     GroupShares shares = with_larger_spread(plane_shares(7, false), 256, 64);
//
// If G does not divide P, groups differ by an item. Any numbers that the groups have are right; the
// fewer larger groups a worker has, the fewer items it loads.
#pragma once

#include <cstdint>

#include "loadorder/shares/groups/group_shares.hpp"

namespace changeover {

/// The same shares with other numbers of the groups: such that each worker's share fits, if that is
/// possible, and the busiest loads few items, as a search of some milliseconds finds them. Shares
/// that gain nothing by it, or have more than 600 groups, are returned as they are.
[[nodiscard]] GroupShares with_larger_spread(GroupShares shares, std::uint64_t items,
                                             std::uint64_t room);

}  // namespace changeover
