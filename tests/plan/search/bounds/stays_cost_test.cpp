#include "plan/search/bounds/stays_cost.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "run/random.hpp"

namespace changeover::stays_cost_test {
namespace {

// The least cost over all numbers of stays that satisfy every inequality.
std::uint64_t least_by_trying(const std::vector<Amount>& prices, std::uint64_t room,
                              std::vector<std::uint64_t>& stays) {
  constexpr std::uint64_t most_stays = 5;
  if (stays.size() < prices.size()) {
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    for (std::uint64_t i = 1; i <= most_stays; ++i) {
      stays.push_back(i);
      least = std::min(least, least_by_trying(prices, room, stays));
      stays.pop_back();
    }
    return least;
  }
  std::uint64_t cost = 0;
  for (std::uint64_t s = 1; s <= most_stays; ++s) {
    std::uint64_t sum = 0;
    for (const std::uint64_t i : stays) {
      sum += i < s + 1 ? s + 1 - i : 0;
    }
    // Pairs within these parts, counted: at the number of parts for which that says most, n =
    // (s+1)(room-1).
    if (sum > (s * s - s + 1) * room || (room > 1 && 2 * sum > s * ((s + 2) * room - (s + 1)))) {
      return std::numeric_limits<std::uint64_t>::max();
    }
  }
  for (std::size_t x = 0; x < prices.size(); ++x) {
    cost += (stays[x] - 1) * prices[x].millionths;
  }
  return cost;
}

TEST(StaysCost, IsTheLeastOverAllNumbersOfStays) {
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    std::vector<Amount> prices(1 + random.below(5));
    for (Amount& price : prices) {
      price.millionths = random.below(9);
    }
    const std::uint64_t room = 1 + random.below(static_cast<std::uint32_t>(prices.size()) + 1);
    std::vector<std::uint64_t> stays;
    EXPECT_EQ(stays_cost(prices, room).cost.millionths, least_by_trying(prices, room, stays))
        << prices.size() << " parts, room for " << room;
  }
}

TEST(StaysCost, CountsWhatTheTheoremAsks) {
  const std::vector<Amount> prices(25, Amount{1});
  EXPECT_EQ(stays_cost(prices, 10).extra, 20U);  // 3·25 − 3·10 in all, 25 of them the first ones
  EXPECT_EQ(stays_cost(prices, 25).extra, 0U);
  EXPECT_EQ(stays_cost({}, 3).extra, 0U);
  // 25 parts, room for 3: c_1, …, c_6 are 3, 9, 16, 26, 37, 51, so Y_1, …, Y_6 are 22, 19, 18, 15,
  // 14, 11, and so on.
  EXPECT_EQ(stays_cost(prices, 3).extra, 22U + 19 + 18 + 15 + 14 + 11 + 10 + 7 + 6 + 3 + 2);
}

}  // namespace
}  // namespace changeover::stays_cost_test
