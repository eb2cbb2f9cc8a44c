#include "changeover/loadorder/workers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "loadorder/listed/lockstep_cuts.hpp"
#include "loadorder/listed/quick_moves.hpp"
#include "loadorder/order/in_rounds.hpp"
#include "loadorder/order/lockstep/check_disjoint.hpp"
#include "loadorder/order/lockstep/crews.hpp"
#include "loadorder/order/lockstep/eras.hpp"
#include "loadorder/order/lockstep/grown.hpp"
#include "loadorder/order/read_order.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t most_items_to_grow = 1000;  // for growing orders item by item

/// The most items of which all pairs are listed for workers that together have room for more than
/// all of them.
constexpr std::uint64_t most_items_of_crowded = 300;

/// An order of G groups of items, with room for some of the groups. The changes of a step are by
/// worker, so that each worker finds its own.
struct GroupedOrder {
  std::uint64_t items = 0;
  std::uint64_t groups = 0;
  std::uint64_t room = 0;  // for groups
  GrownOrder order;

  [[nodiscard]] std::uint64_t largest() const { return ceil_div(items, groups); }

  /// Upper bounds on the span and on the loads of all workers.
  [[nodiscard]] std::pair<std::uint64_t, std::uint64_t> cost(std::uint64_t workers) const {
    return {largest() * (room + order.steps.size()), largest() * (workers * room + order.changes)};
  }
};

/// The steps of one worker in such an order.
class GroupedSteps final : public StepSource {
 public:
  GroupedSteps(std::shared_ptr<const GroupedOrder> order, std::uint64_t worker)
      : order_(std::move(order)), worker_(worker) {}

  bool next(Step& step) override {
    const std::vector<std::vector<LockstepChange>>& steps = order_->order.steps;
    if (number_ > steps.size()) {
      return false;
    }
    step.evict.clear();
    step.load.clear();
    if (number_ == 0) {
      for (std::uint64_t i = 0; i < order_->room; ++i) {
        put(worker_ * order_->room + i, step.load);
      }
    } else {
      const auto& changes = steps[static_cast<std::size_t>(number_ - 1)];
      const auto change = std::ranges::lower_bound(changes, worker_, {}, &LockstepChange::worker);
      if (change != changes.end() && change->worker == worker_) {
        put(change->out, step.evict);
        put(change->in, step.load);
      }
    }
    step.number = ++number_;
    return true;
  }

 private:
  void put(std::uint64_t group, std::vector<Element>& into) const {
    const std::uint64_t end = (group + 1) * order_->items / order_->groups;
    for (std::uint64_t x = group * order_->items / order_->groups; x < end; ++x) {
      into.push_back(static_cast<Element>(x));
    }
  }

  std::shared_ptr<const GroupedOrder> order_;
  std::uint64_t worker_;
  std::uint64_t number_ = 0;
};

/// Grows orders and keeps the best one.
class Garden {
 public:
  Garden(std::uint64_t items, std::uint64_t room, std::uint64_t workers, std::uint64_t seed)
      : items_(items), room_(room), workers_(workers), random_(seed) {}

  void sow() {
    for (std::size_t rule = 0; rule < growth_rules; ++rule) {
      stop_if_asked();
      grow(0, growth_rule(rule));
    }
  }

  /// Cuts the best order and grows it again, mostly in its last third, which is the least efficient
  /// part.
  void cut_and_grow(std::uint64_t times) {
    for (std::uint64_t i = 0; i < times && best_ && !best_->steps.empty(); ++i) {
      stop_if_asked();
      const auto steps = static_cast<std::uint32_t>(best_->steps.size());
      const std::uint32_t keep =
          random_.one_in_two() ? random_.below(steps) : steps - 1 - random_.below(steps / 3 + 1);
      grow(keep, growth_rule(random_.below(growth_rules)));
    }
  }

  [[nodiscard]] const std::optional<GrownOrder>& best() const { return best_; }

 private:
  void grow(std::size_t keep, GrowthRule rule) {
    const std::uint64_t most_steps = best_ ? best_->steps.size() : 4 * items_ * items_;
    auto grown = grow_order(items_, room_, workers_, best_ ? *best_ : GrownOrder(), keep, rule,
                            most_steps, random_);
    // An order that is equally good may lead to a better one.
    if (grown && (!best_ || !best_->better_than(*grown))) {
      best_ = std::move(grown);
    }
  }

  std::uint64_t items_, room_, workers_;
  Random random_;
  std::optional<GrownOrder> best_;
};

// Cuts and grows, for about `work` additions of bytes.
void tend(Garden& garden, std::uint64_t items, std::uint64_t room, std::uint64_t work) {
  garden.sow();
  const std::uint64_t one = items * items / room * (items + 10 * room) + 1000;
  garden.cut_and_grow(std::min<std::uint64_t>(work / one, 3000));
}

