// The fewest loads for a few pairs, by trying everything, and graphs to try.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "../loadorder_support.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/run/control.hpp"
#include "run/random.hpp"

namespace changeover::test {

/// Breadth first over what is in memory and which pairs have met. Loads one by one, evictions at
/// any time.
inline std::uint64_t fewest_loads(std::uint64_t items, const std::vector<ItemPair>& pairs,
                                  std::uint64_t room) {
  using State = std::pair<std::uint32_t, std::uint32_t>;
  const std::uint32_t all = (std::uint32_t{1} << pairs.size()) - 1;
  std::map<State, std::uint64_t> loads{{{0, 0}, 0}};
  std::deque<State> queue{{0, 0}};
  while (!queue.empty()) {
    const State state = queue.front();
    queue.pop_front();
    if (state.second == all) {
      return loads[state];
    }
    for (Element x = 0; x < items; ++x) {
      const std::uint32_t bit = std::uint32_t{1} << x;
      if ((state.first & bit) != 0) {
        continue;
      }
      for (Element out = 0; out <= items; ++out) {  // `items`: nothing goes
        std::uint32_t memory = state.first;
        if (out < items) {
          if ((memory & (std::uint32_t{1} << out)) == 0) {
            continue;
          }
          memory &= ~(std::uint32_t{1} << out);
        }
        memory |= bit;
        if (static_cast<std::uint64_t>(__builtin_popcount(memory)) > room) {
          continue;
        }
        State next{memory, state.second};
        for (std::size_t i = 0; i < pairs.size(); ++i) {
          if ((memory >> pairs[i].first & 1) != 0 && (memory >> pairs[i].second & 1) != 0) {
            next.second |= std::uint32_t{1} << i;
          }
        }
        if (loads.try_emplace(next, loads[state] + 1).second) {
          queue.push_back(next);
        }
      }
    }
  }
  return 0;
}

inline std::vector<ItemPair> random_pairs(std::uint64_t items, std::size_t count,
                                          std::uint64_t seed) {
  Random random(seed);
  std::vector<ItemPair> pairs;
  while (pairs.size() < count) {
    const Element x = random.below(static_cast<std::uint32_t>(items));
    const Element y = random.below(static_cast<std::uint32_t>(items));
    if (x != y && std::find(pairs.begin(), pairs.end(),
                            std::pair(std::min(x, y), std::max(x, y))) == pairs.end()) {
      pairs.emplace_back(std::min(x, y), std::max(x, y));
    }
  }
  return pairs;
}

/// The pairs of the points of a square that lie closest to each other.
inline std::vector<ItemPair> close_points(std::uint32_t items, std::size_t count,
                                          std::uint64_t seed) {
  Random random(seed);
  std::vector<std::pair<double, double>> points(items);
  for (auto& [x, y] : points) {
    x = random.next32() / 4294967296.0;
    y = random.next32() / 4294967296.0;
  }
  std::vector<std::pair<double, ItemPair>> all;
  for (Element i = 0; i < items; ++i) {
    for (Element j = i + 1; j < items; ++j) {
      const double dx = points[i].first - points[j].first;
      const double dy = points[i].second - points[j].second;
      all.push_back({dx * dx + dy * dy, {i, j}});
    }
  }
  std::sort(all.begin(), all.end());
  std::vector<ItemPair> pairs;
  for (std::size_t i = 0; i < count; ++i) {
    pairs.push_back(all[i].second);
  }
  return pairs;
}

/// Without the search that takes some seconds, of which the result would be better.
inline LoadOrderOptions hardly_searched() {
  LoadOrderOptions options;
  options.effort = 1e-3;
  options.search_pairs = [](const std::function<void()>& search) {
    RunControl control({.time = std::chrono::milliseconds(2)});
    const RunScope scope(control);
    search();
  };
  return options;
}

inline WantedPairs listed(std::uint64_t items, const std::vector<ItemPair>& pairs) {
  return WantedPairs::listed(std::make_shared<const PairGraph>(items, pairs));
}

/// Every pair that `wanted` contains, asked one by one.
inline std::vector<ItemPair> pairs_of(const WantedPairs& wanted) {
  std::vector<ItemPair> pairs;
  for (Element y = 0; y < wanted.items(); ++y) {
    for (Element x = 0; x < y; ++x) {
      if (wanted.contains(x, y)) {
        pairs.emplace_back(x, y);
      }
    }
  }
  return pairs;
}

/// Plays the order; the first thing that is wrong, or "".
inline std::string defect(const LoadOrder& order) {
  const LoadOrderFacts& facts = order.facts();
  const auto steps = order.stream();
  const Simulation played = simulate(*steps, facts.items, facts.room);
  if (!played.fault.empty()) {
    return played.fault;
  }
  for (const ItemPair& pair : pairs_of(facts.wanted)) {
    if (played.met.count(pair) == 0) {
      return fmt::format("{{{},{}}} did not meet", pair.first, pair.second);
    }
  }
  if (played.loads != facts.loads || played.steps != facts.steps) {
    return fmt::format("{} loads in {} steps", played.loads, played.steps);
  }
  return played.loads < facts.bound.loads ? "fewer loads than the bound" : "";
}

}  // namespace changeover::test
