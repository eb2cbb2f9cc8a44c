#include "changeover/plan/run_plan.hpp"

#include <gtest/gtest.h>

#include "cheapest.hpp"
#include "replacing_jobs.hpp"

namespace changeover::what_if_test {
namespace {

Amount units(std::uint64_t n) { return Amount{n * 1'000'000}; }

Candidate point(std::uint64_t tests, std::uint64_t changes) {
  Candidate candidate;
  candidate.name = std::to_string(tests) + "/" + std::to_string(changes);
  candidate.setups.resize(static_cast<std::size_t>(tests));
  candidate.changes = changes;
  candidate.change_cost = units(changes);
  candidate.pairs_tested = 6;
  return candidate;
}

TEST(Envelope, IsTheCheapestAtEveryRatio) {
  const Job job = make_job(4, 3, units(1), units(1));
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    std::vector<Candidate> candidates;
    for (std::uint32_t i = 1 + random.below(8); i > 0; --i) {
      candidates.push_back(point(1 + random.below(12), 1 + random.below(12)));
    }
    const WhatIf answer = envelope(job, candidates);
    ASSERT_FALSE(answer.ranges.empty());
    EXPECT_FALSE(answer.ranges.front().from.has_value());
    EXPECT_FALSE(answer.ranges.back().to.has_value());
    // At ratios i/60 times the tests' unit: the plan of the range costs no more than any candidate.
    for (std::uint64_t i = 1; i < 900; i += 7) {
      const auto cost = [&](const Candidate& c) { return 60 * c.tests() + i * c.changes; };
      std::size_t ranges = 0;
      for (const WhatIf::Range& range : answer.ranges) {
        const bool inside = (!range.from || range.from->over * 60 <= i * range.from->under) &&
                            (!range.to || range.to->over * 60 >= i * range.to->under);
        ranges += inside ? 1U : 0U;
        for (const Candidate& other : candidates) {
          EXPECT_TRUE(!inside || cost(range.plan) <= cost(other)) << seed << ' ' << i;
        }
      }
      EXPECT_GE(ranges, 1U) << seed << ' ' << i << ": a gap";
    }
    for (std::size_t i = 1; i < answer.ranges.size(); ++i) {
      EXPECT_EQ(answer.ranges[i].from->to_string(), answer.ranges[i - 1].to->to_string());
      EXPECT_GT(answer.ranges[i].plan.tests(), answer.ranges[i - 1].plan.tests());
    }
  }
}

TEST(WhatIf, KnowsTheCheapestPlanOfTinyJobsAtManyRatios) {
  for (const auto& [v, k] : {std::pair{5U, 3U}, {5U, 2U}, {6U, 3U}}) {
    const Job job = make_job(v, k, units(1), units(1));
    RunControl control({});
    const PlanOptions options{.steps = 20'000, .design_moves = 10'000};
    const WhatIf answer = what_if(job, make_run_plan(job, options, control), options, control);
    EXPECT_EQ(answer.asked->to_string(), "1");
    for (const auto& [test, change] : {std::pair{8U, 1U}, {3U, 1U}, {1U, 1U}, {1U, 3U}, {1U, 8U}}) {
      std::uint64_t least = ~std::uint64_t{0};
      for (const WhatIf::Range& range : answer.ranges) {
        least = std::min(least, test * range.plan.tests() + change * range.plan.changes);
      }
      const Job there = make_job(v, k, units(test), units(change));
      EXPECT_EQ(units(least).millionths, test::least_cost(there)) << v << ' ' << k << ' ' << test;
    }
  }
}

TEST(WhatIf, MultipliesTheCostsOfPartsByAFactor) {
  Job job = make_job(5, 3, units(3), units(1));
  job.change_costs[0] = units(4);
  RunControl control({});
  const PlanOptions options{.steps = 10'000, .design_moves = 10'000};
  const WhatIf answer = what_if(job, make_run_plan(job, options, control), options, control);
  EXPECT_TRUE(answer.by_factor);
  for (const std::uint64_t factor : {1U, 2U, 5U}) {
    Job there = job;
    for (Amount& cost : there.change_costs) {
      cost = cost * factor;
    }
    std::uint64_t least = ~std::uint64_t{0};
    for (const WhatIf::Range& range : answer.ranges) {
      least = std::min(least, (job.test_cost * range.plan.tests()).millionths +
                                  factor * range.plan.change_cost.millionths);
    }
    EXPECT_EQ(least, test::least_cost(there)) << factor;
  }
}

TEST(WhatIf, MultipliesTheCostsOfWhatIsReplacedToo) {
  Job job = test::replacing(make_job(5, 3, units(3), units(2)), 7);
  RunControl control({});
  const PlanOptions options{.steps = 20'000};
  const WhatIf answer = what_if(job, make_run_plan(job, options, control), options, control);
  EXPECT_TRUE(answer.by_factor);
  for (const std::uint64_t factor : {1U, 2U, 5U}) {
    Job there = job;
    for (std::vector<Amount>* const costs : {&there.change_costs, &there.replace_costs}) {
      for (Amount& cost : *costs) {
        cost = cost * factor;
      }
    }
    std::uint64_t least = ~std::uint64_t{0};
    for (const WhatIf::Range& range : answer.ranges) {
      least = std::min(least, (job.test_cost * range.plan.tests()).millionths +
                                  factor * range.plan.change_cost.millionths);
    }
    const std::uint64_t exact = test::least_cost_of_replacing(there);
    EXPECT_GE(least, exact) << factor;
    EXPECT_LE(least, exact + exact / 10) << factor;
  }
}

TEST(WhatIf, OfNothingIsOneRange) {
  Job job = make_job(4, 3, units(1), units(1));
  job.needed = PairSet(4);
  RunControl control({});
  const WhatIf answer = what_if(job, make_run_plan(job, {}, control), {}, control);
  ASSERT_EQ(answer.ranges.size(), 1U);
  EXPECT_EQ(answer.ranges.front().plan.tests(), 0U);
}

}  // namespace
}  // namespace changeover::what_if_test
