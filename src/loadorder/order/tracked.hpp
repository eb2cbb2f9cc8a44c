// Internal: what the check of schedules keeps in mind.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "loadorder/order/met_pairs.hpp"

namespace changeover {

inline constexpr std::uint64_t absent = ~std::uint64_t{0};

/// The items in memory, or on the accelerator.
struct Held {
  // Adds an item and returns its place in the list.
  std::uint32_t take(Element x, std::vector<Element>& list) {
    const std::uint32_t at = place[x] - 1;
    const Element moved = list.back();
    list[at] = moved;
    place[moved] = at + 1;
    list.pop_back();
    place[x] = 0;
    return at;
  }
  void put(Element x, std::vector<Element>& list) {
    list.push_back(x);
    place[x] = static_cast<std::uint32_t>(list.size());
  }
  [[nodiscard]] bool has(Element x) const { return place[x] != 0; }

  std::vector<std::uint32_t> place;  // by item: index in the list plus one, 0 if it is not in it
};

/// The pairs that were computed, in each direction, and the items computed alone.
struct Computed {
  Computed(const ScheduleRules& rules, bool all_pairs)
      : alone(static_cast<std::size_t>(rules.items), false), loaded(alone) {
    if (all_pairs || rules.wanted.graph() != nullptr) {
      upward.emplace(rules.wanted, rules.items);
    }
    if (upward && rules.compute->ordered) {
      downward.emplace(rules.wanted, rules.items);
    }
  }

  // Adds (x,y), in this order. Returns whether it is new, as far as pairs are tracked.
  bool insert(Element x, Element y) {
    std::optional<SeenPairs>& pairs = x < y ? upward : downward;
    return !pairs || pairs->insert(x, y);
  }

  std::optional<SeenPairs> upward;    // smaller item first
  std::optional<SeenPairs> downward;  // larger item first
  std::vector<bool> alone;
  std::vector<bool> loaded;
};

/// The pairs of one epoch.
struct Epoch {
  std::optional<MetPairs> met;
  std::optional<Computed> computed;
};

/// For items that change: the number of changes, and which version is where.
struct Changes {
  explicit Changes(std::size_t items)
      : all(items, 0), on_disk(items, 0), in_memory(items, absent) {}

  std::vector<std::uint64_t> all;
  std::vector<std::uint64_t> on_disk;
  std::vector<std::uint64_t> in_memory;  // or absent
};

}  // namespace changeover
