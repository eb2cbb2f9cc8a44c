// A larger design out of one of yours: by an expansion set, or by unchanged subsets that overlap.
//
//     Enlarged larger = enlarge(design);                             // by as many elements as serve it best
//     Enlarged by_four = enlarge(design, {.new_elements = 4});       // by four
//     larger.design.block_count();  larger.at.size();                // the positions where blocks were inserted
//
// If the number of new elements is left open and m = 2, the recursion of [ChafeeStevens2025, Theorem 2] is taken
// (construct/expansion.hpp), provided that there is an expansion set with an odd number of members. Otherwise, and for a
// number that is asked for, subsets that cover V and may overlap serve (construct/partial_expansion.hpp).
//
// Contract: a larger design out of a valid one. Neither is verified here.
#pragma once

#include <cstdint>
#include <optional>

#include "changeover/construct/expansion.hpp"
#include "changeover/construct/one_factorization.hpp"
#include "changeover/core/design.hpp"

namespace changeover {

struct EnlargeOptions {
  /// How many elements are inserted at subsets that may overlap; 0: the best number up to 2k + 2. Nothing: an
  /// expansion set if there is one, else as 0.
  std::optional<std::uint64_t> new_elements = {};
  /// The number of the expansion set, as they are found, from 1; this one and nothing else. Nothing: the first, if there is any.
  std::optional<std::uint64_t> set = {};
  FactorizationKind factorization = FactorizationKind::circle;  ///< of the new elements
  SearchLimits limits = {};  ///< of each search; without nodes, 200,000 for subsets that overlap
};

struct Enlarged {
  Design design;
  ExpansionSet at;                 ///< the unchanged subsets that new elements were put beside
  std::uint64_t new_elements = 0;  ///< v of the design less v of yours
  bool by_expansion_set =
      false;  ///< the subsets partition the elements, and all 1-factors came once
};

/// The larger design; its new elements come last. Bound by the search for subsets, which is exponential in the worst case.
/// @throws BadInput if `set` is 0 or comes with `new_elements`; MissingResource if there are fewer expansion sets than `set`, or it has
/// an even number of members, or m is not 2, or the new elements cannot be inserted, with the reason; ImpossibleParameters as blocks_added().
[[nodiscard]] Enlarged enlarge(const Design& design, const EnlargeOptions& options = {});

}  // namespace changeover
