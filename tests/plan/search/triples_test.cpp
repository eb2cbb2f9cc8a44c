// Plans in which every three parts meet.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "changeover/core/error.hpp"
#include "cheapest.hpp"
#include "plan/search/lists/lists_search.hpp"
#include "plan/search/triple_plan.hpp"
#include "random_jobs.hpp"

namespace changeover::triples_test {
namespace {

Amount units(std::uint64_t n) { return Amount{n * 1'000'000}; }

Job triple_job(std::uint64_t v, std::uint64_t k, std::uint64_t test, std::uint64_t change) {
  Job job = make_job(v, k, units(test), units(change));
  EXPECT_EQ(need_triples(job), 0U);
  return job;
}

RunPlan planned(const Job& job, PlanOptions options = {}, unsigned threads = 1) {
  options.steps = options.steps == 0 ? 20'000 : options.steps;
  RunControl control({.threads = threads});
  return make_run_plan(job, options, control);
}

// In other words than run_sheet() has.
std::set<std::set<Element>> met_in(const std::vector<Block>& setups) {
  std::set<std::set<Element>> met;
  for (const Block& s : setups) {
    for (const Element x : s) {
      for (const Element y : s) {
        for (const Element z : s) {
          if (std::set<Element>{x, y, z}.size() == 3) {
            met.insert({x, y, z});
          }
        }
      }
    }
  }
  return met;
}

// A random job of few parts with constraints, in which triples must meet; nothing if none can.
Job random_triples(std::uint64_t seed, std::uint32_t most) {
  for (std::uint64_t turn = 0;; ++turn) {
    const std::uint64_t at = seed + 1000 * turn;
    Job job = seed % 2 == 0 ? test::random_job(at, most) : test::random_job_with_slots(at, most);
    need_triples(job);
    if (!job.triples.empty() && job.triples.size() <= 10) {
      return job;
    }
  }
}

TEST(Triples, TheCheapestPlanOfTinyJobs) {
  for (const auto& [v, k] : {std::pair{3U, 3U}, {4U, 3U}, {5U, 3U}, {5U, 4U}}) {
    for (const auto& [test, change] : {std::pair{1U, 1U}, {1U, 5U}, {10U, 1U}, {1U, 0U}}) {
      const Job job = triple_job(v, k, test, change);
      const RunPlan plan = planned(job);
      const std::uint64_t least = *test::least_cost(job);
      EXPECT_EQ(plan.sheet.cost.millionths, least) << v << k << test << change;
      EXPECT_LE(plan.bound.cost.millionths, least) << v << k << test << change;
      EXPECT_TRUE(plan.sheet.does_the_job());
      EXPECT_EQ(met_in(plan.candidates.front().setups).size(), job.triples.size());
    }
  }
}

TEST(Triples, HonourConstraintsAndBounds) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Job job = random_triples(seed, 5);
    const RunPlan plan = planned(job);
    const auto least = test::least_cost(job);
    ASSERT_TRUE(least) << seed;
    EXPECT_LE(plan.bound.cost.millionths, *least) << seed;
    EXPECT_EQ(plan.sheet.cost.millionths, *least) << seed;
    EXPECT_TRUE(plan.sheet.does_the_job());
    for (const Candidate& c : plan.candidates) {
      const auto met = met_in(c.setups);
      for (const Triple& t : job.triples) {
        EXPECT_TRUE(met.count({t[0], t[1], t[2]}) != 0) << seed;
      }
    }
  }
}

TEST(Triples, DesignsOfStrengthThreeAreAmongThePlans) {
  const RunPlan plan = planned(triple_job(8, 5, 1, 1), {.steps = 30'000});
  EXPECT_TRUE(std::any_of(plan.candidates.begin(), plan.candidates.end(), [](const Candidate& c) {
    return c.name == "single-change design" && c.tests() == 10;
  })) << "the linear one with 10 blocks of docs/theorems.md";
  EXPECT_GE(plan.sheet.cost, plan.bound.cost);
  // 4 + 10 changes and 10 tests cost 24; nothing is known that is cheaper.
  EXPECT_LE(plan.sheet.cost, units(24));
}

TEST(Triples, TheRefereeCountsThem) {
  const Job job = triple_job(4, 3, 1, 1);
  const RunSheet sheet = run_sheet(job, {{2, 1, 0}, {0, 1, 3}, {0, 1, 3}});
  EXPECT_EQ(sheet.triples_needed, 4U);
  EXPECT_EQ(sheet.triples_tested, 2U);
  EXPECT_EQ(sheet.steps[0].new_triples, (std::vector<Triple>{{0, 1, 2}}));
  EXPECT_TRUE(sheet.steps[2].new_triples.empty());
  EXPECT_FALSE(sheet.does_the_job());
  EXPECT_FALSE(run_sheet(job, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}}).does_the_job())
      << "all pairs, but not all triples";
  EXPECT_TRUE(run_sheet(job, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}).does_the_job());
}

