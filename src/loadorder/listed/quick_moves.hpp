// Internal: small orders for parts of a list, many of them, without a search.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "changeover/loadorder/wanted_pairs.hpp"
#include "loadorder/pairs/closing.hpp"
#include "loadorder/shares/step_lists.hpp"

namespace changeover {

/// The number of a load that does not come.
inline constexpr std::size_t not_again = ~std::size_t{0};

/// The loads of the best start (pairs/starts.hpp). O(pairs) for each start
[[nodiscard]] std::vector<LoadMove> quick_moves(const PairGraph& graph, std::uint64_t room);

/// The loads of all starts that do not have much more than the best before them; the best one is
/// first.
[[nodiscard]] std::vector<std::vector<LoadMove>> several_orders(const PairGraph& graph,
                                                                std::uint64_t room);

/// quick_moves() of some pairs, whose items are items_of(pairs).
[[nodiscard]] std::vector<LoadMove> quick_moves(std::span<const ItemPair> pairs,
                                                const std::vector<Element>& items,
                                                std::uint64_t room);

/// The items of pairs, in increasing order, each once; and the pairs with their places there.
[[nodiscard]] std::vector<Element> items_of(std::span<const ItemPair> pairs);
[[nodiscard]] std::vector<ItemPair> numbered(std::span<const ItemPair> pairs,
                                             const std::vector<Element>& items);

/// The wanted pairs as a list; of all pairs it must be known of how many items. @throws
/// ImpossibleParameters if they are not listed and more than 10⁷
[[nodiscard]] WantedPairs as_list(const WantedPairs& wanted);

/// A step for each load.
[[nodiscard]] std::vector<Move> one_step_each(const std::vector<LoadMove>& moves);

}  // namespace changeover
