#include "changeover/loadorder/workers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bounds/counting_bound.hpp"
#include "bounds/stays.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/run/control.hpp"
#include "core/bit_scan.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "loadorder/order/order_relay.hpp"
#include "loadorder/order/read_order.hpp"
#include "loadorder/order/streamed_order.hpp"
#include "loadorder/pairs/held_blocks.hpp"
#include "loadorder/pairs/pair_bounds.hpp"

namespace changeover {

bool OrderRelay::Place::next(Step& next_step) {
  if (!order->next(next_step)) {
    return false;
  }
  ++step;
  const auto mark = [](std::vector<std::uint64_t>& there, const Step& from, auto leave, auto come) {
    for (const Element x : from.*leave) {
      there[x / 64] &= ~(std::uint64_t{1} << x % 64);
    }
    for (const Element x : from.*come) {
      there[x / 64] |= std::uint64_t{1} << x % 64;
    }
  };
  mark(present, next_step, &Step::evict, &Step::load);
  mark(fast, next_step, &Step::fast_evict, &Step::fast_load);
  return true;
}

OrderRelay::Place OrderRelay::take(const LoadOrder& order, std::uint64_t before) {
  {
    const std::scoped_lock lock(mutex_);
    if (left_.order && left_.step < before) {
      return std::exchange(left_, {});
    }
  }
  const std::vector<std::uint64_t> nothing(static_cast<std::size_t>(order.facts().items / 64 + 1));
  return {order.stream(), 0, nothing, nothing};
}

void OrderRelay::give(Place place) {
  const std::scoped_lock lock(mutex_);
  left_ = std::move(place);
}

namespace {

/// Steps `first` to `first + count − 1` of an order of groups, as steps of items.
class Stretch final : public StepSource {
 public:
  Stretch(std::shared_ptr<OrderRelay> relay, const LoadOrder& order, std::uint64_t first,
          std::uint64_t count, std::uint64_t items, std::uint64_t worker)
      : worker_(worker),
        relay_(std::move(relay)),
        at_(count == 0 ? OrderRelay::Place() : relay_->take(order, first)),
        first_(first),
        count_(count),
        items_(items),
        groups_(order.facts().items),
        two_levels_(order.facts().fast_room) {}
  ~Stretch() override {
    if (done_ == count_ && at_.order) {
      relay_->give(std::move(at_));
    }
  }
  Stretch(const Stretch&) = delete;
  Stretch& operator=(const Stretch&) = delete;

  bool next(Step& step) override {
    if (done_ == count_ || !(done_ == 0 ? start() : at_.next(inner_))) {
      return false;
    }
    step.number = ++done_;
    step.worker = worker_;
    step.evict.clear();
    step.load.clear();
    for (const Element group : inner_.evict) {
      expand(group, step.evict);
    }
    for (const Element group : inner_.load) {
      expand(group, step.load);
    }
    if (two_levels_) {  // whose items are not grouped
      step.fast_evict = inner_.fast_evict;
      step.fast_load = inner_.fast_load;
    }
    return true;
  }

 private:
  // The first step loads what is in memory then.
  bool start() {
    while (at_.step < first_) {
      if (!at_.next(inner_)) {
        return false;
      }
    }
    for (std::vector<Element>* const list :
         {&inner_.evict, &inner_.load, &inner_.fast_evict, &inner_.fast_load}) {
      list->clear();
    }
    const auto put = [](const std::vector<std::uint64_t>& there, std::vector<Element>& into) {
      for (std::uint64_t x = next_bit(there, 0, 0); x < 64 * there.size();
           x = next_bit(there, x + 1, 0)) {
        into.push_back(static_cast<Element>(x));
      }
    };
    put(at_.present, inner_.load);
    put(at_.fast, inner_.fast_load);
    return true;
  }

  void expand(Element group, std::vector<Element>& out) const {
    const auto begin = static_cast<Element>(group * items_ / groups_);
    const auto end = static_cast<Element>((group + std::uint64_t{1}) * items_ / groups_);
    for (Element x = begin; x < end; ++x) {
      out.push_back(x);
    }
  }

  std::uint64_t worker_;
  std::shared_ptr<OrderRelay> relay_;
  OrderRelay::Place at_;
  std::uint64_t first_, count_, items_, groups_;
  bool two_levels_;
  std::uint64_t done_ = 0;
  Step inner_;
};

void check_workers(std::uint64_t workers) {
  if (workers == 0 || workers > most_workers) {
    throw BadInput(fmt::format("{} workers: give 1 to {}", workers, most_workers));
  }
}

struct Grouping {
  std::uint64_t groups = 0;
  std::uint64_t room = 0;
  std::uint64_t makespan = 0;
  std::uint64_t loads = 0;

