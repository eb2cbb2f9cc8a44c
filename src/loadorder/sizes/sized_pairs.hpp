// Internal: wanted pairs of items of different sizes.
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
/// bytes, or the number of sizes is wrong
void check_sizes(const ItemSizes& sizes, const WantedPairs& wanted);

/// Calls visit(y) for all items y that x must meet.
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

/// The largest number of items that fit into memory.
[[nodiscard]] std::uint64_t most_held(const ItemSizes& sizes, const WantedPairs& wanted);

/// Reads sizes from a list: an item and its bytes per row, or rows with the bytes of items 0, 1, …
/// in turn. Bytes are whole numbers, with K, M, G or T for powers of 1000. Items have the numbers
/// or names of the listed pairs; without a list, `names` receives the names. @throws BadInput with
/// a place
[[nodiscard]] std::vector<std::uint64_t> read_sizes(Input& input,
                                                    std::optional<std::uint64_t> items,
                                                    const PairGraph* graph,
                                                    std::vector<std::string>& names);

}  // namespace changeover
