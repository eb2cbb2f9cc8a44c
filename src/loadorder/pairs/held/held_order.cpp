#include "loadorder/pairs/held/held_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/each.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

ItemRange common(const ItemRange& a, const ItemRange& b) {
  const std::uint64_t first = std::max(a.first, b.first);
  return {first, std::max(first, std::min(a.end, b.end))};
}

/// One group and the items that pass it, in ranges. Only Walk::next() knows what a step is.
class Walk {
 public:
  explicit Walk(const HeldShape& shape) : shape_(&shape) {}

  struct Change {
    ItemRange group_out;
    std::vector<ItemRange> out, in;  // of those that pass
    std::uint64_t times = 1;         // so many steps of the same size follow each other
  };

  /// The next step; with `all_alike`, as many steps at once as load and evict equally many items.
  /// False at the end.
  bool next(Change& change, bool all_alike) {
    change = {};
    if (round_ == shape_->groups.size()) {
      return false;
    }
    const ItemRange& group = shape_->groups[round_];
    const ItemRange& others = shape_->others[round_];
    const std::uint64_t places = shape_->room - group.size();
    if (!begun_) {
      begin_round(change, group, others, places);
      return true;
    }
    const std::uint64_t count = std::min(places, left(others));
    if (all_alike && passing_.size() == places) {
      change.times = std::max<std::uint64_t>(1, left(others) / places);
    }
    pass(change, count, places);
    if (change.times > 1) {  // the rest of these steps
      const std::uint64_t more = (change.times - 1) * count;
      next_ = up_ ? next_ + more : next_ - more;
      passing_ = up_ ? ItemRange{next_ - places, next_} : ItemRange{next_, next_ + places};
    }
    end_round_if_done(others);
    return true;
  }

 private:
  [[nodiscard]] std::uint64_t left(const ItemRange& others) const {
    return up_ ? others.end - next_ : next_ - others.first;
  }

  // Evicts the old group and loads the new one, and others as far as there is room.
  void begin_round(Change& change, const ItemRange& group, const ItemRange& others,
                   std::uint64_t places) {
    begun_ = true;
    if (round_ > 0) {
      change.group_out = shape_->groups[round_ - 1];
    }
    // Items that passed last may belong to the group, and some are kept.
    const ItemRange joined = common(passing_, group);
    ItemRange kept = common(passing_, others);
    if (kept.size() > places) {  // keep those where the next pass begins
      kept =
          up_ ? ItemRange{kept.first, kept.first + places} : ItemRange{kept.end - places, kept.end};
    }
    // passing_ is one range; joined and kept are parts of it.
    std::uint64_t at = passing_.first;
    std::vector<ItemRange> stay{joined, kept};
    std::ranges::sort(stay, {}, &ItemRange::first);
    for (const ItemRange& part : stay) {
      if (part.size() > 0) {
        change.out.push_back({at, part.first});
        at = part.end;
      }
    }
    change.out.push_back({at, passing_.end});
    if (joined.size() == 0) {
      change.in.push_back(group);
    } else {
      change.in.push_back({group.first, joined.first});
      change.in.push_back({joined.end, group.end});
    }
    if (up_) {
      next_ = kept.size() > 0 ? kept.end : others.first;
    } else {
      next_ = kept.size() > 0 ? kept.first : others.end;
    }
    passing_ = kept.size() > 0 ? kept : ItemRange{next_, next_};
    pass(change, std::min(places - kept.size(), left(others)), places);
    end_round_if_done(others);
  }

  void pass(Change& change, std::uint64_t count, std::uint64_t places) {
    const std::uint64_t now = passing_.size() + count;
    const std::uint64_t going = now > places ? now - places : 0;
    if (up_) {
      change.out.push_back({passing_.first, passing_.first + going});
      change.in.push_back({next_, next_ + count});
      next_ += count;
      passing_ = {passing_.first + going, next_};
    } else {
      change.out.push_back({passing_.end - going, passing_.end});
      change.in.push_back({next_ - count, next_});
      next_ -= count;
      passing_ = {next_, passing_.end - going};
    }
  }

  void end_round_if_done(const ItemRange& others) {
    if (left(others) == 0) {
      ++round_;
      begun_ = false;
      up_ = !up_;
    }
  }

