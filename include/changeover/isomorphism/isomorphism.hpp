// When two designs are the same up to names, and the map that shows it.
//
//     if (const auto map = find_isomorphism(mine, theirs, {.reversal = true})) {
//       map->elements[0];                    // what element 0 of mine is called in theirs
//       position(*map, 0, b);                // where the first block of mine stands in theirs
//     }
//
// Two designs are the same up to relabelling if a bijection of their elements carries block i of
// one to block i of the other, for every i. Circular designs have no first block, so a rotation is
// allowed too; reading a design backwards is allowed only if asked for, as the literature counts
// [McSorley1999, PreeceEtAl1995]. A linear design is never the same as a circular one.
//
// Contract. Designs are lists of blocks here: whether they cover anything is not asked. Names of
// elements, recipes, the change number and the strength are ignored. Every map is checked block by
// block before it is handed out; a map that fails is InternalError.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/core/design.hpp"

namespace changeover {

/// What does not make a difference between designs, besides the names of the elements.
struct Sameness {
  bool rotation = true;   ///< where a circular design begins; means nothing for linear designs
  bool reversal = false;  ///< in which direction it is read
};

/// A map from one list of b blocks to another: element x goes to elements[x], block i to position i
/// + shift modulo b, or to shift − i modulo b if `reversed`. In a linear design shift is 0, or b −
/// 1 if reversed.
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

/// The design that `map` makes of `design`: same kind, elements of each block in increasing order,
/// without labels and recipe. @throws BadInput if the map is not one of v elements and b blocks.
/// O(bk log k).
[[nodiscard]] Design image(const Isomorphism& map, const Design& design);

/// Whether `map` carries `from` to `to`: block by block, by looking. A rotation of linear designs
/// does not. O(bk).
[[nodiscard]] bool carries(const Isomorphism& map, const Design& from, const Design& to);

/// A map that carries `from` to `to`; nothing if they are not the same. O(n·bk) for n rotations
/// that cheap invariants cannot tell apart: 1 or 2 unless the design has a symmetry. @throws
/// InternalError if the map that was found fails its check.
[[nodiscard]] std::optional<Isomorphism> find_isomorphism(const Design& from, const Design& to,
                                                          const Sameness& same = {});

// One design for each class of designs that are the same.
//
//     const CanonicalForm form = canonical_form(design, {.reversal = true});
//     form.design.elements();                // equal for two designs exactly if they are the same
//     form.map;                              // carries `design` to `form.design`
//
// With the blocks in a fixed order nothing has to be searched: an element is known by its column,
// the list of blocks that hold it, and the *standard form* numbers the elements by their columns,
// sorted so that at the first block in which two columns differ the element that is in comes first.
// So elements are numbered by first introduction, and those that are introduced together by who
// stays longer. Elements with the same column are twins and may be exchanged.
//
// The canonical form of a class is the least of the standard forms of some of its rotations (and
// reversals): of those that begin the least cyclic word of invariants of the blocks. It begins
// where a longest run begins, a run being a longest interval of blocks that hold an element.
//
// Bound by: O(bk) for each rotation that is looked at, O(bk log k) for the invariants. No graph is
// needed; block_system(), where the order of blocks is forgotten, does need one.

struct CanonicalForm {
  Design design;    ///< blocks in increasing order of elements, without labels and recipe
  Isomorphism map;  ///< carries the given design to `design`
};

/// The canonical form: isomorphic designs have equal canonical forms. `same` says which changes of
/// a design count as isomorphisms. O(n·bk) as find_isomorphism().
[[nodiscard]] CanonicalForm canonical_form(const Design& design, const Sameness& same = {});

/// The standard form: designs that differ only in the names of elements have equal standard forms.
/// Blocks keep their places. O(bk).
[[nodiscard]] CanonicalForm standard_form(const Design& design);

// The symmetries of a design: all maps that carry it to itself.
//
//     const AutomorphismGroup group = automorphisms(design);
//     group.order;                  // "11" for the cyclic circular DCCD(11,4,11)
//     group.rotations;              // 11: every rotation of the blocks extends to the elements
//     group.generators;             // maps to check with carries(map, design, design)
//
// A map is known by what it does to positions, up to exchanging twins (elements that are in the
// same blocks). So the group has (number of rotations and reflections that extend to the elements)
// times (product of n! over the classes of n twins) members, and nothing has to be searched but
// rotations.

struct AutomorphismGroup {
  std::string order;            ///< exact, in decimal
  std::uint64_t rotations = 1;  ///< rotations of the blocks, the identity among them, that extend
  bool reflections = false;     ///< whether a reversal extends; then as many as rotations do
  std::vector<std::vector<Element>> twins;  ///< classes of two or more elements, each increasing
  /// Generate the group: exchanges of two twins, the shortest rotation, one reversal. Each is
  /// checked.
  std::vector<Isomorphism> generators;

  /// How many position maps extend to elements.
  [[nodiscard]] std::uint64_t position_maps() const { return rotations * (reflections ? 2 : 1); }
};

/// The maps of the kind that `same` allows. O(n·bk) as find_isomorphism(), and O(v) for each twin.
/// @throws InternalError if a generator fails its check.
[[nodiscard]] AutomorphismGroup automorphisms(const Design& design, const Sameness& same = {});

/// How many standard forms the class of the design has: rotations and reversals that differ by more
/// than the names of elements. b, or 2b with reversal, over position_maps() if circular; 1 or 2 if
/// linear. `group` must be that of the design under `same`. O(1).
[[nodiscard]] std::uint64_t standard_forms_in_class(const Design& design,
                                                    const AutomorphismGroup& group,
                                                    const Sameness& same = {});

// The blocks of a design without their order: when two designs are different walks through the same
// blocks.
//
//     const BlockSystem a = block_system(first);
//     const BlockSystem b = block_system(second);
//     a.blocks == b.blocks;        // the same collection of blocks up to names of elements
//     a.group_order;               // permutations of the elements that keep the collection, exact
//
// The incidence graph of elements and blocks is brought into canonical form by bliss. A block that
// occurs several times counts as often.
//
// Bound by: bliss; exponential for contrived designs, milliseconds for those of this library.

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
