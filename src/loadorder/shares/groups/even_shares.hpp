// Internal: shares whose pairs are made even, without more loads of the busiest worker.
#pragma once

#include <cstdint>

#include "loadorder/shares/groups/group_shares.hpp"

namespace changeover {

/// The same shares, or shares of smaller groups that are changed group by group: all pairs still
/// meet, no worker loads more than `makespan`, and the fullest has fewer pairs. A search of some
/// tenths of a second, which ends where pairs are even. Returns the shares unchanged if that does
/// not help.
[[nodiscard]] GroupShares with_even_pairs(GroupShares shares, std::uint64_t items,
                                          std::uint64_t room, std::uint64_t makespan);

}  // namespace changeover
