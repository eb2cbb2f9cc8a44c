#include "changeover/loadorder/load_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "loadorder/listed/listed_levels.hpp"
#include "loadorder/order/accelerator.hpp"
#include "loadorder/order/kept_steps.hpp"
#include "loadorder/order/pair_assigner.hpp"
#include "loadorder/order/read_order.hpp"

namespace changeover {
namespace {

/// The orders for the accelerator, each made once: `fresh` items with each other and with `others`,
/// or with the others only. Thread-safe.
class InnerOrders {
 public:
  explicit InnerOrders(std::uint64_t room) : room_(room) {}

  const LoadOrder& get(std::uint64_t others, std::uint64_t fresh, bool each_other) {
    const std::scoped_lock lock(mutex_);
    const auto key = std::tuple(others, fresh, each_other);
    const auto found = orders_.find(key);
    if (found != orders_.end()) {
      return found->second;
    }
    LoadOrderOptions quick;
    quick.closure_rules = false;
    LoadOrder order =
        others == 0  ? plan_load_order(fresh, room_, quick)
        : each_other ? plan_load_order(WantedPairs::beyond(others, others + fresh), room_, quick)
                     : plan_load_order(WantedPairs::between(others, fresh), room_, quick);
    return orders_.emplace(key, std::move(order)).first->second;
  }

 private:
  std::uint64_t room_;
  std::mutex mutex_;
  std::map<std::tuple<std::uint64_t, std::uint64_t, bool>, LoadOrder> orders_;
};

struct Shape {
  std::uint64_t items = 0;
  std::uint64_t room = 0;
  std::uint64_t fast_room = 0;
  std::uint64_t group_items = 0;

  [[nodiscard]] std::uint64_t groups() const { return ceil_div(items, group_items); }
  [[nodiscard]] Element begin_of(std::uint64_t group) const {
    return static_cast<Element>(group * items / groups());
  }
  void put(std::uint64_t group, std::vector<Element>& into) const {
    for (Element x = begin_of(group); x < begin_of(group + 1); ++x) {
      into.push_back(x);
    }
  }
};

/// Loads groups by an order of groups; after each load computes the new pairs on the accelerator.
class Steps final : public StepSource {
 public:
  Steps(const Shape& shape, std::unique_ptr<StepSource> groups, std::uint64_t group_room,
        std::shared_ptr<InnerOrders> inner_orders)
      : shape_(shape),
        assigner_(shape.groups(), group_room),
        inner_orders_(std::move(inner_orders)),
        accelerator_(shape.items, shape.fast_room) {
    assigner_.start(std::move(groups));
  }

  bool next(Step& step) override {
    step.number = number_ + 1;
    step.fast_evict.clear();
    step.evict.clear();
    step.load.clear();
    step.fast_load.clear();
    while (true) {
      if (inner_ && inner_->next(inner_step_)) {
        follow(step);
        if (!step.fast_load.empty() || !step.load.empty()) {
          ++number_;
          return true;
        }
        continue;
      }
      inner_.reset();
      if (next_task_ < tasks_.size()) {
        begin(tasks_[next_task_++]);
        continue;
      }
      // Loads without transfers after them are a step of their own.
      if (!step.load.empty()) {
        ++number_;
        return true;
      }
      if (!assigner_.next(groups_)) {
        return false;
      }
      load_groups(step);
    }
  }

 private:
  struct Task {
    std::vector<Element> items;  // others, then the fresh ones
    std::size_t fresh = 0;
    bool each_other = false;
  };

  // The tasks after the loads of some groups: for each group, what it meets for the first time.
  void load_groups(Step& step) {
    for (const Element group : groups_.step.evict) {
      shape_.put(group, step.evict);
    }
    for (const Element x : step.evict) {
      if (accelerator_.has(x)) {
        accelerator_.take_off(x, step.fast_evict);
      }
    }
    for (const Element group : groups_.step.load) {
      shape_.put(group, step.load);
    }
    tasks_.clear();
    next_task_ = 0;
    const std::size_t loaded = groups_.step.load.size();
    if (groups_.step.number == 1) {  // all loaded items are new to each other
      tasks_.push_back({step.load, step.load.size(), true});
      return;
    }
    std::size_t begin = 0;
    for (std::size_t i = 0; i < loaded; ++i) {
      const Element group = groups_.step.load[i];
      Task task;
      for (std::size_t p = begin; p < groups_.arrival_end[i]; ++p) {
        const auto& [x, y] = groups_.pairs[p];
        shape_.put(x == group ? y : x, task.items);
      }
      begin = groups_.arrival_end[i];
      // Items on the accelerator already come first.
      std::stable_partition(task.items.begin(), task.items.end(),
                            [&](Element x) { return accelerator_.has(x); });
      const std::size_t others = task.items.size();
      shape_.put(group, task.items);
      task.fresh = task.items.size() - others;
      task.each_other = groups_.is_new[i];
      if (others > 0 || (task.each_other && task.fresh > 1)) {
        tasks_.push_back(std::move(task));
      }
    }
  }

