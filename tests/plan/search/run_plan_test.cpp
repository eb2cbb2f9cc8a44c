#include "changeover/plan/run_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>

#include "changeover/core/error.hpp"
#include "cheapest.hpp"
#include "random_jobs.hpp"

namespace changeover::run_plan_test {
namespace {

Amount units(std::uint64_t n) { return Amount{n * 1'000'000}; }

RunPlan planned(const Job& job, PlanOptions options = {}, unsigned threads = 1,
                std::uint64_t seed = 1) {
  options.design_moves = std::min<std::uint64_t>(options.design_moves, 20'000);
  RunControl control({.threads = threads, .seed = seed});
  return make_run_plan(job, options, control);
}

const Candidate& candidate(const RunPlan& plan, const std::string& name) {
  for (const Candidate& c : plan.candidates) {
    if (c.name == name) {
      return c;
    }
  }
  throw std::runtime_error("no candidate is called " + name);
}

// The constraints and the cost once more, in other words than run_sheet() has.
void expect_sound(const Job& job, const std::vector<Block>& setups, Amount cost, bool complete) {
  std::uint64_t total = 0;
  std::set<Element> bench(job.start.begin(), job.start.end());
  std::set<std::pair<Element, Element>> met;
  for (const Block& setup : setups) {
    const std::set<Element> now(setup.begin(), setup.end());
    ASSERT_EQ(now.size(), setup.size());
    ASSERT_LE(now.size(), job.at_once);
    for (const Element m : job.mounted) {
      ASSERT_TRUE(now.count(m));
    }
    total += job.test_cost.millionths;
    for (const Element x : now) {
      total += bench.count(x) ? 0 : job.change_costs[x].millionths;
      for (const Element y : now) {
        if (x < y) {
          ASSERT_FALSE(job.never.contains(x, y));
          met.emplace(x, y);
        }
      }
    }
    bench = now;
  }
  EXPECT_EQ(total, cost.millionths);
  if (complete) {
    job.needed.for_each(1'000'000, [&](Element x, Element y) { EXPECT_TRUE(met.count({x, y})); });
  }
}

TEST(RunPlan, ReproducesTheCostsOfThePaperAndBeatsThem) {
  const RunPlan costly_changes = planned(make_job(9, 3, units(1), units(5)), {.steps = 200'000});
  EXPECT_EQ(candidate(costly_changes, "single-change design").cost, units(118));
  EXPECT_EQ(candidate(costly_changes, "double-change design").cost, units(137));
  EXPECT_EQ(costly_changes.sheet.cost, units(117));
  EXPECT_TRUE(costly_changes.proved_cheapest());

  const RunPlan costly_tests = planned(make_job(9, 3, units(10), units(1)), {.steps = 50'000});
  EXPECT_EQ(candidate(costly_tests, "single-change design").cost, units(200));
  EXPECT_EQ(candidate(costly_tests, "double-change design").cost, units(145));
  EXPECT_EQ(costly_tests.sheet.cost, units(145));
  EXPECT_TRUE(costly_tests.proved_cheapest());
}

TEST(RunPlan, FindsTheCheapestPlanOfTinyJobs) {
  for (std::uint64_t v = 2; v <= 6; ++v) {
    for (std::uint64_t k = 2; k <= std::min<std::uint64_t>(v, 4); ++k) {
      for (const auto& [test, change] :
           {std::pair{1U, 1U}, {1U, 5U}, {10U, 1U}, {0U, 1U}, {1U, 0U}}) {
        if (v == 6 && (test + change == 1 || k == 2)) {
          continue;  // the brute force takes long
        }
        const Job job = make_job(v, k, units(test), units(change));
        const RunPlan plan = planned(job, {.steps = 20'000});
        EXPECT_EQ(plan.sheet.cost.millionths, test::least_cost(job))
            << v << ' ' << k << ' ' << test << ' ' << change;
        expect_sound(job, plan.candidates.front().setups, plan.sheet.cost, true);
      }
    }
  }
}

TEST(RunPlan, HonoursAllConstraintsAtTheLeastCost) {
  for (std::uint64_t seed = 1; seed <= 250; ++seed) {
    const Job job = test::random_job(seed, 5);
    const RunPlan plan = planned(job, {.steps = 10'000});
    for (const Candidate& c : plan.candidates) {
      expect_sound(job, c.setups, c.cost, true);
      EXPECT_GE(c.cost, plan.bound.cost);
    }
    EXPECT_TRUE(plan.sheet.does_the_job());
    EXPECT_EQ(plan.sheet.cost.millionths, test::least_cost(job)) << seed;
  }
}

TEST(RunPlan, HonoursTheConstraintsOfLargerJobs) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Job job = test::random_job(1000 + seed, 16);
    const RunPlan plan = planned(job, {.steps = 20'000, .attempts = 2});
    for (const Candidate& c : plan.candidates) {
      expect_sound(job, c.setups, c.cost, true);
      EXPECT_GE(c.cost, plan.bound.cost) << seed;
      EXPECT_GE(c.cost, plan.sheet.cost);
    }
  }
}

TEST(RunPlan, CostlyPartsStandWhereIntroductionsAreRare) {
  Job job = make_job(13, 4, units(1), units(1));
  for (Element x = 0; x < 3; ++x) {
    job.change_costs[x] = units(100);
  }
  const RunPlan plan = planned(job, {.steps = 50'000, .attempts = 2});
  std::uint64_t costly = 0;
  for (const RunStep& step : plan.sheet.steps) {
    for (const Element x : step.put_in) {
      costly += x < 3 ? 1U : 0U;
    }
  }
  EXPECT_EQ(costly, 3U);
}

// Where parts differ in price, lists with any number of changes a step are far cheaper than what
// they start from.
TEST(RunPlan, TheSearchLeavesItsStartsFarBehind) {
  for (const std::uint64_t test : {1U, 2U}) {
    Job job = make_job(30, 5, units(test), Amount{});
    for (Element x = 0; x < 30; ++x) {
      job.change_costs[x] = Amount{(1 + x * 7 % 19) * 500'000ULL};
    }
    const RunPlan plan = planned(job, {.steps = 1'500'000, .attempts = 1});
    ASSERT_EQ(plan.candidates.front().name, "local search");
    EXPECT_LT(plan.sheet.cost, plan.candidates[1].cost) << test;
    EXPECT_LT(plan.sheet.cost.millionths * 8, candidate(plan, "greedy list").cost.millionths * 7)
        << test;
  }
}

TEST(RunPlan, IsTheSameAgainForAnyNumberOfThreads) {
  Job job = make_job(12, 4, units(3), units(2));
  job.change_costs[5] = units(9);
  for (const std::optional<Amount>& budget : {std::optional<Amount>(), std::optional(units(60))}) {
    const PlanOptions options{.steps = 30'000, .budget = budget};
    const RunPlan once = planned(job, options);
    for (const unsigned threads : {1U, 3U}) {
      const RunPlan again = planned(job, options, threads);
      ASSERT_EQ(again.candidates.size(), once.candidates.size());
      for (std::size_t i = 0; i < once.candidates.size(); ++i) {
        EXPECT_EQ(again.candidates[i].setups, once.candidates[i].setups);
      }
      EXPECT_EQ(again.steps, once.steps);
    }
  }
}

TEST(RunPlan, TestsTheMostPairsThatABudgetPaysFor) {
  for (const auto& [v, k] : {std::pair{4U, 2U}, {5U, 3U}, {5U, 2U}}) {
    const Job job = make_job(v, k, units(2), units(1));
    const std::uint64_t all = *test::least_cost(job) / 1'000'000;
    std::uint64_t before = 0;
    for (std::uint64_t budget = 0; budget <= all + 2; budget += 2) {
      const RunPlan plan = planned(job, {.steps = 20'000, .budget = units(budget)});
      EXPECT_LE(plan.sheet.cost, units(budget));
      EXPECT_GE(plan.sheet.pairs_tested, before) << "more money, fewer pairs";
      before = plan.sheet.pairs_tested;
      std::uint64_t most = 0;
      for (std::uint64_t pairs = 1; pairs <= job.needed.size(); ++pairs) {
        most = *test::least_cost(job, pairs) <= units(budget).millionths ? pairs : most;
      }
      EXPECT_EQ(plan.sheet.pairs_tested, most) << v << ' ' << k << ' ' << budget;
      expect_sound(job, plan.candidates.front().setups, plan.sheet.cost, false);
      ASSERT_TRUE(plan.complete.has_value());
      EXPECT_EQ(plan.complete->cost, units(all));
    }
  }
}

TEST(RunPlan, TestsNoFewerPairsThanTheBeginningOfTheCheapestPlan) {
  const Job job = make_job(14, 4, units(2), units(1));
  for (const std::uint64_t budget : {10U, 25U, 40U, 60U}) {
    const RunPlan plan = planned(job, {.steps = 30'000, .attempts = 2, .budget = units(budget)});
    std::uint64_t beginning = 0;
    for (const RunStep& step : run_sheet(job, plan.complete->setups).steps) {
      beginning += step.cost_so_far <= units(budget) ? step.new_pairs.size() : 0;
    }
    EXPECT_GE(plan.sheet.pairs_tested, beginning);
    EXPECT_LE(plan.sheet.cost, units(budget));
  }
}

TEST(RunPlan, PlansTheRest) {
  const Job job = make_job(10, 4, units(2), units(3));
  const RunPlan whole = planned(job, {.steps = 30'000, .attempts = 2});
  const std::vector<Block>& setups = whole.candidates.front().setups;
  for (std::size_t done = 0; done <= setups.size(); ++done) {
    Job rest = job;
    mark_done(rest, {setups.begin(), setups.begin() + static_cast<std::ptrdiff_t>(done)});
    const RunPlan plan = planned(rest, {.steps = 5'000, .attempts = 1});
    EXPECT_TRUE(plan.sheet.does_the_job());
    if (done == setups.size()) {
      EXPECT_TRUE(plan.sheet.steps.empty());
      EXPECT_TRUE(plan.proved_cheapest());
    }
  }
}

TEST(RunPlan, StopsWhenItIsToldTo) {
  RunControl control({.time = std::chrono::seconds(0)});
  const RunPlan plan = make_run_plan(make_job(30, 5, units(1), units(1)), {}, control);
  EXPECT_TRUE(plan.sheet.does_the_job());
  EXPECT_EQ(plan.why_stopped, WhyStopped::time_limit);
}

TEST(RunPlan, RefusesWhatCannotBe) {
  Job job = make_job(5, 3, units(1), units(1));
  job.never.insert(0, 1);
  EXPECT_THROW((void)planned(job), BadInput);
  EXPECT_THROW((void)planned(make_job(100, 5, parse_amount("9000000000000"), units(1))),
               ImpossibleParameters);
}

TEST(RunPlan, MoreRoomThanPartsIsRoomForAll) {
  for (const std::uint64_t at_once :
       {std::uint64_t{9}, std::uint64_t{1} << 31, std::uint64_t{1} << 32,
        (std::uint64_t{1} << 63) - 1, std::uint64_t{1} << 63, ~std::uint64_t{0}}) {
    Job job = make_job(9, at_once, units(1), units(5));
    const RunPlan plan = planned(job);
    EXPECT_EQ(plan.sheet.steps.size(), 1U) << at_once;
    EXPECT_TRUE(plan.proved_cheapest());
    job.never.insert(0, 1);
    job.never.insert(2, 3);
    job.needed = all_pairs_but(job.never);
    const RunPlan other = planned(job, {.steps = 5000});
    EXPECT_TRUE(other.sheet.does_the_job());
    expect_sound(job, other.candidates.front().setups, other.sheet.cost, true);
  }
}

TEST(RunPlan, StoppedAtOnceItIsStillComplete) {
  std::atomic<bool> interrupted = true;
  for (const std::uint64_t at_once : {2U, 3U, 40U, 200U}) {
    Job job = make_job(400, at_once, units(1), units(5));
    if (at_once == 40) {
      for (Element x = 0; x + 1 < 400; ++x) {
        job.never.insert(x, x + 1);
      }
      job.needed = all_pairs_but(job.never);
    }
    RunControl control({.interrupted = &interrupted});
    const RunPlan plan = make_run_plan(job, {.until_stopped = true}, control);
    EXPECT_TRUE(plan.sheet.does_the_job());
    EXPECT_EQ(plan.why_stopped, WhyStopped::interrupted);
    EXPECT_LE(plan.bound.cost, plan.sheet.cost);
    EXPECT_EQ(plan.steps, 0U);
    if (at_once != 2) {
      expect_sound(job, plan.candidates.front().setups, plan.sheet.cost, true);
    }
    const WhatIf answer = what_if(job, plan, {}, control);
    EXPECT_EQ(answer.ranges.size(), 1U);
  }
}

// Without the limit it would not end.
TEST(RunPlan, OfAThousandPartsEndsByItsTimeLimit) {
  RunControl control({.time = std::chrono::milliseconds(200), .threads = 2});
  const RunPlan plan =
      make_run_plan(make_job(1000, 5, units(1), units(5)), {.until_stopped = true}, control);
  EXPECT_TRUE(plan.sheet.does_the_job());
  EXPECT_EQ(control.why_stopped(), WhyStopped::time_limit);
}

TEST(RunPlan, StoppedUnderABudgetItStaysWithinIt) {
  std::atomic<bool> interrupted = true;
  const Job job = make_job(100, 5, units(1), units(1));
  RunControl control({.interrupted = &interrupted});
  const RunPlan plan = make_run_plan(job, {.budget = units(50)}, control);
  EXPECT_LE(plan.sheet.cost, units(50));
  EXPECT_GT(plan.sheet.pairs_tested, 0U);
  ASSERT_TRUE(plan.complete);
  EXPECT_EQ(plan.complete->pairs_tested, job.needed.size());
}

TEST(RunPlan, CostsNearTheLargestAreStillSearched) {
  // 64 times the total would not fit in 64 bits, the total does.
  const Amount large = parse_amount("100000000000");
  const RunPlan plan = planned(make_job(9, 3, large, large), {.steps = 20'000});
  EXPECT_TRUE(plan.sheet.does_the_job());
  EXPECT_GT(plan.steps, 0U);
  const RunPlan small = planned(make_job(9, 3, units(1), units(1)), {.steps = 20'000});
  EXPECT_EQ(plan.sheet.cost, small.sheet.cost * 100'000'000'000U);
  const RunPlan within =
      planned(make_job(9, 3, large, large), {.steps = 20'000, .budget = large * 20});
  EXPECT_LE(within.sheet.cost, large * 20);
  EXPECT_GT(within.sheet.pairs_tested, 10U);
  EXPECT_THROW((void)planned(make_job(9, 3, large * 10, large * 10)), ImpossibleParameters);
}

TEST(RunPlan, AShortageLeavesWhatWasFoundBefore) {
  const Job job = make_job(60, 4, units(1), units(1));
  RunControl tiny({.memory_bytes = 1000});
  EXPECT_THROW((void)make_run_plan(job, {}, tiny), MissingResource);
  RunControl small({.memory_bytes = 290'000, .threads = 4});
  const RunPlan plan = make_run_plan(job, {.steps = 1000, .design_moves = 0}, small);
  ASSERT_TRUE(plan.shortage);
  EXPECT_THAT(*plan.shortage, testing::HasSubstr("searching among lists of"));
  EXPECT_TRUE(plan.sheet.does_the_job());
  EXPECT_EQ(plan.steps, 0U);
}

TEST(RunPlan, NoNumberOfStepsOverflows) {
  RunControl control({.time = std::chrono::milliseconds(100)});
  const RunPlan plan = make_run_plan(make_job(12, 4, units(1), units(1)),
                                     {.steps = ~std::uint64_t{0}, .design_moves = 1000}, control);
  EXPECT_TRUE(plan.sheet.does_the_job());
  EXPECT_LT(plan.steps, 1'000'000'000U) << "steps that were made, not those that were allowed";
}

}  // namespace
}  // namespace changeover::run_plan_test
