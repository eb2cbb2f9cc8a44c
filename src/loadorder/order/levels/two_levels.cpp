#include "changeover/loadorder/load_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "loadorder/listed/level_search.hpp"
#include "loadorder/listed/listed_levels.hpp"
#include "loadorder/listed/quick_moves.hpp"
#include "loadorder/order/in_rounds.hpp"
#include "loadorder/order/levels/group_levels.hpp"
#include "loadorder/order/levels/level_cost.hpp"
#include "loadorder/order/read_order.hpp"
#include "loadorder/shares/step_lists.hpp"
#include "loadorder/sizes/sized_pairs.hpp"

namespace changeover {
namespace {

/// Loads groups by an order of groups; after each load computes the new pairs on the accelerator.
class Steps final : public StepSource {
 public:
  Steps(const LevelShape& shape, std::unique_ptr<StepSource> groups,
        std::shared_ptr<InnerOrders> inner_orders)
      : assigner_(shape.groups(), shape.group_room(), shape.wanted_groups()),
        worker_(shape, std::move(inner_orders)) {
    assigner_.start(std::move(groups));
  }

  bool next(Step& step) override {
    while (!worker_.next(step)) {
      if (!assigner_.next(groups_)) {
        return false;
      }
      worker_.take(groups_);
    }
    step.number = ++number_;
    return true;
  }

 private:
  PairAssigner assigner_;
  AssignedStep groups_;
  LevelWorker worker_;
  std::uint64_t number_ = 0;
};

/// The order for groups of a given size.
LoadOrder::Maker with_groups(const LevelShape& shape) {
  LoadOrderOptions quick;
  quick.closure_rules = false;
  const auto groups = std::make_shared<const LoadOrder>(
      plan_load_order(shape.wanted_groups(), shape.group_room(), quick));
  const auto inner = std::make_shared<InnerOrders>(shape.fast_room);
  return [shape, groups, inner]() -> std::unique_ptr<StepSource> {
    return std::make_unique<Steps>(shape, groups->stream(), inner);
  };
}

struct LevelOrder {
  std::uint64_t group_items = 0;  // 0 if items are not grouped
  LoadOrder::Maker maker;
  std::string explanation;
};

// The first of the cheapest offers; loads and transfers are each divided by their lower bounds.
LevelOrder best_of(std::vector<LevelOrder> offers, const LoadOrderFacts& bounds) {
  const auto cost = [&](const LevelOrder& offer) { return cost_of(*offer.maker(), bounds, {}); };
  std::size_t best = 0;
  double least = offers.size() == 1 ? 0 : cost(offers[0]);
  for (std::size_t i = 1; i < offers.size() && !must_hurry(); ++i) {
    if (const double its = cost(offers[i]); its < least) {
      best = i;
      least = its;
    }
  }
  return std::move(offers[best]);
}

// An order of items, whose moves are kept in memory.
LevelOrder without_groups(const LoadOrderFacts& facts, const WantedPairs& wanted,
                          const LoadOrderOptions& options) {
  if (wanted.are_all()) {
    const LoadOrder alone = plan_load_order(wanted, *facts.fast_room);
    return {0, in_memory(with_a_cache(moves_of(*alone.stream()), facts.room)),
            std::string(by_a_cache)};
  }
  LoadOrderFacts listed = facts;
  LoadOrder::Maker maker = listed_levels(listed, options);
  return {0, std::move(maker), std::move(listed.explanation)};
}

// The first start alone, which nothing stops.
LevelOrder in_a_hurry(const LoadOrderFacts& facts, const PairGraph& graph) {
  RunControl unlimited({});
  const RunScope scope(unlimited);
  return {0, in_memory(levels_of(graph, facts, quick_moves(graph, *facts.fast_room), 0)),
          std::string(by_a_cache)};
}

// What a search finds from there on, of pairs that are few enough to be listed.
void improve(LevelOrder& best, const LoadOrderFacts& facts, const WantedPairs& wanted,
             std::uint64_t seed, RunControl& control) {
  if (wanted.count() > most_pairs_searched) {
    return;
  }
  const WantedPairs list = as_list(wanted);
  const std::vector<Move> start = moves_of(*best.maker());
  const std::vector<Move> found =
      search_levels(*list.graph(), facts, start, seed, [&] { return control.stop_wanted(); });
  if (!found.empty()) {
    best = {0, in_memory(found),
            "Searched: what an item lacks on the accelerator is brought there while it stays; the "
            "sequence of the items is changed as long as both levels together move less."};
  }
}

// The best order of groups or of items, without a search.
LevelOrder fixed_levels(const LoadOrderFacts& facts, const WantedPairs& wanted,
                        const LoadOrderOptions& options) {
  const std::uint64_t room = facts.room;
  const std::uint64_t fast_room = *facts.fast_room;
  // Limits the time to some seconds.
  constexpr std::uint64_t most_work = 30'000'000;
  const std::uint64_t most_tried =
      std::max<std::uint64_t>(1, most_work / (4 * (wanted.count() + facts.items)));
  std::vector<LevelOrder> offers;
  for (const std::uint64_t size : sizes_to_try(facts.items, room, fast_room)) {
    const LevelShape shape{wanted, room, fast_room, size};
    if (offers.size() >= most_tried || wanted.graph() != nullptr || !done(!offers.empty(), [&] {
          offers.push_back({size, with_groups(shape), shape.explain()});
        })) {
      break;
    }
  }
  constexpr std::uint64_t most_kept = 100'000;      // transfers
  constexpr std::uint64_t most_listed = 1'000'000;  // of two sets, or of new items
  if (wanted.graph() != nullptr || (facts.transfer_bound.loads <= most_kept &&
                                    (wanted.are_all() || wanted.count() <= most_listed))) {
    const bool has_one = !offers.empty() || wanted.graph() != nullptr;
    if (!done(has_one,
              [&] { offers.push_back(without_groups(facts, wanted, fixed_work(options))); }) &&
        offers.empty()) {
      offers.push_back(in_a_hurry(facts, *wanted.graph()));
    }
  }
  return best_of(std::move(offers), facts);
}

// Describes the order in `facts`.
LoadOrder::Maker best_levels(LoadOrderFacts& facts, const LoadOrderOptions& options) {
  const WantedPairs wanted = facts.wanted.among(facts.items);
  LevelOrder best;
  fixed_first(
      options, [&] { best = fixed_levels(facts, wanted, options); },
      [&](RunControl& control) { improve(best, facts, wanted, options.seed, control); });
  facts.group_items = best.group_items;
  facts.explanation = std::move(best.explanation);
  return std::move(best.maker);
}

}  // namespace

LoadOrder plan_two_levels(const WantedPairs& wanted, std::uint64_t room, std::uint64_t fast_room,
                          const LoadOrderOptions& options) {
  const std::uint64_t items = wanted.items();
  LoadOrderFacts facts = facts_before(wanted, room, fast_room);
  if (wanted.graph() == nullptr && items > max_elements_in_memory) {
    throw ImpossibleParameters(
        fmt::format("{} items: two levels have at most {}; group items into larger ones", items,
                    max_elements_in_memory));
  }
  LoadOrder::Maker maker = best_levels(facts, options);
  return read_in_full(
      std::move(facts), std::move(maker), fmt::format("with room for {} and {}", room, fast_room),
      [&](const auto& verdict) { return levels_read(verdict, wanted.count(), false); });
}

}  // namespace changeover
