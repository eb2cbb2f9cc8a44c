// Plans for pairs of different weights.
#include "plan/search/weighted.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "changeover/plan/run_plan.hpp"
#include "cheapest.hpp"
#include "message_of.hpp"
#include "random_jobs.hpp"

namespace changeover::weighted_test {
namespace {

using testing::HasSubstr;

Amount units(std::uint64_t n) { return Amount{n * 1'000'000}; }

RunPlan planned(const Job& job, PlanOptions options = {}, unsigned threads = 1) {
  options.steps = options.steps == 0 ? 20'000 : options.steps;
  options.design_moves = 0;
  RunControl control({.threads = threads});
  return make_run_plan(job, options, control);
}

void weigh_at_random(Job& job, std::uint64_t seed) {
  Random random(seed, 66);
  job.needed.for_each(1000, [&](Element x, Element y) {
    if (random.below(2) == 0) {
      job.weights.set(x, y, Amount{random.below(9) * 1'250'000ULL});
    }
  });
  job.weights.set(0, 1, units(3));
}

// The most weight within a budget, of all lists.
std::uint64_t most_weight(const Job& job, const std::vector<std::uint64_t>& least,
                          std::uint64_t budget) {
  std::vector<std::uint64_t> weights;
  job.needed.for_each(
      1000, [&](Element x, Element y) { weights.push_back(job.weights(x, y).millionths); });
  std::uint64_t most = 0;
  for (std::size_t covered = 0; covered < least.size(); ++covered) {
    std::uint64_t weight = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      weight += (covered >> i & 1U) != 0 ? weights[i] : 0;
    }
    most = least[covered] <= budget ? std::max(most, weight) : most;
  }
  return most;
}

TEST(Weighted, TheMostWeightThatABudgetPaysFor) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Job job = seed % 2 == 0 ? test::random_job(seed, 5) : test::random_job_with_slots(seed, 5);
    weigh_at_random(job, seed);
    const std::vector<std::uint64_t> least = test::least_costs(job);
    const std::uint64_t all = *test::least_cost(job);
    for (const std::uint64_t share : {2U, 5U, 8U}) {
      const std::uint64_t budget = all * share / 10;
      const std::uint64_t most = most_weight(job, least, budget);
      EXPECT_GE(most_weight_within(job, Amount{budget}).millionths, most) << seed;
      const RunPlan plan = planned(job, {.budget = Amount{budget}});
      EXPECT_LE(plan.sheet.cost.millionths, budget);
      EXPECT_EQ(plan.sheet.weight_tested.millionths, most) << seed << ' ' << share;
      if (plan.complete && plan.complete->cost.millionths > budget) {
        ASSERT_TRUE(plan.most_weight.has_value());
        EXPECT_GE(*plan.most_weight, plan.sheet.weight_tested);
      }
    }
  }
}

TEST(Weighted, NoBudgetPaysForMorePairsThanTheBound) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Job job =
        seed % 2 == 0 ? test::random_job(seed, 5) : test::random_job_with_slots(seed, 5);
    const std::vector<std::uint64_t> least = test::least_costs(job);
    std::size_t inner = 0;
    std::size_t bit = 0;
    job.needed.for_each(1000, [&](Element x, Element y) {
      const auto stays = [&](Element z) {
        return std::count(job.mounted.begin(), job.mounted.end(), z) > 0;
      };
      inner |= stays(x) || stays(y) ? 0 : std::size_t{1} << bit;
      ++bit;
    });
    for (std::size_t covered = 0; covered < least.size(); ++covered) {
      if (least[covered] != test::no_cost) {
        EXPECT_GE(most_pairs_within(job, Amount{least[covered]}),
                  static_cast<std::uint64_t>(std::popcount(covered & inner)))
            << seed;
      }
    }
  }
  // Seven parts, three at a time, 1 a change and 0 a test: 3 pairs for 3, then one change each
  // brings 2.
  const Job job = make_job(7, 3, Amount{}, units(1));
  EXPECT_EQ(most_pairs_within(job, units(2)), 1U);
  EXPECT_EQ(most_pairs_within(job, units(3)), 3U);
  EXPECT_EQ(most_pairs_within(job, units(4)), 5U);
  EXPECT_EQ(most_pairs_within(job, units(400)), 21U);
}

// The mean cost at which a unit of weight is met.
double waits(const Job& job, const std::vector<Block>& setups) {
  double sum = 0;
  for (const RunStep& step : run_sheet(job, setups).steps) {
    for (const auto& [x, y] : step.new_pairs) {
      sum += static_cast<double>(job.weights(x, y).millionths) * 1e-12 *
             static_cast<double>(step.cost_so_far.millionths);
    }
  }
  return sum;
}

