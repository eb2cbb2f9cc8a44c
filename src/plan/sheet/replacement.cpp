#include "plan/sheet/replacement.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "core/checked.hpp"

namespace changeover {
namespace {

using CostMatrix = std::vector<std::vector<std::uint64_t>>;

// A cycle of rows that reduces the cost: each takes the place of the next one, and the last that of
// the first.
std::optional<std::vector<std::size_t>> circle(const CostMatrix& costs,
                                               const std::vector<std::size_t>& place) {
  const std::size_t n = costs.size();
  std::vector<Wide> saved(n, 0);
  std::vector<std::size_t> before(n, n);
  std::size_t last = n;
  for (std::size_t round = 0; round < n; ++round) {
    last = n;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        // Wide is unsigned: compare saved[i] + the current cost of i with its new cost.
        const Wide gain = saved[i] + costs[i][place[i]];
        if (i != j && gain > saved[j] + costs[i][place[j]]) {
          saved[j] = gain - costs[i][place[j]];
          before[j] = i;
          last = j;
        }
      }
    }
    if (last == n) {
      return std::nullopt;
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    last = before[last];
  }
  std::vector<std::size_t> around{last};
  for (std::size_t at = before[last]; at != last; at = before[at]) {
    around.push_back(at);
  }
  std::ranges::reverse(around);
  return around;
}

}  // namespace

std::vector<std::size_t> best_by_trying(const CostMatrix& costs) {
  const std::size_t n = costs.size();
  const std::size_t all = (std::size_t{1} << n) - 1;
  // By set of places: the least cost of the first rows in them, as many rows as places.
  std::vector<Wide> least(all + 1, 0);
  std::vector<std::size_t> last(all + 1, n);
  for (std::size_t set = 1; set <= all; ++set) {
    std::size_t row = 0;
    for (std::size_t p = 0; p < n; ++p) {
      row += set >> p & 1U;
    }
    --row;
    for (std::size_t p = 0; p < n; ++p) {
      if ((set >> p & 1U) == 0) {
        continue;
      }
      const Wide cost = least[set ^ std::size_t{1} << p] + costs[row][p];
      if (last[set] == n || cost < least[set]) {
        least[set] = cost;
        last[set] = p;
      }
    }
  }
  std::vector<std::size_t> place(n);
  for (std::size_t set = all, row = n; row-- > 0;) {
    place[row] = last[set];
    set ^= std::size_t{1} << last[set];
  }
  return place;
}

std::vector<std::size_t> best_by_circles(const CostMatrix& costs) {
  std::vector<std::size_t> place(costs.size());
  std::iota(place.begin(), place.end(), std::size_t{0});
  while (const auto around = circle(costs, place)) {
    const std::size_t first = place[around->front()];
    for (std::size_t i = 0; i + 1 < around->size(); ++i) {
      place[(*around)[i]] = place[(*around)[i + 1]];
    }
    place[around->back()] = first;
  }
  return place;
}

namespace {

// For parts that may all replace each other.
Replacement cheapest_among(const Job& job, const Block& out, const Block& in) {
  constexpr std::size_t few = 10;
  const std::size_t places = std::max(out.size(), in.size());
  // A row for each part put in and for each place that becomes empty; a place for each part taken
  // out and for each place that was empty.
  CostMatrix costs(places, std::vector<std::uint64_t>(places, 0));
  for (std::size_t i = 0; i < in.size(); ++i) {
    for (std::size_t p = 0; p < places; ++p) {
      const Amount cost = p < out.size() ? job.replace_costs.at(out[p] * job.names.size() + in[i])
                                         : job.change_costs.at(in[i]);
      costs[i][p] = cost.millionths;
    }
  }
  const std::vector<std::size_t> place =
      places <= few ? best_by_trying(costs) : best_by_circles(costs);
  Replacement best;
  for (std::size_t i = 0; i < in.size(); ++i) {
    best.cost += Amount{costs[i][place[i]]};
    if (place[i] < out.size()) {
      best.pairs.emplace_back(out[place[i]], in[i]);
    }
  }
  return best;
}

}  // namespace

Replacement cheapest_replacement(const Job& job, const Block& out, const Block& in) {
  struct OfSlot {
    Block out;
    Block in;
  };
  std::map<std::uint32_t, OfSlot> slots;
  const auto slot = [&](Element x) { return job.slots.empty() ? no_slot : job.slot_of.at(x); };
  for (const Element x : out) {
    slots[slot(x)].out.push_back(x);
  }
  for (const Element x : in) {
    slots[slot(x)].in.push_back(x);
  }
  Replacement best;
  for (const auto& [_, parts] : slots) {
    const Replacement here = cheapest_among(job, parts.out, parts.in);
    best.cost += here.cost;
    best.pairs.insert(best.pairs.end(), here.pairs.begin(), here.pairs.end());
  }
  std::ranges::sort(best.pairs);
  return best;
}

}  // namespace changeover
