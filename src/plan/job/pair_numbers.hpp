// Numbers of pairs.
#pragma once

#include <cstdint>
#include <limits>
#include <utility>

#include "changeover/core/block.hpp"

namespace changeover {

/// No limit, for PairSet::for_each().
inline constexpr std::uint64_t all_of_them = std::numeric_limits<std::uint64_t>::max();

/// C(n, 2), for n below 2³².
[[nodiscard]] inline std::uint64_t choose_two(std::uint64_t n) {
  return n < 2 ? 0 : n * (n - 1) / 2;
}

/// C(n, 3), for n below 2²¹.
[[nodiscard]] inline std::uint64_t choose_three(std::uint64_t n) {
  return n < 3 ? 0 : n * (n - 1) * (n - 2) / 6;
}

/// Sorts three elements.
inline void sort_three(Element& x, Element& y, Element& z) {
  if (x > y) {
    std::swap(x, y);
  }
  if (y > z) {
    std::swap(y, z);
  }
  if (x > y) {
    std::swap(x, y);
  }
}

}  // namespace changeover
