// Whether a range has a value, whatever its order.
//
//     contains(block, x)
#pragma once

#include <algorithm>
#include <iterator>

namespace changeover {

template <typename Range, typename Value>
[[nodiscard]] constexpr bool contains(const Range& range, const Value& value) {
  return std::ranges::find(range, value) != std::ranges::end(range);
}

}  // namespace changeover
