// The best split that is known.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "bounds/counting_bound.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/loadorder/workers.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "loadorder/listed/neighbourhoods.hpp"
#include "loadorder/listed/quick_moves.hpp"
#include "loadorder/order/in_rounds.hpp"
#include "loadorder/order/levels/level_cost.hpp"
#include "loadorder/order/read_order.hpp"
#include "loadorder/pairs/held/held_blocks.hpp"
#include "loadorder/shares/few_workers.hpp"
#include "loadorder/shares/groups/known_shares.hpp"
#include "loadorder/shares/owners/pair_table.hpp"
#include "loadorder/shares/split_maker.hpp"
#include "loadorder/sizes/sized_pairs.hpp"

namespace changeover {
namespace {

struct Grouping {
  std::uint64_t groups = 0;
  std::uint64_t room = 0;
  std::uint64_t makespan = 0;
  std::uint64_t loads = 0;

  [[nodiscard]] bool better_than(const Grouping& other) const {
    return std::pair(makespan, loads) < std::pair(other.makespan, other.loads);
  }
};

// An upper bound on the cost of a split of b steps that load `change` groups of at most `size`
// items.
Grouping cost(std::uint64_t groups, std::uint64_t room, std::uint64_t size, std::uint64_t steps,
              std::uint64_t change, std::uint64_t workers) {
  const std::uint64_t busy = std::min(workers, steps);
  return {groups, room, size * (room + change * (ceil_div(steps, workers) - 1)),
          size * (busy * room + change * (steps - busy))};
}

// The order of items or groups of them whose stretches have the smallest makespan.
LoadOrder order_to_cut(LoadOrder order, std::uint64_t items, std::uint64_t room,
                       std::uint64_t workers, const LoadOrderOptions& options) {
  constexpr std::uint64_t most_groups = 40;
  const LoadOrderFacts& facts = order.facts();
  const std::uint64_t first = std::min(room, items);
  const std::uint64_t change = facts.steps > 1 ? (facts.loads - first) / (facts.steps - 1) : 0;
  Grouping best = cost(items, first, 1, facts.steps, change, workers);
  std::optional<LoadOrder> grouped;
  LoadOrderOptions quick = options;
  quick.improve = nullptr;
  quick.closure_rules = false;
  quick.read_first = true;  // reading it takes almost no time
  for (std::uint64_t groups = 2; groups <= std::min(most_groups, items); ++groups) {
    const std::uint64_t size = ceil_div(items, groups);
    for (std::uint64_t r = 2; r <= std::min(room / size, groups - 1); ++r) {
      // No order of these groups has fewer loads than its bound.
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
  return grouped ? std::move(*grouped) : std::move(order);
}

// Options without verification: the shares are verified instead.
LoadOrderOptions unread(LoadOrderOptions options, std::uint64_t workers) {
  options.read_first = options.read_first && workers == 1;
  return options;
}

// The best split of all pairs: stretches of an order of items or groups, or shares.
WorkerSplit split_all_pairs(std::uint64_t items, std::uint64_t room, std::uint64_t workers,
                            const LoadOrderOptions& options) {
  LoadOrder order = plan_load_order(items, room, unread(options, workers));
  if (workers > 1) {
    order = order_to_cut(std::move(order), items, room, workers, options);
  }
  // With fewer items pairs are assigned one by one, which needs no uneven loads.
  const bool even_pairs = options.balance && items > most_items_of_a_table;
  WorkerSplit split = SplitMaker::stretches(std::move(order), items, room, workers, even_pairs);
  if (workers > 1) {
    if (auto shares = best_group_shares(items, room, workers, split.facts().makespan)) {
      split = SplitMaker::shares(std::move(*shares), items, room, workers);
    }
  }
  SplitMaker::give_pairs(split, options);
  if (workers > 1) {  // One worker's order was read.
    SplitMaker::verify(split, options);
  }
  return split;
}

bool has_less_to_load(const WorkerSplit& split, const WorkerSplit& other) {
  return std::pair(split.facts().makespan, split.facts().loads) <
         std::pair(other.facts().makespan, other.facts().loads);
}

// A split of listed pairs: each worker has a part of them with its own order.
std::optional<WorkerSplit> split_by_neighbourhoods(const WorkerSplit& like,
                                                   const LoadOrderOptions& options) {
  const PairGraph& graph = *like.order().facts().wanted.graph();
  const SplitFacts& facts = like.facts();
  const auto parts = neighbourhoods(graph, facts.workers.size(), options.pair_cost);
  if (parts.empty()) {
    return std::nullopt;
  }
  const std::vector<std::vector<Move>> moves =
      each_of<std::vector<Move>>(parts, [&](const std::vector<ItemPair>& pairs) {
        stop_if_asked();
        return pairs.empty() ? std::vector<Move>()
                             : one_step_each(quick_moves(pairs, items_of(pairs), facts.room));
      });
  return SplitMaker::lists(
      like, moves, "neighbourhoods",
      "The pairs are in parts, one for each worker, that grow from item to item: next is the item "
      "that lacks the fewest partners, and what all parts have left over is exchanged.");
}

// The best split of some pairs only: stretches, neighbourhoods of listed pairs, blocks of two sets,
// or the wanted pairs of a split of all pairs.
WorkerSplit split_some_pairs(const WantedPairs& wanted, std::uint64_t room, std::uint64_t workers,
                             const LoadOrderOptions& options) {
  std::vector<WorkerSplit> candidates;
  candidates.push_back(SplitMaker::stretches(
      plan_load_order(wanted, room, unread(options, workers)), wanted.items(), room, workers));
  const WorkerSplit& stretches = candidates.front();
  const LoadBound bound = stretches.order().facts().bound;
  const LoadBound makespan_bound = stretches.facts().makespan_bound;
  if (wanted.kind() == WantedPairs::Kind::between && workers > 1) {
    auto blocks = best_held_blocks(wanted, room, workers);
    if (blocks && blocks->makespan() < stretches.facts().makespan) {
      candidates.push_back(SplitMaker::blocks(std::move(*blocks), candidates.front()));
    }
  }
  if (wanted.graph() != nullptr && workers > 1) {
    if (auto split = split_by_neighbourhoods(candidates.front(), options)) {
      candidates.push_back(std::move(*split));
    }
  }
  if (workers > 1 && wanted.items() <= max_elements_in_memory) {
    // A split for all pairs brings the wanted ones together, too.
    LoadOrderOptions quick = options;
    quick.improve = nullptr;
    quick.pair_cost = nullptr;
    candidates.push_back(SplitMaker::for_fewer_pairs(
        split_all_pairs(wanted.items(), room, workers, unread(quick, workers)), wanted, bound,
        makespan_bound));
  }
  // Leaving out needless loads may make the second best split the best one.
  const auto makespan = [](const WorkerSplit& split) { return split.facts().makespan; };
  const std::uint64_t least = makespan(*std::ranges::min_element(candidates, has_less_to_load));
  std::erase_if(candidates, [&](const WorkerSplit& split) { return makespan(split) > 2 * least; });
  for (WorkerSplit& split : candidates) {
    SplitMaker::give_pairs(split, options);
  }
  WorkerSplit split = std::move(*std::ranges::min_element(candidates, has_less_to_load));
  SplitMaker::verify(split, options);
  return split;
}

constexpr std::uint64_t most_pairs_listed = 1'000'000;  // of two sets, or of new items

// What the busiest worker moves, at each level over the bound of all, and what all of them move.
std::pair<double, double> busiest_cost(const WorkerSplit& split) {
  const LoadOrderFacts& bounds = split.order().facts();
  std::vector<MovedAtLevels> moved(split.facts().workers.size());
  const auto steps = split.stream();
  for (Step step; steps->next(step);) {
    moved[static_cast<std::size_t>(step.worker)].add(step, sizes_in(bounds));
  }
  const auto cost = [&](const MovedAtLevels& its) { return its.over(bounds); };
  return {largest_of<double>(moved, cost), sum_of<double>(moved, cost)};
}

bool is_less_busy(const WorkerSplit& split, const WorkerSplit& other) {
  return busiest_cost(split) < busiest_cost(other);
}

WorkerSplit best_of_two_levels(std::vector<WorkerSplit> candidates,
                               const LoadOrderOptions& options) {
  const auto costs = each_of<std::pair<double, double>>(candidates, [&](const WorkerSplit& split) {
    return candidates.size() > 1 ? busiest_cost(split) : std::pair(0.0, 0.0);
  });
  WorkerSplit split = std::move(
      candidates[static_cast<std::size_t>(std::ranges::min_element(costs) - costs.begin())]);
  SplitMaker::verify(split, options);
  return split;
}

// Each worker has a part of one set with a part of the other, and an order of two levels for these.
std::optional<WorkerSplit> blocks_of_two_levels(const WorkerSplit& like, std::uint64_t fast_room,
                                                const LoadOrderOptions& options) {
  const std::uint64_t room = like.facts().room;
  // Beside what stays in memory there is a group for the accelerator.
  const auto blocks = best_held_blocks(like.order().facts().wanted, room - fast_room + 2,
                                       like.facts().workers.size());
  if (!blocks) {
    return std::nullopt;
  }
  std::map<std::pair<std::uint64_t, std::uint64_t>, LoadOrder> orders;
  std::vector<std::vector<Move>> moves;
  for (const auto& [some, others] : blocks->parts) {
    const auto sizes = std::pair(some.size(), others.size());
    auto found = orders.find(sizes);
    if (found == orders.end()) {
      const auto pairs = WantedPairs::between(sizes.first, sizes.second);
      found = orders.emplace(sizes, plan_two_levels(pairs, room, fast_room, options)).first;
    }
    moves.push_back(moves_of(*found->second.stream()));
    std::vector<Element> names;
    for (const ItemRange& range : {some, others}) {
      for (std::uint64_t x = range.first; x < range.end; ++x) {
        names.push_back(static_cast<Element>(x));
      }
    }
    give_names(moves.back(), names);
  }
  WorkerSplit split = SplitMaker::lists(
      like, moves, "two levels, a block a worker",
      fmt::format("{} of the first set with {} of the other, a pair of parts a worker; the first: "
                  "{}",
                  count_of(blocks->first_parts, "part"), count_of(blocks->other_parts, "part"),
                  orders.begin()->second.facts().explanation));
  SplitMaker::give_pairs(split, options);
  return split;
}

WorkerSplit sized_levels_once(const std::shared_ptr<const ItemSizes>& sizes,
                              const WantedPairs& wanted, std::uint64_t workers,
                              const LoadOrderOptions& options) {
  const std::uint64_t items = sizes->bytes.size();
  LoadOrder order = plan_two_levels(sizes, wanted, options);
  const std::uint64_t room = order.facts().room;
  std::vector<WorkerSplit> candidates;
  candidates.push_back(SplitMaker::stretches(std::move(order), items, room, workers));
  SplitMaker::give_pairs(candidates.back(), options);
  // Workers with orders of their own take a second or so each.
  constexpr std::uint64_t most_own_pairs = 2'000'000;
  constexpr std::uint64_t most_own_workers = 16;
  const std::uint64_t pairs = wanted.among(items).count();
  if (workers > 1 && workers <= most_own_workers && pairs > 0 && pairs <= most_own_pairs) {
    LoadOrderOptions quick = options;
    quick.search_pairs = nullptr;  // the time was for the order that is cut
    const LoadOrderFacts levels = candidates.front().order().facts();
    candidates.push_back(SplitMaker::two_levels(
        split_sized_order(levels.sizes, wanted, workers, quick), levels, quick));
  }
  return best_of_two_levels(std::move(candidates), options);
}

WorkerSplit levels_once(const WantedPairs& wanted, std::uint64_t room, std::uint64_t fast_room,
                        std::uint64_t workers, const LoadOrderOptions& options) {
  const LoadOrderFacts levels = facts_before(wanted, room, fast_room);
  std::vector<WorkerSplit> candidates;
  if (wanted.graph() == nullptr) {
    candidates.push_back(SplitMaker::stretches(plan_two_levels(wanted, room, fast_room, options),
                                               wanted.items(), room, workers));
    SplitMaker::give_pairs(candidates.back(), options);
  }
  if (workers > 1 && wanted.kind() == WantedPairs::Kind::between) {
    if (auto blocks = blocks_of_two_levels(candidates.front(), fast_room, options)) {
      candidates.push_back(std::move(*blocks));
    }
  }
  if (!wanted.are_all() && (workers > 1 || candidates.empty()) &&
      (wanted.graph() != nullptr || wanted.count() <= most_pairs_listed)) {
    candidates.push_back(SplitMaker::two_levels(
        split_some_pairs(wanted, room, workers, unread(options, workers)), levels, options));
  }
  return best_of_two_levels(std::move(candidates), options);
}

}  // namespace

WorkerSplit split_load_order(const WantedPairs& wanted, std::uint64_t room, std::uint64_t workers,
                             const LoadOrderOptions& options) {
  check_workers(workers);
  const auto split = [&](const LoadOrderOptions& its) {
    return wanted.are_all() ? split_all_pairs(wanted.items(), room, workers, its)
                            : split_some_pairs(wanted, room, workers, its);
  };
  return workers == 1 ? split(options) : best_in_rounds(options, split, has_less_to_load);
}

WorkerSplit split_two_levels(std::shared_ptr<const ItemSizes> sizes, const WantedPairs& wanted,
                             std::uint64_t workers, const LoadOrderOptions& options) {
  check_workers(workers);
  const auto split = [&](const LoadOrderOptions& its) {
    return sized_levels_once(sizes, wanted, workers, its);
  };
  return best_in_rounds(options, split, is_less_busy);
}

WorkerSplit split_two_levels(const WantedPairs& wanted, std::uint64_t room, std::uint64_t fast_room,
                             std::uint64_t workers, const LoadOrderOptions& options) {
  check_workers(workers);
  const auto split = [&](const LoadOrderOptions& its) {
    return levels_once(wanted, room, fast_room, workers, its);
  };
  return best_in_rounds(options, split, is_less_busy);
}

}  // namespace changeover
