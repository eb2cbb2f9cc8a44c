#include "plan/search/bounds/stays_cost.hpp"

#include <algorithm>
#include <utility>

#include "bounds/short_stays.hpp"

namespace changeover {

namespace {

StaysCost stays_cost(std::vector<Amount> prices, std::uint64_t room, bool triples) {
  StaysCost least;
  if (room == 0) {
    return least;
  }
  std::sort(prices.begin(), prices.end());
  std::vector<Amount> cheapest{Amount{}};  // by number of parts: cost of the cheapest ones
  for (const Amount price : prices) {
    cheapest.push_back(cheapest.back() + price);
  }
  const std::uint64_t n = prices.size();
  std::uint64_t taken = room;
  for (std::uint64_t s = 1; taken < n; ++s) {
    least.extra += n - taken;
    least.cost += cheapest[static_cast<std::size_t>(n - taken)];
    if (triples || room == 1) {
      taken = triples && s == 1 ? room : triples && s == 2 ? 5 * room : 2 * s * room;
    } else {
      taken = most_stays_short(s + 1, room) - most_stays_short(s, room);
    }
  }
  return least;
}

}  // namespace

StaysCost stays_cost(std::vector<Amount> prices, std::uint64_t room) {
  return stays_cost(std::move(prices), room, false);
}

StaysCost stays_cost_of_triples(std::vector<Amount> prices, std::uint64_t room) {
  return stays_cost(std::move(prices), room, true);
}

}  // namespace changeover
