// Internal: what disjoint workers cannot hold.
#pragma once

#include <cstdint>

#include "changeover/loadorder/wanted_pairs.hpp"

namespace changeover {

/// @throws BadInput if all pairs are wanted and the workers would hold more than all items;
/// ImpossibleParameters above 65,535 items, unless pairs are listed
void check_disjoint(const WantedPairs& wanted, std::uint64_t room, std::uint64_t workers);

}  // namespace changeover
