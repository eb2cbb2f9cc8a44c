// The inequality of stays (docs/theorems.md, Theorem 5), counted from a list of sets. Shares no
// code with bounds/.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "changeover/core/design.hpp"

namespace changeover::test {

/// How many stays each of v elements has in a list of sets.
inline std::vector<std::uint64_t> stays(std::uint64_t v, const std::vector<Block>& sets) {
  constexpr std::size_t never = std::numeric_limits<std::size_t>::max();
  std::vector<std::uint64_t> stays(static_cast<std::size_t>(v));
  std::vector<std::size_t> last(static_cast<std::size_t>(v), never);
  for (std::size_t i = 0; i < sets.size(); ++i) {
    for (const Element x : sets[i]) {
      stays[x] += i == 0 || last[x] != i - 1 ? 1U : 0U;
      last[x] = i;
    }
  }
  return stays;
}

/// The first s for which the inequality fails, for sets of at most k elements in which every
/// `strength` elements meet; nullopt if it holds for all s.
inline std::optional<std::uint64_t> broken_inequality_of_stays(std::uint64_t v, std::uint64_t k,
                                                               std::uint64_t strength,
                                                               const std::vector<Block>& sets) {
  const std::vector<std::uint64_t> counted = stays(v, sets);
  for (std::uint64_t s = 1; s <= v / k + strength + 2; ++s) {
    std::uint64_t sum = 0;
    for (const std::uint64_t i : counted) {
      sum += i < s + 1 ? s + 1 - i : 0;
    }
    if (sum > (s < strength ? s : s * s - s + 1) * k) {
      return s;
    }
  }
  return std::nullopt;
}

}  // namespace changeover::test
