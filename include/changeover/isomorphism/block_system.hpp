// The blocks of a design without their order: when two designs are different walks through the same blocks.
//
//     const BlockSystem a = block_system(first);
//     const BlockSystem b = block_system(second);
//     a.blocks == b.blocks;        // the same collection of blocks up to names of elements
//     a.group_order;               // permutations of the elements that keep the collection, exact
//
// The incidence graph of elements and blocks is brought into canonical form by bliss. A block that occurs
// several times counts as often.
//
// Bound by: bliss; exponential for contrived designs, milliseconds for those of this library.
#pragma once

#include <string>
#include <vector>

#include "changeover/core/design.hpp"

namespace changeover {

struct BlockSystem {
  std::vector<Block> blocks;      ///< canonical names; each block and the list of blocks increasing
  std::vector<Element> elements;  ///< the canonical name of each element of the given design
  std::string group_order;        ///< of permutations of the elements, exact, in decimal
  std::vector<std::vector<Element>> generators;  ///< permutations x ↦ generator[x] of the elements
};

/// The canonical form and the group of the collection of blocks.
/// @throws MissingResource if the incidence graph has more than 2³¹ vertices or edges.
[[nodiscard]] BlockSystem block_system(const Design& design);

}  // namespace changeover
