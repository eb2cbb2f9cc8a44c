// Streams of g-change designs out of streams of single-change designs: the unions of g
// consecutive blocks, for lists in which whatever leaves stays away for at least 2g−1 blocks.
//
//     auto blocks = unions_of_blocks(std::move(single), 3);     // ⌈b/3⌉ blocks of k+2
//
// The union C_i of the blocks gi, …, gi+g−1 has k+g−1 elements, and C_{i+1} has g that C_i lacks:
// each of the g that enter in it was away for 2g−1 blocks. Every pair that was in a block still
// is in one. If g does not divide b, the last union is short of elements. It gets the first that
// are neither in it nor in the union before nor, in a circular design, in the first union, so
// that they enter there and leave at once. coarsened() (construct/tools/coarsen.hpp) is for
// designs that lack this property.
#pragma once

#include <cstdint>
#include <memory>

#include "changeover/core/block.hpp"

namespace changeover {

/// Whether unions of g fit a list in which K−1 blocks or more stand between two stays of an
/// element: K ≥ 2g.
[[nodiscard]] constexpr bool unions_fit(std::uint64_t big, std::uint64_t g) { return big / 2 >= g; }

/// The g-change design on (v, k+g−1), of the same kind. `single` has that property and says how
/// many blocks it has, at least 3g; v ≥ k+3g−1, so that there are elements to fill with. O(gk)
/// memory.
[[nodiscard]] std::unique_ptr<BlockSource> unions_of_blocks(std::unique_ptr<BlockSource> single,
                                                            std::uint64_t g);

}  // namespace changeover