TEST(Triples, WhatCannotMeetNeedNot) {
  Job job = make_job(6, 4, units(1), units(1));
  job.never.insert(0, 1);
  EXPECT_EQ(need_triples(job), 4U);
  EXPECT_EQ(job.triples.size(), 16U);
  EXPECT_EQ(job.needed.size(), 14U);
  EXPECT_TRUE(planned(job).sheet.does_the_job());
  Job large = make_job(101, 4, units(1), units(1));
  EXPECT_THROW((void)need_triples(large), BadInput);
}

TEST(Triples, BudgetsTestTheMost) {
  const Job job = triple_job(5, 4, 2, 1);
  const std::vector<std::uint64_t> least = test::least_costs(job);
  for (std::uint64_t budget = 0; budget <= 24; budget += 3) {
    int most = 0;
    for (std::size_t covered = 0; covered < least.size(); ++covered) {
      most = least[covered] <= units(budget).millionths ? std::max(most, std::popcount(covered))
                                                        : most;
    }
    const RunPlan plan = planned(job, {.budget = units(budget)});
    EXPECT_LE(plan.sheet.cost, units(budget));
    EXPECT_EQ(plan.sheet.triples_tested, static_cast<std::uint64_t>(most)) << budget;
  }
}

TEST(Triples, WhatIsDoneOrComesFirstNeedNotBeTestedAgain) {
  Job job = triple_job(6, 4, 2, 1);
  Job rest = job;
  mark_done(rest, {{0, 1, 2, 3}, {2, 3, 4, 5}});
  EXPECT_EQ(rest.triples.size(), 12U);
  EXPECT_TRUE(planned(rest).sheet.does_the_job());
  job.first = {{0, 1, 2, 3}, {2, 3, 4, 5}};
  const RunPlan plan = planned(job);
  EXPECT_TRUE(plan.sheet.does_the_job());
  EXPECT_EQ(plan.sheet.steps[1].setup, (Block{2, 3, 4, 5}));
  EXPECT_EQ(plan.sheet.triples_tested, 20U);
  const RunPlan going_on = planned(rest, {.rest = {{0, 1, 4, 5}, {0, 2, 4}}});
  EXPECT_TRUE(going_on.sheet.does_the_job());
}

TEST(Triples, TheSameForAnyNumberOfThreadsAndWhenStopped) {
  const Job job = triple_job(10, 5, 2, 1);
  EXPECT_EQ(planned(job).candidates.front().setups, planned(job, {}, 3).candidates.front().setups);
  RunControl control({.time = std::chrono::seconds(0)});
  EXPECT_TRUE(make_run_plan(job, {}, control).sheet.does_the_job());
}

// What is kept up to date under moves and their undoing must equal what is counted again.
TEST(Lists, KeepCountUnderAllMoves) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Job job = seed % 2 == 0 ? test::random_job(seed, 8) : triple_job(7, 4, seed, 2);
    job.weights.set(0, 1, units(7));
    const Weights weights = Weights::of(job, 100);
    Lists lists(job, weights, {{{0, 1}, {1, 2}, {0, 2}}, {{2, 1, 0}}, {}});
    Random random(seed, 1);
    const auto below = [&](std::size_t n) { return random.below(static_cast<std::uint32_t>(n)); };
    for (int i = 0; i < 300; ++i) {
      for (int move = 0; move < 3; ++move) {
        const Spot at = lists.spot(below(lists.tests()));
        const Element x = below(job.parts());
        switch (below(6)) {
          case 0:
            if (!lists.holds(at, x)) {
              lists.replace(at, lists.setup(at).size() > 2 ? lists.setup(at)[0] : no_part, x);
            }
            break;
          case 1:
            if (lists.tests() > 2) {
              lists.take_out(at);
            }
            break;
          case 2:
            lists.insert(at, Block{x, static_cast<Element>((x + 1) % job.parts())});
            break;
          case 3:
            lists.reverse(at.bench, {at.at, lists.tests(at.bench) - 1});
            break;
          default: {
            const std::size_t count = 1 + below(lists.tests(at.bench) - at.at);
            const std::size_t to = below(3);
            const std::size_t left = lists.tests(to) - (to == at.bench ? count : 0);
            lists.move(at, count, {to, below(left + 1)});
          }
        }
      }
      random.one_in_two() ? lists.keep() : lists.undo();
      const Lists anew(job, weights, lists.lists());
      ASSERT_EQ(anew.total(), lists.total());
      ASSERT_EQ(anew.largest(), lists.largest());
      ASSERT_EQ(anew.missing(), lists.missing());
      ASSERT_EQ(anew.open(), lists.open());
      for (std::size_t open = 0; open < lists.open(); ++open) {
        const auto target = lists.open_target(open);
        for (std::size_t at = 0; at < lists.tests(); ++at) {
          ASSERT_FALSE(lists.holds(lists.spot(at), target[0]) &&
                       lists.holds(lists.spot(at), target[1]) &&
                       (target[2] == no_part || lists.holds(lists.spot(at), target[2])));
        }
      }
    }
  }
}

}  // namespace
}  // namespace changeover::triples_test
