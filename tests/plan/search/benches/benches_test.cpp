// The tests of a job on several benches.
#include "changeover/plan/benches.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <ctime>

#include "changeover/core/error.hpp"
#include "cheapest.hpp"
#include "message_of.hpp"
#include "plan/search/benches/step_costs.hpp"
#include "random_jobs.hpp"
#include "replacing_jobs.hpp"
#include "run/random.hpp"

namespace changeover::benches_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

Amount units(std::uint64_t n) { return Amount{n * 1'000'000}; }

BenchPlan planned(const Job& job, BenchOptions options, unsigned threads = 1) {
  options.plan.steps = options.plan.steps == 0 ? 20'000 : options.plan.steps;
  options.plan.design_moves = 0;
  RunControl control({.threads = threads});
  return make_bench_plan(job, options, control);
}

// By what is covered at least: the least cost of a list for it, from an empty bench.
std::vector<std::uint64_t> costs_at_least(const Job& job) {
  std::vector<std::uint64_t> least = test::least_costs(job);
  for (std::size_t bit = 1; bit < least.size(); bit *= 2) {
    for (std::size_t mask = 0; mask < least.size(); ++mask) {
      if ((mask & bit) == 0) {
        least[mask] = std::min(least[mask], least[mask | bit]);
      }
    }
  }
  return least;
}

// The least largest cost of two or three benches, over all ways to share what has to meet.
std::uint64_t least_largest(const std::vector<std::uint64_t>& least, int benches) {
  std::vector<std::uint64_t> best = least;
  const std::size_t all = least.size() - 1;
  for (int more = 1; more < benches; ++more) {
    const std::vector<std::uint64_t> before = best;
    for (std::size_t mask = 0; mask <= all; ++mask) {
      for (std::size_t own = mask;; own = (own - 1) & mask) {
        best[mask] = std::min(best[mask], std::max(least[own], before[mask & ~own]));
        if (own == 0) {
          break;
        }
      }
    }
  }
  return best[all];
}

Job without_start(Job job) {
  job.start.clear();
  return job;
}

TEST(Benches, TheLeastLargestCostOfTinyJobs) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Job job = without_start(seed % 2 == 0 ? test::random_job(seed, 5)
                                                : test::random_job_with_slots(seed, 5));
    const std::vector<std::uint64_t> least = costs_at_least(job);
    for (const int benches : {2, 3}) {
      const BenchPlan plan = planned(job, {.benches = static_cast<std::uint64_t>(benches)});
      const std::uint64_t best = least_largest(least, benches);
      EXPECT_TRUE(plan.does_the_job());
      EXPECT_LE(plan.makespan_bound.millionths, best) << seed;
      EXPECT_LE(plan.bound.cost, plan.cost);
      EXPECT_EQ(plan.makespan.millionths, best) << seed << ' ' << benches;
    }
  }
}

TEST(Benches, TheLeastCostTogetherIsThatOfOneBench) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Job job = without_start(test::random_job(seed, 5));
    const BenchPlan plan = planned(job, {.benches = 2, .objective = BenchObjective::cost});
    EXPECT_EQ(plan.cost.millionths, test::least_cost(job)) << seed;
    EXPECT_LE(plan.makespan, plan.cost);
  }
}

TEST(Benches, NoWorseThanCuttingAndNoBetterThanTheBounds) {
  for (const auto& [v, k, benches] :
       {std::tuple{9U, 3U, 2U}, {12U, 4U, 3U}, {15U, 5U, 4U}, {6U, 3U, 9U}}) {
    const Job job = make_job(v, k, units(2), units(1));
    const BenchPlan plan = planned(job, {.benches = benches});
    EXPECT_EQ(plan.sheets.size(), benches);
    for (const BenchCandidate& c : plan.candidates) {
      EXPECT_GE(c.makespan, plan.makespan);
      EXPECT_GE(c.makespan, plan.makespan_bound);
      EXPECT_GE(c.cost, plan.bound.cost);
      const BenchCount count = count_benches(job, c.lists);
      EXPECT_TRUE(count.does_the_job()) << c.name;
      EXPECT_EQ(count.makespan, c.makespan);
      EXPECT_EQ(count.cost, c.cost);
    }
    std::uint64_t pairs = 0;
    for (const RunSheet& sheet : plan.sheets) {
      pairs += sheet.pairs_tested;
    }
    EXPECT_EQ(pairs, job.needed.size()) << "each pair is new on one bench";
  }
}

TEST(Benches, TheRefereeSeesWhatIsWrong) {
  Job job = make_job(4, 3, units(1), units(1));
  EXPECT_TRUE(count_benches(job, {{{0, 1, 2}}, {{0, 3}, {1, 2, 3}}}).does_the_job());
  EXPECT_FALSE(count_benches(job, {{{0, 1, 2}}, {{1, 2, 3}}}).does_the_job());
  const BenchCount count = count_benches(job, {{{0, 1, 2}}, {{0, 3}, {1, 2, 3}}});
  EXPECT_EQ(count.cost, units(4 + 6));
  EXPECT_EQ(count.makespan, units(6));
  EXPECT_EQ(count.sheets[1].pairs_tested, 3U);
  job.never.insert(1, 2);
  job.needed = all_pairs_but(job.never);
  EXPECT_THAT(count_benches(job, {{{0, 1}}, {{1, 2, 3}}}).faults,
              Contains(HasSubstr("Bench 2: set-up 1 holds 2 and 3, which must never meet")));
}

