// Base blocks by annealing on the orbits of pairs (search/local/segment_orbits.hpp). The scope of
// the thread (run/control.hpp) can stop all of it; MissingResource is thrown if base blocks or
// counters need too much memory.
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/run/control.hpp"
#include "changeover/search/base_block_search.hpp"
#include "run/random.hpp"

namespace changeover {

/// Random base blocks of this shape with the change property, including the step from the last one
/// to π(first); covering is not required. Empty if none were found in a bounded number of steps: a
/// descent on the number of wrong changes, which rarely fails where there are any. p is circular
/// with shape.v() elements.
[[nodiscard]] std::vector<Block> random_base_blocks(const Parameters& p,
                                                    const BaseBlockShape& shape, Random& random);

struct BaseBlockAnnealing {
  std::vector<Block> blocks;  ///< empty unless found
  std::uint64_t missing = 0;  ///< the fewest uncovered orbits seen; 0 if found
  std::uint64_t moves = 0;
};

/// Anneals until base blocks are found, the moves are used up or the control requests a stop; every
/// second run is twice as long. A tight design needs no special treatment: the design is tight if
/// everything is covered. Time: O(moves · segment · k).
[[nodiscard]] BaseBlockAnnealing base_blocks_by_annealing(const Parameters& p,
                                                          const BaseBlockShape& shape,
                                                          std::uint64_t moves, Random& random,
                                                          RunControl& control);

// The possible numbers of introductions and occurrences of an element in a tight circular design.

/// For an element of a cycle: in the whole design, which is the same as those of its cycle in the
/// base blocks. For a fixed element: in the base blocks.
struct Degree {
  std::uint64_t introductions = 0;
  std::uint64_t occurrences = 0;
};

/// All degrees of an element of a cycle with i(k−1) + m(r−i) = v−1, fewest introductions first.
[[nodiscard]] std::vector<Degree> cycle_degrees(const Parameters& p, const BaseBlockShape& shape);

/// The same for the fixed element, n(j(k−1) + m(r−j)) = v−1.
[[nodiscard]] std::vector<Degree> fixed_degrees(const Parameters& p, const BaseBlockShape& shape);

}  // namespace changeover
