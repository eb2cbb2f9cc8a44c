// Plans where change costs depend on what is replaced, against looking at all lists.
#include "replacing_jobs.hpp"

#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "changeover/plan/benches.hpp"
#include "changeover/plan/run_plan.hpp"
#include "cheapest.hpp"
#include "message_of.hpp"
#include "plan/job/prices.hpp"
#include "plan/search/lists/lists_search.hpp"
#include "random_jobs.hpp"

namespace changeover::replacing_test {
namespace {

RunPlan planned(const Job& job, PlanOptions options = {}, unsigned threads = 1) {
  options.steps = options.steps == 0 ? 20'000 : options.steps;
  options.design_moves = 0;
  RunControl control({.threads = threads});
  return make_run_plan(job, options, control);
}

// Costs by what is replaced that do not depend on it.
Job with_equal_columns(Job job) {
  for (std::size_t out = 0; out < job.names.size(); ++out) {
    job.replace_costs.insert(job.replace_costs.end(), job.change_costs.begin(),
                             job.change_costs.end());
  }
  return job;
}

// Some set-ups that the job allows.
std::vector<Block> some_setups(const Job& job, std::uint64_t seed) {
  Random random(seed, 3);
  std::vector<Block> setups;
  while (setups.size() < 8) {
    Block setup = job.mounted;
    for (Element x = 0; x < job.parts(); ++x) {
      const bool there = std::find(setup.begin(), setup.end(), x) != setup.end();
      if (!there && setup.size() < job.room() && random.one_in_two()) {
        setup.push_back(x);
      }
    }
    if (!setup_defect(job, setup)) {
      setups.push_back(setup);
    } else if (random.below(200) == 0) {
      break;
    }
  }
  return setups;
}

TEST(Replacing, NoPlanAndNoBoundBeatsTheCheapestOfAllLists) {
  unsigned cheapest = 0;
  unsigned jobs = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Job plain = seed % 3 == 0 ? test::random_job_with_slots(seed, 5)
                                    : test::random_job(seed, 5, seed % 2 == 0);
    const Job job = test::replacing(plain, seed);
    const RunPlan plan = planned(job);
    const std::uint64_t least = test::least_cost_of_replacing(job);
    EXPECT_TRUE(plan.sheet.does_the_job());
    EXPECT_GE(plan.sheet.cost.millionths, least) << "seed " << seed;
    EXPECT_LE(cost_bound(job).cost.millionths, least) << "seed " << seed;
    ++jobs;
    cheapest += plan.sheet.cost.millionths == least ? 1U : 0U;
  }
  EXPECT_GE(cheapest + 1, jobs);  // the search misses one of them
}

TEST(Replacing, EqualColumnsAreOrdinaryCosts) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Job plain = test::random_job(seed, 6);
    const Job job = with_equal_columns(plain);
    const std::vector<Block> setups = some_setups(plain, seed);
    const RunSheet sheet = run_sheet(job, setups);
    EXPECT_EQ(sheet.cost, run_sheet(plain, setups).cost);
    EXPECT_EQ(sheet.change_cost, run_sheet(plain, setups).change_cost);
    EXPECT_EQ(cost_bound(job).cost, cost_bound(plain).cost);
    const Weights weights = Weights::of(job, 100);
    EXPECT_EQ(Lists(job, weights, {setups}).total(),
              Lists(plain, Weights::of(plain, 100), {setups}).total());
    if (seed < 12) {
      EXPECT_EQ(planned(job).sheet.cost.millionths, test::least_cost(plain)) << "seed " << seed;
    }
  }
}

TEST(Replacing, TheSearchCountsAsTheRefereeDoes) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Job job = test::replacing(
        seed % 2 == 0 ? test::random_job(seed, 9) : test::random_job_with_slots(seed, 9), seed);
    for (Amount& cost : job.replace_costs) {  // no cost is nothing, which weighs a millionth
      cost = cost + Amount{1};
    }
    for (Amount& cost : job.change_costs) {
      cost = cost + Amount{1};
    }
    const std::vector<Block> setups = some_setups(job, seed);
    const auto total = Lists(job, Weights::of(job, 100), {setups}).total();
    EXPECT_EQ(static_cast<std::uint64_t>(total), run_sheet(job, setups).cost.millionths);
  }
}

TEST(Replacing, NoListCostsLessThanAtTheLeastPrices) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Job job = test::replacing(
        seed % 2 == 0 ? test::random_job(seed, 7) : test::random_job_with_slots(seed, 7), seed);
    const std::vector<Block> setups = some_setups(job, seed);
    const Amount cost = run_sheet(job, setups).cost;
    EXPECT_LE(run_sheet(at_prices(job, Price::least), setups).cost, cost);
  }
}

TEST(Replacing, GoingOnCostsWhatTheSheetSaid) {
  const Job job = test::replacing(make_job(8, 3, Amount{1'000'000}, Amount{2'000'000}), 5);
  const RunPlan plan = planned(job);
  Job rest = job;
  std::vector<Block> done;
  std::vector<Block> left;
  for (const RunStep& step : plan.sheet.steps) {
    (done.size() < 4 ? done : left).push_back(step.setup);
  }
  mark_done(rest, done);
  const RunPlan on = planned(rest, {.rest = left});
  EXPECT_LE(on.sheet.cost, plan.sheet.cost - plan.sheet.steps[3].cost_so_far);
}

