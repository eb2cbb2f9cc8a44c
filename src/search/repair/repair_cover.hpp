// Adding blocks to a list until everything is covered: simple, always possible, not few.
#pragma once

#include "changeover/core/design.hpp"
#include "run/random.hpp"

namespace changeover {

/// The list with blocks appended until every t-subset is covered and, if it is circular, its last
/// step is right too. The next block is the best of some random ones, or a step on the shortest way
/// to something uncovered. Steps within the list must be right already; one or more blocks; v ≥ k +
/// m unless v = k. Listens to the scope of this thread (run/control.hpp). @throws
/// ImpossibleParameters if there is no way between some blocks; MissingResource if the subsets are
/// too many.
[[nodiscard]] Design cover_the_rest(const Design& list, Random& random);

}  // namespace changeover
