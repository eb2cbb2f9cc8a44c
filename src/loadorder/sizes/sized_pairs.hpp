// Internal: wanted pairs of items of different sizes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "changeover/io/input.hpp"
#include "changeover/loadorder/workers.hpp"
#include "loadorder/shares/step_lists.hpp"

namespace changeover {

/// Where the size of an item is written: "sizes.csv:3:5", "sizes[2]".
using SizePlace = std::function<std::string(Element)>;

/// @throws BadInput, with the place of an item if there are places, if a wanted item, or two that
/// must meet, are larger than memory, an item has no bytes, or the number of sizes is wrong
void check_sizes(const ItemSizes& sizes, const WantedPairs& wanted, const SizePlace& place = {},
                 const std::string& where = "memory");

/// What these items have together. @throws ImpossibleParameters if that exceeds 64 bits
[[nodiscard]] std::uint64_t bytes_of(const ItemSizes& sizes, std::span<const Element> items);

/// Those of some of the items, and the same memory.
[[nodiscard]] ItemSizes sizes_of(const ItemSizes& sizes, std::span<const Element> items);

/// Orders of closing items are for all pairs of at most so many items.
inline constexpr std::uint64_t most_closed_all = 2'000;

/// @throws BadInput that says that so many items cannot be planned, some being too large
[[noreturn]] void refuse_large_items(std::uint64_t items);

/// Calls visit(y) for all items y that x must meet.
template <typename Visit>
void each_partner(const WantedPairs& wanted, std::uint64_t items, Element x, Visit&& visit) {
  if (wanted.graph() != nullptr) {
    for (const Element y : wanted.graph()->partners(x)) {
      visit(y);
    }
    return;
  }
  // Between two sets: the items of the other set. With new items: all others.
  const bool between = wanted.kind() == WantedPairs::Kind::between;
  const bool is_first = between && x < wanted.first();
  const std::uint64_t end = between && !is_first ? wanted.first() : items;
  for (auto y = static_cast<Element>(is_first ? wanted.first() : 0); y < end; ++y) {
    if (y != x && wanted.contains(std::min(x, y), std::max(x, y))) {
      visit(y);
    }
  }
}

/// The most bytes of two items that must meet, or of one that meets none.
[[nodiscard]] std::uint64_t largest_pair(const ItemSizes& sizes, const WantedPairs& wanted);

/// The items that are in some wanted pair, or must be loaded alone.
[[nodiscard]] std::vector<Element> needed_among(const WantedPairs& wanted, std::uint64_t items);

/// What is known before there is an order: the sizes, and the bounds of one worker.
[[nodiscard]] LoadOrderFacts facts_before(std::shared_ptr<const ItemSizes> sizes,
                                          const WantedPairs& wanted);

/// The same for two levels: `fast` is what the accelerator has.
[[nodiscard]] LoadOrderFacts with_levels(LoadOrderFacts facts, const ItemSizes& fast);

/// The largest number of items that fit into memory.
[[nodiscard]] std::uint64_t most_held(const ItemSizes& sizes, const WantedPairs& wanted);

/// The moves of an order of two levels for these pairs alone; (x,x) for an item in no pair.
[[nodiscard]] std::vector<Move> sized_levels_of(const std::vector<ItemPair>& pairs,
                                                const ItemSizes& sizes,
                                                const LoadOrderOptions& options);

struct SizesRead {
  std::vector<std::uint64_t> bytes;  ///< by item
  std::vector<std::string> names;    ///< if these items are named without listed pairs
  SizePlace place;
};

/// Reads sizes from a list: an item and its bytes per row, or rows with the bytes of items 0, 1, …
/// in turn. Bytes are whole numbers, with K, M, G or T for powers of 1000. Items have the numbers
/// or names of the listed pairs. A first row without a size is a header, which `notes` then
/// receive.
/// @throws BadInput with a place
[[nodiscard]] SizesRead read_sizes(std::unique_ptr<Input> input, std::optional<std::uint64_t> items,
                                   const PairGraph* graph,
                                   std::vector<std::string>* notes = nullptr);

// Two ways to have room for what is loading, as plan_prefetch() knows them for places.

/// Orders that leave `spare` bytes of the memory free as far as they can, with the facts and bounds
/// of the whole memory.
[[nodiscard]] LoadOrder plan_with_spare(std::shared_ptr<const ItemSizes> sizes,
                                        const WantedPairs& wanted, std::uint64_t spare,
                                        const LoadOrderOptions& options);
[[nodiscard]] WorkerSplit split_with_spare(std::shared_ptr<const ItemSizes> sizes,
                                           const WantedPairs& wanted, std::uint64_t workers,
                                           std::uint64_t spare, const LoadOrderOptions& options);

}  // namespace changeover
