// Benches that share scarce parts, differ, and rest: by definition, by looking at everything, and
// by mutations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "bench_checker.hpp"
#include "changeover/core/error.hpp"
#include "changeover/plan/benches.hpp"
#include "earliest.hpp"
#include "plan/search/benches/bench_bounds.hpp"
#include "random_jobs.hpp"

namespace changeover::bench_stock_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

Amount units(std::uint64_t n) { return Amount{n * 1'000'000}; }

BenchPlan planned(const Job& job, std::vector<Bench> benches, BenchOptions options = {}) {
  options.plan.steps = options.plan.steps == 0 ? 20'000 : options.plan.steps;
  options.plan.design_moves = 0;
  options.each = std::move(benches);
  RunControl control({.threads = 1});
  return make_bench_plan(job, options, control);
}

// A plan that does the job, within its bounds, and stands against the definition.
void expect_sound(const Job& job, const BenchPlan& plan, const std::string& what) {
  const test::CheckedSchedule checked = test::check_schedule(job, plan.benches, plan.schedule);
  EXPECT_THAT(checked.faults, IsEmpty()) << what;
  EXPECT_EQ(checked.makespan, plan.makespan.millionths) << what;
  EXPECT_EQ(checked.cost, plan.cost.millionths) << what;
  EXPECT_TRUE(plan.does_the_job()) << what;
  job.needed.for_each(~std::uint64_t{0}, [&](Element x, Element y) {
    EXPECT_EQ(checked.met.count({x, y}), 1U) << what;
  });
  EXPECT_GE(plan.makespan, plan.makespan_bound) << what;
  EXPECT_GE(plan.cost, plan.bound.cost) << what;
}

// Four parts at most, whole costs, some of them scarce.
Job tiny_job(std::uint64_t seed) {
  Random random(seed, 5);
  const std::uint32_t v = 3 + random.below(2);
  Job job = make_job(v, 2 + random.below(v - 2), units(1 + random.below(3)), Amount{});
  for (Amount& cost : job.change_costs) {
    cost = units(random.below(3));
  }
  for (std::uint32_t x = 0; x < v; ++x) {
    job.quantities.push_back(random.below(3) == 0 ? enough_for_all : 1 + random.below(4) / 3);
  }
  return job;
}

// The plan is sound, and its end no sooner than can be: whether it is that soon.
bool is_done_at_the_earliest(const Job& job, const std::vector<Bench>& benches,
                             std::uint64_t seed) {
  const BenchPlan plan = planned(job, benches);
  expect_sound(job, plan, "seed " + std::to_string(seed));
  const std::uint64_t end = test::earliest_end(job, benches) * 1'000'000;
  EXPECT_LE(plan.makespan_bound.millionths, end) << seed << ": " << plan.makespan_reason;
  EXPECT_GE(plan.makespan.millionths, end) << seed;
  return plan.makespan.millionths == end;
}

TEST(BenchStock, TheEarliestEndOfTinyJobs) {
  int best = 0;
  int all = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Job job = tiny_job(seed);
    const std::vector<Bench> benches(2);
    best += is_done_at_the_earliest(job, benches, seed) ? 1 : 0;
    ++all;
  }
  EXPECT_GE(best, all - 2) << "nearly all are done at the earliest";
}

TEST(BenchStock, ThereIsABoundEvenIfNoTimeIsLeft) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Job job = tiny_job(seed);
    const std::vector<Bench> benches(2);
    const BenchField field(job, benches);
    RunControl stopped({.threads = 1});
    stopped.stop(WhyStopped::step_limit);
    const RunScope scope(stopped);
    const BenchBounds bounds = bench_bounds(field);
    EXPECT_GT(bounds.makespan, Amount{}) << seed;
    EXPECT_LE(bounds.makespan.millionths, test::earliest_end(job, benches) * 1'000'000) << seed;
    EXPECT_THAT(bounds.makespan_reason, HasSubstr("every plan costs at least")) << seed;
  }
}

TEST(BenchStock, TheEarliestEndOfTinyJobsWithStartsAndBenchesThatDiffer) {
  int best = 0;
  int all = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Job job = tiny_job(100 + seed);
    Random random(seed, 9);
    std::vector<Bench> benches(2);
    benches[0].test_cost = units(1 + random.below(3));
    benches[1].change_factor = units(1 + random.below(2));
    for (Element x = 0; x < job.parts(); ++x) {
      Bench& bench = benches[random.below(2)];
      if (random.one_in_two()) {
        Block start = bench.start.value_or(Block());
        start.push_back(x);
        bench.start = start.size() <= job.at_once ? start : bench.start;
      }
    }
    best += is_done_at_the_earliest(job, benches, seed) ? 1 : 0;
    ++all;
  }
  EXPECT_GE(best, all - 4) << "nearly all are done at the earliest";
}