  void begin(const Task& task) {
    for (const Element x : names_) {
      accelerator_.unwant(x);
    }
    names_ = task.items;
    inner_ = inner_orders_->get(names_.size() - task.fresh, task.fresh, task.each_other).stream();
  }

  // A step of the order for the accelerator.
  void follow(Step& step) {
    for (const Element i : inner_step_.evict) {
      accelerator_.unwant(names_[i]);
    }
    coming_.clear();
    for (const Element i : inner_step_.load) {
      coming_.push_back(names_[i]);
    }
    accelerator_.bring(coming_, step.fast_evict, step.fast_load);
  }

  Shape shape_;
  PairAssigner assigner_;
  std::shared_ptr<InnerOrders> inner_orders_;
  AssignedStep groups_;
  std::vector<Task> tasks_;
  std::size_t next_task_ = 0;
  std::unique_ptr<StepSource> inner_;
  Step inner_step_;
  std::vector<Element> names_;  // of the items in the order that is followed
  Accelerator accelerator_;
  std::vector<Element> coming_;
  std::uint64_t number_ = 0;
};

/// The order for groups of a given size.
LoadOrder::Maker with_groups(const Shape& shape) {
  const std::uint64_t group_room = shape.room / shape.group_items;
  LoadOrderOptions quick;
  quick.closure_rules = false;
  const auto groups =
      std::make_shared<const LoadOrder>(plan_load_order(shape.groups(), group_room, quick));
  const auto inner = std::make_shared<InnerOrders>(shape.fast_room);
  return [shape, groups, group_room, inner]() -> std::unique_ptr<StepSource> {
    return std::make_unique<Steps>(shape, groups->stream(), group_room, inner);
  };
}

/// The order for the accelerator alone. Items that leave it stay in memory; memory evicts the item
/// that is needed last.
class Cache {
 public:
  explicit Cache(const Shape& shape)
      : shape_(shape),
        uses_(static_cast<std::size_t>(shape.items)),
        place_(uses_.size(), Place::disk) {
    const LoadOrder order = plan_load_order(shape.items, shape.fast_room);
    Step step;
    for (const auto steps = order.stream(); steps->next(step);) {
      for (const Element x : step.load) {
        uses_[x].push_back(step.number);
      }
      steps_.push_back(step);
    }
    for (std::vector<std::uint64_t>& each : uses_) {
      std::reverse(each.begin(), each.end());  // the next one last
    }
  }

  LoadOrder::Maker run() {
    const auto made = std::make_shared<std::vector<Step>>();
    for (const Step& step : steps_) {
      made->push_back(follow(step));
    }
    return [made]() -> std::unique_ptr<StepSource> { return std::make_unique<KeptSteps>(made); };
  }

 private:
  enum class Place : std::uint8_t { disk, memory, accelerator };

  Step follow(const Step& step) {
    Step out;
    out.number = step.number;
    out.fast_evict = step.evict;
    for (const Element x : step.evict) {
      place_[x] = Place::memory;
    }
    for (const Element x : step.load) {
      uses_[x].pop_back();
      if (place_[x] == Place::disk) {
        out.load.push_back(x);
        memory_.push_back(x);
      }
      place_[x] = Place::accelerator;
    }
    while (memory_.size() > shape_.room) {
      const auto goes = std::max_element(memory_.begin(), memory_.end(), [&](Element a, Element b) {
        return needed_at(a) < needed_at(b);
      });
      out.evict.push_back(*goes);
      place_[*goes] = Place::disk;
      memory_.erase(goes);
    }
    out.fast_load = step.load;
    return out;
  }

  // Items on the accelerator are needed now.
  [[nodiscard]] std::uint64_t needed_at(Element x) const {
    return place_[x] == Place::accelerator ? 0
           : uses_[x].empty()              ? ~std::uint64_t{0}
                                           : uses_[x].back();
  }

