// The possible numbers of introductions and occurrences of an element in a tight circular design.
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/search/base_block_search.hpp"

namespace changeover {

/// Of an element of a cycle: in the whole design, which is the same as those of its cycle in the
/// base blocks. Of a fixed element: in the base blocks.
struct Degree {
  std::uint64_t introductions = 0;
  std::uint64_t occurrences = 0;
};

/// All degrees of an element of a cycle with i(k−1) + m(r−i) = v−1, fewest introductions first.
[[nodiscard]] std::vector<Degree> cycle_degrees(const Parameters& p, const BaseBlockShape& shape);

/// The same for the fixed element, n(j(k−1) + m(r−j)) = v−1.
[[nodiscard]] std::vector<Degree> fixed_degrees(const Parameters& p, const BaseBlockShape& shape);

}  // namespace changeover
