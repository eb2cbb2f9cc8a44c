// All cells of a range at once, in columns: what a map of the catalog holds.
//
//     atlas_json(asked.cells(), cells)  // {"k_from":3,…,"b":[…],"lower_bound":[…],…}
//     groups_json(asked, cells)         // {"order":["1","24",null,…]}
//
// The first map is built with the program; it is computed again if the user has a catalog.
#pragma once

#include <cstdint>
#include <deque>
#include <string>

#include "answer/known/known_table.hpp"

namespace changeover::serve {

struct AtlasQuestion {
  cli::TableRange range;
  Kind kind = Kind::circular;
  std::uint32_t strength = 2;

  [[nodiscard]] CellRange cells() const;
};

/// The range that is shown unless another is asked for: all cells that the catalog comes with; for
/// larger strengths the few that anything is known of.
[[nodiscard]] cli::TableRange atlas_range(std::uint64_t change, std::uint32_t strength);

/// What is known of each cell of a strength that tables do not have, as a table would say it.
/// Listens to the scope.
[[nodiscard]] std::deque<KnownCell> cells_of_strength(const AtlasQuestion& asked);

/// The order of the group of each best design, in decimal, null where there is no design. Builds
/// them; listens to the scope.
[[nodiscard]] std::string groups_json(const AtlasQuestion& asked, const Cells& cells);

}  // namespace changeover::serve
