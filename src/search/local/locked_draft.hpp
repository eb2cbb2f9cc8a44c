// The lists that a search with locked cells starts from: places are drawn for what is required, and
// blocks that have it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/search/local_search.hpp"
#include "run/random.hpp"
#include "search/local/segment_swap.hpp"

namespace changeover {

/// A list to start from, and what is locked in it.
struct Draft {
  Design list;
  std::vector<LockedCell> locked;
  std::vector<LockedPart> parts;
};

/// A list of so many blocks that has the required properties and takes every step; nullopt if the
/// places that were drawn do not fit, and another try may. Needs wanted_defect() to find none.
[[nodiscard]] std::optional<Draft> draw_draft(const Parameters& p, const Wanted& wanted,
                                              std::size_t blocks, Random& random);

}  // namespace changeover
