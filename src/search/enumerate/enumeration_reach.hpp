// Checks whether every missing pair can still meet within the remaining excess.
//
// Two elements that were covered together and then separated are a *dead* pair: when they meet
// again, this adds to the excess. So each missing pair needs a set of k elements that contains it
// and has no more dead pairs than the remaining excess; every later block is such a set. In a
// circular design the last unchanged subset must also meet again.
#pragma once

#include <cstdint>
#include <span>

#include "search/enumerate/enumeration_case.hpp"

namespace changeover {

/// The part of a partial design that matters for later blocks.
struct Position {
  std::uint64_t block = 0;
  std::int64_t excess = 0;                   ///< excess that remains
  std::span<const std::uint64_t> missing{};  ///< by element: the elements that it must still meet
};

/// The largest excess for which the check saves time.
inline constexpr std::int64_t reach_excess = 2;

/// False only if some missing pair cannot be covered any more. The number of steps is limited; if
/// it runs out, the result is true.
[[nodiscard]] bool all_within_reach(const EnumerationCase& own, const Position& position);

}  // namespace changeover
