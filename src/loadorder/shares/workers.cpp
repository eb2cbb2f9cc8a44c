// The best split that is known.
#include <algorithm>
#include <utility>

#include "bounds/counting_bound.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/loadorder/workers.hpp"
#include "core/checked.hpp"
#include "loadorder/listed/listed_levels.hpp"
#include "loadorder/listed/quick_moves.hpp"
#include "loadorder/pairs/held/held_blocks.hpp"
#include "loadorder/shares/few_workers.hpp"
#include "loadorder/shares/known_shares.hpp"
#include "loadorder/shares/owners/pair_table.hpp"
#include "loadorder/shares/split_maker.hpp"

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

// Of all pairs: stretches of an order of items or groups, or shares.
WorkerSplit split_all_pairs(std::uint64_t items, std::uint64_t room, std::uint64_t workers,
                            const LoadOrderOptions& options) {
  LoadOrder order = plan_load_order(items, room, unread(options, workers));
  if (workers > 1) {
    order = order_to_cut(std::move(order), items, room, workers, options);
  }
  // Of fewer items pairs are given away one by one, and need no uneven loads.
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

// Of some: stretches, blocks of two sets, or what is left of a split of all pairs.
WorkerSplit split_some_pairs(const WantedPairs& wanted, std::uint64_t room, std::uint64_t workers,
                             const LoadOrderOptions& options) {
  std::vector<WorkerSplit> candidates;
  candidates.push_back(split_order(plan_load_order(wanted, room, unread(options, workers)),
                                   wanted.items(), room, workers));
  const WorkerSplit& stretches = candidates.front();
  const LoadBound bound = stretches.order().facts().bound;
  const LoadBound makespan_bound = stretches.facts().makespan_bound;
  if (wanted.kind() == WantedPairs::Kind::between && workers > 1) {
    auto blocks = best_held_blocks(wanted, room, workers);
    if (blocks && blocks->makespan() < stretches.facts().makespan) {
      candidates.push_back(SplitMaker::blocks(std::move(*blocks), candidates.front()));
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
  const auto less = [&](const WorkerSplit& a, const WorkerSplit& b) {
    return makespan(a) < makespan(b);
  };
  const std::uint64_t least = makespan(*std::ranges::min_element(candidates, less));
  std::erase_if(candidates, [&](const WorkerSplit& split) { return makespan(split) > 2 * least; });
  for (WorkerSplit& split : candidates) {
    SplitMaker::give_pairs(split, options);
  }
  WorkerSplit split = std::move(*std::ranges::min_element(candidates, less));
  SplitMaker::verify(split, options);
  return split;
}

}  // namespace

WorkerSplit split_load_order(const WantedPairs& wanted, std::uint64_t room, std::uint64_t workers,
                             const LoadOrderOptions& options) {
  check_workers(workers);
  return wanted.are_all() ? split_all_pairs(wanted.items(), room, workers, options)
                          : split_some_pairs(wanted, room, workers, options);
}

WorkerSplit split_two_levels(const WantedPairs& wanted, std::uint64_t room, std::uint64_t fast_room,
                             std::uint64_t workers, const LoadOrderOptions& options) {
  check_workers(workers);
  WorkerSplit split = [&] {
    if (wanted.are_all()) {
      WorkerSplit cut =
          split_order(plan_two_levels(wanted, room, fast_room), wanted.items(), room, workers);
      SplitMaker::give_pairs(cut, options);
      return cut;
    }
    check_rooms(room, fast_room);
    return SplitMaker::two_levels(
        split_some_pairs(as_list(wanted), room, workers, unread(options, workers)), fast_room,
        options);
  }();
  SplitMaker::verify(split, options);
  return split;
}

}  // namespace changeover
