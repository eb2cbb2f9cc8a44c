// Internal: shares of groups that are changed group by group, for searches.
#pragma once

#include <cstdint>
#include <vector>

#include "loadorder/shares/groups/group_shares.hpp"
#include "run/random.hpp"

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

  /// So many exchanges at random of two groups of a share that still fits then. Those stay that
  /// `keeps` wants, which is asked after each, with its number.
  template <typename Keeps>
  void try_exchanges(std::uint64_t moves, Random& random, const Keeps& keeps) {
    for (std::uint64_t i = 0; i < moves; ++i) {
      const std::size_t of = random.below(static_cast<std::uint32_t>(shares_.size()));
      const Share& share = shares_[of];
      const std::size_t a = random.below(static_cast<std::uint32_t>(share.size()));
      const std::size_t b = random.below(static_cast<std::uint32_t>(share.order.size()));
      if (!can_exchange(of, a, b)) {
        continue;
      }
      exchange(of, a, b);
      if (!keeps(i)) {
        exchange(of, a, b);
      }
    }
  }

  // NOLINTBEGIN(misc-non-private-member-variables-in-classes): of searches, which are internal
  ItemGroups groups_;
  std::uint64_t room_, makespan_;
  std::vector<Share> shares_;
  // NOLINTEND(misc-non-private-member-variables-in-classes)

 private:
  /// Whether two groups have different parts in a share, which still fits after their exchange.
  [[nodiscard]] bool can_exchange(std::size_t share, std::size_t a, std::size_t b) const;
  /// Doing it again takes it back.
  void exchange(std::size_t share, std::size_t a, std::size_t b);
  void place(std::size_t share, std::size_t at, std::size_t besides, int by);
};

}  // namespace changeover