// If few items are outside the memories, groups that move together are better than single items.
void consider_groups(std::optional<GroupedOrder>& best, const LoadOrderFacts& facts,
                     std::uint64_t seed) {
  constexpr std::uint64_t most_room = 8;
  constexpr std::uint64_t most_groups = 120;
  constexpr std::uint64_t work = 20'000'000;
  const auto consider = [&](GroupedOrder order) {
    if (!best || order.cost(facts.lockstep) < best->cost(facts.lockstep)) {
      best = std::move(order);
    }
  };
  if (const std::uint64_t groups = 2 * facts.lockstep;
      ceil_div(facts.items, groups) <= facts.room / 2) {
    consider({facts.items, groups, 2, round_robin_order(facts.lockstep)});
  }
  for (std::uint64_t room = 2; room <= std::min(most_room, facts.room / 2); ++room) {
    const std::uint64_t groups = ceil_div(facts.items, facts.room / room);
    if (groups <= most_groups && groups >= room * facts.lockstep) {
      Garden garden(groups, room, facts.lockstep, seed);
      tend(garden, groups, room, work);
      if (garden.best()) {
        consider({facts.items, groups, room, *garden.best()});
      }
    }
  }
}

std::optional<GroupedOrder> grown_order(const LoadOrderFacts& facts,
                                        const LoadOrderOptions& options) {
  std::optional<GroupedOrder> best;
  if (facts.items <= most_items_to_grow) {
    constexpr std::uint64_t work = 400'000'000;
    Garden garden(facts.items, facts.room, facts.lockstep, options.seed);
    tend(garden, facts.items, facts.room, work);
    if (options.search_pairs) {
      options.search_pairs([&garden] {
        try {
          do {
            garden.cut_and_grow(16);
          } while (RunScope::current() != nullptr);
        } catch (const Stopped&) {
          // The best order so far is used.
        }
      });
    }
    if (garden.best()) {
      best = {facts.items, facts.items, facts.room, *garden.best()};
    }
  }
  consider_groups(best, facts, options.seed);
  return best;
}

// The order of one worker.
WorkerMaker steps_of_one(LoadOrderFacts& facts, const LoadOrderOptions& options) {
  const auto order = std::make_shared<const LoadOrder>(
      plan_load_order(facts.wanted.among(facts.items), facts.room, options));
  facts.method = order->facts().method;
  facts.explanation = order->facts().explanation;
  return [order](std::uint64_t) { return order->stream(); };
}

// Orders of all pairs for workers that together have room for no more than all items. Describes the
// order in `facts`.
WorkerMaker steps_of_all(LoadOrderFacts& facts, const LoadOrderOptions& options) {
  if (facts.lockstep == 1) {
    return steps_of_one(facts, options);
  }
  const EraShape shape = best_eras(facts.items, facts.room, facts.lockstep);
  const EraCost eras = cost_of_eras(shape);
  std::optional<GroupedOrder> grown = grown_order(facts, options);
  if (!grown || std::pair(eras.span, eras.loads) < grown->cost(facts.lockstep)) {
    facts.method = "eras";
    facts.explanation = fmt::format(
        "{} groups of at most {}: one stays at each worker while the others pass in turn.",
        shape.groups, count_of(ceil_div(shape.items, shape.groups), "item"));
    return [shape](std::uint64_t worker) { return era_steps(shape, worker); };
  }
  if (grown->groups == 2 * facts.lockstep && grown->room == 2) {
    facts.method = "round robin";
    facts.explanation = fmt::format(
        "{} groups, two at each worker, which keeps one and takes the other from another worker.",
        grown->groups);
  } else {
    facts.method = "grown";
    facts.explanation = fmt::format(
        "In each step the changes of one {}, or the exchanges between two workers, that bring most "
        "new pairs together.",
        grown->groups == facts.items
            ? std::string("item")
            : fmt::format("of {} groups of at most {} items", grown->groups, grown->largest()));
  }
  for (std::vector<LockstepChange>& step : grown->order.steps) {
    std::ranges::sort(step, {}, &LockstepChange::worker);
  }
  const auto order = std::make_shared<const GroupedOrder>(std::move(*grown));
  return [order](std::uint64_t worker) { return std::make_unique<GroupedSteps>(order, worker); };
}

using Cost = std::pair<std::uint64_t, std::uint64_t>;  // span, loads

/// Orders of all pairs, of which some workers may have no part.
class CrewOrders {
 public:
  explicit CrewOrders(const LoadOrderFacts& facts) {
    for (const Crew& crew : crews(facts.items, facts.room, facts.lockstep)) {
      LoadOrderFacts its = facts_before(facts.items, crew.room);
      its.lockstep = crew.workers;
      its.makespan_bound = makespan_lower_bound(facts.items, crew.room, crew.workers);
      all_.push_back(std::move(its));
    }
    // What may be best comes first: then the others are left out unseen.
    std::ranges::stable_sort(all_, {}, least);
  }

  [[nodiscard]] bool are_several() const { return all_.size() > 1; }

  /// Calls visit() for the orders of crews that may be better than the best one, which it returns.
  void each(Cost best, const LoadOrderOptions& options,
            const std::function<Cost(const LoadOrderFacts&, const WorkerMaker&)>& visit) const {
    for (LoadOrderFacts facts : all_) {
      if (least(facts) < best) {
        const WorkerMaker steps = steps_of_all(facts, options);
        best = std::min(best, visit(facts, steps));
      }
    }
  }