TEST(Replacing, BudgetsFirstTestsAndTriples) {
  Job job = test::replacing(make_job(7, 3, Amount{1'000'000}, Amount{2'000'000}), 9);
  const RunPlan whole = planned(job);
  const Amount half{whole.sheet.cost.millionths / 2};
  std::uint64_t at_least = 0;
  for (const RunStep& step : whole.sheet.steps) {
    at_least += step.cost_so_far <= half ? step.new_pairs.size() : 0;
  }
  const RunPlan within = planned(job, {.budget = half});
  EXPECT_LE(within.sheet.cost, half);
  EXPECT_GE(within.sheet.pairs_tested, at_least);
  ASSERT_TRUE(within.complete);
  EXPECT_GE(within.complete->cost, within.bound.cost);

  job.first = {{3, 5}, {0, 1, 2}};
  const RunPlan first = planned(job);
  EXPECT_TRUE(first.sheet.does_the_job());
  EXPECT_EQ(first.sheet.steps[1].setup, (Block{0, 1, 2}));
  EXPECT_GE(first.sheet.cost, first.bound.cost);

  job.first.clear();
  job.at_once = 4;
  EXPECT_EQ(need_triples(job), 0U);
  const RunPlan triples = planned(job);
  EXPECT_TRUE(triples.sheet.does_the_job());
  EXPECT_GE(triples.sheet.cost, triples.bound.cost);
}

// All ways to share the pairs between two benches, each with its cheapest list.
TEST(Replacing, OnTwoBenchesNoPlanAndNoBoundBeatsTheBestOfAllWays) {
  unsigned best = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Job job = test::replacing(
        make_job(4, 2 + seed % 2, Amount{1'000'000}, Amount{(1 + seed % 4) * 1'000'000}), seed);
    std::vector<std::pair<Element, Element>> pairs;
    job.needed.for_each(1000, [&](Element x, Element y) { pairs.emplace_back(x, y); });
    std::vector<std::uint64_t> costs;
    for (std::size_t mask = 0; mask < std::size_t{1} << pairs.size(); ++mask) {
      Job some = job;
      some.needed = PairSet(4);
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        if ((mask >> i & 1U) != 0) {
          some.needed.insert(pairs[i].first, pairs[i].second);
        }
      }
      costs.push_back(test::least_cost_of_replacing(some));
    }
    std::uint64_t largest = costs.back();
    std::uint64_t together = costs.back();
    for (std::size_t mask = 0; mask < costs.size(); ++mask) {
      const std::uint64_t other = costs[costs.size() - 1 - mask];
      largest = std::min(largest, std::max(costs[mask], other));
      together = std::min(together, costs[mask] + other);
    }
    for (const BenchObjective objective : {BenchObjective::makespan, BenchObjective::cost}) {
      RunControl control({.threads = 1});
      const BenchPlan plan = make_bench_plan(
          job, {.benches = 2, .objective = objective, .plan = {.steps = 20'000, .design_moves = 0}},
          control);
      EXPECT_TRUE(plan.does_the_job());
      EXPECT_GE(plan.makespan.millionths, largest) << "seed " << seed;
      EXPECT_LE(plan.makespan_bound.millionths, largest) << "seed " << seed;
      EXPECT_GE(plan.cost.millionths, together) << "seed " << seed;
      EXPECT_LE(plan.bound.cost.millionths, together) << "seed " << seed;
      best += objective == BenchObjective::makespan
                  ? (plan.makespan.millionths == largest ? 1U : 0U)
                  : (plan.cost.millionths == together ? 1U : 0U);
    }
  }
  EXPECT_EQ(best, 8U);
}

TEST(Replacing, TheSameForAnyNumberOfThreads) {
  const Job job = test::replacing(make_job(9, 4, Amount{1'000'000}, Amount{2'000'000}), 2);
  const RunPlan one = planned(job);
  const RunPlan two = planned(job, {}, 2);
  EXPECT_EQ(one.candidates.front().setups, two.candidates.front().setups);
}

TEST(Replacing, StopsAtOnceWithAPlan) {
  const Job job = test::replacing(make_job(30, 5, Amount{1'000'000}, Amount{2'000'000}), 2);
  RunControl control({.threads = 1});
  control.stop(WhyStopped::interrupted);
  const RunPlan plan = make_run_plan(job, {}, control);
  EXPECT_TRUE(plan.sheet.does_the_job());
}

TEST(Replacing, WhatIsNotDoneIsRefused) {
  const Job job = test::replacing(make_job(6, 3, Amount{1}, Amount{2}), 1);
  RunControl control({.threads = 1});
  const RunPlan plan = planned(job);
  std::uint64_t exchanged = 0;
  EXPECT_REFUSAL((void)shuffled(job, plan, 1, exchanged), BadInput,
                 "does not support change costs by what is replaced; leave one of them out");
  Job weighed = job;
  weighed.weights.set(0, 1, Amount{5});
  EXPECT_REFUSAL((void)make_run_plan(weighed, {}, control), BadInput,
                 "does not support change costs by what is replaced; leave one of them out");
  Job cut = job;
  cut.replace_costs.pop_back();
  EXPECT_FALSE(defects(cut).empty());
}

}  // namespace
}  // namespace changeover::replacing_test
