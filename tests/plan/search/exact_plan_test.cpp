#include "plan/search/exact_plan.hpp"

#include <gtest/gtest.h>

#include "changeover/plan/run_plan.hpp"
#include "cheapest.hpp"
#include "random_jobs.hpp"

namespace changeover::exact_plan_test {
namespace {

Amount units(std::uint64_t n) { return Amount{n * 1'000'000}; }

void expect_exact(const Job& job, const std::string& which) {
  RunControl control({.threads = 1});
  const Amount least{test::least_cost(job).value()};
  ASSERT_TRUE(is_small(job)) << which;
  // Something cheaper is found, and is the least; where there is nothing cheaper, that is known.
  const ExactPlan found = exact_plan(job, least + Amount{1}, 1'000'000, control);
  ASSERT_TRUE(found.setups) << which;
  EXPECT_EQ(found.bound, least) << which;
  const RunSheet sheet = run_sheet(job, *found.setups);
  EXPECT_TRUE(sheet.does_the_job()) << which;
  EXPECT_EQ(sheet.cost, least) << which;
  const ExactPlan none = exact_plan(job, least, 1'000'000, control);
  EXPECT_FALSE(none.setups) << which;
  EXPECT_EQ(none.bound, least) << which;
  const ExactPlan far = exact_plan(job, least * 3 + units(1), 1'000'000, control);
  EXPECT_EQ(far.bound, least) << which;
  // Cut short, the bound is still one.
  EXPECT_LE(exact_plan(job, least * 2 + units(1), 3, control).bound, least) << which;
}

TEST(ExactPlan, FindsTheLeastOfAllLists) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    if (const Job job = test::random_job(seed, 5); job.needed.size() > 0) {
      expect_exact(job, "job " + std::to_string(seed));
    }
    expect_exact(test::random_job_with_slots(seed, 5), "slots " + std::to_string(seed));
  }
  for (std::uint64_t k = 3; k <= 4; ++k) {
    expect_exact(make_job(6, k, units(2), units(3)), "6 parts, " + std::to_string(k));
  }
}

TEST(ExactPlan, PartsThatLookAlikeAreTakenForOne) {
  // Seven parts with one cost, and with seven costs: the same list, in far fewer states.
  Job alike = make_job(7, 3, units(1), units(2));
  Job apart = alike;
  for (Element x = 0; x < 7; ++x) {
    apart.change_costs[x] = units(2) + Amount{x};
  }
  RunControl control({.threads = 1});
  const ExactPlan one = exact_plan(alike, units(1000), 1'000'000, control);
  const ExactPlan other = exact_plan(apart, units(1000), 1'000'000, control);
  ASSERT_TRUE(one.setups && other.setups);
  EXPECT_EQ(run_sheet(alike, *one.setups).cost, run_sheet(alike, *other.setups).cost);
  EXPECT_LT(one.states * 10, other.states);
}

TEST(ExactPlan, SmallPlansAreProved) {
  std::uint64_t proved = 0;
  std::uint64_t all = 0;
  for (std::uint64_t v = 4; v <= 7; ++v) {
    for (std::uint64_t k = 2; k <= std::min<std::uint64_t>(4, v - 1); ++k) {
      for (const auto& [test, change] : {std::pair{1U, 1U}, {1U, 5U}, {5U, 1U}}) {
        RunControl control({.threads = 1});
        const RunPlan plan = make_run_plan(make_job(v, k, units(test), units(change)),
                                           {.steps = 20'000, .design_moves = 0}, control);
        ++all;
        proved += plan.proved_cheapest() ? 1U : 0U;
      }
    }
  }
  EXPECT_EQ(proved, all);
}

TEST(ExactPlan, LargeJobsAndLargeCostsAreNotSmall) {
  EXPECT_FALSE(is_small(make_job(13, 3, units(1), units(1))));
  EXPECT_TRUE(is_small(make_job(11, 3, units(1), units(1))));
  EXPECT_FALSE(is_small(make_job(12, 3, units(1), units(1)))) << "66 pairs";
  EXPECT_FALSE(is_small(make_job(5, 3, parse_amount("9000000000000"), units(1))));
}

}  // namespace
}  // namespace changeover::exact_plan_test
