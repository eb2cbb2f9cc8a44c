// Plans that begin with given set-ups.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "changeover/plan/run_plan.hpp"
#include "cheapest.hpp"
#include "message_of.hpp"
#include "random_jobs.hpp"

namespace changeover::first_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

Amount units(std::uint64_t n) { return Amount{n * 1'000'000}; }

RunPlan planned(const Job& job, PlanOptions options = {}) {
  options.steps = options.steps == 0 ? 10'000 : options.steps;
  options.design_moves = 0;
  RunControl control({.threads = 1});
  return make_run_plan(job, options, control);
}

// Some set-ups that break no rule, by trying at random.
std::vector<Block> some_setups(const Job& job, std::uint64_t seed) {
  Random random(seed, 55);
  std::vector<Block> setups;
  const std::size_t wanted = 1 + random.below(3);
  Job any = job;
  any.needed = PairSet(job.parts());
  while (setups.size() < wanted) {
    Block setup = job.mounted;
    for (Element x = 0; x < job.parts(); ++x) {
      if (random.below(2) == 0 && std::count(setup.begin(), setup.end(), x) == 0) {
        setup.push_back(x);
      }
    }
    if (!setup.empty() && run_sheet(any, {setup}).faults.empty()) {
      setups.push_back(setup);
    }
  }
  return setups;
}

// What is left, in other words than after_first() has.
Job left_after(const Job& job, const std::vector<Block>& setups) {
  Job rest = job;
  rest.start = setups.back();
  rest.needed = PairSet(job.parts());
  job.needed.for_each(1000, [&](Element x, Element y) {
    const bool met = std::any_of(setups.begin(), setups.end(), [&](const Block& s) {
      return std::count(s.begin(), s.end(), x) + std::count(s.begin(), s.end(), y) == 2;
    });
    if (!met) {
      rest.needed.insert(x, y);
    }
  });
  return rest;
}

TEST(First, TheCheapestListThatBeginsWithThem) {
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    Job job = seed % 2 == 0 ? test::random_job(seed, 5) : test::random_job_with_slots(seed, 5);
    const std::vector<Block> setups = some_setups(job, seed);
    const Amount given = run_sheet(job, setups).cost;
    const std::uint64_t least = *test::least_cost(left_after(job, setups));
    job.first = setups;
    const RunPlan plan = planned(job);
    EXPECT_TRUE(plan.sheet.does_the_job()) << seed;
    EXPECT_EQ(plan.sheet.cost.millionths, given.millionths + least) << seed;
    EXPECT_LE(plan.bound.cost, plan.sheet.cost);
    EXPECT_LE(cost_bound(job).cost, plan.sheet.cost);
    for (const Candidate& c : plan.candidates) {
      ASSERT_GE(c.setups.size(), setups.size());
      EXPECT_TRUE(std::equal(setups.begin(), setups.end(), c.setups.begin())) << seed;
      EXPECT_EQ(run_sheet(job, c.setups).cost, c.cost);
      EXPECT_GE(c.cost, plan.bound.cost);
    }
  }
}

TEST(First, TheRefereeMissesThem) {
  Job job = make_job(4, 3, units(1), units(1));
  job.first = {{2, 0}, {1, 3}};
  EXPECT_TRUE(run_sheet(job, {{0, 2}, {1, 3}, {0, 1, 2}, {0, 2, 3}}).does_the_job());
  EXPECT_THAT(run_sheet(job, {{0, 1, 2}, {1, 3}}).faults,
              Contains("set-up 1 is not the one that must be run there"));
  EXPECT_THAT(run_sheet(job, {{0, 2}}).faults, Contains(HasSubstr("are not there")));
}

