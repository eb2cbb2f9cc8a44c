// What the files of the partial expansion share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "changeover/construct/expansion.hpp"

namespace changeover {

/// The 1-factors of K_w, or of K_{w+1} if w is odd, by number.
using Factors = std::function<OneFactor(std::uint32_t which)>;

/// As expand_by(), with such factors and a cover that was checked.
[[nodiscard]] std::unique_ptr<BlockSource> expand_with(std::unique_ptr<BlockSource> source,
                                                       UnchangedCover cover, std::uint64_t w,
                                                       Factors factors);

/// The sweep for m = 1: the blocks between U ∪ {a} and U ∪ {b} that cover all pairs of new elements
/// and all pairs of a new and an old element of U, and those of new elements with a if a is left
/// out.
/// @param kept U, at least one element.
/// @param left_out a, or nothing.
/// @param added the new elements, at least one.
/// @return |U| + 1 elements a block, blocks one after another.
[[nodiscard]] std::vector<Element> sweep(const Block& kept, std::optional<Element> left_out,
                                         const Block& added);

/// The number of blocks of sweep() for `kept` elements of U.
[[nodiscard]] std::uint64_t sweep_length(std::uint64_t kept, std::uint64_t added, bool left_out);

/// The same for m = 2, k ≥ 4, between U ∪ {a,a′} and U ∪ {b,b′}.
/// @param added an even number of elements: the new ones, if need be with one of none of the
/// blocks.
[[nodiscard]] std::vector<Element> double_sweep(const Block& kept, const Block& added);

/// From how many positions on the factors cover all pairs of new elements, m = 2, w > 2: w − 1 if w
/// is even, else w. Otherwise 1.
[[nodiscard]] std::uint64_t positions_for_factors(const Parameters& p, std::uint64_t w);

/// Whether the pairs of new elements are covered by a sweep.
[[nodiscard]] bool takes_sweep(const Parameters& p, std::uint64_t subsets, std::uint64_t w);

/// Given a cover of that many subsets, how many to use for the fewest blocks, when positions can be
/// added up to `available`; nullopt if w takes more than that.
[[nodiscard]] std::optional<std::uint64_t> best_positions(const Parameters& p,
                                                          std::uint64_t subsets,
                                                          std::uint64_t available, std::uint64_t w);

/// How many old elements at most come beside unmatched new ones at a position.
[[nodiscard]] std::uint64_t beside_at_most(const Parameters& p, std::uint64_t w);

/// The elements of V that are in none of the subsets, increasing. The subsets hold elements below
/// v.
[[nodiscard]] Block left_out_elements(std::uint64_t v, const std::vector<UnchangedSubset>& subsets);

/// The subsets that the inner positions of a design offer, and at the ends of a linear one the
/// first k − m elements of its first and of its last block: one a position, in order of position.
[[nodiscard]] std::vector<UnchangedSubset> one_subset_a_position(const Design& design);

/// Adds subsets from `more`, in its order, at positions that the cover does not use, until it has
/// `count`; false if there are too few. Nothing may be said about what comes beside.
[[nodiscard]] bool add_positions(UnchangedCover& cover, const std::vector<UnchangedSubset>& more,
                                 std::uint64_t count);

/// The cover by the unchanged subsets at these positions: at the ends of a linear design by
/// elements of its first and last block that no other subset has, and then by its first ones.
/// nullopt if a position is none of the design, they do not increase, or elements are left over.
[[nodiscard]] std::optional<UnchangedCover> cover_at(const Design& design,
                                                     std::span<const Element> positions);

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

}  // namespace changeover
