// How often some parts come at least, whatever the others do [docs/theorems.md, Theorem 28].
#include "plan/search/bounds/costly_walk.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "changeover/plan/run_plan.hpp"
#include "changeover/run/control.hpp"
#include "cheapest.hpp"
#include "plan/search/bounds/costliest_parts.hpp"
#include "plan/search/bounds/step_bound.hpp"
#include "random_jobs.hpp"

namespace changeover::costly_walk_test {
namespace {

constexpr std::uint64_t money = 1'000'000;
constexpr std::uint64_t enough = 1'000'000;  // states

// The walk of these parts of a job, by their numbers there.
CostlyWalk walk_of(const Job& job, const std::vector<bool>& chosen) {
  Amount mounting;
  const CostliestParts parts = costliest_parts_of(job, mounting).value();
  const JobNumbers n = numbers_of(job);
  std::vector<std::size_t> numbers;
  for (std::size_t x = 0; x < n.parts.size(); ++x) {
    if (chosen[n.parts[x]]) {
      numbers.push_back(x);
    }
  }
  return {job, n, StepGroups(job, n, parts), parts.at_start, numbers};
}

bool has_walk(const Job& job) {
  Amount mounting;
  return costliest_parts_of(job, mounting).has_value();
}

// The most that is proved.
std::uint64_t least_times(const CostlyWalk& walk) {
  std::uint64_t times = 0;
  for (std::uint64_t states = enough; walk.comes_more_than(times, states); states = enough) {
    ++times;
  }
  return times;
}

TEST(CostlyWalk, ProvesNoMoreThanTheLeastOfSmallJobs) {
  std::uint64_t looked = 0;
  std::uint64_t attained = 0;
  for (std::uint64_t seed = 1; seed <= 900; ++seed) {
    Job job = seed % 3 == 0 ? test::random_job(seed, 5) : test::random_job_with_slots(seed, 5);
    if (!has_walk(job)) {
      continue;
    }
    // Only the chosen parts cost something, each time that they come.
    Random random(seed, 28);
    std::vector<bool> chosen(job.names.size());
    job.test_cost = Amount{};
    const JobNumbers n = numbers_of(job);
    for (Amount& cost : job.change_costs) {
      cost = Amount{};
    }
    for (const Element x : n.parts) {
      chosen[x] = random.below(3) > 0;
      job.change_costs[x] = Amount{chosen[x] ? money : 0};
    }
    const std::uint64_t least = test::least_cost(job).value() / money;
    const std::uint64_t proved = least_times(walk_of(job, chosen));
    EXPECT_LE(proved, least) << seed;
    ++looked;
    attained += proved == least ? 1U : 0U;
  }
  EXPECT_GT(looked, 700U);
  EXPECT_GT(attained, looked * 9 / 10);
}

// Four slots of one place: one expensive part in each of the first two, three in each of the
// others, of
// which three pairs must not meet, and one that costs nothing in each.
Job staircase() {
  Job job = make_job(12, 4, Amount{}, Amount{});
  job.slot_of = {0, 1, 2, 2, 2, 3, 3, 3, 0, 1, 2, 3};
  for (std::uint32_t s = 0; s < 4; ++s) {
    job.slots.push_back({"s" + std::to_string(s), 1, 1});
  }
  for (Element x = 0; x < 8; ++x) {
    job.change_costs[x] = Amount{money};
  }
  job.never.insert(3, 6);
  job.never.insert(3, 7);
  job.never.insert(4, 7);
  job.needed = all_pairs_but(job.never);
  drop_needed(job, cannot_meet(job));
  return job;
}

TEST(CostlyWalk, CountsWhatPairsOfSlotsDoNot) {
  const Job job = staircase();
  std::vector<bool> costly(12, false);
  std::fill(costly.begin(), costly.begin() + 8, true);
  // Of every two slots, (4) of Theorem 18 asks for 2, 4 and 7, which 1 + 1 + 7 satisfy.
  EXPECT_EQ(least_times(walk_of(job, costly)), 10U);
  CostBound bound;
  bound.tests = 1;
  raise_by_steps(job, "at least 1 test", bound);
  EXPECT_EQ(to_string(bound.cost), "10");
  EXPECT_NE(bound.reason.find("the 8 most expensive parts are put in at least 10 times in all"),
            std::string::npos)
      << bound.reason;
  RunControl control({.threads = 1});
  EXPECT_EQ(to_string(make_run_plan(job, {}, control).sheet.cost), "10");
}

TEST(CostlyWalk, SaysNothingWithoutStates) {
  const Job job = staircase();
  std::vector<bool> costly(12, false);
  std::fill(costly.begin(), costly.begin() + 8, true);
  const CostlyWalk walk = walk_of(job, costly);
  std::uint64_t states = 50;
  EXPECT_FALSE(walk.comes_more_than(9, states));
  EXPECT_EQ(states, 0U);
  states = enough;
  EXPECT_TRUE(walk.comes_more_than(9, states));
  EXPECT_GT(states, 0U);
}

TEST(CostlyWalk, IsForFewParts) {
  const Job job = make_job(20, 4, Amount{}, Amount{money});
  EXPECT_FALSE(walk_of(job, std::vector<bool>(20, true)).fits());
}

}  // namespace
}  // namespace changeover::costly_walk_test
