// Internal: groups that are held while other items pass, for pairs between two sets and for new
// items.
//
// A range of items is cut into groups. Each group in turn stays in memory while the items that it
// must meet pass through the other places: one whole range, up and down in turn, so the last items
// to pass are the first ones of the next pass. For between() these are the items of the other set.
// For beyond() they are the old items and the new ones that no group had yet: groups are taken from
// the top of the range, with 0 at the bottom.
//
// Memory contains a group and the range that passed last, so only ranges are stored.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

/// The items first, …, end−1.
struct ItemRange {
  std::uint64_t first = 0;
  std::uint64_t end = 0;

  [[nodiscard]] std::uint64_t size() const { return end - first; }
  bool operator==(const ItemRange&) const = default;
};

struct HeldShape {
  std::uint64_t room = 0;
  std::vector<ItemRange> groups;
  std::vector<ItemRange> others;  ///< items that pass while the group with the same number stays
  std::uint64_t loads = 0;
  std::uint64_t steps = 0;

  /// A description in one line.
  [[nodiscard]] std::string explain() const;
};

/// The shape with the fewest loads for between() or beyond().
[[nodiscard]] HeldShape best_held_shape(const WantedPairs& wanted, std::uint64_t room);

/// The same for all items of one range with all of another, disjoint one.
[[nodiscard]] HeldShape best_held_shape(const ItemRange& some, const ItemRange& others,
                                        std::uint64_t room);

[[nodiscard]] std::unique_ptr<StepSource> held_steps(HeldShape shape);

}  // namespace changeover
