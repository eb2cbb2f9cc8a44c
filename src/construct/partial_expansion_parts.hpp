// What the files of the partial expansion share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "changeover/construct/partial_expansion.hpp"

namespace changeover::detail {

/// The m = 1 sweep: the blocks between U ∪ {a} and U ∪ {b} that cover all pairs of new elements and all
/// pairs of a new and an old element of U, and those of new elements with a if a is left out.
/// @param kept U, k − 1 elements.
/// @param left_out a, or nothing.
/// @param added the new elements, at least one.
/// @return k elements a block, blocks one after another.
[[nodiscard]] std::vector<Element> sweep(const Block& kept, std::optional<Element> left_out,
                                         const Block& added);

/// The number of blocks of sweep() for subsets of `kept` elements.
[[nodiscard]] std::uint64_t sweep_length(std::uint64_t kept, std::uint64_t added, bool left_out);

/// How many old elements at most come beside unmatched new ones at a position.
[[nodiscard]] std::uint64_t beside_at_most(const Parameters& p, std::uint64_t w);

/// The elements of V that are in none of the subsets, increasing. The subsets hold elements below v.
[[nodiscard]] Block left_out_elements(std::uint64_t v, const std::vector<UnchangedSubset>& subsets);

/// The subsets that the inner positions of a design offer, and at the ends of a linear one the first
/// k − m elements of its first and of its last block: one a position, in order of position.
[[nodiscard]] std::vector<UnchangedSubset> one_subset_a_position(const Design& design);

/// Adds subsets from `more`, in its order, at positions that the cover does not use, until it has
/// `count`; false if there are too few. Nothing may be said about what comes beside.
[[nodiscard]] bool add_positions(UnchangedCover& cover, const std::vector<UnchangedSubset>& more,
                                 std::uint64_t count);

/// Shares out `rest` among places that take `capacity` elements each, where allowed(place, element)
/// says what may stand: an increasing list for each place. nullopt if a greedy choice with single
/// exchanges fails.
[[nodiscard]] std::optional<std::vector<Block>> share_out(
    const Block& rest, std::size_t places, std::size_t capacity,
    const std::function<bool(std::size_t, Element)>& allowed);

/// Puts the elements that the cover leaves out beside the new ones: each of them beside each new
/// element. @param allowed asked only for w < m. False if share_out() fails or there are too many.
[[nodiscard]] bool put_beside(const Parameters& p, std::uint64_t w, UnchangedCover& cover,
                              const std::function<bool(std::size_t, Element)>& allowed);

}  // namespace changeover::detail