  [[nodiscard]] bool better_than(const Grouping& other) const {
    return std::pair(makespan, loads) < std::pair(other.makespan, other.loads);
  }
};

// What a split of b steps that load `change` groups of at most `size` items costs at most.
Grouping cost(std::uint64_t groups, std::uint64_t room, std::uint64_t size, std::uint64_t steps,
              std::uint64_t change, std::uint64_t workers) {
  const std::uint64_t busy = std::min(workers, steps);
  return {groups, room, size * (room + change * (ceil_div(steps, workers) - 1)),
          size * (busy * room + change * (steps - busy))};
}

// What the steps of an order of groups hold and load, in items; a transfer to an accelerator
// counts, too, if it has a weight.
class StepSizes {
 public:
  StepSizes(const LoadOrder& order, std::uint64_t items, std::uint64_t load = 1,
            std::uint64_t transfer = 0) {
    const LoadOrderFacts& whole = order.facts();
    const auto size = [&](const std::vector<Element>& groups, const std::vector<Element>& fast) {
      std::uint64_t sum = 0;
      for (const Element group : groups) {
        sum += (group + std::uint64_t{1}) * items / whole.items - group * items / whole.items;
      }
      return sum * load + fast.size() * transfer;
    };
    held_.reserve(static_cast<std::size_t>(whole.steps));
    loaded_.reserve(static_cast<std::size_t>(whole.steps) + 1);
    loaded_.push_back(0);
    std::uint64_t held = 0;
    const auto steps = order.stream();
    for (Step step; steps->next(step);) {
      stop_if_asked();
      const std::uint64_t loads = size(step.load, step.fast_load);
      held += loads - size(step.evict, step.fast_evict);
      held_.push_back(held);
      loaded_.push_back(loaded_.back() + loads);
    }
  }

  [[nodiscard]] std::uint64_t steps() const { return held_.size(); }
  /// The loads of a worker whose share begins with step `first`, counted from 0: what is in memory
  /// then, and all after it.
  [[nodiscard]] std::uint64_t loads(std::uint64_t first, std::uint64_t count) const {
    return held_[first] + loaded_[first + count] - loaded_[first + 1];
  }
  /// The most steps from `first` on with at most so many loads.
  [[nodiscard]] std::uint64_t fitting(std::uint64_t first, std::uint64_t most) const {
    if (held_[first] > most) {
      return 0;
    }
    const auto begin = loaded_.begin() + static_cast<std::ptrdiff_t>(first + 1);
    const std::uint64_t left = most - held_[first] + *begin;
    return static_cast<std::uint64_t>(std::upper_bound(begin, loaded_.end(), left) - begin);
  }

  /// The number of steps of each share, as many shares as needed, so that none has more than `most`
  /// loads; nothing if a step alone has more.
  [[nodiscard]] std::vector<std::uint64_t> shares(std::uint64_t most) const {
    std::vector<std::uint64_t> counts;
    for (std::uint64_t first = 0; first < steps();) {
      const std::uint64_t count = fitting(first, most);
      if (count == 0) {
        return {};
      }
      counts.push_back(count);
      first += count;
    }
    return counts;
  }

  /// Shares for so many workers whose largest has as few loads as can be: with contiguous shares,
  /// by bisection.
  [[nodiscard]] std::vector<std::uint64_t> best_shares(std::uint64_t workers) const {
    std::uint64_t low = 1;
    std::uint64_t high = loaded_.back();
    const auto fits = [&](const std::vector<std::uint64_t>& counts) {
      return !counts.empty() && counts.size() <= workers;
    };
    while (low < high) {
      const std::uint64_t middle = low + (high - low) / 2;
      fits(shares(middle)) ? high = middle : low = middle + 1;
    }
    return shares(high);
  }

 private:
  std::vector<std::uint64_t> held_;    // after each step
  std::vector<std::uint64_t> loaded_;  // before each step
};

class OneAfterAnother final : public StepSource {
 public:
  explicit OneAfterAnother(const WorkerSplit& split) : split_(split) {}

  bool next(Step& step) override {
    while (!steps_ || !steps_->next(step)) {
      steps_.reset();  // leaves its place in the order to the next one
      if (worker_ == split_.facts().workers.size()) {
        return false;
      }
      steps_ = split_.stream(worker_++);
    }
    return true;
  }

