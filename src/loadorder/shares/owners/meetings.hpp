// Internal: which groups meet at which workers, so that their pairs can be given to them.
#pragma once

#include <cstdint>
#include <memory>

#include "loadorder/shares/group_shares.hpp"
#include "loadorder/shares/owners/group_owners.hpp"

namespace changeover {

/// Balanced, as Pouring::pour().
[[nodiscard]] std::shared_ptr<const GroupOwners> owners_of(const GroupShares& shares,
                                                           std::uint64_t items, double part = 1e-5);

}  // namespace changeover
