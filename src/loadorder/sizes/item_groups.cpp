#include "loadorder/sizes/item_groups.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <queue>
#include <unordered_set>
#include <utility>

#include "core/checked.hpp"
#include "core/each.hpp"
#include "loadorder/sizes/sized_pairs.hpp"

namespace changeover {

std::vector<Element> items_as_they_come(const std::vector<Move>& moves) {
  std::vector<Element> items;
  std::unordered_set<Element> came;
  for (const Move& move : moves) {
    std::ranges::copy_if(move.load, std::back_inserter(items),
                         [&](Element x) { return came.insert(x).second; });
  }
  return items;
}

std::vector<Element> largest_first(const ItemSizes& sizes, std::span<const Element> items) {
  std::vector<Element> order(items.begin(), items.end());
  std::ranges::stable_sort(order, std::ranges::greater(),
                           [&](const Element x) { return sizes.bytes[x]; });
  return order;
}

std::uint64_t largest_of(const ItemSizes& sizes, const Groups& groups) {
  return largest_of(groups,
                    [&](const std::vector<Element>& group) { return bytes_of(sizes, group); });
}

Groups even_groups(const ItemSizes& sizes, std::span<const Element> items, std::uint64_t count) {
  Groups groups(static_cast<std::size_t>(count));
  using Filled = std::pair<std::uint64_t, std::size_t>;
  std::priority_queue<Filled, std::vector<Filled>, std::greater<>> next;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    next.emplace(0, g);
  }
  for (const Element x : largest_first(sizes, items)) {
    const auto [bytes, g] = next.top();
    next.pop();
    groups[g].push_back(x);
    next.emplace(bytes + sizes.bytes[x], g);
  }
  return groups;
}

Groups groups_of_at_most(const ItemSizes& sizes, const std::vector<Element>& items,
                         std::uint64_t most, std::uint64_t least) {
  std::uint64_t count = std::max(least, ceil_div(bytes_of(sizes, items), most));
  for (; count <= items.size(); count += std::max<std::uint64_t>(1, count / 32)) {
    Groups groups = even_groups(sizes, items, count);
    if (largest_of(sizes, groups) <= most) {
      return groups;
    }
  }
  return {};
}

Groups cut_into_groups(const ItemSizes& sizes, const std::vector<Element>& items,
                       std::uint64_t most) {
  Groups groups;
  std::uint64_t left = 0;
  for (const Element x : items) {
    if (groups.empty() || left < sizes.bytes[x]) {
      groups.emplace_back();
      left = most;
    }
    groups.back().push_back(x);
    left -= sizes.bytes[x];
  }
  return groups;
}

std::vector<Move> of_items(StepSource& steps, const Groups& groups) {
  std::vector<Move> moves;
  for (Step step; steps.next(step);) {
    moves.push_back({items_in(groups, step.evict), items_in(groups, step.load),
                     items_in(groups, step.fast_evict), items_in(groups, step.fast_load)});
  }
  return moves;
}

WantedPairs between_groups(const Groups& groups, const PairGraph& graph) {
  std::vector<Element> group_of(static_cast<std::size_t>(graph.items()), 0);
  for (Element g = 0; g < groups.size(); ++g) {
    for (const Element x : groups[g]) {
      group_of[x] = g;
    }
  }
  std::vector<ItemPair> pairs;
  for (Element g = 0; g < groups.size(); ++g) {
    std::vector<Element> others{g};
    for (const Element x : groups[g]) {
      for (const Element y : graph.partners(x)) {
        others.push_back(group_of[y]);
      }
    }
    std::ranges::sort(others);
    others.erase(std::unique(others.begin(), others.end()), others.end());
    for (const Element other : others) {
      if (other >= g) {
        pairs.emplace_back(g, other);
      }
    }
  }
  return WantedPairs::listed(std::make_shared<const PairGraph>(groups.size(), pairs));
}

}  // namespace changeover
