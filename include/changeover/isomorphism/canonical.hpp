// One design for each class of designs that are the same.
//
//     const CanonicalForm form = canonical_form(design, {.reversal = true});
//     seen.insert(form.design.elements());   // equal for two designs exactly if they are the same
//     form.map;                              // carries `design` to `form.design`
//
// With the blocks in a fixed order nothing has to be searched: an element is known by its column, the list
// of blocks that hold it, and the *standard form* numbers the elements by their columns, sorted so that at
// the first block in which two columns differ the element that is in comes first. So elements are numbered
// by first introduction, and those that are introduced together by who stays longer. Elements with
// the same column are twins and may be exchanged.
//
// The canonical form of a class is the least of the standard forms of some of its rotations (and
// reversals): of those that begin the least cyclic word of invariants of the blocks. It begins where a
// longest run begins, a run being a longest interval of blocks that hold an element.
//
// Bound by: O(bk) for each rotation that is looked at, O(bk log k) for the invariants. No graph is needed;
// isomorphism/block_system.hpp, where the order of blocks is forgotten, does need one.
#pragma once

#include "changeover/core/design.hpp"
#include "changeover/isomorphism/isomorphism.hpp"

namespace changeover {

struct CanonicalForm {
  Design design;    ///< blocks in increasing order of elements, without labels and recipe
  Isomorphism map;  ///< carries the given design to `design`
};

/// The same design for all designs that are the same as this one. O(n·bk) as find_isomorphism().
[[nodiscard]] CanonicalForm canonical_form(const Design& design, const Sameness& same = {});

/// The same with every block in its place: only elements are renamed. O(bk).
[[nodiscard]] CanonicalForm standard_form(const Design& design);

}  // namespace changeover
