// Internal: workers for whom known shares leave nothing take pairs from the others.
#pragma once

#include <cstdint>

#include "loadorder/shares/group_shares.hpp"

namespace changeover {

/// The pairs of the fullest worker by the mean of so many.
[[nodiscard]] double unevenness(const GroupShares& shares, std::uint64_t items,
                                std::uint64_t workers);

/// The same shares, perhaps of smaller groups, and shares for as many more workers as there are:
/// with at most `makespan` loads each, and such that pairs are as even as some tenths of a second
/// of search make them. As they are, if that makes nothing better or there are too many groups.
[[nodiscard]] GroupShares with_idle_workers(GroupShares shares, std::uint64_t items,
                                            std::uint64_t room, std::uint64_t workers,
                                            std::uint64_t makespan);

}  // namespace changeover
