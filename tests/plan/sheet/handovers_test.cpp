// Parts that go from one bench to another: a reader who follows the sheets and the handovers always
// has the parts of a set-up, and never needs more pieces than there are.
#include "plan/sheet/benches/handovers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "changeover/plan/benches.hpp"
#include "plan/sheet/benches/bench_words.hpp"
#include "run/random.hpp"

namespace changeover::handovers_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Amount units(std::uint64_t n) { return Amount{n * 1'000'000}; }

BenchPlan planned(const Job& job, std::vector<Bench> benches, std::uint64_t steps) {
  BenchOptions options;
  options.plan.steps = steps;
  options.plan.design_moves = 0;
  options.each = std::move(benches);
  RunControl control({.threads = 1});
  return make_bench_plan(job, options, control);
}

// Does what the sheets and the handovers say, moment by moment. A line for what cannot be done.
std::vector<std::string> followed(const Job& job, const BenchPlan& plan,
                                  const std::vector<Handover>& all) {
  std::vector<std::string> faults;
  std::map<std::pair<std::size_t, Element>, bool> there;
  std::map<Element, std::uint64_t> aside;
  for (Element x = 0; x < job.parts(); ++x) {
    aside[x] = job.quantities[x];
    for (std::size_t b = 0; b < plan.benches.size(); ++b) {
      if (std::ranges::count(plan.benches[b].start.value_or(job.start), x) > 0) {
        there[{b, x}] = true;
        --aside[x];
      }
    }
  }
  std::set<Amount> moments;
  for (const auto& times : plan.times) {
    for (const StepTime& time : times) {
      moments.insert(time.begin);
    }
  }
  for (const Amount now : moments) {
    const auto begin = [&](std::size_t bench, auto&& act) {
      for (std::size_t i = 0; i < plan.times[bench].size(); ++i) {
        if (plan.times[bench][i].begin == now) {
          act(i, plan.sheets[bench].steps[i]);
        }
      }
    };
    for (const Handover& each : all) {
      if (each.is_early && plan.times[each.to][each.step].begin == now) {
        const auto& times = plan.times[each.from];
        if (!there[{each.from, each.part}] || (each.after && now < times[*each.after].end)) {
          faults.push_back("taken out where it is not, or is needed");
        }
        there[{each.from, each.part}] = false;
        ++aside[each.part];
      }
    }
    for (std::size_t b = 0; b < plan.benches.size(); ++b) {
      begin(b, [&](std::size_t, const RunStep& step) {
        for (const Element x : step.take_out) {
          aside[x] += std::exchange(there[{b, x}], false) ? 1U : 0U;
        }
      });
    }
    for (std::size_t b = 0; b < plan.benches.size(); ++b) {
      begin(b, [&](std::size_t i, const RunStep& step) {
        for (const Element x : step.put_in) {
          if (aside[x] == 0) {
            faults.push_back("no piece is there to be put in");
            continue;
          }
          --aside[x];
          there[{b, x}] = true;
        }
        for (const Element x : step.setup) {
          if (!there[{b, x}]) {
            faults.push_back("step " + std::to_string(i) + " lacks a part");
          }
        }
      });
    }
  }
  return faults;
}

TEST(Handovers, WhoFollowsThemAlwaysHasTheParts) {
  std::size_t early = 0;
  std::size_t needed = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    Random random(seed, 9);
    const std::uint32_t v = 4 + random.below(4);
    Job job = make_job(v, 3, units(1 + random.below(3)), Amount{});
    for (Amount& cost : job.change_costs) {
      cost = units(1 + random.below(3));
    }
    for (std::uint32_t x = 0; x < v; ++x) {
      job.quantities.push_back(1 + random.below(5) / 4);
    }
    std::vector<Bench> benches(2 + random.below(2));
    if (random.below(2) == 0) {
      benches[0].start = Block{0, 1};
    }
    for (Bench& bench : benches) {
      bench.hours = random.below(2) == 0 ? std::nullopt : std::optional(units(7));
    }
    const BenchPlan plan = planned(job, benches, 3000);
    const std::vector<Handover> all = handovers(job, plan);
    EXPECT_THAT(followed(job, plan, all), IsEmpty()) << seed;
    early += static_cast<std::size_t>(std::ranges::count(all, true, &Handover::is_early));
    // Without those that take out in time it cannot be done: nothing is said in vain.
    std::vector<Handover> rest = all;
    std::erase_if(rest, [](const Handover& each) { return each.is_early; });
    needed += rest.size() < all.size() && !followed(job, plan, rest).empty() ? 1U : 0U;
    EXPECT_EQ(rest.size() < all.size(), !followed(job, plan, rest).empty()) << seed;
  }
  EXPECT_GT(early, 5U);
  EXPECT_GT(needed, 2U);
}

// Two benches, one of each part: B is on bench 1 until 4, and on bench 2 from 5 on.
TEST(Handovers, SayWhatToTakeOutAndWhereItComesFrom) {
  Job job = make_job(3, 2, units(2), Amount{});
  job.change_costs.assign(3, units(1));
  job.quantities = {1, 1, 1};
  const BenchSchedule schedule{{{{0, 1}, units(0)}}, {{{1, 2}, units(5)}}};
  BenchPlan plan;
  static_cast<BenchCount&>(plan) = count_benches(job, std::vector<Bench>(2), schedule);
  const std::vector<Handover> all = handovers(job, plan);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0],
            (Handover{.part = 1, .from = 0, .to = 1, .step = 0, .is_early = true, .after = 0}));
  const BenchDocument document{.job = &job, .plan = &plan};
  const HandoverLines lines = handover_lines(job, plan, money_of(document), calendar_of(document));
  EXPECT_THAT(lines[0][0], ElementsAre("take out 2 after it: Bench 2 needs it for step 1 at 5"));
  EXPECT_THAT(lines[1][0], ElementsAre("2 from Bench 1"));
  job.quantities = {1, 2, 1};
  EXPECT_THAT(handovers(job, plan), IsEmpty()) << "there are enough";
}

}  // namespace
}  // namespace changeover::handovers_test
