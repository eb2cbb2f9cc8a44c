// Internal: items of different sizes in groups that move together.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "changeover/loadorder/schedule.hpp"
#include "loadorder/shares/step_lists.hpp"

namespace changeover {

/// Items in the order of their first loads.
[[nodiscard]] std::vector<Element> items_as_they_come(const std::vector<Move>& moves);

/// By bytes, those of equally many as they were.
[[nodiscard]] std::vector<Element> largest_first(const ItemSizes& sizes,
                                                 std::span<const Element> items);

/// The most bytes of a group.
[[nodiscard]] std::uint64_t largest_of(const ItemSizes& sizes, const Groups& groups);

/// Groups of bytes as even as can be: the largest items first, each into the group with the fewest
/// bytes. O(items · log count)
[[nodiscard]] Groups even_groups(const ItemSizes& sizes, std::span<const Element> items,
                                 std::uint64_t count);

/// Few groups of about equal bytes, but at least `least`, of at most `most` bytes each; none if
/// that cannot be. O(items · log groups) for each number of groups that is tried
[[nodiscard]] Groups groups_of_at_most(const ItemSizes& sizes, const std::vector<Element>& items,
                                       std::uint64_t most, std::uint64_t least);

/// The same items in the same order, cut into groups of at most `most` bytes.
[[nodiscard]] Groups cut_into_groups(const ItemSizes& sizes, const std::vector<Element>& items,
                                     std::uint64_t most);

/// The steps of an order of groups, item by item.
[[nodiscard]] std::vector<Move> of_items(StepSource& steps, const Groups& groups);

/// The pairs of groups that have listed pairs.
[[nodiscard]] WantedPairs between_groups(const Groups& groups, const PairGraph& graph);

}  // namespace changeover
