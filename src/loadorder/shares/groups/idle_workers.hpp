// Internal: gives workers without a share some pairs of the others.
#pragma once

#include <cstdint>

#include "loadorder/shares/groups/group_shares.hpp"

namespace changeover {

/// The pairs of the worker that has most of them.
[[nodiscard]] std::uint64_t pairs_of_the_fullest(const GroupShares& shares, std::uint64_t items);

/// The pairs of the busiest worker divided by the mean over so many workers.
[[nodiscard]] double unevenness(const GroupShares& shares, std::uint64_t items,
                                std::uint64_t workers);

/// The same shares, perhaps of smaller groups, and shares for the additional workers with at most
/// `makespan` loads each. A search of some tenths of a second makes the pairs even. Returns the
/// shares unchanged if that does not help or there are too many groups.
[[nodiscard]] GroupShares with_idle_workers(GroupShares shares, std::uint64_t items,
                                            std::uint64_t room, std::uint64_t workers,
                                            std::uint64_t makespan);

/// The same shares, perhaps of smaller groups, which hold of the streamed groups what fits beside
/// the held ones: these meet each other, too, so pairs can be more even for the same loads. Returns
/// the shares unchanged if that does not help.
[[nodiscard]] GroupShares with_more_held(const GroupShares& shares, std::uint64_t items,
                                         std::uint64_t room);

}  // namespace changeover
