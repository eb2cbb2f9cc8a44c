// Internal: shares of workers who hold some groups of items all the time and stream others past
// them.
//
// The items are in G groups of ⌊P/G⌋ or ⌈P/G⌉. Two items meet where both groups are held, or one is
// held and the other streamed; items of one group where it is held. Groups that are streamed come
// item by item, or so many items at a time as half of the room beside what is held takes: the next
// ones can be loaded while these are computed.
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

/// What one worker has.
struct GroupShare {
  std::vector<Element> held;
  std::vector<Element> streamed;

  bool operator==(const GroupShare&) const = default;
};

struct GroupShares {
  std::uint64_t groups = 0;
  std::vector<GroupShare> workers;
  std::string method;
  std::string explanation;  ///< what the groups are, and who has them
  /// Of a plane over the field of so many elements: each two groups are together at one worker. 0:
  /// of none.
  std::uint64_t plane_order = 0;
};

/// What a share costs in a room: loads and steps; no steps if it does not fit.
struct ShareCost {
  std::uint64_t loads = 0;
  std::uint64_t steps = 0;
};
[[nodiscard]] ShareCost cost_of(const GroupShare& share, const ItemGroups& groups,
                                std::uint64_t room);

/// The steps of a worker whose share fits, O(1) a load.
[[nodiscard]] std::unique_ptr<StepSource> share_steps(const GroupShare& share,
                                                      const ItemGroups& groups, std::uint64_t room,
                                                      std::uint64_t worker);

}  // namespace changeover