TEST(Weighted, HeavyPairsMeetEarlyAtNoMoreCost) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Job job = seed % 2 == 0 ? test::random_job(seed, 9) : test::random_job_with_slots(seed, 9);
    const RunPlan light = planned(job);
    weigh_at_random(job, seed);
    RunControl control({});
    const std::vector<Block> setups = heavy_first(job, light.candidates.front().setups, control);
    const RunSheet sheet = run_sheet(job, setups);
    EXPECT_TRUE(sheet.does_the_job());
    EXPECT_LE(sheet.cost, light.sheet.cost);
    EXPECT_LE(waits(job, setups), waits(job, light.candidates.front().setups) + 1e-9);
    EXPECT_EQ(planned(job).sheet.cost, light.sheet.cost);
  }
}

TEST(Weighted, TheHeavyPairIsInTheFirstTest) {
  Job job = make_job(9, 3, units(1), units(5));
  job.weights.set(6, 8, units(100));
  const RunPlan plan = planned(job);
  const Block& first = plan.sheet.steps.front().setup;
  EXPECT_EQ(std::count(first.begin(), first.end(), 6) + std::count(first.begin(), first.end(), 8),
            2);
  EXPECT_EQ(plan.sheet.cost, units(117));
  EXPECT_EQ(plan.sheet.weight_needed, units(135));
  EXPECT_EQ(plan.sheet.weight_tested, units(135));
  EXPECT_GE(plan.sheet.steps.front().weight_so_far, units(102));
}

TEST(Weighted, TheSameForAnyNumberOfThreads) {
  Job job = make_job(12, 4, units(2), units(1));
  weigh_at_random(job, 5);
  const RunPlan once = planned(job, {.budget = units(30)});
  EXPECT_EQ(planned(job, {.budget = units(30)}, 3).candidates.front().setups,
            once.candidates.front().setups);
}

TEST(Weighted, NeverFewerThanTheBeginningAndAddedToWhatComesFirst) {
  Job job = make_job(10, 4, units(2), units(1));
  weigh_at_random(job, 8);
  job.first = {{0, 1, 2}, {7, 8}};
  const RunPlan plan = planned(job, {.budget = units(28)});
  EXPECT_LE(plan.sheet.cost, units(28));
  ASSERT_TRUE(plan.most_weight);
  EXPECT_GE(*plan.most_weight, plan.sheet.weight_tested);
  for (const Candidate& c : plan.candidates) {
    EXPECT_LE(c.weight, plan.sheet.weight_tested);
    EXPECT_EQ(run_sheet(job, c.setups).weight_tested, c.weight);
  }
}

TEST(Weighted, NothingThatWeighsNothing) {
  Job job = make_job(5, 3, units(1), units(1));
  job.needed.for_each(1000, [&](Element x, Element y) { job.weights.set(x, y, {}); });
  const RunPlan plan = planned(job, {.budget = units(6)});
  EXPECT_EQ(plan.sheet.weight_needed, Amount{});
  EXPECT_EQ(plan.most_weight, Amount{});
}

TEST(Priorities, AreReadOrRefusedWithTheirPlace) {
  const std::vector<std::string> names{"a", "b", "c"};
  const auto read = [&](const std::string& text) {
    return read_priorities(*input_from_text(text, "p.csv"), names);
  };
  const auto complaint = [&](const std::string& text) -> std::string {
    return message_of([&] { (void)read(text); });
  };
  const PairWeights weights = read("part,part 2,weight\na,b,5\n3,2,0.25\nb,a,5\n");
  EXPECT_EQ(weights(1, 0), units(5));
  EXPECT_EQ(weights(1, 2), parse_amount("0.25"));
  EXPECT_EQ(weights(0, 2), units(1));
  EXPECT_FALSE(weights.weighs(0, 2));
  EXPECT_EQ(read("a;b;2,5\n")(0, 1), parse_amount("2.5"));
  EXPECT_THAT(complaint("a,b\n"), HasSubstr("p.csv:1:1: expected a pair with its weight"));
  EXPECT_THAT(complaint("a,b,-1\n"), HasSubstr("p.csv:1:5: '-1' is not a weight"));
  EXPECT_THAT(complaint("a,b,99999999999999\n"),
              HasSubstr("p.csv:1:5: '99999999999999' is not a weight"));
  EXPECT_THAT(complaint("a,b,2\na,b,heavy\n"), HasSubstr("p.csv:2:5: 'heavy' is not a weight"));
  EXPECT_THAT(complaint("a,x,2\n"), HasSubstr("p.csv:1:3: there is no part 'x'"));
  EXPECT_THAT(complaint("a,a,2\n"), HasSubstr("twice"));
  EXPECT_THAT(complaint("a,,2\n"), HasSubstr("only one part"));
  EXPECT_THAT(complaint("a,b,2\nb,a,3\n"), HasSubstr("p.csv:2:5: b and a have the weight 2"));
  EXPECT_THAT(complaint(""), HasSubstr("no pair is listed"));
}

}  // namespace
}  // namespace changeover::weighted_test
