// The least standard form over the rotations and reversals of a design, and those that attain it.
//
//     const LeastForm least = least_form(design, {.reversal = true});
//     least.reading;                 // how to read the design
//     least.step;                    // rotating by that many blocks renames elements only
//     least.mirror;                  // a backwards reading with the same form, if there is one
#pragma once

#include <optional>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/isomorphism/isomorphism.hpp"
#include "isomorphism/standard_names.hpp"

namespace changeover {

struct LeastForm {
  Reading reading;
  std::vector<Element> form;  ///< the renamed blocks, read in this way
  Isomorphism map;            ///< from the design to `form`
  std::vector<std::vector<Element>> twins;
  std::size_t step = 0;           ///< the shortest rotation that is a symmetry, b (or 1 if
                                  ///< there is no block) if only the whole turn is
  std::optional<Reading> mirror;  ///< a reading in the other direction with the same form
};

/// O(n·bk) for n readings that the invariants of isomorphism/cyclic_word.hpp cannot tell apart.
[[nodiscard]] LeastForm least_form(const Design& design, const Sameness& same);

}  // namespace changeover
