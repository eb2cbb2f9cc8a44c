// What replacing parts costs, as the referee counts it.
#include "plan/sheet/replacement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plan/search/lists/assignment.hpp"
#include "replacing_jobs.hpp"

namespace changeover::replacement_test {
namespace {

using testing::ElementsAre;
using testing::Pair;

std::uint64_t sum(const std::vector<std::vector<std::uint64_t>>& costs,
                  const std::vector<std::size_t>& place) {
  std::uint64_t total = 0;
  std::vector<bool> taken(costs.size(), false);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    EXPECT_FALSE(taken.at(place.at(i)));
    taken[place[i]] = true;
    total += costs[i][place[i]];
  }
  return total;
}

TEST(Replacement, TryingCirclesAndTheSearchAgree) {
  Random random(11, 1);
  for (int turn = 0; turn < 200; ++turn) {
    const std::size_t n = 1 + random.below(turn % 20 == 0 ? 12 : 8);
    std::vector<std::vector<std::uint64_t>> costs(n, std::vector<std::uint64_t>(n));
    std::vector<std::int64_t> flat;
    for (auto& row : costs) {
      for (std::uint64_t& cost : row) {
        cost = random.below(turn % 2 == 0 ? 4 : 1'000'000);
        flat.push_back(static_cast<std::int64_t>(cost));
      }
    }
    const std::uint64_t tried = sum(costs, best_by_trying(costs));
    EXPECT_EQ(sum(costs, best_by_circles(costs)), tried);
    EXPECT_EQ(static_cast<std::uint64_t>(cheapest_assignment(n, n, flat)), tried);
  }
}

TEST(Replacement, IsWhatAllWaysGive) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Job job = test::replacing(make_job(7, 5, Amount{1}, Amount{seed % 3 * 1'000'000}), seed);
    Random random(seed, 5);
    const unsigned from = random.below(128);
    const unsigned to = random.below(128);
    Block out;
    Block in;
    for (Element x = 0; x < 7; ++x) {
      if ((from >> x & 1U) != (to >> x & 1U)) {
        ((from >> x & 1U) != 0 ? out : in).push_back(x);
      }
    }
    const Replacement found = cheapest_replacement(job, out, in);
    EXPECT_EQ(found.cost.millionths, test::cost_of_changes(job, from, to));
    EXPECT_EQ(found.pairs.size(), std::min(out.size(), in.size()));
  }
}

TEST(Replacement, IsMadeInEachSlotByItself) {
  unsigned apart = 0;  // steps for which it matters
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Job job = test::replacing(make_job(7, 5, Amount{1}, Amount{seed % 3 * 1'000'000}), seed);
    Random random(seed, 5);
    const Block out{0, 1, 2};
    const Block in{3, 4, 5, 6};
    const Amount together = cheapest_replacement(job, out, in).cost;
    job.slots = {{.name = "CPU"}, {.name = "disk"}};
    for (Element x = 0; x < 7; ++x) {
      job.slot_of.push_back(random.below(4) == 0 ? no_slot : random.below(2));
    }
    const Replacement found = cheapest_replacement(job, out, in);
    EXPECT_EQ(found.cost.millionths, test::cost_of_changes(job, 0b0000111, 0b1111000));
    for (const auto& [gone, come] : found.pairs) {
      EXPECT_EQ(job.slot_of[gone], job.slot_of[come]);
    }
    apart += found.cost != together ? 1U : 0U;
  }
  EXPECT_GT(apart, 30U);
}

TEST(Replacement, ExcessIsPaidAtItsOwnCostOrTakenOutForNothing) {
  Job job = make_job(4, 3, Amount{}, Amount{7});
  job.replace_costs.assign(16, Amount{100});
  job.replace_costs[0 * 4 + 2] = Amount{1};   // part 3 where part 1 was
  job.replace_costs[0 * 4 + 3] = Amount{50};  // part 4 where part 1 was
  const Replacement more = cheapest_replacement(job, {0}, {2, 3});
  EXPECT_EQ(more.cost, Amount{8});
  EXPECT_THAT(more.pairs, ElementsAre(Pair(0, 2)));
  const Replacement fewer = cheapest_replacement(job, {0, 1}, {3});
  EXPECT_EQ(fewer.cost, Amount{50});
  EXPECT_THAT(fewer.pairs, ElementsAre(Pair(0, 3)));
  EXPECT_EQ(cheapest_replacement(job, {0, 1}, {}).cost, Amount{});
}

}  // namespace
}  // namespace changeover::replacement_test
