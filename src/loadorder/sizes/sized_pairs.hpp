// Internal: wanted pairs of items of different size.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/io/input.hpp"
#include "changeover/loadorder/load_order.hpp"

namespace changeover {

/// @throws BadInput if a wanted item, or two that must meet, are larger than memory, an item has no
/// byte, or there are other sizes than items
void check_sizes(const ItemSizes& sizes, const WantedPairs& wanted);

/// Calls visit(y) for all that x must meet.
template <typename Visit>
void each_partner(const WantedPairs& wanted, std::uint64_t items, Element x, Visit&& visit) {
  if (wanted.graph() != nullptr) {
    for (const Element y : wanted.graph()->partners(x)) {
      visit(y);
    }
    return;
  }
  for (Element y = 0; y < items; ++y) {
    if (y != x && wanted.contains(std::min(x, y), std::max(x, y))) {
      visit(y);
    }
  }
}

/// The most items that memory can hold at once.
[[nodiscard]] std::uint64_t most_held(const ItemSizes& sizes, const WantedPairs& wanted);

/// Sizes from a list: an item and its bytes per row, or in rows of one field the bytes of items 0,
/// 1, … in turn; bytes are whole numbers, with K, M, G or T for thousands. Items have the numbers
/// or names of the pairs that are listed; without a list, if they have names, `names` gets them.
/// @throws BadInput with a place
[[nodiscard]] std::vector<std::uint64_t> read_sizes(Input& input,
                                                    std::optional<std::uint64_t> items,
                                                    const PairGraph* graph,
                                                    std::vector<std::string>& names);

}  // namespace changeover
