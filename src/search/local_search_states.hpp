// Annealing a list of blocks with the counters that fit it.
#pragma once

#include <cstddef>
#include <optional>

#include "changeover/core/design.hpp"
#include "changeover/search/anneal.hpp"

namespace changeover {

struct Annealed {
  std::optional<Design> design;  ///< if nothing is missing; not verified
  AnnealOutcome outcome;
};

/// Anneals all blocks but the first `frozen`.
[[nodiscard]] Annealed anneal_blocks(const Design& start, std::size_t frozen,
                                     const AnnealSchedule& schedule, Random& random,
                                     RunControl& control, const AnnealWatch& watch = {});

}  // namespace changeover
