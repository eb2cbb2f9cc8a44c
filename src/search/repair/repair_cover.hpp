// Adds blocks to a list until everything is covered: simple and always possible, but not with few
// blocks.
#pragma once

#include "changeover/core/design.hpp"
#include "run/random.hpp"

namespace changeover {

/// Appends blocks until every t-subset is covered and, if the list is circular, its last step is
/// right, too. The next block is the best of some random ones, or a step on the shortest path to
/// something uncovered. Needs one or more blocks with right steps, and v ≥ k + m unless v = k. The
/// scope of this thread (run/control.hpp) can stop it. @throws ImpossibleParameters if there is no
/// path between some blocks; MissingResource if there are too many subsets.
[[nodiscard]] Design cover_the_rest(const Design& list, Random& random);

}  // namespace changeover
