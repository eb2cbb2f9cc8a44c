// Internal: how many items disjoint workers may have.
#pragma once

#include "changeover/loadorder/wanted_pairs.hpp"

namespace changeover {

/// @throws ImpossibleParameters above 65,535 items, unless pairs are listed
void check_disjoint(const WantedPairs& wanted);

}  // namespace changeover
