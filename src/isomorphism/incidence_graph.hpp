// The incidence graph of elements and blocks, for bliss.
//
// A second, independent way to decide what isomorphism/isomorphism.hpp decides by sorting columns,
// and the only way where the order of blocks is forgotten. How much of the order is kept is a
// matter of gadgets: block i of a sequence has a colour of its own; a circle has an arc of two
// vertices from each block to the next, one vertex if its direction is forgotten.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "changeover/core/design.hpp"

namespace changeover {

/// What is kept of the order of the blocks.
enum class BlockOrder : std::uint8_t {
  sequence,             ///< all of it
  reversible_sequence,  ///< up to reading backwards
  circle,               ///< up to rotation
  reversible_circle,    ///< up to both
  collection            ///< nothing; a block that occurs r times is one vertex of its own colour
};

struct GraphForm {
  /// Vertex v of the graph has the place label[v] in the canonical graph; elements are vertices 0,
  /// …, v−1.
  std::vector<unsigned> label;
  /// The canonical graph: (place, colour) of each vertex, then its edges (lesser place first);
  /// sorted.
  std::vector<std::pair<unsigned, unsigned>> colours, edges;
  std::string group_order;                        ///< exact, in decimal
  std::vector<std::vector<unsigned>> generators;  ///< on vertices
};

/// @throws MissingResource if there are 2³¹ or more vertices.
[[nodiscard]] GraphForm graph_form(const Design& design, BlockOrder order);

}  // namespace changeover
