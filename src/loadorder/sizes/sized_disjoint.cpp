// Workers that never hold one item twice, for items of different sizes.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

#include "changeover/loadorder/workers.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "loadorder/listed/lockstep_events.hpp"
#include "loadorder/listed/quick_moves.hpp"
#include "loadorder/listed/stretches_in_lockstep.hpp"
#include "loadorder/order/in_rounds.hpp"
#include "loadorder/order/lockstep/levels.hpp"
#include "loadorder/order/read_order.hpp"
#include "loadorder/sizes/item_groups.hpp"
#include "loadorder/sizes/sized_pairs.hpp"

namespace changeover {
namespace {

struct Best {
  LockstepLists lists;  // span and loads in bytes
  std::string method;
  std::string explanation;
  // At two levels: the bytes of both, each divided by its bound.
  std::function<double(const LockstepLists&)> cost_of = {};
  double cost = 0;

  [[nodiscard]] bool better_than(const Best& other) const {
    return std::tuple(cost, lists.span, lists.loads) <
           std::tuple(other.cost, other.lists.span, other.lists.loads);
  }

  void consider(LockstepLists others, std::string its_method, std::string its_explanation) {
    const double its_cost = cost_of ? cost_of(others) : 0;
    if (lists.lists == nullptr || std::tuple(its_cost, others.span, others.loads) <
                                      std::tuple(cost, lists.span, lists.loads)) {
      lists = std::move(others);
      cost = its_cost;
      method = std::move(its_method);
      explanation = std::move(its_explanation);
    }
  }
};

/// The ways to plan one job.
class Ways {
 public:
  Ways(const ItemSizes& sizes, std::vector<Element> items, std::uint64_t workers,
       const PairGraph* graph, Best& best)
      : sizes_(sizes), items_(std::move(items)), workers_(workers), graph_(graph), best_(best) {
    largest_ = largest_of(items_, [&](const Element x) { return sizes.bytes[x]; });
  }

  /// For all pairs: groups of even bytes.
  void groups_of_all() {
    for (const std::uint64_t room : rooms()) {
      const Groups groups =
          groups_of_at_most(sizes_, items_, sizes_.memory / room, room * workers_);
      if (!groups.empty()) {
        follow(plan_disjoint_order(groups.size(), room, workers_), groups);
      }
    }
  }

  /// For some pairs: groups of items that an order of one worker has next to each other.
  void groups_of(const LoadOrder& one) {
    const std::vector<Element> items = items_as_they_come(moves_of(*one.stream()));
    for (const std::uint64_t room : rooms()) {
      const Groups groups = cut_into_groups(sizes_, items, sizes_.memory / room);
      follow(plan_disjoint_order(between_groups(groups, *graph_), room, workers_), groups);
    }
  }

  /// Where so many workers would above all wait for each other, some of them are idle: one that has
  /// all of the order waits for none.
  void stretches_of(const LoadOrder& one) {
    const StretchesInLockstep stretches(*graph_, moves_of(*one.stream()));
    bool is_better = true;
    for (std::uint64_t busy = workers_; busy > 0 && is_better; busy /= 2) {
      const Best before = best_;
      play(stretches, stretches.even_cut(busy), one);
      is_better = best_.lists.lists == nullptr || before.lists.lists == nullptr ||
                  best_.better_than(before);
    }
  }

 private:
  void play(const StretchesInLockstep& stretches, const std::vector<std::size_t>& begins,
            const LoadOrder& one) {
    stretches.play_each(begins, 4 * (one.facts().loads + 1), [&](LockstepEvents events) {
      best_.consider(lists_of(std::move(events), graph_, &sizes_), "stretches",
                     fmt::format("An order of one worker is cut into {}. A worker waits for an "
                                 "item that another one holds and needs soon.",
                                 count_of(begins.size(), "stretch", "stretches")));
    });
  }

  // How many groups are at a worker at once; the last one has room for any items.
  [[nodiscard]] std::vector<std::uint64_t> rooms() const {
    const std::uint64_t most = sizes_.memory / largest_;
    std::vector<std::uint64_t> all;
    for (const std::uint64_t room : {2U, 3U, 4U, 6U, 8U, 12U, 16U}) {
      if (room < most) {
        all.push_back(room);
      }
    }
    if (most >= 2) {
      all.push_back(most);
    }
    return all;
  }

  void follow(const LoadOrder& order, const Groups& groups) {
    if (best_.lists.lists != nullptr && must_hurry()) {
      return;
    }
    best_.consider(lists_of(events_of(*order.stream(), workers_, groups), graph_, &sizes_),
                   "groups, " + order.facts().method,
                   fmt::format("Items are in {} of at most {} bytes, of which {} fit: {}",
                               count_of(groups.size(), "group"), largest_of(sizes_, groups),
                               order.facts().room, order.facts().explanation));
  }