 private:
  const WorkerSplit& split_;
  std::unique_ptr<StepSource> steps_;
  std::uint64_t worker_ = 0;
};

ScheduleRules rules_of(const SplitFacts& facts, const LoadOrderFacts& whole) {
  return {.items = facts.items,
          .room = facts.room,
          .fast_room = whole.fast_room,
          .wanted = whole.wanted};
}

void verify_split(const WorkerSplit& split) {
  const SplitFacts& facts = split.facts();
  CheckOptions options;
  if (split.order().facts().method == "streamed" && facts.groups == facts.items) {
    options.kept_as = names_by_window(best_streamed_shape(facts.items, facts.room));
  }
  const ScheduleVerdict verdict =
      check_schedule(*split.stream(), rules_of(facts, split.order().facts()), options);
  if (!verdict.valid() || verdict.loads != facts.loads) {
    throw InternalError(fmt::format("the split of {} items with room for {} is wrong: {}{}",
                                    facts.items, facts.room, verdict.fault, verdict.example));
  }
}

}  // namespace

namespace {

// `pairs` among all that are loaded, one worker alone needing so many loads.
LoadBound bound_by_pairs(std::uint64_t pairs, bool between, std::uint64_t least_items,
                         std::uint64_t alone, std::uint64_t room, std::uint64_t workers) {
  const std::uint64_t needed = ceil_div(pairs, workers);
  const std::uint64_t least = between ? least_between(needed, room) : least_loads(needed, room);
  const std::uint64_t low = std::min(alone, std::max(ceil_div(least_items, workers), least));
  return {low,
          fmt::format("one of {} workers brings at least {} of {} pairs together; {} loads are "
                      "enough for {} at most",
                      workers, needed, pairs, low,
                      between ? most_between(low, room) : most_pairs(low, room))};
}

// One block a worker.
std::pair<SplitFacts, LoadOrder> split_of_blocks(HeldBlocks blocks, const WorkerSplit& other) {
  SplitFacts facts = other.facts();
  LoadOrderFacts whole = other.order().facts();
  facts.loads = whole.steps = 0;
  facts.makespan = blocks.makespan();
  for (std::size_t w = 0; w < facts.workers.size(); ++w) {
    WorkerFacts& worker = facts.workers[w] = {};
    if (w < blocks.shapes.size()) {
      worker = {whole.steps + 1, blocks.shapes[w].steps, blocks.shapes[w].loads};
      whole.steps += worker.steps;
      facts.loads += worker.loads;
    }
  }
  whole.loads = facts.loads;
  whole.method = "held groups, a block a worker";
  whole.explanation = fmt::format("{} of the first set with {} of the other; the first pair: {}",
                                  count_of(blocks.first_parts, "part"),
                                  count_of(blocks.other_parts, "part"), blocks.shapes[0].explain());
  const auto shared = std::make_shared<const HeldBlocks>(std::move(blocks));
  const std::uint64_t items = whole.items;
  return {std::move(facts),
          LoadOrder(std::move(whole), [shared, items] { return block_steps(shared, items); })};
}

}  // namespace

LoadBound makespan_lower_bound(const WantedPairs& wanted, std::uint64_t room,
                               std::uint64_t workers) {
  check_workers(workers);
  const LoadBound alone = load_lower_bound(wanted, room);
  room = std::min(room, std::max<std::uint64_t>(2, wanted.items()));
  return workers == 1 ? alone
                      : bound_by_pairs(wanted.count(), wanted.kind() == WantedPairs::Kind::between,
                                       needed_items(wanted), alone.loads, room, workers);
}

LoadBound makespan_lower_bound(std::uint64_t items, std::uint64_t room, std::uint64_t workers) {
  check_workers(workers);
  const LoadBound alone = load_lower_bound(items, room);
  if (workers == 1) {
    return alone;
  }
  room = std::min(room, std::max<std::uint64_t>(2, items));
  LoadBound by_pairs = bound_by_pairs(binomial(items, 2), false, items, alone.loads, room, workers);
  const Introductions all = least_introductions(items, std::min(items, room));
  if (const std::uint64_t each = ceil_div(all.count, workers); each > by_pairs.loads) {
    return {each, fmt::format("all {} workers together load at least {}P - {}C = {} items "
                              "(docs/theorems.md, Theorem 5): one of them at least {}",
                              workers, all.s + 1, most_meetings(all.s, 2), all.count, each)};
  }
  return by_pairs;
}

WorkerSplit::WorkerSplit(SplitFacts facts, LoadOrder order)
    : facts_(std::move(facts)), order_(std::move(order)), relay_(std::make_shared<OrderRelay>()) {
  facts_.explanation = order_.facts().explanation;
  if (facts_.groups < facts_.items) {
    facts_.explanation = fmt::format("Of {} groups of at most {} items: {}", facts_.groups,
                                     ceil_div(facts_.items, facts_.groups), facts_.explanation);
  }
}

std::unique_ptr<StepSource> WorkerSplit::stream(std::uint64_t worker) const {
  if (worker >= facts_.workers.size()) {
    throw BadInput(
        fmt::format("worker {} of {}: they are numbered from 0", worker, facts_.workers.size()));
  }
  const WorkerFacts& facts = facts_.workers[static_cast<std::size_t>(worker)];
  return std::make_unique<Stretch>(relay_, order_, facts.first_step, facts.steps, facts_.items,
                                   worker);
}

std::unique_ptr<StepSource> WorkerSplit::stream() const {
  return std::make_unique<OneAfterAnother>(*this);
}

WorkerSplit split_order(LoadOrder order, std::uint64_t items, std::uint64_t room,
                        std::uint64_t workers) {
  check_workers(workers);
  const LoadOrderFacts& whole = order.facts();
  if (whole.items > items) {
    throw BadInput(fmt::format("{} items cannot be put into {} groups", items, whole.items));
  }
  if (whole.lockstep > 1) {
    throw BadInput(fmt::format("an order for {} workers in lockstep cannot be cut for others",
                               whole.lockstep));
  }
  SplitFacts facts;
  facts.items = items;
  facts.room = room;
  facts.groups = whole.items;
  facts.group_room = whole.room;
  facts.makespan_bound = whole.wanted.are_all() ? makespan_lower_bound(items, room, workers)
                                                : makespan_lower_bound(whole.wanted, room, workers);
  facts.certificate = (whole.items < items ? "of groups of items: " : "") + whole.certificate;
  facts.workers.resize(static_cast<std::size_t>(workers));
  // Blocks are full and steps alike, unless items are grouped: then sizes differ by one.
  const std::uint64_t first_loads = std::min(whole.room, whole.items);
  const std::uint64_t change =
      whole.steps > 1 ? (whole.loads - first_loads) / (whole.steps - 1) : 0;
  const bool alike = whole.items == items && whole.wanted.are_all() && !whole.fast_room &&
                     whole.loads == first_loads + change * (whole.steps - 1);
  // Shares of equal numbers of steps, unless steps differ: then shares whose loads are even.
  constexpr std::uint64_t most_steps_cut = 10'000'000;
  std::vector<std::uint64_t> counts;
  std::optional<StepSizes> sizes;
  if (!alike && whole.steps <= most_steps_cut) {
    sizes.emplace(order, items);
    // Of two levels what both move, measured by the fewest there can be.
    counts = whole.fast_room
                 ? StepSizes(order, items, whole.transfer_bound.loads, whole.bound.loads)
                       .best_shares(workers)
                 : sizes->best_shares(workers);
    facts.cut_by_loads = workers > 1;
  }
  const auto relay = std::make_shared<OrderRelay>();
  std::uint64_t next = 1;
  for (std::uint64_t w = 0; w < workers; ++w) {
    WorkerFacts& worker = facts.workers[static_cast<std::size_t>(w)];
    worker.steps = sizes ? (w < counts.size() ? counts[static_cast<std::size_t>(w)] : 0)
                         : whole.steps / workers + (w < whole.steps % workers ? 1 : 0);
    worker.first_step = worker.steps > 0 ? next : 0;
    next += worker.steps;
    if (worker.steps > 0 && alike) {
      worker.loads = first_loads + change * (worker.steps - 1);
    } else if (worker.steps > 0 && sizes) {
      worker.loads = sizes->loads(worker.first_step - 1, worker.steps);
    } else if (worker.steps > 0) {
      Stretch stretch(relay, order, worker.first_step, worker.steps, items, w);
      for (Step step; stretch.next(step);) {
        stop_if_asked();
        worker.loads += step.load.size();
      }
    }
    facts.loads += worker.loads;
    facts.makespan = std::max(facts.makespan, worker.loads);
  }
  return {std::move(facts), std::move(order)};
}

WorkerSplit split_load_order(std::uint64_t items, std::uint64_t room, std::uint64_t workers,
                             const LoadOrderOptions& options) {
  constexpr std::uint64_t most_groups = 40;
  check_workers(workers);
  LoadOrder order = plan_load_order(items, room, options);
  if (workers > 1) {
    const LoadOrderFacts& facts = order.facts();
    const std::uint64_t first = std::min(room, items);
    const std::uint64_t change = facts.steps > 1 ? (facts.loads - first) / (facts.steps - 1) : 0;
    Grouping best = cost(items, first, 1, facts.steps, change, workers);
    std::optional<LoadOrder> grouped;
    LoadOrderOptions quick = options;
    quick.improve = nullptr;
    quick.closure_rules = false;
    for (std::uint64_t groups = 2; groups <= std::min(most_groups, items); ++groups) {
      const std::uint64_t size = ceil_div(items, groups);
      for (std::uint64_t r = 2; r <= std::min(room / size, groups - 1); ++r) {
        // No order of these groups can be shorter than its bound.
        const Parameters p{.v = groups, .k = r, .change = 1, .kind = Kind::linear};
        if (!cost(groups, r, size, counting_bound(p), 1, workers).better_than(best)) {
          continue;
        }
        LoadOrder candidate = plan_load_order(groups, r, quick);
        const LoadOrderFacts& its = candidate.facts();
        const std::uint64_t m = its.steps > 1 ? (its.loads - r) / (its.steps - 1) : 0;
        const Grouping grouping = cost(groups, r, size, its.steps, m, workers);
        if (grouping.better_than(best)) {
          best = grouping;
          grouped = std::move(candidate);
        }
      }
    }
    if (grouped) {
      order = std::move(*grouped);
    }
  }
  WorkerSplit split = split_order(std::move(order), items, room, workers);
  if (items <= max_elements_in_memory && split.order().facts().every_step_read) {
    verify_split(split);
    split.facts_.certificate = fmt::format("every step read, all {} pairs met", binomial(items, 2));
  }
  return split;
}

WorkerSplit split_two_levels(std::uint64_t items, std::uint64_t room, std::uint64_t fast_room,
                             std::uint64_t workers) {
  check_workers(workers);
  WorkerSplit split = split_order(plan_two_levels(items, room, fast_room), items, room, workers);
  SplitFacts& facts = split.facts_;
  const ScheduleVerdict verdict =
      read_order([&] { return split.stream(); }, rules_of(facts, split.order().facts()),
                 fmt::format("{} items with room for {} and {}, for {} workers", items, room,
                             fast_room, workers));
  if (verdict.loads != facts.loads) {
    throw InternalError(
        fmt::format("the shares have {} loads, not {}", verdict.loads, facts.loads));
  }
  facts.transfers = verdict.transfers;
  facts.certificate =
      "every step read: room at both levels, " + pairs_read(verdict, items, " on the accelerator");
  return split;
}

WorkerSplit split_load_order(const WantedPairs& wanted, std::uint64_t room, std::uint64_t workers,
                             const LoadOrderOptions& options) {
  check_workers(workers);
  WorkerSplit split =
      split_order(plan_load_order(wanted, room, options), wanted.items(), room, workers);
  if (wanted.kind() == WantedPairs::Kind::between && workers > 1) {
    auto blocks = best_held_blocks(wanted, room, workers);
    if (blocks && blocks->makespan() < split.facts().makespan) {
      auto [facts, order] = split_of_blocks(std::move(*blocks), split);
      split = WorkerSplit(std::move(facts), std::move(order));
    }
  }
  if (workers > 1 && wanted.items() <= max_elements_in_memory) {
    // Who brings all pairs together brings these together.
    LoadOrderOptions quick = options;
    quick.improve = nullptr;
    const auto all =
        std::make_shared<const WorkerSplit>(split_load_order(wanted.items(), room, workers, quick));
    if (all->facts().makespan < split.facts().makespan) {
      SplitFacts facts = all->facts();
      facts.makespan_bound = split.facts().makespan_bound;
      LoadOrderFacts whole = all->order().facts();
      whole.wanted = wanted;
      whole.bound = split.order().facts().bound;
      whole.explanation = "An order for all pairs. " + whole.explanation;
      split = WorkerSplit(std::move(facts),
                          LoadOrder(std::move(whole), [all] { return all->order().stream(); }));
    }
  }
  if (split.order().facts().every_step_read) {
    verify_split(split);
  }
  return split;
}

}  // namespace changeover
