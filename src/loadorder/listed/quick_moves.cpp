#include "loadorder/listed/quick_moves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "loadorder/pairs/starts.hpp"

namespace changeover {

std::vector<LoadMove> quick_moves(const PairGraph& graph, std::uint64_t room) {
  std::vector<LoadMove> best;
  bool found = false;
  std::uint64_t least = 0;
  for (Element x = 0; x < graph.items(); ++x) {
    least += graph.is_needed(x) ? 1U : 0U;
  }
  each_start(graph, room, [&](const std::string&, const std::vector<Element>& start) {
    stop_if_asked();
    Closing closing(graph, room, start);
    const std::uint64_t limit = found ? best.size() - 1 : Closing::no_limit;
    if (closing.run(limit) <= limit) {
      best = closing.take_moves();
      found = true;
    }
    return best.size() > least;
  });
  return best;
}

std::vector<std::vector<LoadMove>> several_orders(const PairGraph& graph, std::uint64_t room) {
  std::vector<std::vector<LoadMove>> orders;
  std::uint64_t limit = Closing::no_limit;
  each_start(graph, room, [&](const std::string&, const std::vector<Element>& start) {
    stop_if_asked();
    Closing closing(graph, room, start);
    if (const std::uint64_t loads = closing.run(limit); loads <= limit) {
      orders.push_back(closing.take_moves());
      limit = std::min(limit, loads + loads / 3);
    }
    return true;
  });
  std::ranges::stable_sort(orders, {}, &std::vector<LoadMove>::size);
  return orders;
}

std::vector<Element> items_of(std::span<const ItemPair> pairs) {
  std::vector<Element> items;
  items.reserve(2 * pairs.size());
  for (const auto& [x, y] : pairs) {
    items.push_back(x);
    items.push_back(y);
  }
  std::ranges::sort(items);
  items.erase(std::unique(items.begin(), items.end()), items.end());
  return items;
}

std::vector<ItemPair> numbered(std::span<const ItemPair> pairs, const std::vector<Element>& items) {
  const auto number = [&](Element x) {
    return static_cast<Element>(std::ranges::lower_bound(items, x) - items.begin());
  };
  std::vector<ItemPair> found;
  found.reserve(pairs.size());
  for (const auto& [x, y] : pairs) {
    found.emplace_back(number(x), number(y));
  }
  return found;
}

std::vector<LoadMove> quick_moves(std::span<const ItemPair> pairs,
                                  const std::vector<Element>& items, std::uint64_t room) {
  std::vector<LoadMove> moves = quick_moves(PairGraph(items.size(), numbered(pairs, items)), room);
  for (LoadMove& move : moves) {
    move.load = items[move.load];
    move.evict = move.evict == LoadMove::nothing ? LoadMove::nothing : items[move.evict];
  }
  return moves;
}

WantedPairs as_list(const WantedPairs& wanted) {
  constexpr std::uint64_t most_pairs = 10'000'000;
  if (wanted.graph() != nullptr) {
    return wanted;
  }
  if (wanted.count() > most_pairs) {
    throw ImpossibleParameters(fmt::format(
        "{} are {} pairs; for disjoint workers at most {}; group items into larger ones",
        wanted.describe(), wanted.count(), most_pairs));
  }
  const auto items = static_cast<Element>(wanted.items());
  return WantedPairs::listed(std::make_shared<const PairGraph>(
      items,
      [&](const PairGraph::Visit& visit) {
        for (auto y = static_cast<Element>(wanted.first()); y < items; ++y) {
          visit(y, y);  // even if it is in no pair
          const Element end = wanted.kind() == WantedPairs::Kind::between
                                  ? static_cast<Element>(wanted.first())
                                  : y;
          for (Element x = 0; x < end; ++x) {
            visit(x, y);
          }
        }
      },
      std::vector<std::string>()));
}

std::vector<Move> one_step_each(const std::vector<LoadMove>& moves) {
  std::vector<Move> all;
  all.reserve(moves.size());
  for (const auto& [x, out] : moves) {
    all.push_back({.load = {x}});
    if (out != LoadMove::nothing) {
      all.back().evict.push_back(out);
    }
  }
  return all;
}

}  // namespace changeover
