// Extension: an SCCD(v,k,b) becomes an SCCD(v+2(k−1), k, b+2v+2k−3), with no more excess.
//
// The new blocks cover the pairs of the 2(k−1) new elements, and their pairs with the old ones,
// exactly once. So from a tight or economical design come such designs for every larger v of the
// same residue modulo 2(k−1), and minimum designs for all v from 2(k−1) minimum ones:
//
//     Design base({.v = 5, .k = 3, .change = 1, .kind = Kind::circular},
//                 std::vector<Block>{{0,1,2}, {0,2,3}, {2,3,4}, {1,3,4}, {0,1,4}});
//     auto source = extend_single_change(base, 2);   // a tight circular SCCD(13,3,39)
//     read_all(*source).block_count();               // 5 + (2·5 + 3) + (2·9 + 3) = 39
//
// *The end of the list.* The last k−2 blocks are taken away and the list goes on in another way, so
// that the same can be done again. It is needed that the last k−2 blocks introduce k−2 different
// elements and that all of these are in the last block; in a circular design they are in the first
// block too. If e is the remaining element that the last block has in common with the first (of a
// linear design, any one of the two that remain) and S the block before those k−2, then
//     S = {e, x_1, …, x_{k−1}},   and block i after it is {e, p_1, …, p_i, x_1, …, x_{k−1−i}}.
// Taking them away uncovers the pairs of p_i with e, p_j and x_j, j < k−i. A *script* is a list of
// blocks of the 2(k−1) elements e, p_i, x_i and the new ones that begins with S, ends in the same
// way with {e, p_1, …, p_{k−2}} in its last block, makes single changes, newly covers k−1 pairs in
// each block, those uncovered pairs and all pairs that contain a new element, and holds each of two
// sets of k−1 new elements, together all of them, in two consecutive blocks. There each further old
// element is inserted beside the set: k−1 new pairs in a block.
//
// Scripts are known for k = 3 and 4. The one for k = 3 was found by hand and is checked here; for
// k = 4 by exhaustive search. One found for a larger k would do the same there.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "changeover/construct/expansion.hpp"
#include "changeover/core/block.hpp"
#include "changeover/core/design.hpp"

namespace changeover {

/// Whether a script is known for blocks of k elements.
[[nodiscard]] bool has_single_change_extension(std::uint64_t k);

/// Why a design cannot be extended, in one line; nullopt if it can. Only the end of the list is
/// looked at, not whether it is a design.
[[nodiscard]] std::optional<std::string> single_change_extension_defect(const Design& design);

/// The design extended `rounds` times, as a stream: elements v, …, v+2(k−1)−1 are new in the first
/// round, and so on. Memory is that of the given design.
/// @throws BadInput if single_change_extension_defect() finds one; ImpossibleParameters if the
/// number of elements exceeds the limit of check() or that of blocks 64 bits.
[[nodiscard]] std::unique_ptr<BlockSource> extend_single_change(const Design& design,
                                                                std::uint64_t rounds);

/// An expansion set of the extended design: the first one of the given design, if it has one, that
/// uses only positions up to b−k+1 and, if it is circular, b; and the two sets of new elements
/// of every round. nullopt if there is none of that kind. O(v) and a search in the given design.
/// @throws as extend_single_change().
[[nodiscard]] std::optional<ExpansionSet> extended_expansion_set(const Design& design,
                                                                 std::uint64_t rounds);

}  // namespace changeover
