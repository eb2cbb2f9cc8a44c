#include "loadorder/listed/neighbourhoods.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "../pairs/pairs_support.hpp"
#include "changeover/loadorder/workers.hpp"

namespace changeover::test::neighbourhoods_test {
namespace {

using Parts = std::vector<std::vector<ItemPair>>;

// All pairs of a hub with others, and a path beside it.
std::vector<ItemPair> star_and_path(Element leaves) {
  std::vector<ItemPair> pairs;
  for (Element x = 1; x <= leaves; ++x) {
    pairs.emplace_back(0, x);
    pairs.emplace_back(leaves + x, leaves + x + 1);
  }
  return pairs;
}

std::size_t items_in_all(const Parts& parts) {
  std::size_t sum = 0;
  for (const std::vector<ItemPair>& part : parts) {
    std::set<Element> items;
    for (const auto& [x, y] : part) {
      items.insert(x);
      items.insert(y);
    }
    sum += items.size();
  }
  return sum;
}

// Each pair is in one part, and no part has more than a pair, or a twentieth, above the mean.
void expect_parted(const PairGraph& graph, const std::vector<ItemPair>& pairs,
                   std::uint64_t workers) {
  const Parts parts = neighbourhoods(graph, workers);
  ASSERT_EQ(parts.size(), workers);
  std::multiset<ItemPair> all;
  std::size_t most = 0;
  for (const std::vector<ItemPair>& part : parts) {
    all.insert(part.begin(), part.end());
    most = std::max(most, part.size());
  }
  EXPECT_EQ(all, std::multiset<ItemPair>(pairs.begin(), pairs.end())) << workers;
  const double mean = static_cast<double>(pairs.size()) / static_cast<double>(workers);
  EXPECT_LE(static_cast<double>(most), std::max(1.05 * mean, std::ceil(mean))) << workers;
}

TEST(Neighbourhoods, HaveEachPairOnceAndAreEven) {
  for (const std::uint64_t workers : {1U, 2U, 3U, 7U, 20U, 64U, 200U}) {
    for (const std::vector<ItemPair>& pairs :
         {random_pairs(60, 150, 3), close_points(90, 400, 4), star_and_path(70),
          random_pairs(20, 190, 5), random_pairs(50, 3, 6)}) {
      expect_parted(PairGraph(150, pairs), pairs, workers);
    }
  }
}

TEST(Neighbourhoods, OfCostsAreEvenInCosts) {
  const std::vector<ItemPair> pairs = close_points(100, 600, 7);
  const auto cost = [](Element x, Element y) { return 0.5 + (x * 7 + y * 3) % 11; };
  double all = 0;
  for (const auto& [x, y] : pairs) {
    all += cost(x, y);
  }
  constexpr std::uint64_t workers = 12;
  const Parts parts = neighbourhoods(PairGraph(100, pairs), workers, cost);
  std::multiset<ItemPair> seen;
  for (const std::vector<ItemPair>& part : parts) {
    double sum = 0;
    for (const auto& [x, y] : part) {
      sum += cost(x, y);
      seen.emplace(x, y);
    }
    EXPECT_LE(sum, std::max(1.05 * all / workers, all / workers + 11));
    EXPECT_GT(sum, 0);
  }
  EXPECT_EQ(seen, std::multiset<ItemPair>(pairs.begin(), pairs.end()));
}

TEST(Neighbourhoods, AnItemAloneIsAtOneWorker) {
  std::vector<ItemPair> pairs = random_pairs(30, 40, 8);
  pairs.emplace_back(35, 35);
  const Parts parts = neighbourhoods(PairGraph(40, pairs), 4);
  std::size_t alone = 0;
  for (const std::vector<ItemPair>& part : parts) {
    alone += static_cast<std::size_t>(std::ranges::count(part, ItemPair(35, 35)));
  }
  EXPECT_EQ(alone, 1U);
  EXPECT_EQ(std::accumulate(parts.begin(), parts.end(), std::size_t{0},
                            [](std::size_t sum, const auto& part) { return sum + part.size(); }),
            41U);
}

// Parts of consecutive pairs of a sorted list have far more items.
TEST(Neighbourhoods, OfPointsHaveFewItems) {
  std::vector<ItemPair> pairs = close_points(800, 6000, 9);
  std::ranges::sort(pairs);
  constexpr std::size_t workers = 60;
  Parts sorted(workers);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    sorted[i * workers / pairs.size()].push_back(pairs[i]);
  }
  const Parts parts = neighbourhoods(PairGraph(800, pairs), workers);
  EXPECT_LE(3 * items_in_all(parts), items_in_all(sorted));
}

// Many workers with a list: the busiest loads less than with stretches of one order, whose pairs
// were up to twice the mean.
TEST(Neighbourhoods, AreTakenForManyWorkers) {
  const std::vector<ItemPair> pairs = close_points(800, 6000, 10);
  const WantedPairs wanted = listed(800, pairs);
  constexpr std::uint64_t workers = 100;
  constexpr std::uint64_t room = 24;
  const WorkerSplit split = split_load_order(wanted, room, workers, hardly_searched());
  const SplitFacts& facts = split.facts();
  EXPECT_EQ(split.order().facts().method, "neighbourhoods");
  EXPECT_LE(static_cast<double>(facts.most_pairs), 1.05 * 6000 / workers);
  ScheduleCheck check({.items = 800, .room = room, .wanted = wanted});
  std::uint64_t makespan = 0;
  for (std::uint64_t w = 0; w < workers; ++w) {
    std::uint64_t loads = 0;
    const auto steps = split.stream(w);
    for (Step step; steps->next(step);) {
      loads += step.load.size();
      check.read(step);
    }
    makespan = std::max(makespan, loads);
  }
  EXPECT_TRUE(check.finish().valid());
  EXPECT_EQ(makespan, facts.makespan);
  const WorkerSplit stretches =
      split_order(plan_load_order(wanted, room, hardly_searched()), 800, room, workers);
  EXPECT_LT(4 * makespan, 3 * stretches.facts().makespan);
}

}  // namespace
}  // namespace changeover::test::neighbourhoods_test
