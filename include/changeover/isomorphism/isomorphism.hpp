// When two designs are the same up to names, and the map that shows it.
//
//     if (const auto map = find_isomorphism(mine, theirs, {.reversal = true})) {
//       map->elements[0];                    // what element 0 of mine is called in theirs
//       position(*map, 0, b);                // where the first block of mine stands in theirs
//     }
//
// Two designs are the same up to relabelling if a bijection of their elements carries block i of one to
// block i of the other, for every i. Circular designs have no first block, so a rotation is allowed too;
// reading a design backwards is allowed only if asked for, as the literature counts [McSorley1999,
// PreeceEtAl1995]. A linear design is never the same as a circular one.
//
// Contract. Designs are lists of blocks here: whether they cover anything is not asked. Names of elements,
// recipes, the change number and the strength are ignored. Every map is checked block by block before it
// is handed out; a map that fails is InternalError.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "changeover/core/design.hpp"

namespace changeover {

/// What does not make a difference between designs, besides the names of the elements.
struct Sameness {
  bool rotation = true;   ///< where a circular design begins; means nothing for linear designs
  bool reversal = false;  ///< in which direction it is read
};

/// A map from one list of b blocks to another: element x goes to elements[x], block i to position i + shift
/// modulo b, or to shift − i modulo b if `reversed`. In a linear design shift is 0, or b − 1 if reversed.
struct Isomorphism {
  std::vector<Element> elements;  ///< a permutation of 0, …, v−1
  std::size_t shift = 0;          ///< less than b
  bool reversed = false;

  bool operator==(const Isomorphism&) const = default;
};

/// Where block `index` goes among `b` blocks. O(1).
[[nodiscard]] std::size_t position(const Isomorphism& map, std::size_t index, std::size_t b);

/// The map that does nothing to v elements.
[[nodiscard]] Isomorphism identity(std::size_t v);

/// First `first`, then `second`, both maps of the same v elements, on lists of b blocks. O(v).
[[nodiscard]] Isomorphism compose(const Isomorphism& first, const Isomorphism& second,
                                  std::size_t b);

/// The way back, on lists of b blocks; `map` must be a map of v elements. O(v).
[[nodiscard]] Isomorphism inverse(const Isomorphism& map, std::size_t b);

/// The design that `map` makes of `design`: same kind, elements of each block in increasing order, without
/// labels and recipe. @throws BadInput if the map is not one of v elements and b blocks. O(bk log k).
[[nodiscard]] Design image(const Isomorphism& map, const Design& design);

/// Whether `map` carries `from` to `to`: block by block, by looking. A rotation of linear designs does
/// not. O(bk).
[[nodiscard]] bool carries(const Isomorphism& map, const Design& from, const Design& to);

/// A map that carries `from` to `to`; nothing if they are not the same. O(n·bk) for n rotations that
/// cheap invariants cannot tell apart: 1 or 2 unless the design has a symmetry. @throws InternalError if
/// the map that was found fails its check.
[[nodiscard]] std::optional<Isomorphism> find_isomorphism(const Design& from, const Design& to,
                                                          const Sameness& same = {});

}  // namespace changeover
