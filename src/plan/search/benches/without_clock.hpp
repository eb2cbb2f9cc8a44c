// How much time the search for lists without the clock gets.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "plan/search/lists/lists.hpp"

namespace changeover {

/// How many parts are in all tests of the lists at most.
[[nodiscard]] std::uint64_t places_of(const ListsJob& job, const BenchLists& lists);

/// The share of the time that is left, for lists of so many places together: as long as it takes to
/// part benches that want the same scarce parts, a tenth. Then the search with the clock does more;
/// but where time is short it needs up to half, and half if there is no limit.
[[nodiscard]] double share_without_clock(std::uint64_t places,
                                         std::optional<std::chrono::duration<double>> left);

}  // namespace changeover
