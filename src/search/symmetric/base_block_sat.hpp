// Base blocks by SAT: all of them at once, or the solver's word that there are none.
//
//     const BaseBlocksBySat result = base_blocks_by_sat({.v = 15, .k = 4, .kind = Kind::circular},
//                                                   {3, 5, 0, 7}, true, std::nullopt, control);
//
// A variable for each base block and element; introduced and leaving elements are m a step, the one
// from the last base block to π(first) included. Tight: each orbit of pairs is newly covered
// exactly once, and each element has a degree that i(k−1) + m(r−i) = v−1 allows. Otherwise: each
// orbit meets a block.
//
// Each cycle can be rotated by itself without changing which blocks it meets. So the first block
// that meets a cycle holds its residue 0, cycles are in the order of the blocks that they meet, and
// fixed points in that of the blocks that hold them: no solution is lost, most copies are.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/run/control.hpp"
#include "changeover/search/base_block_search.hpp"

namespace changeover {

struct BaseBlocksBySat {
  Outcome outcome = Outcome::unknown;  ///< none: so says the solver
  std::vector<Block> blocks;           ///< empty unless found
  std::uint64_t conflicts = 0;
};

/// How many variables stand for pairs in blocks: what the size of the formula goes with.
[[nodiscard]] std::uint64_t sat_size(const BaseBlockShape& shape);

/// The memory that the formula takes, with the solver's share, about. @throws ImpossibleParameters
/// if that exceeds 64 bits.
[[nodiscard]] std::uint64_t sat_bytes(const Parameters& p, const BaseBlockShape& shape, bool tight);

/// Base blocks of this shape for the circular p, tight if wanted. Gives up after so many conflicts,
/// or when the control wants to stop; while the formula is built the scope of this thread is
/// listened to (run/control.hpp). @throws MissingResource if the formula would take more memory
/// than `control` allows; ImpossibleParameters if it would be too large for any, see Cnf. Bound by:
/// the solver.
[[nodiscard]] BaseBlocksBySat base_blocks_by_sat(const Parameters& p, const BaseBlockShape& shape,
                                                 bool tight, std::optional<std::uint64_t> conflicts,
                                                 RunControl& control);

}  // namespace changeover
