// Internal: what a worker with two levels does when groups of items come into its memory.
//
// The pairs that meet there for the first time are done at once on the accelerator: up to c − 1
// items of the group that came stay there while the others pass. What the accelerator still has is
// not transferred again.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <vector>

#include "changeover/loadorder/load_order.hpp"
#include "core/checked.hpp"
#include "loadorder/order/levels/accelerator.hpp"
#include "loadorder/order/pair_assigner.hpp"
#include "loadorder/sizes/byte_closing.hpp"

namespace changeover {

/// Items in groups, of one set, or of two whose items are not in one group.
struct LevelShape {
  WantedPairs wanted;  ///< of items
  std::uint64_t room = 0;
  std::uint64_t fast_room = 0;
  std::uint64_t group_items = 0;                ///< 1 for listed pairs, and with sizes
  std::shared_ptr<const ItemSizes> sizes = {};  ///< both rooms are counted in bytes then

  [[nodiscard]] std::uint64_t items() const { return wanted.items(); }
  /// Whether what meets is done pair by pair.
  [[nodiscard]] bool are_pairs() const { return sizes != nullptr || wanted.graph() != nullptr; }
  /// Whether the item is in no wanted pair.
  [[nodiscard]] bool is_alone(Element x) const {
    return wanted.graph() != nullptr ? wanted.graph()->partners(x).empty() : items() == 1;
  }
  [[nodiscard]] std::uint64_t group_room() const { return room / group_items; }
  [[nodiscard]] std::uint64_t first_groups() const { return ceil_div(wanted.first(), group_items); }
  [[nodiscard]] std::uint64_t groups() const {
    return first_groups() + ceil_div(items() - wanted.first(), group_items);
  }
  /// The pairs of groups whose items must meet.
  [[nodiscard]] WantedPairs wanted_groups() const;
  /// Whether the items of the group must meet each other.
  [[nodiscard]] bool meets_itself(std::uint64_t group) const {
    return wanted.kind() != WantedPairs::Kind::between && group >= first_groups();
  }
  void put(std::uint64_t group, std::vector<Element>& into) const;

  /// How an order of such groups is described.
  [[nodiscard]] std::string explain() const;
};

/// Sizes of groups around the most promising ones, those first.
[[nodiscard]] std::vector<std::uint64_t> sizes_to_try(std::uint64_t items, std::uint64_t room,
                                                      std::uint64_t fast_room);

/// The orders for the accelerator, each made once: `fresh` items with each other and with `others`,
/// or with the others only. Thread-safe.
class InnerOrders {
 public:
  explicit InnerOrders(std::uint64_t room) : room_(room) {}

  const LoadOrder& get(std::uint64_t others, std::uint64_t fresh, bool each_other);

 private:
  std::uint64_t room_;
  std::mutex mutex_;
  std::map<std::tuple<std::uint64_t, std::uint64_t, bool>, LoadOrder> orders_;
};

/// The moves of one worker.
class LevelWorker {
 public:
  LevelWorker(const LevelShape& shape, std::shared_ptr<InnerOrders> inner_orders)
      : shape_(shape),
        inner_orders_(std::move(inner_orders)),
        accelerator_(shape.items(), shape.fast_room, shape.sizes) {}

  /// What groups move and meet in a step, the first one or another.
  void take(const AssignedStep& groups);

  /// The next moves, which begin with those of the groups; false when all is done.
  bool next(Step& step);

 private:
  struct Task {
    std::vector<Element> items;  // others, then the fresh ones
    std::size_t fresh = 0;
    bool each_other = false;
  };

  void add_first_task(const AssignedStep& groups);
  void add(Task task);
  void begin(const Task& task);
  void follow(Step& step);
  bool next_listed(Step& step);

  LevelShape shape_;
  std::shared_ptr<InnerOrders> inner_orders_;
  std::vector<Element> evict_;  // what the next moves begin with
  std::vector<Element> load_;
  std::vector<Element> fast_evict_;
  std::vector<Task> tasks_;
  std::size_t next_task_ = 0;
  std::unique_ptr<StepSource> inner_;
  Step inner_step_;
  std::vector<Element> names_;     // of the items in the order that is followed
  std::vector<SizedMove> listed_;  // the same pair by pair
  std::size_t next_listed_ = 0;
  Accelerator accelerator_;
  std::vector<Element> coming_;
};

}  // namespace changeover
