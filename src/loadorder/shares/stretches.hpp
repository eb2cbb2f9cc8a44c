// Internal: stretches of an order, possibly of groups of items: one per worker, each beginning with
// everything that is in memory then.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "changeover/loadorder/workers.hpp"
#include "loadorder/shares/owners/group_owners.hpp"

namespace changeover {

/// Balanced pairs of groups, of stretches of so many steps each.
[[nodiscard]] std::shared_ptr<const GroupOwners> owners_of_stretches(
    const LoadOrder& order, const std::vector<WorkerFacts>& workers, std::uint64_t items);

/// An order that is cut.
struct Stretches {
  std::vector<WorkerFacts> workers;  ///< their steps and loads
  bool by_loads = false;  ///< which are even; otherwise numbers of steps, or of new pairs
};

/// Stretches of an order of as many groups of `items` items. Where all steps are alike each has as
/// many of them or, with `even_pairs`, brings as many new pairs together; otherwise the one with
/// most loads has as few as can be, of two levels what both move.
[[nodiscard]] Stretches cut_order(const LoadOrder& order, std::uint64_t items,
                                  std::uint64_t workers, bool even_pairs);

}  // namespace changeover
