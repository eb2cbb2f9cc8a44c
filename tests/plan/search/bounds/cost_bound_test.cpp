#include "changeover/plan/run_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "cheapest.hpp"
#include "random_jobs.hpp"

namespace changeover::cost_bound_test {
namespace {

Amount units(std::uint64_t n) { return Amount{n * 1'000'000}; }

TEST(CostBound, IsAttainedInTheScenariosOfThePaper) {
  EXPECT_EQ(cost_bound(make_job(9, 3, units(10), units(1))).cost, units(145));
  const CostBound bound = cost_bound(make_job(9, 3, units(1), units(5)));
  EXPECT_EQ(bound.cost, units(117));
  EXPECT_EQ(bound.tests, 12U);
  EXPECT_EQ(bound.introductions, 20U);
}

TEST(CostBound, IsNeverAboveTheCheapestPlanOfTinyJobs) {
  std::uint64_t jobs = 0;
  std::uint64_t attained = 0;
  for (std::uint64_t v = 2; v <= 6; ++v) {
    for (std::uint64_t k = 2; k <= std::min<std::uint64_t>(v, 4); ++k) {
      for (const auto& [test, change] :
           {std::pair{1, 1}, {1, 5}, {10, 1}, {0, 1}, {1, 0}, {3, 2}}) {
        if (v == 6 && (test + change == 1 || k == 2)) {
          continue;  // the brute force takes long
        }
        const Job job = make_job(v, k, units(static_cast<std::uint64_t>(test)),
                                 units(static_cast<std::uint64_t>(change)));
        const auto least = test::least_cost(job);
        ASSERT_TRUE(least.has_value());
        const CostBound bound = cost_bound(job);
        EXPECT_LE(bound.cost.millionths, *least) << v << ' ' << k << ' ' << test << ' ' << change;
        EXPECT_FALSE(bound.reason.empty());
        ++jobs;
        attained += bound.cost.millionths == *least ? 1U : 0U;
      }
    }
  }
  EXPECT_GE(attained * 10, jobs * 7) << "a bound so weak says little";
}

TEST(CostBound, IsNeverAboveTheCheapestPlanWhateverTheConstraints) {
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    const Job job = test::random_job(seed, 5);
    const auto least = test::least_cost(job);
    ASSERT_TRUE(least.has_value()) << seed;
    EXPECT_LE(cost_bound(job).cost.millionths, *least) << seed;
  }
}

TEST(CostBound, OfPartsWithSixAndTheirOwnCosts) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Job job = test::random_job(seed, 6, seed % 2 == 0);
    const auto least = test::least_cost(job);
    ASSERT_TRUE(least.has_value()) << seed;
    EXPECT_LE(cost_bound(job).cost.millionths, *least) << seed;
  }
}

// The least number of changes, or of tests, of any list.
std::uint64_t least_number_of(Job job, bool of_changes) {
  job.test_cost = Amount{of_changes ? 0U : 1U};
  std::ranges::fill(job.change_costs, Amount{of_changes ? 1U : 0U});
  return test::least_cost(job).value_or(0);
}

TEST(CostBound, CountsNoMoreThanTheFewestChangesAndTests) {
  std::uint64_t by_cost = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Job job = seed % 4 == 0 ? test::random_job_with_slots(seed, 5) : test::random_job(seed, 5);
    if (seed % 3 == 0) {
      std::ranges::fill(job.change_costs, Amount{});
      job.test_cost = units(1);
    } else if (seed % 3 == 1) {
      job.test_cost = Amount{};
    }
    const CostBound bound = cost_bound(job);
    EXPECT_LE(bound.introductions, least_number_of(job, true)) << seed;
    EXPECT_LE(bound.tests, least_number_of(job, false)) << seed;
    const Amount costliest = *std::ranges::max_element(job.change_costs);
    if (job.test_cost == Amount{} && costliest > Amount{}) {
      EXPECT_LE(bound.cost, costliest * bound.introductions) << seed;
      ++by_cost;
    }
  }
  EXPECT_GT(by_cost, 100U);
}

// Six slots with two parts each: where only changes cost something, 17 of them cost 17.
TEST(CostBound, OfChangesAloneIsTheirNumber) {
  Job job = make_job(12, 6, Amount{}, units(1));
  for (Element x = 0; x < 12; ++x) {
    job.slot_of.push_back(x / 2);
  }
  for (const char* name : {"A", "B", "C", "D", "E", "F"}) {
    job.slots.push_back({name, 1, 1});
  }
  drop_needed(job, cannot_meet(job));
  const CostBound bound = cost_bound(job);
  EXPECT_EQ(bound.cost, units(17));
  EXPECT_EQ(bound.introductions, 17U);
  EXPECT_NE(bound.reason.find("so 17 changes"), std::string::npos) << bound.reason;
  job.test_cost = units(1);
  RunControl control({.threads = 1});
  const RunPlan plan = make_run_plan(job, {.steps = 1000, .attempts = 1}, control);
  EXPECT_GE(plan.sheet.changes, plan.bound.introductions);
}

TEST(CostBound, IsNothingWhenNothingIsLeft) {
  Job job = make_job(4, 2, units(1), units(1));
  job.needed = PairSet(4);
  EXPECT_EQ(cost_bound(job).cost, Amount{});
  EXPECT_EQ(cost_bound(job).tests, 0U);
}

TEST(CostBound, OfPairsThatStayMountedIsThatOfOneTest) {
  for (const std::uint64_t mounted : {2U, 3U, 4U}) {
    for (const std::uint64_t room : {mounted, mounted + 1}) {
      Job job = make_job(5, room, units(7), units(2));
      job.needed = PairSet(5);
      for (Element x = 0; x < mounted; ++x) {
        job.mounted.push_back(x);
        for (Element y = 0; y < x; ++y) {
          job.needed.insert(x, y);
        }
      }
      const CostBound bound = cost_bound(job);
      EXPECT_EQ(bound.cost, units(7 + 2 * mounted)) << mounted << ' ' << room;
      EXPECT_EQ(bound.tests, 1U);
      EXPECT_EQ(bound.introductions, mounted);
      EXPECT_EQ(bound.cost.millionths, test::least_cost(job));
    }
  }
}

TEST(CostBound, CountsLargeJobs) {
  const CostBound bound = cost_bound(make_job(1000, 10, units(1), units(1)));
  EXPECT_GT(bound.cost, units(66'000));
  EXPECT_LT(bound.cost, units(90'000));
}

TEST(CostBound, IsWeakerButTrueWhenItIsStopped) {
  std::atomic<bool> interrupted = true;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Job job = test::random_job(seed, 8);
    const CostBound whole = cost_bound(job);
    RunControl control({.interrupted = &interrupted});
    const RunScope scope(control);
    const CostBound soon = cost_bound(job);
    EXPECT_LE(soon.cost, whole.cost) << seed;
    EXPECT_FALSE(soon.reason.empty());
  }
}

TEST(CostBound, CountsWithTheLargestCosts) {
  const Amount large = parse_amount("30000000000");
  const Amount one = parse_amount("1");
  EXPECT_EQ(cost_bound(make_job(20, 3, large, large)).cost.millionths,
            cost_bound(make_job(20, 3, one, one)).cost.millionths * 30'000'000'000U);
  EXPECT_THROW((void)cost_bound(make_job(40, 3, large, large)), ImpossibleParameters);
}

}  // namespace
}  // namespace changeover::cost_bound_test
