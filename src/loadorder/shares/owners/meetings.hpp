// Internal: finds which groups meet at which workers, to assign their pairs.
#pragma once

#include <cstdint>
#include <memory>

#include "loadorder/shares/group_shares.hpp"
#include "loadorder/shares/owners/group_owners.hpp"

namespace changeover {

/// Balanced owners; see Pouring::pour().
[[nodiscard]] std::shared_ptr<const GroupOwners> owners_of(const GroupShares& shares,
                                                           std::uint64_t items, double part = 1e-5);

}  // namespace changeover
