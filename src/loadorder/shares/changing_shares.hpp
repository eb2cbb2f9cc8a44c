// Internal: shares of groups that are changed group by group, for searches.
#pragma once

#include <cstdint>
#include <vector>

#include "loadorder/shares/group_shares.hpp"

namespace changeover {

/// A move exchanges two groups of one share that are held, streamed or not in it. Which groups meet
/// is told pair by pair.
class ChangingShares {
 public:
  virtual ~ChangingShares() = default;
  ChangingShares(const ChangingShares&) = delete;
  ChangingShares& operator=(const ChangingShares&) = delete;

  [[nodiscard]] std::vector<GroupShare> result() const;

 protected:
  /// Held groups come first, then streamed ones, then the rest.
  struct Share {
    std::vector<Element> order;
    std::size_t held = 0;
    std::size_t streamed = 0;
    std::uint64_t held_items = 0;
    std::uint64_t all_items = 0;

    [[nodiscard]] std::size_t size() const { return held + streamed; }
  };

  ChangingShares(const ItemGroups& groups, std::uint64_t room, std::uint64_t makespan)
      : groups_(groups), room_(room), makespan_(makespan) {}

  /// Two groups, or one with itself, meet at a worker once more (1), or once less (−1).
  virtual void meet(std::size_t share, Element group, Element other, int by) = 0;

  /// Adds a share and tells what meets there.
  void add(Share share);
  /// Whether two groups have different parts in a share, which still fits after their exchange.
  [[nodiscard]] bool can_exchange(std::size_t share, std::size_t a, std::size_t b) const;
  /// Doing it again takes it back.
  void exchange(std::size_t share, std::size_t a, std::size_t b);

  // NOLINTBEGIN(misc-non-private-member-variables-in-classes): of searches, which are internal
  ItemGroups groups_;
  std::uint64_t room_, makespan_;
  std::vector<Share> shares_;
  // NOLINTEND(misc-non-private-member-variables-in-classes)

 private:
  void place(std::size_t share, std::size_t at, std::size_t besides, int by);
};

}  // namespace changeover
