// Internal: the number of pairs that loads can bring together.
#pragma once

#include <cstdint>

#include "changeover/loadorder/wanted_pairs.hpp"

namespace changeover {

/// The most pairs that `loads` loads can bring together: the i-th load meets at most min(i, room) −
/// 1 other items.
[[nodiscard]] std::uint64_t most_pairs(std::uint64_t loads, std::uint64_t room);

/// The fewest loads that can bring `pairs` pairs together.
[[nodiscard]] std::uint64_t least_loads(std::uint64_t pairs, std::uint64_t room);

/// The same for pairs of an item of one set with an item outside it: the first loads bring together
/// at most the pairs between two halves of the room.
[[nodiscard]] std::uint64_t most_between(std::uint64_t loads, std::uint64_t room);
[[nodiscard]] std::uint64_t least_between(std::uint64_t pairs, std::uint64_t room);

/// The number of items that have to be loaded.
[[nodiscard]] std::uint64_t needed_items(const WantedPairs& wanted);

}  // namespace changeover
