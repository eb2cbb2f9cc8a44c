// Two levels for items of different sizes.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "changeover/loadorder/load_order.hpp"
#include "changeover/run/control.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "loadorder/listed/quick_moves.hpp"
#include "loadorder/order/in_rounds.hpp"
#include "loadorder/order/levels/level_cost.hpp"
#include "loadorder/order/read_order.hpp"
#include "loadorder/shares/step_lists.hpp"
#include "loadorder/sizes/item_groups.hpp"
#include "loadorder/sizes/sized_pairs.hpp"

namespace changeover {
namespace {

struct LevelWay {
  std::vector<Move> moves = {};
  double cost = std::numeric_limits<double>::max();
  std::string method = {};
  std::string explanation = {};
};

/// The best of the ways: the moves of an order for the accelerator, or an order of groups.
class LevelWays {
 public:
  LevelWays(const ItemSizes& sizes, const LoadOrderFacts& facts) : sizes_(sizes), facts_(facts) {}

  [[nodiscard]] bool has_one() const { return !best_.method.empty(); }

  /// An order for the accelerator, and memory as a cache.
  void consider_cache(const std::vector<Move>& alone) {
    std::vector<Move> moves = with_a_cache(alone, facts_.room, &sizes_);
    if (const double cost = cost_of(moves, facts_); cost <= best_.cost) {
      best_ = {std::move(moves), cost, "cache", std::string(by_a_cache)};
      order_ = nullptr;
    }
  }

  /// Groups of which some number fits on the accelerator, and more into memory.
  void consider_groups(const std::vector<Element>& items) {
    const std::uint64_t largest =
        largest_of(items, [&](const Element x) { return sizes_.bytes[x]; });
    const PairGraph* const graph = facts_.wanted.are_all() ? nullptr : facts_.wanted.graph();
    LoadOrderOptions quick;
    quick.read_first = false;  // the steps of the best are read as items
    for (const std::uint64_t count : {2U, 3U, 4U, 5U, 6U, 7U, 8U, 10U, 12U, 16U, 24U, 32U, 64U}) {
      const std::uint64_t most = sizes_.fast_memory / count;
      if (most < largest || (must_hurry() && has_one())) {
        return;
      }
      Groups groups = graph == nullptr ? groups_of_at_most(sizes_, items, most, 1)
                                       : cut_into_groups(sizes_, items, most);
      if (groups.size() < 2) {
        continue;
      }
      const std::uint64_t size = largest_of(sizes_, groups);
      const std::uint64_t room = sizes_.memory / size;
      const std::uint64_t fast_room = sizes_.fast_memory / size;
      const LoadOrder order = plan_two_levels(
          graph == nullptr ? WantedPairs(groups.size()) : between_groups(groups, *graph), room,
          fast_room, quick);
      const std::vector<std::uint64_t> bytes = each_of<std::uint64_t>(
          groups, [&](const std::vector<Element>& group) { return bytes_of(sizes_, group); });
      if (const double cost = cost_of(*order.stream(), facts_, bytes); cost < best_.cost) {
        order_ = order.maker();
        best_ = {
            {},
            cost,
            order.facts().method.empty() ? "groups" : "groups, " + order.facts().method,
            fmt::format("Items are in {} of at most {} bytes, of which {} fit into memory and {} "
                        "on the accelerator: {}",
                        count_of(groups.size(), "group"), size, room, fast_room,
                        order.facts().explanation)};
        groups_ = std::move(groups);
      }
    }
  }

  LevelWay take() {
    if (order_) {
      best_.moves = of_items(*order_(), groups_);
    }
    return std::move(best_);
  }

 private:
  const ItemSizes& sizes_;
  const LoadOrderFacts& facts_;
  LevelWay best_;
  LoadOrder::Maker order_;  // of groups, if there is one
  Groups groups_;
};

}  // namespace

LoadOrder plan_two_levels(std::shared_ptr<const ItemSizes> sizes, const WantedPairs& wanted,
                          const LoadOrderOptions& options) {
  const auto fast = std::make_shared<const ItemSizes>(ItemSizes{sizes->bytes, sizes->fast_memory});
  const LoadOrderFacts bounds = with_levels(facts_before(sizes, wanted), *fast);
  std::vector<Element> all_items(sizes->bytes.size());
  std::iota(all_items.begin(), all_items.end(), Element{0});
  LevelWay best = best_in_rounds(
      options,
      [&](const LoadOrderOptions& its) {
        LevelWays ways(*sizes, bounds);
        const bool is_searched = its.search_pairs != nullptr;
        if (!is_searched && wanted.are_all()) {  // which take less time than what comes then
          static_cast<void>(done(true, [&] { ways.consider_groups(all_items); }));
        }
        static_cast<void>(done(ways.has_one(), [&] {
          const std::vector<Move> alone = moves_of(*plan_sized_order(fast, wanted, its).stream());
          ways.consider_cache(alone);
          if (!is_searched && wanted.graph() != nullptr) {
            ways.consider_groups(items_as_they_come(alone));
          }
        }));
        return ways.take();
      },
      [](const LevelWay& its, const LevelWay& others) { return its.cost < others.cost; });
  LoadOrderFacts facts = bounds;
  facts.method = std::move(best.method);
  facts.explanation = std::move(best.explanation);
  const std::string memory =
      fmt::format("with {} and {} bytes of memory", sizes->memory, sizes->fast_memory);
  return read_in_full(std::move(facts), in_memory(best.moves), memory, [&](const auto& verdict) {
    return levels_read(verdict, wanted.among(sizes->bytes.size()).count(), true);
  });
}

std::vector<Move> sized_levels_of(const std::vector<ItemPair>& pairs, const ItemSizes& sizes,
                                  const LoadOrderOptions& options) {
  if (pairs.empty()) {
    return {};
  }
  const std::vector<Element> items = items_of(pairs);
  const auto graph = std::make_shared<const PairGraph>(items.size(), numbered(pairs, items));
  std::vector<Move> moves =
      moves_of(*plan_two_levels(std::make_shared<const ItemSizes>(sizes_of(sizes, items)),
                                WantedPairs::listed(graph), options)
                    .stream());
  give_names(moves, items);
  return moves;
}

}  // namespace changeover
