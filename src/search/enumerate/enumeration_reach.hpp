// Whether every missing pair can still meet within the excess that is left.
//
// Two elements that were covered together and then separated are a *dead* pair: when they meet
// again, an excess is spent. So each missing pair needs a set of k elements around it with no more
// dead pairs than can be afforded, every such set of the future being a block. In a circular design
// the last unchanged subset must meet again too.
#pragma once

#include <cstdint>
#include <span>

#include "search/enumerate/enumeration_case.hpp"

namespace changeover {

/// A partial design as far as the future is concerned.
struct Position {
  std::uint64_t block = 0;
  std::int64_t excess = 0;                   ///< that may still be spent
  std::span<const std::uint64_t> missing{};  ///< by element: those it must still meet
};

/// The largest excess for which looking pays.
inline constexpr std::int64_t reach_excess = 2;

/// False only if some missing pair cannot be covered any more. Sets are looked for with a limited
/// number of steps: where it is used up, the answer is true.
[[nodiscard]] bool all_within_reach(const EnumerationCase& own, const Position& position);

}  // namespace changeover
