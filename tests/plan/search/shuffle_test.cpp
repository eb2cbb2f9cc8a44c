#include <gtest/gtest.h>

#include "changeover/plan/run_plan.hpp"
#include "random_jobs.hpp"

namespace changeover::shuffle_test {
namespace {

RunPlan planned(const Job& job) {
  RunControl control({.threads = 1});
  return make_run_plan(job, {.steps = 1000, .attempts = 1, .design_moves = 0, .states = 0},
                       control);
}

TEST(Shuffled, PlansCostTheSameAndDoTheJob) {
  std::uint64_t exchanged_in_all = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    const Job job =
        seed % 2 == 0 ? test::random_job(seed, 12) : test::random_job_with_slots(seed, 12);
    const RunPlan plan = planned(job);
    std::uint64_t exchanged = 0;
    const RunPlan other = shuffled(job, plan, seed, exchanged);
    EXPECT_TRUE(other.sheet.does_the_job()) << seed;
    EXPECT_EQ(other.sheet.cost, plan.sheet.cost);
    EXPECT_EQ(run_sheet(job, other.candidates.front().setups).cost, plan.sheet.cost);
    EXPECT_EQ(other.candidates.front().setups == plan.candidates.front().setups || exchanged > 0,
              true);
    std::uint64_t again = 0;
    EXPECT_EQ(shuffled(job, plan, seed, again).candidates.front().setups,
              other.candidates.front().setups);
    exchanged_in_all += exchanged;
  }
  EXPECT_GT(exchanged_in_all, 100U);
}

TEST(Shuffled, NothingIsExchangedWhereAllPartsDiffer) {
  Job job = make_job(9, 3, Amount{1}, Amount{1});
  std::uint64_t exchanged = 0;
  const RunPlan plan = planned(job);
  EXPECT_NE(shuffled(job, plan, 1, exchanged).candidates.front().setups,
            plan.candidates.front().setups);
  EXPECT_GT(exchanged, 0U);
  for (Element x = 0; x < 9; ++x) {
    job.change_costs[x] = Amount{x};
  }
  const RunPlan apart = planned(job);
  EXPECT_EQ(shuffled(job, apart, 1, exchanged).candidates.front().setups,
            apart.candidates.front().setups);
  EXPECT_EQ(exchanged, 0U);
}

}  // namespace
}  // namespace changeover::shuffle_test
