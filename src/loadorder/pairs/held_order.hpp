// Internal: groups that are held while others pass, for pairs between two sets and for items that
// are new.
//
// A range of items is cut into groups. Each group in turn stays in memory while the others that it
// must meet pass through the places left: one whole range, up and down in turn, so that the last to
// pass are the first of the next time. For between() these others are the other set. For beyond()
// they are the old items and those new ones that no group had yet: the groups are taken from the
// top of the range, 0 being the bottom.
//
// Memory holds a group and the range that passed last, so nothing is remembered but ranges.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "changeover/loadorder/load_order.hpp"

namespace changeover {

/// Items first, …, end−1.
struct ItemRange {
  std::uint64_t first = 0;
  std::uint64_t end = 0;

  [[nodiscard]] std::uint64_t size() const { return end - first; }
  bool operator==(const ItemRange&) const = default;
};

struct HeldShape {
  std::uint64_t room = 0;
  std::vector<ItemRange> groups;
  std::vector<ItemRange> others;  ///< that pass while the group of the same number stays
  std::uint64_t loads = 0;
  std::uint64_t steps = 0;

  /// One line.
  [[nodiscard]] std::string explain() const;
};

/// The shape with the fewest loads for between() or beyond().
[[nodiscard]] HeldShape best_held_shape(const WantedPairs& wanted, std::uint64_t room);

/// The same for all items of one range with all of another one that has none of them.
[[nodiscard]] HeldShape best_held_shape(const ItemRange& some, const ItemRange& others,
                                        std::uint64_t room);

[[nodiscard]] std::unique_ptr<StepSource> held_steps(HeldShape shape);

}  // namespace changeover