// Whatever there is: slots, forbidden pairs, first set-ups, starts, stock, hours, benches that
// differ or are down.
struct Lab {
  Job job;
  std::vector<Bench> benches;
};

Lab random_lab(std::uint64_t seed, std::uint32_t parts) {
  for (std::uint64_t turn = 0;; ++turn) {
    Lab lab{seed % 2 == 0 ? test::random_job(seed + 1000 * turn, parts)
                          : test::random_job_with_slots(seed + 1000 * turn, parts),
            {}};
    Random random(seed, 100 + turn);
    lab.job.start.clear();
    const std::uint32_t v = static_cast<std::uint32_t>(lab.job.parts());
    for (std::uint32_t x = 0; x < v; ++x) {
      lab.job.quantities.push_back(random.below(3) == 0 ? enough_for_all : 1 + random.below(2));
    }
    const std::uint32_t benches = 2 + random.below(2);
    for (std::uint32_t b = 0; b < benches; ++b) {
      Bench bench;
      if (random.below(3) == 0) {
        bench.test_cost = Amount{random.below(5) * 1'500'000ULL};
      }
      if (random.below(3) == 0) {
        bench.change_factor = Amount{500'000 * (1 + random.below(4))};
      }
      if (random.below(3) == 0) {
        bench.hours = Amount{4'000'000 + random.below(20) * 500'000ULL};
      }
      for (Element x = 0; x < v; ++x) {
        if (random.below(8) == 0) {
          bench.own.push_back(x);
        } else if (random.below(12) == 0) {
          bench.without.push_back(x);
        }
      }
      if (random.below(3) == 0) {
        bench.at_once = lab.job.at_once + random.below(2);
      }
      if (random.below(3) == 0) {
        Block start;
        for (Element x = 0; x < v && start.size() < lab.job.at_once; ++x) {
          if (random.below(3) == 0) {
            start.push_back(x);
          }
        }
        bench.start = start;
      }
      bench.down = random.below(8) == 0;
      lab.benches.push_back(bench);
    }
    drop_needed(lab.job, cannot_meet(lab.job, lab.benches));
    if (bench_defects(lab.job, lab.benches).empty() && lab.job.needed.size() > 0) {
      return lab;
    }
  }
}

TEST(BenchStock, WhateverThereIs) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Lab lab = random_lab(seed, 8);
    const BenchObjective objective =
        seed % 3 == 0 ? BenchObjective::cost : BenchObjective::makespan;
    const BenchPlan plan =
        planned(lab.job, lab.benches, {.objective = objective, .plan = {.steps = 3'000}});
    expect_sound(lab.job, plan, "seed " + std::to_string(seed));
    for (const BenchCandidate& c : plan.candidates) {
      EXPECT_GE(c.makespan, plan.makespan_bound) << c.name;
      EXPECT_GE(c.cost, plan.bound.cost) << c.name;
    }
  }
}

TEST(BenchStock, WithinABudget) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Lab lab = random_lab(200 + seed, 7);
    const BenchPlan whole = planned(lab.job, lab.benches, {.plan = {.steps = 3'000}});
    const Amount budget{whole.cost.millionths / 2};
    const BenchPlan plan =
        planned(lab.job, lab.benches, {.plan = {.steps = 3'000, .budget = budget}});
    const test::CheckedSchedule checked =
        test::check_schedule(lab.job, plan.benches, plan.schedule);
    EXPECT_THAT(checked.faults, IsEmpty());
    EXPECT_LE(plan.cost, budget);
    EXPECT_TRUE(plan.faults.empty());
    ASSERT_TRUE(plan.complete.has_value());
    EXPECT_GT(plan.complete->cost, budget);
    for (const BenchCandidate& c : plan.candidates) {
      EXPECT_LE(c.pairs_tested, plan.pairs_tested);
      EXPECT_LE(c.cost, budget);
    }
  }
}

TEST(BenchStock, TheRefereeAgreesWithTheDefinitionAboutMutations) {
  int refused = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Lab lab = random_lab(400 + seed, 7);
    const BenchPlan plan = planned(lab.job, lab.benches, {.plan = {.steps = 2'000}});
    Random random(seed, 3);
    for (int turn = 0; turn < 20; ++turn) {
      BenchSchedule changed = plan.schedule;
      std::vector<BenchStep>& steps =
          changed[random.below(static_cast<std::uint32_t>(changed.size()))];
      if (steps.empty()) {
        continue;
      }
      BenchStep& step = steps[random.below(static_cast<std::uint32_t>(steps.size()))];
      const auto some_part = [&] {
        return static_cast<Element>(random.below(static_cast<std::uint32_t>(lab.job.parts())));
      };
      switch (random.below(5)) {
        case 0:
          step.begin = Amount{step.begin.millionths -
                              std::min<std::uint64_t>(step.begin.millionths, 500'000)};
          break;
        case 1:
          step.begin += Amount{500'000};
          break;
        case 2:
          step.again.push_back(some_part());
          break;
        case 3:
          if (const Element x = some_part();
              std::find(step.setup.begin(), step.setup.end(), x) == step.setup.end()) {
            step.setup.push_back(x);
          }
          break;
        default:
          step.again.clear();
          step.setup.pop_back();
          break;
      }
      const test::CheckedSchedule checked = test::check_schedule(lab.job, lab.benches, changed);
      const BenchCount count = count_benches(lab.job, lab.benches, changed);
      EXPECT_EQ(checked.faults.empty(), count.faults.empty())
          << seed << ' ' << turn << ": "
          << (checked.faults.empty() ? count.faults.front() : checked.faults.front());
      if (checked.faults.empty()) {
        EXPECT_EQ(checked.makespan, count.makespan.millionths);
        EXPECT_EQ(checked.cost, count.cost.millionths);
      } else {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 200);
}

TEST(BenchStock, TwoBenchesNeverHoldTheOnlyPieceAtATime) {
  Job job = make_job(4, 2, units(1), units(1));
  job.quantities = {1, enough_for_all, enough_for_all, enough_for_all};
  const std::vector<Bench> benches(2);
  const BenchSchedule both{{{{0, 1}, units(0)}}, {{{0, 2}, units(0)}}};
  EXPECT_THAT(count_benches(job, benches, both).faults,
              Contains(HasSubstr("1 is on 2 benches, but there is 1")));
  const BenchSchedule later{{{{0, 1}, units(0)}}, {{{0, 2}, units(3)}}};
  EXPECT_THAT(count_benches(job, benches, later).faults, IsEmpty());
  // While a bench waits, it holds what stays …
  const BenchSchedule waits{{{{0, 1}, units(0)}, {{0, 3}, units(9)}}, {{{0, 2}, units(4)}}};
  EXPECT_FALSE(count_benches(job, benches, waits).faults.empty());
  // … unless it gives it up and pays for it again.
  const BenchSchedule gives{{{{0, 1}, units(0)}, {{0, 3}, units(9), {0}}}, {{{0, 2}, units(4)}}};
  const BenchCount count = count_benches(job, benches, gives);
  EXPECT_THAT(count.faults, IsEmpty());
  EXPECT_EQ(count.makespan, units(12));
  EXPECT_EQ(count.cost, units(3 + 3 + 3));
  EXPECT_EQ(count.sheets[0].steps[1].put_in, (Block{0, 3}));
}

TEST(BenchStock, WhatWouldBlockBothIsGivenUp) {
  // Each bench has what the other one needs, and keeps it.
  Job job = make_job(3, 3, units(1), units(1));
  job.quantities = {1, 1, 1};
  std::vector<Bench> benches(2);
  benches[0].start = Block{0};
  benches[0].first = std::vector<Block>{{0, 1}};
  benches[1].start = Block{1};
  benches[1].first = std::vector<Block>{{0, 1}};
  const BenchPlan plan = planned(job, benches);
  expect_sound(job, plan, "both blocked");
}

TEST(BenchStock, NoBoundOfTinyJobsWithSlotsIsAboveTheEarliestEnd) {
  int taking_turns = 0;
  int exact = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed, 31);
    Job job = test::random_job_with_slots(seed, 4);
    job.first.clear();
    job.test_cost = units(1 + random.below(3));
    for (Element x = 0; x < job.parts(); ++x) {
      job.change_costs[x] = units(random.below(4));
      job.quantities.push_back(random.one_in_two() ? 1 : enough_for_all);
    }
    std::vector<Bench> benches(2);
    if (random.one_in_two()) {
      benches[0].test_cost = units(1 + random.below(3));
      benches[1].change_factor = units(1 + random.below(2));
    }
    if (!bench_defects(job, benches).empty()) {
      continue;
    }
    RunControl control({.threads = 1});
    const RunScope scope(control);
    const BenchBounds bounds = bench_bounds(BenchField(job, benches));
    const std::uint64_t end = test::earliest_end(job, benches) * 1'000'000;
    EXPECT_LE(bounds.makespan.millionths, end) << seed << ": " << bounds.makespan_reason;
    if (bounds.makespan_reason.find("can work at a time") != std::string::npos) {
      ++taking_turns;
      exact += bounds.makespan.millionths == end ? 1 : 0;
    }
  }
  EXPECT_GT(taking_turns, 3);
  EXPECT_GT(exact, 1);
}

TEST(BenchStock, OneOfTwoPartsThatAllNeedLeavesOneBenchAtWork) {
  Job job = make_job(6, 3, units(2), units(1));
  job.slots = {{"CPU", 2, 2}, {"", 1, 1}};
  job.slot_of = {0, 0, 1, 1, 1, 1};
  job.quantities = {
      1, enough_for_all, enough_for_all, enough_for_all, enough_for_all, enough_for_all};
  job.needed = all_pairs_but(job.never);
  drop_needed(job, cannot_meet(job));
  const BenchPlan plan = planned(job, std::vector<Bench>(3));
  EXPECT_EQ(plan.makespan, units(14));
  EXPECT_EQ(plan.makespan_bound, plan.makespan);
  EXPECT_THAT(plan.makespan_reason,
              HasSubstr("only 1 bench can work at a time: slot CPU needs 2 parts on each, no two "
                        "alike, and 2 benches could have only 3"));
}

// One bench at a time: North is fast and rests from noon on, South slower and goes on.
TEST(BenchStock, BenchesThatTakeTurnsDoMoreThanTheBestAlone) {
  Job job = make_job(4, 2, units(2), Amount{});
  job.mounted = {0};
  job.quantities = {1, enough_for_all, enough_for_all, enough_for_all};
  job.needed = PairSet(4);
  for (Element x = 1; x < 4; ++x) {
    job.needed.insert(0, x);
  }
  std::vector<Bench> benches(2);
  benches[0].hours = units(4);
  benches[1].hours = units(8);
  benches[1].test_cost = units(4);
  BenchField field(job, benches);
  RunControl control({.threads = 1});
  const RunScope scope(control);
  EXPECT_LE(bench_bounds(field).makespan, units(8));
  EXPECT_EQ(planned(job, benches).makespan, units(8));
}

TEST(BenchStock, AnUnsharedStockIsNoStock) {
  for (const std::uint64_t quantity : {std::uint64_t{3}, enough_for_all}) {
    Job job = make_job(9, 3, units(1), units(5));
    const BenchPlan plain = planned(job, std::vector<Bench>(3));
    job.quantities.assign(9, quantity);
    EXPECT_EQ(planned(job, std::vector<Bench>(3)).candidates.front().lists,
              plain.candidates.front().lists);
  }
}

TEST(BenchStock, WhatStaysMountedStaysWherePartsMustNotMeetIt) {
  for (std::uint32_t v = 3; v <= 5; ++v) {
    Job job = make_job(v, 3, units(4), Amount{});
    job.change_costs[2] = units(2);
    job.never.insert(1, 2);
    job.needed = all_pairs_but(job.never);
    job.quantities.assign(v, 1);
    std::vector<Bench> benches(2);
    benches[0].mounted = Block{1};
    expect_sound(job, planned(job, benches), std::to_string(v) + " parts");
    benches[1].hours = units(4);
    expect_sound(job, planned(job, benches), std::to_string(v) + " parts, a rest");
  }
}

TEST(BenchStock, DefectsAreSaid) {
  Job job = make_job(4, 3, units(1), units(1));
  std::vector<Bench> benches(2);
  EXPECT_THAT(bench_defects(job, benches), IsEmpty());
  benches[0].name = benches[1].name = "North";
  EXPECT_THAT(bench_defects(job, benches), Contains("two benches are called North; rename one"));
  benches[1].name = "NORTH";  // their sheets could not be told apart
  EXPECT_THAT(bench_defects(job, benches),
              Contains("the benches North and NORTH differ only in capitals; rename one"));
  benches[0].name = "Äpfel";
  benches[1].name = "äpfel";
  EXPECT_THAT(bench_defects(job, benches),
              Contains("the benches Äpfel and äpfel differ only in capitals; rename one"));
  benches[0].name = "North";
  benches[1].name = "";
  benches[1].without = {2};
  benches[0].without = {2};
  EXPECT_THAT(bench_defects(job, benches),
              Contains("1 and 3 must meet, but no bench can hold both in one set-up; let a bench "
                       "have both"));
  benches[0].without = {3};
  EXPECT_THAT(bench_defects(job, benches),
              Contains("3 and 4 must meet, but no bench can hold both in one set-up; let a bench "
                       "have both"));
  benches[1].down = true;
  benches[0].without = {};
  EXPECT_THAT(bench_defects(job, benches), IsEmpty());
  benches[0].down = true;
  EXPECT_THAT(bench_defects(job, benches), Contains("all benches are down; nothing can be tested"));
  benches[0].down = benches[1].down = false;
  benches[1].without = {};
  benches[0].start = benches[1].start = Block{0, 1};
  job.quantities = {1, 2, 2, 2};
  EXPECT_THAT(bench_defects(job, benches),
              Contains("1 is mounted at the start on 2 benches, but there is 1; say what is "
                       "mounted where"));
  benches[1].own = {0};
  EXPECT_THAT(bench_defects(job, benches), IsEmpty());
  benches[0].at_once = 1;
  EXPECT_THAT(bench_defects(job, benches), Contains(HasSubstr("North: 1 at once")));
  benches[0].at_once.reset();
  benches[0].change_factor = Amount{333'333};
  job.change_costs[0] = Amount{1};
  EXPECT_THAT(bench_defects(job, benches), Contains(HasSubstr("more than six decimals")));
  benches[0].change_factor = units(1);
  benches[0].hours = Amount{};
  EXPECT_THAT(bench_defects(job, benches), Contains(HasSubstr("it works no hours a day")));
  benches[0].hours = units(25);
  EXPECT_THAT(bench_defects(job, benches), Contains(HasSubstr("give at most 24")));
  EXPECT_THROW((void)planned(job, benches), BadInput);
  EXPECT_THROW((void)count_benches(job, benches, BenchSchedule(3)), BadInput);
}

TEST(BenchStock, NothingIsPlannedForABenchThatIsDown) {
  const Job job = make_job(7, 3, units(2), units(1));
  std::vector<Bench> benches(3);
  benches[1].down = true;
  const BenchPlan plan = planned(job, benches);
  expect_sound(job, plan, "one is down");
  EXPECT_TRUE(plan.schedule[1].empty());
  EXPECT_FALSE(plan.schedule[0].empty());
  EXPECT_FALSE(plan.schedule[2].empty());
}

TEST(BenchStock, TheRestOfPlansUnderWayIsACandidate) {
  const Job job = make_job(9, 4, units(2), units(1));
  const BenchPlan before = planned(job, std::vector<Bench>(2));
  Job rest = job;
  std::vector<Bench> benches(2);
  for (std::size_t b = 0; b < 2; ++b) {
    std::vector<Block> list = before.candidates.front().lists[b];
    const std::vector<Block> done(list.begin(), list.begin() + 2);
    mark_done(rest, done);
    benches[b].start = done.back();
    benches[b].tests_done = 2;
    benches[b].rest.assign(list.begin() + 2, list.end());
  }
  rest.start.clear();
  rest.tests_done = 0;
  const BenchPlan plan = planned(rest, benches);
  expect_sound(rest, plan, "rest");
  Amount going_on;
  for (const RunSheet& sheet : before.sheets) {
    going_on = std::max(going_on, sheet.cost - sheet.steps[1].cost_so_far);
  }
  EXPECT_LE(plan.makespan, going_on);
}

// Two pieces of some parts: the one that a bench waits for may be free earlier than it seemed.
TEST(BenchStock, APieceThatIsFreeEarlierMovesTheMorning) {
  Job job = make_job(7, 3, units(2), Amount{});
  job.change_costs = {units(3), units(2), units(1), units(3), units(3), units(1), units(3)};
  job.quantities = {1, 2, 1, 1, 2, 2, 1};
  std::vector<Bench> benches(3);
  benches[1].hours = units(7);
  benches[2].hours = units(7);
  for (std::uint64_t steps = 1'000; steps <= 20'000; steps += 1'000) {
    BenchOptions options;
    options.plan.steps = steps;
    expect_sound(job, planned(job, benches, options), std::to_string(steps));
  }
}

TEST(BenchStock, DaysEndBeforeTheNight) {
  const Job job = make_job(6, 3, units(3), units(1));
  std::vector<Bench> benches(2);
  benches[0].hours = units(8);
  benches[1].hours = units(6);
  const BenchPlan plan = planned(job, benches);
  expect_sound(job, plan, "days");
  for (std::size_t b = 0; b < 2; ++b) {
    for (const StepTime& time : plan.times[b]) {
      const std::uint64_t hours = benches[b].hours->millionths;
      EXPECT_LT(time.begin.millionths % 8'000'000, hours);
      EXPECT_EQ(time.begin.millionths / 8'000'000, (time.end.millionths - 1) / 8'000'000);
    }
  }
}

}  // namespace
}  // namespace changeover::bench_stock_test