  const HeldShape* shape_;
  std::size_t round_ = 0;
  bool begun_ = false;
  bool up_ = true;
  std::uint64_t next_ = 0;  // the way up loads it next; the way down has just loaded it
  ItemRange passing_;       // the other items in memory
};

class HeldSteps final : public StepSource {
 public:
  explicit HeldSteps(HeldShape shape) : shape_(std::move(shape)), walk_(shape_) {}

  bool next(Step& step) override {
    if (!walk_.next(change_, false)) {
      return false;
    }
    step.number = ++number_;
    step.evict.clear();
    step.load.clear();
    list(change_.group_out, step.evict);
    for (const ItemRange& range : change_.out) {
      list(range, step.evict);
    }
    for (const ItemRange& range : change_.in) {
      list(range, step.load);
    }
    return true;
  }

 private:
  static void list(const ItemRange& range, std::vector<Element>& items) {
    for (std::uint64_t x = range.first; x < range.end; ++x) {
      items.push_back(static_cast<Element>(x));
    }
  }

  HeldShape shape_;
  Walk walk_;
  Walk::Change change_;
  std::uint64_t number_ = 0;
};

void count_loads(HeldShape& shape) {
  Walk walk(shape);
  for (Walk::Change change; walk.next(change, true);) {
    stop_if_asked();
    std::uint64_t loads = sum_of(change.in, &ItemRange::size);
    shape.loads = checked_add(shape.loads, checked_multiply(loads, change.times));
    shape.steps += change.times;
  }
}

// Cuts `held` into groups from the top; sizes differ by one or, if not balanced, all groups but the
// last are full.
HeldShape shape_of(const ItemRange& held, std::uint64_t groups, bool balanced,
                   const ItemRange& others, bool others_grow_less, std::uint64_t room) {
  HeldShape shape;
  shape.room = room;
  std::uint64_t end = held.end;
  for (std::uint64_t i = 0; i < groups; ++i) {
    const std::uint64_t rest = end - held.first;
    const std::uint64_t size = balanced ? ceil_div(rest, groups - i) : std::min(rest, room - 1);
    shape.groups.push_back({end - size, end});
    end -= size;
    shape.others.push_back(others_grow_less ? ItemRange{others.first, end} : others);
  }
  count_loads(shape);
  return shape;
}

}  // namespace

std::string HeldShape::explain() const {
  const std::uint64_t most = largest_of(groups, &ItemRange::size);
  return fmt::format(
      "{} of up to {}: each stays while those that it must meet pass, up and down in turn.",
      count_of(groups.size(), "group"), count_of(most, "item"));
}

namespace {

/// Keeps the best of the shapes considered.
class BestShape {
 public:
  explicit BestShape(std::uint64_t room) : room_(room) {}

  void consider(const ItemRange& held, const ItemRange& others, bool others_grow_less) {
    const std::uint64_t least = ceil_div(held.size(), room_ - 1);
    constexpr std::uint64_t more_groups = 2;
    for (std::uint64_t groups = least; groups <= std::min(held.size(), least + more_groups);
         ++groups) {
      for (const bool balanced : {false, true}) {
        if (!balanced && groups != least) {
          continue;
        }
        HeldShape shape = shape_of(held, groups, balanced, others, others_grow_less, room_);
        if (!best_ || std::pair(shape.loads, shape.steps) < std::pair(best_->loads, best_->steps)) {
          best_ = std::move(shape);
        }
      }
    }
  }

  HeldShape take() { return std::move(*best_); }

 private:
  std::uint64_t room_;
  std::optional<HeldShape> best_;
};

}  // namespace

HeldShape best_held_shape(const ItemRange& some, const ItemRange& others, std::uint64_t room) {
  BestShape best(room);
  best.consider(some, others, false);
  best.consider(others, some, false);
  return best.take();
}

HeldShape best_held_shape(const WantedPairs& wanted, std::uint64_t room) {
  const ItemRange low{0, wanted.first()};
  const ItemRange high{wanted.first(), wanted.items()};
  if (wanted.kind() == WantedPairs::Kind::between) {
    return best_held_shape(low, high, room);
  }
  BestShape best(room);
  best.consider(high, {0, wanted.items()}, true);
  return best.take();
}

std::unique_ptr<StepSource> held_steps(HeldShape shape) {
  return std::make_unique<HeldSteps>(std::move(shape));
}

}  // namespace changeover