TEST(First, BudgetsPayForThem) {
  Job job = make_job(6, 3, units(2), units(1));
  job.first = {{0, 1}, {2, 3}};  // 8
  EXPECT_THROW((void)planned(job, {.budget = units(7)}), BadInput);
  const RunPlan nothing_more = planned(job, {.budget = units(8)});
  EXPECT_EQ(nothing_more.sheet.steps.size(), 2U);
  EXPECT_EQ(nothing_more.sheet.pairs_tested, 2U);
  const RunPlan more = planned(job, {.budget = units(16)});
  EXPECT_LE(more.sheet.cost, units(16));
  EXPECT_GT(more.sheet.pairs_tested, 5U);
  EXPECT_EQ(more.sheet.steps.front().setup, (Block{0, 1}));
  ASSERT_TRUE(more.complete);
  EXPECT_TRUE(run_sheet(job, more.complete->setups).does_the_job());
}

TEST(First, ShufflesAndWhatIfLeaveThemAlone) {
  Job job = make_job(8, 3, units(2), units(1));
  job.first = {{0, 1, 2}, {5, 6, 7}};
  const RunPlan plan = planned(job);
  std::uint64_t exchanged = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const RunPlan mixed = shuffled(job, plan, seed, exchanged);
    EXPECT_EQ(mixed.sheet.cost, plan.sheet.cost);
    EXPECT_TRUE(mixed.sheet.does_the_job());
    EXPECT_EQ(mixed.sheet.steps[1].setup, (Block{5, 6, 7}));
  }
  EXPECT_GT(exchanged, 0U);
  RunControl control({.threads = 1});
  const WhatIf ranges = what_if(job, plan, {.steps = 2000}, control);
  ASSERT_FALSE(ranges.ranges.empty());
  for (const WhatIf::Range& range : ranges.ranges) {
    EXPECT_TRUE(run_sheet(job, range.plan.setups).does_the_job());
  }
}

TEST(First, AllPairsAtOnceNeedNoMore) {
  Job job = make_job(3, 3, units(1), units(1));
  job.first = {{0, 1, 2}, {0, 1, 2}};
  const RunPlan plan = planned(job);
  EXPECT_EQ(plan.sheet.cost, units(5));
  EXPECT_EQ(plan.candidates.front().name, "first tests");
  EXPECT_TRUE(plan.proved_cheapest());
}

TEST(First, ARuleThatIsBrokenIsNamedWithItsLine) {
  Job job = make_job(5, 3, units(1), units(1));
  job.never.insert(0, 1);
  job.needed = all_pairs_but(job.never);
  const auto complaint = [&](const std::string& text) -> std::string {
    return message_of([&] { (void)read_first(*input_from_text(text, "f.csv"), job); });
  };
  EXPECT_EQ(complaint("# smoke\n1,3\n2,3,4\n"), "");
  EXPECT_THAT(complaint("# none\n"), HasSubstr("no set-up is listed"));
  EXPECT_EQ(complaint("1,3\n\n2,1\n"),
            "f.csv:3:1: 2 and 1 must never be in one set-up; remove one");
  EXPECT_THAT(complaint("1,3,4,5\n"), HasSubstr("f.csv:1:1: 4 parts, but only 3 fit"));
  EXPECT_THAT(complaint("1,9\n"), HasSubstr("f.csv:1:3: there is no part '9'"));
  EXPECT_THAT(complaint("3,3\n"), HasSubstr("twice"));
  job.mounted = {4};
  job.needed = PairSet(5);
  EXPECT_THAT(complaint("1,5\n1,3\n"), HasSubstr("f.csv:2:1: 5 stays mounted, but is not"));
  job.slots = {{"a", 1, 1}};
  job.slot_of = {0, 0, no_slot, no_slot, no_slot};
  EXPECT_THAT(complaint("5,3\n"), HasSubstr("slot 'a' has 0 parts here, but needs 1"));
  job.first = {{4, 3}};
  EXPECT_THAT(defects(job), Contains(HasSubstr("set-up 1 of those that come first: slot 'a'")));
}

}  // namespace
}  // namespace changeover::first_test