TEST(Benches, TriplesMeetOnSomeBench) {
  Job job = make_job(6, 4, units(1), units(1));
  need_triples(job);
  const BenchPlan plan = planned(job, {.benches = 2});
  EXPECT_TRUE(plan.does_the_job());
  EXPECT_EQ(plan.triples_tested, 20U);
  Job tiny = make_job(5, 4, units(1), units(1));
  need_triples(tiny);
  EXPECT_EQ(planned(tiny, {.benches = 2}).makespan.millionths,
            least_largest(costs_at_least(tiny), 2));
}

TEST(Benches, TheSameForAnyNumberOfThreadsAndWhenStopped) {
  const Job job = make_job(10, 4, units(2), units(1));
  EXPECT_EQ(planned(job, {.benches = 3}).candidates.front().lists,
            planned(job, {.benches = 3}, 3).candidates.front().lists);
  RunControl control({.time = std::chrono::seconds(0)});
  const BenchPlan stopped = make_bench_plan(job, {.benches = 3}, control);
  EXPECT_TRUE(stopped.does_the_job());
  EXPECT_GT(stopped.makespan_bound, Amount{});
  EXPECT_GE(stopped.makespan_bound * 3, stopped.bound.cost);
}

TEST(Benches, RefuseWhatTheyDoNotServe) {
  Job job = make_job(5, 3, units(1), units(1));
  EXPECT_REFUSAL((void)planned(job, {.benches = 0}), BadInput, "0 benches; give 1 to 64");
  EXPECT_REFUSAL((void)planned(job, {.benches = 65}), BadInput, "65 benches; give 1 to 64");
  EXPECT_REFUSAL((void)planned(job, {.plan = {.rest = {{0, 1}}}}), BadInput,
                 "tests that were done on several benches need the bench of each; give it");
  job.weights.set(0, 1, units(3));
  EXPECT_REFUSAL((void)planned(job, {}), BadInput,
                 "weights of pairs need a budget in plans for several benches; give one");
  EXPECT_NO_THROW((void)planned(job, {.plan = {.budget = units(3)}}));
}

TEST(Benches, StepsCostWhatSheetsSay) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Job job = test::random_job(seed, 9);
    if (seed % 2 == 1) {
      job = test::replacing(job, seed);
    }
    Random random(seed, 8);
    std::vector<Block> setups(random.below(6));
    for (Block& setup : setups) {
      for (auto x = static_cast<Element>(job.parts()); x-- > 0;) {  // in no order
        if (random.one_in_two() && setup.size() < job.at_once) {
          setup.push_back(x);
        }
      }
    }
    std::vector<Amount> expected;
    for (const RunStep& step : run_sheet(job, setups).steps) {
      expected.push_back(step.cost);
    }
    EXPECT_EQ(step_costs(job, setups), expected) << seed;
  }
}

// What a clock cannot interrupt takes no time for each pair of a test and of two parts.
TEST(Benches, OfAThousandPartsEndSoonAfterTheirTime) {
  constexpr std::uint64_t parts = 1'000;
  constexpr std::uint64_t room = 15;
  const Job job = make_job(parts, room, units(1), units(1));
  const auto begin = std::clock();
  RunControl control({.time = std::chrono::seconds(1)});
  const BenchPlan plan = make_bench_plan(job, {.benches = 3}, control);
  // Some 1.3 s of the processor; 200 s for four benches with room for ten when each test had its
  // own sheet.
  constexpr double most_seconds = 30;
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, most_seconds);
  EXPECT_EQ(plan.pairs_tested, parts * (parts - 1) / 2);
}

// Each bench lacks a part, so that none can test everything: there is a plan all the same, without
// time for any search.
TEST(Benches, AThousandPartsOfWhichNoBenchHasAll) {
  const Job job = make_job(1000, 3, units(1), units(1));
  BenchOptions options;
  for (Element missing = 0; missing < 4; ++missing) {
    options.each.push_back({.at_once = 3 + missing % 2, .without = {missing}});
  }
  options.plan.until_stopped = true;
  RunControl control({.time = std::chrono::seconds(0), .threads = 1});
  const auto begin = std::clock();
  const BenchPlan plan = make_bench_plan(job, options, control);
  constexpr double most_seconds = 10;  // of the processor; a list from nothing takes thirty
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, most_seconds);
  EXPECT_TRUE(plan.does_the_job());
  EXPECT_EQ(plan.candidates.front().name, "one bench after the other");
}

}  // namespace
}  // namespace changeover::benches_test