  const ItemSizes& sizes_;
  std::vector<Element> items_;
  std::uint64_t workers_;
  const PairGraph* graph_;  // none of all pairs of many items
  Best& best_;
  std::uint64_t largest_ = 1;
};

using CostOf = std::function<double(const LockstepLists&)>;

Best best_once(const std::shared_ptr<const ItemSizes>& sizes, const WantedPairs& wanted,
               std::uint64_t workers, const LoadOrderOptions& options, CostOf cost_of) {
  const std::uint64_t items = sizes->bytes.size();
  const WantedPairs list =
      wanted.are_all() && items > most_closed_all ? wanted : as_list(wanted.among(items));
  const PairGraph* const graph = list.graph();
  Best best;
  const bool is_level = cost_of == nullptr;
  best.cost_of = std::move(cost_of);
  Ways ways(*sizes, needed_among(wanted, items), workers, graph, best);
  // One worker has its own order, at one level.
  const bool shares = workers > 1 || graph == nullptr || !is_level;
  if (shares && (wanted.are_all() || 2 * graph->pairs() >= binomial(items, 2))) {
    ways.groups_of_all();
  }
  if (graph != nullptr) {
    const LoadOrder one = plan_sized_order(sizes, wanted, options);
    ways.stretches_of(one);
    if (shares && !wanted.are_all()) {
      ways.groups_of(one);
    }
  }
  return best;
}

Best best_of(const std::shared_ptr<const ItemSizes>& sizes, const WantedPairs& wanted,
             std::uint64_t workers, const LoadOrderOptions& options, const CostOf& cost_of = {}) {
  return best_in_rounds(
      options,
      [&](const LoadOrderOptions& its) { return best_once(sizes, wanted, workers, its, cost_of); },
      [](const Best& its, const Best& others) { return its.better_than(others); });
}

// What is known before there is an order.
LoadOrderFacts facts_before(std::shared_ptr<const ItemSizes> sizes, const WantedPairs& wanted,
                            std::uint64_t workers) {
  LoadOrderFacts facts = facts_before(std::move(sizes), wanted);
  facts.makespan_byte_bound = sized_makespan_bound(*facts.sizes, wanted, workers);
  facts.lockstep = workers;
  facts.makespan_bound = makespan_lower_bound(wanted.among(facts.items), facts.room, workers);
  return facts;
}

// The order that `maker` makes, once it has been read.
LoadOrder read_disjoint(LoadOrderFacts facts, const LoadOrder::Maker& maker) {
  const std::string memory =
      fmt::format("for {} workers with {} bytes of memory", facts.lockstep, facts.sizes->memory);
  const std::uint64_t pairs = facts.wanted.among(facts.items).count();
  const bool levels = facts.fast_room.has_value();
  return read_in_full(std::move(facts), maker, memory, [&](const ScheduleVerdict& verdict) {
    return levels ? "no item held twice at once, " + levels_read(verdict, pairs, true)
                  : fmt::format(
                        "every step read: no item held twice at once, {}, at most {} bytes at a "
                        "worker",
                        pairs_read(verdict, pairs), verdict.most_bytes);
  });
}

}  // namespace

LoadOrder plan_disjoint_order(std::shared_ptr<const ItemSizes> sizes, const WantedPairs& wanted,
                              std::uint64_t workers, const LoadOrderOptions& options) {
  LoadOrderFacts facts = facts_before(std::move(sizes), wanted, workers);
  const Best best = best_of(facts.sizes, wanted, workers, options);
  if (best.lists.lists == nullptr) {
    refuse_large_items(facts.items);
  }
  facts.method = best.method;
  facts.explanation = best.explanation;
  const LockstepLists lists = best.lists;
  return read_disjoint(std::move(facts),
                       [lists, workers] { return in_lockstep(steps_in(lists), workers); });
}

LoadOrder plan_disjoint_levels(std::shared_ptr<const ItemSizes> sizes, const WantedPairs& wanted,
                               std::uint64_t workers, const LoadOrderOptions& options) {
  const ItemSizes fast{sizes->bytes, sizes->fast_memory};
  LoadOrderFacts facts = with_levels(facts_before(sizes, wanted, workers), fast);
  const std::uint64_t least_transfers = sized_makespan_bound(fast, wanted, workers).loads;
  const LevelShape shape{wanted.among(facts.items), facts.room, *facts.fast_room, 1, sizes};
  const auto both_levels = [shape, workers](const LockstepLists& lists) {
    return levels_in_lockstep(shape, in_lockstep(steps_in(lists), workers), workers, nullptr);
  };
  const Best best = best_of(sizes, wanted, workers, options, [&](const LockstepLists& lists) {
    return spans_of(*both_levels(lists), workers, sizes.get())
        .over(facts.makespan_byte_bound.loads, least_transfers);
  });
  if (best.lists.lists == nullptr) {
    refuse_large_items(facts.items);
  }
  facts.method = best.method;
  facts.explanation = "What items meet is done at once. " + best.explanation;
  // Made once: each part of it is a separate order.
  std::vector<std::vector<Move>> moves(static_cast<std::size_t>(workers));
  const auto all = both_levels(best.lists);
  for (Step step; all->next(step);) {
    moves[static_cast<std::size_t>(step.worker)].push_back(
        {step.evict, step.load, step.fast_evict, step.fast_load});
  }
  const auto steps = std::make_shared<StepLists>();
  for (const std::vector<Move>& its : moves) {
    steps->add(its);
  }
  return read_disjoint(std::move(facts), [steps, workers] {
    return in_lockstep([&](std::uint64_t worker) { return steps->of(worker); }, workers);
  });
}

}  // namespace changeover
