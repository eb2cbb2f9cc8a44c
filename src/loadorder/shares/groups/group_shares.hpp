// Internal: shares in which each worker holds some groups of items all the time and streams others
// past them.
//
// The items are in G groups of ⌊P/G⌋ or ⌈P/G⌉. Two items meet where both groups are held, or one is
// held and the other streamed; items of one group meet where it is held. Streamed groups come item
// by item, or in batches of half of the room besides the held items: then the next batch can be
// loaded while this one is computed.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "changeover/loadorder/schedule.hpp"

namespace changeover {

/// Items in groups of consecutive numbers.
struct ItemGroups {
  std::uint64_t items = 0;
  std::uint64_t groups = 0;

  [[nodiscard]] std::uint64_t begin(std::uint64_t group) const { return group * items / groups; }
  [[nodiscard]] std::uint64_t end(std::uint64_t group) const { return begin(group + 1); }
  [[nodiscard]] std::uint64_t size(std::uint64_t group) const { return end(group) - begin(group); }
  [[nodiscard]] std::uint64_t size(const std::vector<Element>& of) const {
    std::uint64_t sum = 0;
    for (const Element group : of) {
      sum += size(group);
    }
    return sum;
  }
  [[nodiscard]] std::uint64_t group_of(std::uint64_t item) const {
    return ((item + 1) * groups - 1) / items;
  }
  /// Adds the items of the groups.
  void put(const std::vector<Element>& of, std::vector<Element>& out) const;
};

/// The share of one worker.
struct GroupShare {
  std::vector<Element> held;
  std::vector<Element> streamed;

  bool operator==(const GroupShare&) const = default;
};

struct GroupShares {
  std::uint64_t groups = 0;
  std::vector<GroupShare> workers;
  std::string method;
  std::string explanation;  ///< what the groups are, and which worker has them
  /// The order of the field, for shares from a plane, where any two groups are together at one
  /// worker; 0 for other shares.
  std::uint64_t plane_order = 0;
};

/// Splits each group into so many.
void refine(GroupShares& shares, std::uint64_t parts);

/// The cost of a share in a room: loads and steps; 0 steps if it does not fit.
struct ShareCost {
  std::uint64_t loads = 0;
  std::uint64_t steps = 0;
};
[[nodiscard]] ShareCost cost_of(const GroupShare& share, const ItemGroups& groups,
                                std::uint64_t room);

/// The steps of a worker whose share fits. O(1) per load.
[[nodiscard]] std::unique_ptr<StepSource> share_steps(const GroupShare& share,
                                                      const ItemGroups& groups, std::uint64_t room,
                                                      std::uint64_t worker);

}  // namespace changeover
