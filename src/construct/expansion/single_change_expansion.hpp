// One element more: the v → v+1 expansion of a single-change covering design [PreeceEtAl1995], of a
// circular one too [McSorley1999].
//
// Let U₁, …, U_ℓ be unchanged subsets of an SCCD(v,k,b) at different positions that together
// contain all elements; they may overlap. With a new element x, insert the block U_j ∪ {x} at each
// of these positions. It differs from both neighbours in one element and newly covers {x,u} for u ∈
// U_j, and the block after it covers what it covered before. So the result is an SCCD(v+1, k, b+ℓ)
// of the same kind, with ℓ(k−1) − v more excess: none for an expansion set, ℓ = v/(k−1).
//
//     Design design({.v = 4, .k = 3, .change = 1, .kind = Kind::linear},
//                   std::vector<Block>{{0,1,2}, {0,2,3}, {1,2,3}});
//     expand_single_change(design, {0, 2});   // {0,1,4}, {0,1,2}, {0,2,3}, {2,3,4}, {1,2,3}
//
// x is in no unchanged subset of the result unless positions are next to each other, so this can
// hardly be done twice in turn; construct/expansion.hpp adds several elements at once.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/construct/expansion.hpp"
#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"

namespace changeover {

/// Why one element cannot be added at these unchanged subsets, in one line; nullopt if it can. As
/// for ExpansionSet, positions increase from 0, or from 1 if the design is circular, and at the
/// ends 0 and b of a linear design any k−1 elements of its first or last block may be chosen; but
/// subsets may overlap.
[[nodiscard]] std::optional<std::string> single_change_expansion_defect(const Design& design,
                                                                        const ExpansionSet& set);

/// The design with the new element v. If it has labels, so has the new element; see
/// expanded_labels().
/// @throws BadInput if single_change_expansion_defect() finds one; ImpossibleParameters if v + 1
/// exceeds the limit of check().
[[nodiscard]] Design expand_single_change(const Design& design, const ExpansionSet& set);

/// The same at positions in any order. At an end of a linear design the element left out is the
/// first of the end block that is in another chosen subset (if there is none, the first).
/// @throws as above.
[[nodiscard]] Design expand_single_change(const Design& design, std::vector<std::size_t> positions);

/// The same as a stream over a stream: memory for the set only. The design is trusted; only the
/// shape of the set is checked: positions increase, subsets have k − 1 elements and cover V.
/// @throws BadInput if it does not fit, and, from next(), if the source ends before the last
/// position; ImpossibleParameters if m ≠ 1, t ≠ 2, or v + 1 exceeds the limit of check(). O(v).
[[nodiscard]] std::unique_ptr<BlockSource> expand_single_change(std::unique_ptr<BlockSource> source,
                                                                ExpansionSet set);

}  // namespace changeover
