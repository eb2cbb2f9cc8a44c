// Finds base blocks by SAT, all of them at once, or a statement of the solver that there are none.
//
//     const BaseBlocksBySat result = base_blocks_by_sat({.v = 15, .k = 4, .kind = Kind::circular},
//                                                   {3, 5, 0, 7}, true, std::nullopt, control);
//
// There is a variable for each base block and element. Each step introduces m elements and removes
// m, including the step from the last base block to π(first). Tight designs: each orbit of pairs is
// newly covered exactly once, and each element has a degree with i(k−1) + m(r−i) = v−1. Otherwise:
// each orbit meets a block.
//
// Each cycle can be rotated independently, which does not change the blocks that it meets. So the
// first block that meets a cycle contains its residue 0, cycles are sorted by the blocks that they
// meet, and fixed points by the blocks that contain them: one copy of each solution remains, and
// most others are excluded.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/run/control.hpp"
#include "changeover/search/base_block_search.hpp"

namespace changeover {

struct BaseBlocksBySat {
  Outcome outcome = Outcome::unknown;  ///< `none` is the solver's statement
  std::vector<Block> blocks;           ///< empty unless found
  std::uint64_t conflicts = 0;
};

/// The number of variables for pairs in blocks, to which the size of the formula is proportional.
[[nodiscard]] std::uint64_t sat_size(const BaseBlockShape& shape);

/// An estimate of the memory for the formula and the solver. @throws ImpossibleParameters if that
/// exceeds 64 bits.
[[nodiscard]] std::uint64_t sat_bytes(const Parameters& p, const BaseBlockShape& shape, bool tight);

/// Finds base blocks of this shape for the circular p, tight if requested. Ends after `conflicts`
/// conflicts, or when the control requests a stop; while the formula is built, the scope of this
/// thread (run/control.hpp) can stop it. @throws MissingResource if the formula would take more
/// memory than `control` allows; ImpossibleParameters if it would be too large for Cnf. Time: that
/// of the solver.
[[nodiscard]] BaseBlocksBySat base_blocks_by_sat(const Parameters& p, const BaseBlockShape& shape,
                                                 bool tight, std::optional<std::uint64_t> conflicts,
                                                 RunControl& control);

}  // namespace changeover