  Shape shape_;
  std::vector<Step> steps_;
  std::vector<std::vector<std::uint64_t>> uses_;  // by item: the steps that transfer it
  std::vector<Place> place_;
  std::vector<Element> memory_;  // including items on the accelerator
};

// Sizes around the most promising ones, those first.
std::vector<std::uint64_t> sizes_to_try(std::uint64_t items, std::uint64_t room,
                                        std::uint64_t fast_room) {
  const std::uint64_t most = std::min(items, std::max<std::uint64_t>(1, room / 2));
  std::vector<std::uint64_t> sizes;
  const auto add = [&](std::uint64_t size) {
    if (size >= 1 && size <= most && std::find(sizes.begin(), sizes.end(), size) == sizes.end()) {
      sizes.push_back(size);
    }
  };
  add(std::min(fast_room - 1, most));
  add(2 * (fast_room - 1));
  add((fast_room - 1) / 2);
  for (std::uint64_t k = 2; k <= 12; ++k) {
    add(room / k);
  }
  add(3 * (fast_room - 1));
  for (std::uint64_t size = 1; size <= std::min<std::uint64_t>(most, 12); ++size) {
    add(size);
  }
  return sizes;
}

struct Offer {
  std::uint64_t group_items = 0;  // 0 if items are not grouped
  LoadOrder::Maker maker;
};

// The first of the cheapest offers; loads and transfers are each divided by their lower bounds.
Offer best_of(std::vector<Offer> offers, const LoadOrderFacts& bounds) {
  const auto cost = [&](const Offer& offer) {
    std::uint64_t loads = 0;
    std::uint64_t transfers = 0;
    const auto steps = offer.maker();
    for (Step step; steps->next(step);) {
      loads += step.load.size();
      transfers += step.fast_load.size();
    }
    return static_cast<double>(loads) / static_cast<double>(bounds.bound.loads) +
           static_cast<double>(transfers) / static_cast<double>(bounds.transfer_bound.loads);
  };
  std::size_t best = 0;
  double least = offers.size() == 1 ? 0 : cost(offers[0]);
  for (std::size_t i = 1; i < offers.size(); ++i) {
    stop_if_asked();
    if (const double its = cost(offers[i]); its < least) {
      best = i;
      least = its;
    }
  }
  return std::move(offers[best]);
}

// The best order of groups, or of what leaves the accelerator for memory. Describes it in `facts`.
LoadOrder::Maker steps_of_groups(LoadOrderFacts& facts) {
  const std::uint64_t items = facts.items;
  const std::uint64_t room = facts.room;
  const std::uint64_t fast_room = *facts.fast_room;
  // Limits the time to some seconds.
  constexpr std::uint64_t most_work = 30'000'000;
  const std::uint64_t most_tried =
      std::max<std::uint64_t>(1, most_work / (4 * (binomial(items, 2) + items)));
  std::vector<Offer> offers;
  for (const std::uint64_t size : sizes_to_try(items, room, fast_room)) {
    if (offers.size() < most_tried) {
      offers.push_back({size, with_groups({items, room, fast_room, size})});
    }
  }
  constexpr std::uint64_t most_kept = 100'000;  // transfers
  if (facts.transfer_bound.loads <= most_kept) {
    offers.push_back({0, Cache({items, room, fast_room, 0}).run()});
  }
  Offer best = best_of(std::move(offers), facts);
  facts.group_items = best.group_items;
  facts.explanation =
      best.group_items == 0
          ? "An order for the accelerator alone; what leaves it stays in memory, from which goes "
            "what is needed last."
          : fmt::format(
                "Groups of at most {} are loaded; what a group meets for the first time "
                "is done at once: up to {} of its items stay on the accelerator while the "
                "others pass.",
                count_of(best.group_items, "item"), fast_room - 1);
  return std::move(best.maker);
}

}  // namespace

LoadOrder plan_two_levels(const WantedPairs& wanted, std::uint64_t room, std::uint64_t fast_room,
                          const LoadOrderOptions& options) {
  const std::uint64_t items = wanted.items();
  LoadOrderFacts facts;
  facts.items = items;
  facts.room = room;
  facts.fast_room = fast_room;
  facts.wanted = wanted.are_all() ? WantedPairs() : wanted;
  facts.bound = load_lower_bound(wanted, room);
  facts.transfer_bound = load_lower_bound(wanted, fast_room);
  check_rooms(room, fast_room);
  if (wanted.graph() == nullptr && items > max_elements_in_memory) {
    throw ImpossibleParameters(
        fmt::format("{} items: two levels have at most {}; group items into larger ones", items,
                    max_elements_in_memory));
  }
  LoadOrder::Maker maker =
      wanted.are_all() ? steps_of_groups(facts) : listed_levels(facts, options);
  const ScheduleVerdict verdict =
      read_order(maker, LoadOrder(facts, maker).rules(),
                 fmt::format("{} with room for {} and {}",
                             wanted.are_all() ? fmt::format("{} items", items) : wanted.describe(),
                             room, fast_room));
  static_cast<ScheduleFacts&>(facts) = verdict;
  facts.every_step_read = true;
  facts.certificate = "every step read: room at both levels, " +
                      pairs_read(verdict, wanted.count(), " on the accelerator");
  return {std::move(facts), std::move(maker)};
}

}  // namespace changeover
