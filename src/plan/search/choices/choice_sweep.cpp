// Lists of set-ups of a model that change little: one parameter after the other goes a part of its
// way through its values, as in docs/theorems.md, Theorem 24. Parameters with equally many values
// have the same way, and so all their pairs are tested. In which order the parts of the ways of
// different numbers of values follow each other is searched for, so that they test most pairs.
#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "plan/search/choices/choice_search.hpp"

namespace changeover {
namespace {

// The values that are taken one after the other, from 0 on; by part of the way.
using SweptWay = std::vector<std::vector<std::size_t>>;

// Part i goes from i to i + 1 (mod g) by way of u if the cell (i, u) is chosen. Of two cells (i, u)
// and (u - 1, i) one is enough: along the cycles of this map, every second cell.
SweptWay way_through_all(std::size_t g, Random& random) {
  SweptWay way(g < 2 ? 0 : g);
  std::vector<bool> seen(g * g, false);
  for (std::size_t from = 0; from < way.size(); ++from) {
    for (std::size_t by = 0; by < g; ++by) {
      bool chosen = g % 2 == 1 || random.one_in_two();
      for (std::size_t i = from, u = by; u != i && u != (i + 1) % g && !seen[i * g + u];) {
        seen[i * g + u] = true;
        if (chosen) {
          way[i].push_back(u);
        }
        chosen = !chosen;
        i = std::exchange(u, i) + g - 1;
        i %= g;
      }
    }
  }
  for (std::size_t i = 0; i < way.size(); ++i) {
    for (std::size_t j = 1; j < way[i].size(); ++j) {
      std::swap(way[i][j], way[i][random.below(static_cast<std::uint32_t>(j + 1))]);
    }
    way[i].push_back((i + 1) % g);
  }
  return way;
}

// The parameters with so many values.
struct EqualSlots {
  std::size_t values = 0;
  std::vector<std::size_t> slots;
  SweptWay way;
};

// The pairs that parameters of different kinds do not test, if the kinds go in this order.
std::size_t untested(const std::vector<EqualSlots>& kinds, const std::vector<std::size_t>& order) {
  std::vector<std::size_t> begin{0};
  for (const EqualSlots& kind : kinds) {
    begin.push_back(begin.back() + kind.values);
  }
  const std::size_t all = begin.back();
  std::vector<bool> met(all * all, false);
  std::vector<std::size_t> now(kinds.size(), 0);
  std::vector<std::size_t> part(kinds.size(), 0);
  const auto meet = [&](std::size_t kind) {
    const std::size_t x = begin[kind] + now[kind];
    for (std::size_t other = 0; other < kinds.size(); ++other) {
      const std::size_t y = begin[other] + now[other];
      met[x * all + y] = true;
      met[y * all + x] = true;
    }
  };
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    meet(kind);
  }
  for (const std::size_t kind : order) {
    for (const std::size_t x : kinds[kind].way[part[kind]++]) {
      now[kind] = x;
      meet(kind);
    }
  }
  std::size_t open = 0;
  for (std::size_t a = 0; a < kinds.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      std::size_t lacks = 0;
      for (std::size_t x = begin[a]; x < begin[a + 1]; ++x) {
        lacks += static_cast<std::size_t>(
            std::count(met.begin() + static_cast<std::ptrdiff_t>(x * all + begin[b]),
                       met.begin() + static_cast<std::ptrdiff_t>(x * all + begin[b + 1]), false));
      }
      open += lacks * kinds[a].slots.size() * kinds[b].slots.size();
    }
  }
  return open;
}

// Which kind goes the next part of its way, each time: a good order by random exchanges.
std::vector<std::size_t> order_of_parts(std::vector<EqualSlots>& kinds, Random& random) {
  std::vector<std::size_t> order;
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    order.insert(order.end(), kinds[kind].way.size(), kind);
  }
  if (kinds.size() < 2 || order.empty()) {
    return order;
  }
  const auto below = [&](std::size_t n) { return random.below(static_cast<std::uint32_t>(n)); };
  std::size_t open = untested(kinds, order);
  constexpr std::size_t tries = 4000;
  for (std::size_t i = 0; i < tries && open > 0; ++i) {
    const std::size_t kind = below(kinds.size());
    const std::size_t a = below(order.size());
    const std::size_t b = below(order.size());
    const bool exchange = below(8) > 0;
    SweptWay way = exchange ? SweptWay{} : way_through_all(kinds[kind].values, random);
    exchange ? std::swap(order[a], order[b]) : kinds[kind].way.swap(way);
    const std::size_t now = untested(kinds, order);
    if (now > open) {
      exchange ? std::swap(order[a], order[b]) : kinds[kind].way.swap(way);
    } else {
      open = now;
    }
  }
  return order;
}

}  // namespace

std::optional<std::vector<Block>> swept(const ChoiceJob& choices, Random& random) {
  constexpr std::size_t most_values = 12;
  std::vector<std::vector<Element>> values(choices.slots());  // in range
  std::map<std::size_t, EqualSlots, std::greater<>> by_size;
  Block row;
  for (std::size_t p = 0; p < choices.slots(); ++p) {
    std::ranges::copy_if(choices.values(p), std::back_inserter(values[p]),
                         [&](Element x) { return !choices.job().model->value(x).negative; });
    if (values[p].empty() || values[p].size() > most_values) {
      return std::nullopt;
    }
    by_size[values[p].size()].slots.push_back(p);
    row.push_back(values[p][0]);
  }
  std::vector<EqualSlots> kinds;
  kinds.reserve(by_size.size());
  for (auto& [size, kind] : by_size) {
    kinds.push_back({size, std::move(kind.slots), way_through_all(size, random)});
  }
  std::vector<Block> rows;
  const auto keep = [&] {
    if (choices.allows(row)) {
      rows.push_back(row);
    }
  };
  keep();
  std::vector<std::size_t> part(kinds.size(), 0);
  for (const std::size_t kind : order_of_parts(kinds, random)) {
    const std::vector<std::size_t>& steps = kinds[kind].way[part[kind]++];
    for (const std::size_t p : kinds[kind].slots) {
      for (const std::size_t x : steps) {
        row[p] = values[p][x];
        keep();
      }
    }
  }
  return rows;
}

}  // namespace changeover
