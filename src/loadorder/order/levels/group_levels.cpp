#include "loadorder/order/levels/group_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/words.hpp"
#include "loadorder/listed/quick_moves.hpp"
#include "loadorder/pairs/closing.hpp"
#include "loadorder/sizes/closing_search.hpp"
#include "loadorder/sizes/sized_pairs.hpp"

namespace changeover {
namespace {

std::vector<SizedMove> as_sized(const std::vector<LoadMove>& moves) {
  std::vector<SizedMove> all;
  for (const LoadMove& move : moves) {
    all.push_back({move.load, {}});
    if (move.evict != LoadMove::nothing) {
      all.back().evict = {move.evict};
    }
  }
  return all;
}

// The moves of the best start, in bytes of the accelerator. The items are items_of(pairs).
std::vector<SizedMove> quick_bytes(const std::vector<ItemPair>& pairs,
                                   const std::vector<Element>& items, const ItemSizes& sizes) {
  if (items.empty()) {
    return {};
  }
  const ItemSizes fast{sizes_of(sizes, items).bytes, sizes.fast_memory};
  const auto graph = std::make_shared<const PairGraph>(items.size(), numbered(pairs, items));
  ClosingSearch search(fast, *graph, most_held(fast, WantedPairs::listed(graph)), 0, 1);
  search.begin([] { return false; });
  std::vector<SizedMove> moves = search.offer().moves;
  give_names(moves, items);
  return moves;
}

}  // namespace

WantedPairs LevelShape::wanted_groups() const {
  switch (wanted.kind()) {
    case WantedPairs::Kind::listed:
      return wanted;
    case WantedPairs::Kind::between:
      return WantedPairs::between(first_groups(), groups() - first_groups());
    default:
      return first_groups() > 0 ? WantedPairs::beyond(first_groups(), groups())
                                : WantedPairs(groups());
  }
}

void LevelShape::put(std::uint64_t group, std::vector<Element>& into) const {
  const std::uint64_t first = wanted.first();
  const auto begin_of = [&](std::uint64_t g) {
    return g < first_groups()
               ? g * first / first_groups()
               : first + (g - first_groups()) * (items() - first) / (groups() - first_groups());
  };
  const std::uint64_t end = begin_of(group + 1);
  for (std::uint64_t x = begin_of(group); x < end; ++x) {
    into.push_back(static_cast<Element>(x));
  }
}

std::string LevelShape::explain() const {
  return fmt::format(
      "Groups of at most {} are loaded; what a group meets for the first time is done at once: up "
      "to {} of its items stay on the accelerator while the others pass.",
      count_of(group_items, "item"), fast_room - 1);
}

std::vector<std::uint64_t> sizes_to_try(std::uint64_t items, std::uint64_t room,
                                        std::uint64_t fast_room) {
  const std::uint64_t most = std::min(items, std::max<std::uint64_t>(1, room / 2));
  std::vector<std::uint64_t> sizes;
  const auto add = [&](std::uint64_t size) {
    if (size >= 1 && size <= most && std::ranges::find(sizes, size) == sizes.end()) {
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

const LoadOrder& InnerOrders::get(std::uint64_t others, std::uint64_t fresh, bool each_other) {
  const std::scoped_lock lock(mutex_);
  const auto key = std::tuple(others, fresh, each_other);
  const auto found = orders_.find(key);
  if (found != orders_.end()) {
    return found->second;
  }
  LoadOrderOptions quick;
  quick.closure_rules = false;
  LoadOrder order = others == 0 ? plan_load_order(fresh, room_, quick)
                    : each_other
                        ? plan_load_order(WantedPairs::beyond(others, others + fresh), room_, quick)
                        : plan_load_order(WantedPairs::between(others, fresh), room_, quick);
  return orders_.emplace(key, std::move(order)).first->second;
}

// The tasks after the loads of some groups: for each group, what it meets for the first time.
void LevelWorker::take(const AssignedStep& groups) {
  for (const Element group : groups.step.evict) {
    shape_.put(group, evict_);
  }
  for (const Element x : evict_) {
    if (accelerator_.has(x)) {
      accelerator_.take_off(x, fast_evict_);
    }
  }
  for (const Element group : groups.step.load) {
    shape_.put(group, load_);
  }
  tasks_.clear();
  next_task_ = 0;
  if (shape_.are_pairs()) {
    std::vector<ItemPair> pairs = groups.pairs;
    for (std::size_t i = 0; i < groups.step.load.size(); ++i) {
      const Element x = groups.step.load[i];
      if (groups.is_new[i] && shape_.is_alone(x)) {
        pairs.emplace_back(x, x);
      }
    }
    names_ = items_of(pairs);
    listed_ = shape_.sizes ? quick_bytes(pairs, names_, *shape_.sizes)
                           : as_sized(quick_moves(pairs, names_, shape_.fast_room));
    next_listed_ = 0;
    return;
  }
  if (groups.step.number == 1) {
    add_first_task(groups);
    return;
  }
  std::size_t begin = 0;
  for (std::size_t i = 0; i < groups.step.load.size(); ++i) {
    const Element group = groups.step.load[i];
    Task task;
    for (std::size_t p = begin; p < groups.arrival_end[i]; ++p) {
      const auto& [x, y] = groups.pairs[p];
      shape_.put(x == group ? y : x, task.items);
    }
    begin = groups.arrival_end[i];
    // Items on the accelerator already come first.
    std::stable_partition(task.items.begin(), task.items.end(),
                          [&](Element x) { return accelerator_.has(x); });
    const std::size_t others = task.items.size();
    shape_.put(group, task.items);
    task.fresh = task.items.size() - others;
    task.each_other = groups.is_new[i] && shape_.meets_itself(group);
    add(std::move(task));
  }
}

// All loaded items are new to each other.
void LevelWorker::add_first_task(const AssignedStep& groups) {
  Task task;
  std::vector<Element> fresh;
  for (const Element group : groups.step.load) {
    shape_.put(group, group < shape_.first_groups() ? task.items : fresh);
  }
  task.fresh = fresh.size();
  task.items.insert(task.items.end(), fresh.begin(), fresh.end());
  task.each_other = shape_.meets_itself(shape_.first_groups());
  add(std::move(task));
}

void LevelWorker::add(Task task) {
  const std::size_t others = task.items.size() - task.fresh;
  if (task.fresh > 0 && (others > 0 || task.each_other)) {
    tasks_.push_back(std::move(task));
  }
}

void LevelWorker::begin(const Task& task) {
  for (const Element x : names_) {
    accelerator_.unwant(x);
  }
  names_ = task.items;
  inner_ = inner_orders_->get(names_.size() - task.fresh, task.fresh, task.each_other).stream();
}

// A step of the order for the accelerator.
void LevelWorker::follow(Step& step) {
  for (const Element i : inner_step_.evict) {
    accelerator_.unwant(names_[i]);
  }
  coming_.clear();
  for (const Element i : inner_step_.load) {
    coming_.push_back(names_[i]);
  }
  accelerator_.bring(coming_, step.fast_evict, step.fast_load);
}

bool LevelWorker::next(Step& step) {
  step.evict = std::exchange(evict_, {});
  step.load = std::exchange(load_, {});
  step.fast_evict = std::exchange(fast_evict_, {});
  step.fast_load.clear();
  if (shape_.are_pairs()) {
    return next_listed(step);
  }
  while (true) {
    if (inner_ && inner_->next(inner_step_)) {
      follow(step);
      if (!step.fast_load.empty() || !step.load.empty()) {
        return true;
      }
      continue;
    }
    inner_.reset();
    if (next_task_ == tasks_.size()) {
      // Moves of groups without transfers after them are a separate step.
      return !step.load.empty() || !step.evict.empty();
    }
    begin(tasks_[next_task_++]);
  }
}

bool LevelWorker::next_listed(Step& step) {
  while (next_listed_ < listed_.size()) {
    const SizedMove& move = listed_[next_listed_++];
    for (const Element x : move.evict) {
      accelerator_.unwant(x);
    }
    accelerator_.bring({move.load}, step.fast_evict, step.fast_load);
    if (!step.fast_load.empty()) {
      return true;
    }
  }
  for (const Element x : names_) {
    accelerator_.unwant(x);
  }
  names_.clear();
  return !step.load.empty() || !step.evict.empty();
}

}  // namespace changeover
