// Internal: what disjoint workers cannot hold.
#pragma once

#include <cstdint>

#include "changeover/loadorder/wanted_pairs.hpp"

namespace changeover {

/// The most items of which all pairs are listed for workers that together have room for more than
/// all of them. Of more items each worker has at least two.
inline constexpr std::uint64_t most_items_of_crowded = 300;

/// Whether all pairs are wanted and so many workers would hold more than all items, if each of them
/// were full.
[[nodiscard]] inline bool are_crowded(const WantedPairs& wanted, std::uint64_t room,
                                      std::uint64_t workers) {
  return wanted.are_all() && workers > 1 && wanted.items() / workers < room;
}

/// @throws BadInput if all pairs of more than most_items_of_crowded items are wanted by more
/// workers than there are pairs of items to hold; ImpossibleParameters above 65,535 items, unless
/// pairs are listed
void check_disjoint(const WantedPairs& wanted, std::uint64_t room, std::uint64_t workers);

}  // namespace changeover
