// What some bench must mount: by giving the parts to benches in every way.
#include "plan/search/benches/fullest_bench.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/checked.hpp"
#include "run/random.hpp"

namespace changeover::fullest_bench_test {
namespace {

SharedParts all_meet(std::size_t parts, std::uint64_t room) {
  SharedParts shared{.costs = std::vector<Amount>(parts, Amount{10}),
                     .meet = std::vector<std::vector<bool>>(parts, std::vector<bool>(parts, true)),
                     .limits = {{std::vector<bool>(parts, true), room}},
                     .test = Amount{1}};
  return shared;
}

// The least cost of the most expensive bench, over all ways.
Amount by_all_ways(const SharedParts& shared, std::size_t benches) {
  const std::size_t v = shared.costs.size();
  std::vector<std::uint32_t> given(v, 1);
  std::optional<Amount> best;
  const std::uint32_t end = 1U << benches;
  for (;;) {
    bool meets = true;
    for (std::size_t x = 0; x < v; ++x) {
      for (std::size_t y = 0; y < x; ++y) {
        meets = meets && (!shared.meet[x][y] || (given[x] & given[y]) != 0);
      }
    }
    Amount costliest;
    for (std::size_t w = 0; w < benches; ++w) {
      Amount cost;
      std::uint64_t tests = 0;
      for (const auto& [counted, most] : shared.limits) {
        std::uint64_t there = 0;
        for (std::size_t x = 0; x < v; ++x) {
          there += counted[x] && (given[x] >> w & 1U) != 0 ? 1U : 0U;
        }
        tests = std::max(tests, ceil_div(there, most));
      }
      for (std::size_t x = 0; x < v; ++x) {
        cost += (given[x] >> w & 1U) != 0 ? shared.costs[x] : Amount{};
      }
      costliest = std::max(costliest, cost + shared.test * tests);
    }
    best = meets ? std::min(best.value_or(costliest), costliest) : best;
    std::size_t x = 0;
    while (x < v && ++given[x] == end) {
      given[x++] = 1;
    }
    if (x == v) {
      return *best;
    }
  }
}

TEST(FullestBench, OneOfTwoBenchesHasAllPartsIfAllMeet) {
  for (std::size_t parts = 2; parts <= 12; ++parts) {
    EXPECT_EQ(cost_of_fullest(all_meet(parts, parts), 2, Amount{}), Amount{parts * 10 + 1});
  }
}

// Of three sets that hold all pairs of v elements one has 2v/3, of four 3v/5.
TEST(FullestBench, TheLeastSetsThatHoldAllPairs) {
  EXPECT_EQ(cost_of_fullest(all_meet(12, 12), 3, Amount{}), Amount{8 * 10 + 1});
  EXPECT_EQ(cost_of_fullest(all_meet(10, 10), 4, Amount{}), Amount{6 * 10 + 1});
}

TEST(FullestBench, NothingIsSaidThatIsKnownOrOfManyBenches) {
  EXPECT_EQ(cost_of_fullest(all_meet(6, 6), 2, Amount{60}), Amount{61});
  EXPECT_EQ(cost_of_fullest(all_meet(6, 6), 2, Amount{61}), std::nullopt);
  EXPECT_EQ(cost_of_fullest(all_meet(6, 6), 7, Amount{}), std::nullopt);
}

TEST(FullestBench, TheLeastOfAllWays) {
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    Random random(seed, 3);
    const std::size_t benches = 1 + random.below(3);
    const std::size_t parts = 1 + random.below(benches == 3 ? 5 : 6);
    SharedParts shared = all_meet(parts, 1 + random.below(4));
    const bool alike = random.one_in_two();
    for (std::size_t x = 0; x < parts; ++x) {
      shared.costs[x] = Amount{alike ? 3 : random.below(6)};
      for (std::size_t y = 0; y < x; ++y) {
        shared.meet[x][y] = random.below(4) > 0;
        shared.meet[y][x] = shared.meet[x][y];
      }
    }
    shared.test = Amount{random.below(5)};
    if (random.one_in_two()) {
      std::vector<bool> some(parts);
      for (std::size_t x = 0; x < parts; ++x) {
        some[x] = random.one_in_two();
      }
      shared.limits.emplace_back(some, 1 + random.below(2));
    }
    const Amount least = by_all_ways(shared, benches);
    const auto found = cost_of_fullest(shared, benches, Amount{});
    EXPECT_EQ(found.value_or(Amount{}), least) << seed;
    EXPECT_EQ(cost_of_fullest(shared, benches, least), std::nullopt) << seed;
  }
}

}  // namespace
}  // namespace changeover::fullest_bench_test
