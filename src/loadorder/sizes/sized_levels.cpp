// Two levels for items of different sizes.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "changeover/loadorder/load_order.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "loadorder/listed/quick_moves.hpp"
#include "loadorder/order/in_rounds.hpp"
#include "loadorder/order/read_order.hpp"
#include "loadorder/shares/step_lists.hpp"
#include "loadorder/sizes/item_groups.hpp"
#include "loadorder/sizes/sized_pairs.hpp"

namespace changeover {
namespace {

/// The steps of an order of groups, item by item.
std::vector<Move> of_items(StepSource& steps, const Groups& groups) {
  std::vector<Move> moves;
  for (Step step; steps.next(step);) {
    moves.push_back({items_in(groups, step.evict), items_in(groups, step.load),
                     items_in(groups, step.fast_evict), items_in(groups, step.fast_load)});
  }
  return moves;
}

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
    Bytes bytes;
    for (const Move& move : moves) {
      bytes.loaded += bytes_of(sizes_, move.load);
      bytes.transferred += bytes_of(sizes_, move.fast_load);
    }
    if (const double cost = cost_of(bytes); cost <= best_.cost) {
      best_ = {std::move(moves), cost, "cache", std::string(by_a_cache)};
      order_ = nullptr;
    }
  }

  /// Groups of which some number fits on the accelerator, and more into memory.
  void consider_groups(const std::vector<Element>& items) {
    std::uint64_t largest = 1;
    for (const Element x : items) {
      largest = std::max(largest, sizes_.bytes[x]);
    }
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
      if (const double cost = cost_of(bytes_of_groups(order, groups)); cost < best_.cost) {
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
  struct Bytes {
    std::uint64_t loaded = 0;
    std::uint64_t transferred = 0;
  };

  /// Those of both levels, each over its bound.
  [[nodiscard]] double cost_of(const Bytes& bytes) const {
    return static_cast<double>(bytes.loaded) / static_cast<double>(facts_.byte_bound.loads) +
           static_cast<double>(bytes.transferred) /
               static_cast<double>(facts_.transfer_byte_bound.loads);
  }

  [[nodiscard]] Bytes bytes_of_groups(const LoadOrder& order, const Groups& groups) const {
    std::vector<std::uint64_t> bytes;
    for (const std::vector<Element>& group : groups) {
      bytes.push_back(bytes_of(sizes_, group));
    }
    Bytes sum;
    const auto steps = order.stream();
    for (Step step; steps->next(step);) {
      for (const Element g : step.load) {
        sum.loaded += bytes[g];
      }
      for (const Element g : step.fast_load) {
        sum.transferred += bytes[g];
      }
    }
    return sum;
  }

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
  LoadOrderFacts facts = facts_before(sizes, wanted);
  facts.transfer_byte_bound = sized_lower_bound(*fast, wanted);
  facts.fast_room = most_held(*fast, wanted);
  facts.transfer_bound = load_lower_bound(wanted.among(facts.items), *facts.fast_room);
  std::vector<Element> all_items(sizes->bytes.size());
  std::iota(all_items.begin(), all_items.end(), Element{0});
  LevelWay best = best_in_rounds(
      options,
      [&](const LoadOrderOptions& its) {
        LevelWays ways(*sizes, facts);
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
  ItemSizes some{{}, sizes.memory, sizes.fast_memory};
  for (const Element x : items) {
    some.bytes.push_back(sizes.bytes[x]);
  }
  const auto graph = std::make_shared<const PairGraph>(items.size(), numbered(pairs, items));
  std::vector<Move> moves = moves_of(
      *plan_two_levels(std::make_shared<const ItemSizes>(some), WantedPairs::listed(graph), options)
           .stream());
  give_names(moves, items);
  return moves;
}

}  // namespace changeover
