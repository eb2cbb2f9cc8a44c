// Internal: how many pairs loads bring together.
#pragma once

#include <cstdint>

#include "changeover/loadorder/wanted_pairs.hpp"

namespace changeover {

/// Most pairs that `loads` loads bring together: the i-th one meets at most min(i, room) − 1
/// others.
[[nodiscard]] std::uint64_t most_pairs(std::uint64_t loads, std::uint64_t room);

/// Fewest loads for which that is enough.
[[nodiscard]] std::uint64_t least_loads(std::uint64_t pairs, std::uint64_t room);

/// The same for pairs of one item of a set with one outside it: the first ones bring together at
/// most what halves of the room would.
[[nodiscard]] std::uint64_t most_between(std::uint64_t loads, std::uint64_t room);
[[nodiscard]] std::uint64_t least_between(std::uint64_t pairs, std::uint64_t room);

/// How many items have to be loaded.
[[nodiscard]] std::uint64_t needed_items(const WantedPairs& wanted);

}  // namespace changeover
