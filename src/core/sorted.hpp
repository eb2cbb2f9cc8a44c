// A block with its elements in order.
#pragma once

#include <algorithm>
#include <span>

#include "changeover/core/block.hpp"

namespace changeover {

/// The elements, ascending. O(k log k).
[[nodiscard]] inline Block sorted(std::span<const Element> block) {
  Block result(block.begin(), block.end());
  std::ranges::sort(result);
  return result;
}

}  // namespace changeover