 private:
  static Cost least(const LoadOrderFacts& facts) {
    return {facts.makespan_bound.loads, facts.bound.loads};
  }

  std::vector<LoadOrderFacts> all_;
};

// An order for all pairs is good if most pairs are listed.
void consider_all_pairs(LoadOrderFacts& facts, const PairGraph& graph, LockstepLists& best,
                        const LoadOrderOptions& options) {
  if (2 * graph.pairs() < binomial(facts.items, 2) || facts.items > max_elements_in_memory) {
    return;
  }
  const auto consider = [&](const LoadOrderFacts& all, const WorkerMaker& steps) {
    const std::uint64_t busy = all.lockstep;
    LockstepLists lists = lists_of(events_of(*in_lockstep(steps, busy), busy), &graph);
    if (Cost(lists.span, lists.loads) < Cost(best.span, best.loads)) {
      best = std::move(lists);
      facts.method = all.method;
      facts.explanation =
          "An order for all pairs. " + say_idle(busy, facts.lockstep) + all.explanation;
    }
    return Cost(best.span, best.loads);
  };
  const CrewOrders orders(facts);
  orders.each({best.span, orders.are_several() ? best.loads : 0}, fixed_work(options), consider);
}

// Orders for disjoint workers of some pairs only.
WorkerMaker listed_steps(LoadOrderFacts& facts, const LoadOrderOptions& options) {
  const WantedPairs list = as_list(facts.wanted.among(facts.items));
  LockstepLists found = lockstep_of_list(facts, *list.graph(), options);
  consider_all_pairs(facts, *list.graph(), found, options);
  return steps_in(found);
}

/// What the steps of workers come to.
struct Played {
  Cost cost;
  std::uint64_t steps = 0;  // of each worker
};

Played played(const WorkerMaker& maker, std::uint64_t workers) {
  Played all;
  std::size_t slowest = 0;
  const auto steps = in_lockstep(maker, workers);
  for (Step step; steps->next(step);) {
    slowest = std::max(slowest, step.load.size());
    all.cost.second += step.load.size();
    if (step.worker + 1 == workers) {
      stop_if_asked();
      all.cost.first += std::exchange(slowest, 0);
      ++all.steps;
    }
  }
  return all;
}

// Orders of all pairs of many items, for workers that together have room for more than all of them.
WorkerMaker crowded_steps(LoadOrderFacts& facts, const LoadOrderOptions& options) {
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  LoadOrderFacts best;
  Cost cost(most, most);
  WorkerMaker steps;
  const auto consider = [&](const LoadOrderFacts& crew, const WorkerMaker& its) {
    if (const Cost its_cost = played(its, crew.lockstep).cost; its_cost < cost) {
      best = crew;
      cost = its_cost;
      steps = its;
    }
    return cost;
  };
  CrewOrders(facts).each(cost, fixed_work(options), consider);
  if (options.search_pairs || options.improve) {  // goes on from the best
    steps = steps_of_all(best, options);
  }
  facts.method = best.method;
  facts.explanation = fmt::format(
      "{}A worker uses room for {}, since all of them have room for more than {} items. {}",
      say_idle(best.lockstep, facts.lockstep), best.room, facts.items, best.explanation);
  const std::uint64_t count = played(steps, best.lockstep).steps;
  return with_idle(std::move(steps), best.lockstep, count);
}

// Describes the order in `facts`.
WorkerMaker best_steps(LoadOrderFacts& facts, const LoadOrderOptions& options) {
  if (facts.lockstep == 1) {
    return steps_of_one(facts, options);
  }
  const bool crowded = facts.items / facts.lockstep < facts.room;
  if (!facts.wanted.are_all() || (crowded && facts.items <= most_items_of_crowded)) {
    return listed_steps(facts, options);
  }
  return crowded ? crowded_steps(facts, options) : steps_of_all(facts, options);
}

}  // namespace

void check_disjoint(const WantedPairs& wanted) {
  if (wanted.graph() == nullptr && wanted.items() > max_elements_in_memory) {
    throw ImpossibleParameters(
        fmt::format("{} items: disjoint workers have at most {}; group items into larger ones",
                    wanted.items(), max_elements_in_memory));
  }
}

LoadOrder plan_disjoint_order(const WantedPairs& wanted, std::uint64_t room, std::uint64_t workers,
                              const LoadOrderOptions& options) {
  LoadOrderFacts facts = facts_before(wanted, room);
  facts.lockstep = workers;
  facts.makespan_bound = makespan_lower_bound(wanted, room, workers);
  check_disjoint(wanted);
  const WorkerMaker worker = best_steps(facts, options);
  LoadOrder::Maker maker = [worker, workers] { return in_lockstep(worker, workers); };
  const std::string memory = fmt::format("for {} workers with room for {}", workers, room);
  return read_in_full(std::move(facts), std::move(maker), memory, [&](const auto& verdict) {
    return "every step read: no item held twice at once, " + pairs_read(verdict, wanted.count());
  });
}

}  // namespace changeover
