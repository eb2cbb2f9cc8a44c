// Base blocks by annealing on the orbits of pairs (search/local/segment_orbits.hpp). All of it
// listens to the scope of its thread (run/control.hpp) and throws MissingResource if base blocks or
// counters need too much memory.
#pragma once

#include <cstdint>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/run/control.hpp"
#include "changeover/search/base_block_search.hpp"
#include "run/random.hpp"

namespace changeover {

/// Random base blocks of this shape with the change property, the step from the last one to
/// π(first) included; they cover what they cover. Empty if none were found in a bounded number of
/// steps: a descent on the number of wrong changes, which rarely fails where there are any. p is
/// circular with shape.v() elements.
[[nodiscard]] std::vector<Block> random_base_blocks(const Parameters& p,
                                                    const BaseBlockShape& shape, Random& random);

struct BaseBlockAnnealing {
  std::vector<Block> blocks;  ///< empty unless found
  std::uint64_t missing = 0;  ///< the fewest uncovered orbits seen; 0 if found
  std::uint64_t moves = 0;
};

/// Anneals, each second time twice as long, until base blocks are found, the moves are used up or
/// the control wants to stop. A tight design needs no more care: it is one if everything is
/// covered. Bound by: O(moves · segment · k).
[[nodiscard]] BaseBlockAnnealing base_blocks_by_annealing(const Parameters& p,
                                                          const BaseBlockShape& shape,
                                                          std::uint64_t moves, Random& random,
                                                          RunControl& control);

}  // namespace changeover
