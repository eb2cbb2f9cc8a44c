// The bound where change costs depend on what is replaced [docs/theorems.md, Theorem 20].
#include "plan/search/bounds/exchange_bound.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "changeover/run/control.hpp"
#include "plan/job/prices.hpp"
#include "plan/search/valid_job.hpp"
#include "random_jobs.hpp"
#include "replacing_jobs.hpp"

namespace changeover::exchange_bound_test {
namespace {

constexpr std::uint64_t money = 1'000'000;

Amount by_exchanges(const Job& job) {
  CostBound bound;
  bound.tests = 1;
  raise_by_exchanges(job, bound);
  return bound.cost;
}

TEST(ExchangeBound, IsNoMoreThanTheLeastOfSmallJobs) {
  std::uint64_t attained = 0;
  std::uint64_t better = 0;
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    const Job job = test::replacing(seed % 2 == 0 ? test::random_job_with_slots(seed, 5)
                                                  : test::random_job(seed, 4 + seed / 2 % 2),
                                    seed);
    const std::uint64_t least = test::least_cost_of_replacing(job);
    const Amount bound = by_exchanges(job);
    EXPECT_LE(bound.millionths, least) << seed;
    EXPECT_LE(cost_bound(job).cost.millionths, least) << seed;
    attained += bound.millionths == least ? 1U : 0U;
    better += bound > bound_of_valid_job(at_prices(job, Price::least)).cost ? 1U : 0U;
  }
  EXPECT_GT(attained, 300U);
  EXPECT_GT(better, 500U);
}

// Two clusters: within one a change costs 1, between them 50. Any list must cross once.
TEST(ExchangeBound, CountsTheWayFromOneClusterToAnother) {
  Job job = make_job(6, 2, Amount{}, Amount{50 * money});
  set_slots(job, {"A", "A", "A", "A", "B", "B"}, parse_slots("A=1, B=1"));
  drop_needed(job, cannot_meet(job));
  job.replace_costs.assign(36, Amount{50 * money});
  for (const auto& [x, y] : {std::pair{0, 1}, {1, 0}, {2, 3}, {3, 2}, {4, 5}, {5, 4}}) {
    job.replace_costs[static_cast<std::size_t>(6 * x + y)] = Amount{money};
  }
  EXPECT_EQ(cost_bound(job).cost, Amount{156 * money});  // two set, one crossing, six small changes
}

TEST(ExchangeBound, IsThatOfFixedPricesIfTheRowsAreAlike) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Job job = test::random_job(seed, 7);
    const Amount plain = cost_bound(job).cost;
    job.replace_costs.clear();
    for (std::size_t i = 0; i < job.parts(); ++i) {
      job.replace_costs.insert(job.replace_costs.end(), job.change_costs.begin(),
                               job.change_costs.end());
    }
    EXPECT_GE(cost_bound(job).cost, plain) << seed;
  }
}

TEST(ExchangeBound, IsWeakerButTrueWhenItIsStopped) {
  std::atomic<bool> interrupted = true;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Job job = test::replacing(test::random_job(seed, 9), seed);
    const Amount whole = cost_bound(job).cost;
    RunControl control({.interrupted = &interrupted});
    const RunScope scope(control);
    EXPECT_LE(cost_bound(job).cost, whole) << seed;
  }
}

}  // namespace
}  // namespace changeover::exchange_bound_test
