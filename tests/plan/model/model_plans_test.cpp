// Plans for models against all rows, and small ones against the best there is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "changeover/core/error.hpp"
#include "changeover/plan/run_plan.hpp"
#include "message_of.hpp"
#include "random_models.hpp"

namespace changeover::model_plans_test {
namespace {

using testing::HasSubstr;

RunPlan planned(const Job& job, PlanObjective objective = PlanObjective::cost,
                std::uint64_t steps = 4000) {
  RunControl control({.threads = 1});
  return make_run_plan(job, {.objective = objective, .steps = steps, .attempts = 2}, control);
}

struct NeededPair {
  Element x;
  Element y;
};

std::vector<NeededPair> needed_pairs(const Job& job) {
  std::vector<NeededPair> pairs;
  job.needed.for_each(std::numeric_limits<std::uint64_t>::max(), [&](Element x, Element y) {
    pairs.push_back({x, y});
  });
  return pairs;
}

// What a list costs, and whether it does the job, in the plainest words.
struct Judged {
  std::uint64_t cost = 0;
  bool does_the_job = true;
};

std::uint64_t step_cost(const Job& job, const Block& before, const Block& after) {
  std::uint64_t cost = job.test_cost.millionths;
  for (const Element x : after) {
    if (std::find(before.begin(), before.end(), x) != before.end()) {
      continue;
    }
    std::uint64_t change = job.change_costs[x].millionths;
    for (const Element y : before) {
      if (!job.replace_costs.empty() && job.slot_of[y] == job.slot_of[x]) {
        change = job.replace_costs[y * job.parts() + x].millionths;
      }
    }
    cost += change;
  }
  return cost;
}

Judged judged(const Job& job, const std::vector<Block>& list) {
  Judged judged;
  Block before = job.start;
  for (const Block& test : list) {
    judged.does_the_job = judged.does_the_job && follows(*job.model, test);
    judged.cost += step_cost(job, before, test);
    before = test;
  }
  for (const auto& [x, y] : needed_pairs(job)) {
    judged.does_the_job =
        judged.does_the_job && std::any_of(list.begin(), list.end(), [&](const Block& test) {
          return test::shows(*job.model, test, x, y);
        });
  }
  return judged;
}

// The least cost, and the fewest tests, by what is covered and the last row.
struct Least {
  std::uint64_t cost = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t tests = std::numeric_limits<std::uint64_t>::max();
};

Least least_of(const Job& job) {
  const std::vector<Block> rows = test::all_tests(*job.model);
  const std::vector<NeededPair> pairs = needed_pairs(job);
  std::vector<unsigned> shown;
  for (const Block& row : rows) {
    unsigned mask = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      mask |= test::shows(*job.model, row, pairs[i].x, pairs[i].y) ? 1U << i : 0U;
    }
    shown.push_back(mask);
  }
  const unsigned all = (1U << pairs.size()) - 1;
  constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();
  std::vector<std::vector<std::uint64_t>> cost(all + 1,
                                               std::vector<std::uint64_t>(rows.size(), never));
  std::vector<std::uint64_t> tests(all + 1, never);
  tests[0] = 0;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    cost[shown[r]][r] = step_cost(job, job.start, rows[r]);
  }
  Least least;
  // A row that shows nothing new may still be a way between two others: it costs at least as much
  // as going straight, unless prices depend on what is replaced; such jobs are not given here.
  for (unsigned mask = 0; mask <= all; ++mask) {
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (tests[mask] != never) {
        tests[mask | shown[r]] = std::min(tests[mask | shown[r]], tests[mask] + 1);
      }
      if (cost[mask][r] == never) {
        continue;
      }
      for (std::size_t next = 0; next < rows.size(); ++next) {
        const unsigned after = mask | shown[next];
        if (after != mask) {
          cost[after][next] =
              std::min(cost[after][next], cost[mask][r] + step_cost(job, rows[r], rows[next]));
        }
      }
    }
  }
  least.tests = tests[all];
  for (const std::uint64_t each : cost[all]) {
    least.cost = std::min(least.cost, each);
  }
  return least;
}

TEST(ModelPlans, RowsAreTestsAndAllPairsThatCanMeetDo) {
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    const std::string text = test::random_model_text(seed, 5, 4);
    const Job job = test::job_of_text(text, "2", "1");
    const PlanObjective objective = seed % 2 == 0 ? PlanObjective::tests : PlanObjective::cost;
    const RunPlan plan = planned(job, objective, 2000);
    if (job.needed.size() == 0) {
      EXPECT_TRUE(plan.sheet.steps.empty());
      continue;
    }
    for (const Candidate& candidate : plan.candidates) {
      const Judged here = judged(job, candidate.setups);
      EXPECT_TRUE(here.does_the_job) << text << candidate.name;
      EXPECT_EQ(here.cost, candidate.cost.millionths) << text;
      EXPECT_GE(candidate.cost, plan.bound.cost) << text << plan.bound.reason;
      EXPECT_GE(candidate.tests(), plan.bound.tests) << text << plan.bound.reason;
      EXPECT_GE(candidate.changes, plan.bound.introductions) << text << plan.bound.reason;
    }
  }
}

TEST(ModelPlans, SmallOnesAreTheBestThereIs) {
  std::size_t tried = 0;
  std::size_t with_rules = 0;
  std::size_t hidden = 0;
  std::uint64_t least_sum = 0;
  std::uint64_t bound_sum = 0;
  for (std::uint64_t seed = 1; tried < 60; ++seed) {
    const std::string text = test::random_model_text(seed, 3, 3);
    Job job = test::job_of_text(text, std::to_string(seed % 4), "1");
    if (job.needed.size() == 0 || job.needed.size() > 11 ||
        test::all_tests(*job.model).size() > 18) {
      continue;
    }
    if (seed % 2 == 0) {
      for (Element x = 0; x < job.parts(); ++x) {
        job.change_costs[x] = Amount{(1 + (x * 7 + seed) % 5) * 1'000'000};
      }
    }
    if (seed % 3 == 0) {
      job.start = test::all_tests(*job.model).front();
    }
    ++tried;
    with_rules += job.model->constraints.empty() ? 0U : 1U;
    for (Element x = 0; x < job.parts(); ++x) {
      hidden += job.model->value(x).negative ? 1U : 0U;
    }
    const Least least = least_of(job);
    const RunPlan cheap = planned(job, PlanObjective::cost, 40'000);
    EXPECT_EQ(cheap.sheet.cost.millionths, least.cost) << text << seed;
    EXPECT_LE(cheap.bound.cost.millionths, least.cost) << text << cheap.bound.reason;
    const RunPlan few = planned(job, PlanObjective::tests);
    EXPECT_EQ(few.sheet.steps.size(), least.tests) << text << seed;
    EXPECT_LE(few.bound.tests, least.tests) << text << few.bound.reason;
    EXPECT_EQ(few.proved_fewest(), few.bound.tests == least.tests) << text;
    least_sum += least.cost;
    bound_sum += cost_bound(job).cost.millionths;
  }
  EXPECT_GT(with_rules, 20U);
  EXPECT_GT(hidden, 10U);
  EXPECT_GT(bound_sum * 10, least_sum * 8);  // and are not far from it
}

TEST(ModelPlans, AListWithAnyOtherValueIsJudgedAsItIs) {
  std::size_t rejected = 0;
  std::size_t accepted = 0;
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    const std::string text = test::random_model_text(seed, 4, 3);
    const Job job = test::job_of_text(text);
    if (job.needed.size() == 0) {
      continue;
    }
    const std::vector<Block> list =
        planned(job, PlanObjective::tests, 1000).candidates.front().setups;
    for (std::size_t at = 0; at < list.size(); ++at) {
      std::vector<Block> without = list;
      without.erase(without.begin() + static_cast<std::ptrdiff_t>(at));
      EXPECT_EQ(run_sheet(job, without).does_the_job(), judged(job, without).does_the_job);
      const Block row = list[at];
      for (const Element cell : row) {
        for (Element x = 0; x < job.parts(); ++x) {
          std::vector<Block> other = list;
          std::replace(other[at].begin(), other[at].end(), cell, x);
          const bool expected = judged(job, other).does_the_job;
          ++(expected ? accepted : rejected);
          ASSERT_EQ(run_sheet(job, other).does_the_job(), expected) << text << at;
        }
      }
    }
  }
  EXPECT_GT(rejected, 1000U);
  EXPECT_GT(accepted, 100U);
}

TEST(ModelPlans, EveryThreeMeetWithStrengthThree) {
  Job job = job_of(
      test::model_of(
          "A: 1, 2, 3\nB: 1, 2\nC: x, y\nD: u, v\nIF [A] = 1 THEN [B] <> 2 OR [C] = \"x\";\n"),
      parse_amount("1"), parse_amount("1"));
  EXPECT_EQ(need_triples(job), 1U);  // 1, 2 and y
  const RunPlan plan = planned(job);
  EXPECT_TRUE(plan.sheet.does_the_job());
  EXPECT_EQ(plan.bound.tests, 12U);  // A, B and C or D
  EXPECT_EQ(plan.sheet.triples_needed, 12U + 12 + 8 + 12 - 1);
}

TEST(ModelPlans, KnownFewestTests) {
  const auto tests = [](const std::string& text) {
    const RunPlan plan = planned(test::job_of_text(text), PlanObjective::tests, 40'000);
    return std::pair(plan.sheet.steps.size(), plan.bound.tests);
  };
  const auto parameters = [](unsigned count, const std::string& values) {
    std::string text;
    for (unsigned i = 0; i < count; ++i) {
      text += "P" + std::to_string(i) + ": " + values + "\n";
    }
    return text;
  };
  EXPECT_EQ(tests(parameters(4, "1, 2, 3")), (std::pair<std::size_t, std::uint64_t>(9, 9)));
  EXPECT_EQ(tests(parameters(4, "1, 2")), (std::pair<std::size_t, std::uint64_t>(5, 5)));
  EXPECT_EQ(tests(parameters(10, "1, 2")), (std::pair<std::size_t, std::uint64_t>(6, 6)));
  EXPECT_EQ(tests("A: ~-1, 0, 1, 2\nB: ~-1, 0, 1, 2\n"),
            (std::pair<std::size_t, std::uint64_t>(15, 15)));
  EXPECT_EQ(tests("A: ~-1, 0, 1\nB: 1, 2\nC: 1, 2\n"),
            (std::pair<std::size_t, std::uint64_t>(6, 6)));
}

TEST(ModelPlans, WhatWasDoneWhatComesFirstAndWhatStays) {
  const std::string text =
      "OS: Debian, Fedora, Windows\nBrowser: Firefox, Chrome, Edge\nLocale: de, en, ja\n"
      "IF [Browser] = \"Edge\" THEN [OS] = \"Windows\";\n";
  Job job = test::job_of_text(text, "10", "1");
  Job first = job;
  first.first =
      read_first(*input_from_text("Browser\tOS\tLocale\nEdge\t\tja\nFirefox\tFedora\t\n"), job);
  ASSERT_EQ(first.first.size(), 2U);
  const RunPlan plan = planned(first);
  EXPECT_TRUE(plan.sheet.does_the_job());
  EXPECT_EQ(plan.sheet.steps[0].setup, (Block{2, 5, 8}));
  EXPECT_TRUE(std::ranges::includes(plan.sheet.steps[1].setup, Block{1, 3}));
  Job done = job;
  mark_done(done, {{2, 5, 8}, {0, 3, 6}});
  EXPECT_EQ(done.needed.size(), job.needed.size() - 6);
  EXPECT_TRUE(planned(done).sheet.does_the_job());
  Job mounted = job;
  mounted.mounted = parts_named({"os=windows"}, job);
  drop_needed(mounted, cannot_meet(mounted));
  EXPECT_EQ(mounted.needed.size(), 9U + 3 + 3);
  for (const RunStep& step : planned(mounted).sheet.steps) {
    EXPECT_EQ(step.setup.front(), 2U);
  }
  RunControl control({.threads = 1});
  const RunPlan within =
      make_run_plan(job, {.steps = 4000, .attempts = 2, .budget = parse_amount("60")}, control);
  EXPECT_LE(within.sheet.cost, parse_amount("60"));
  EXPECT_GE(within.sheet.pairs_tested, 12U);
  EXPECT_TRUE(within.complete);
}

TEST(ModelPlans, WhatIsThereAtTheStartMustNotStayForWhatIsMounted) {
  Job job = test::job_of_text("A: a, b\nB: c, d\nC: e, f, g\n", "2", "2");
  job.mounted = {0};
  drop_needed(job, cannot_meet(job));
  job.start = {1, 5};
  const RunPlan plan = planned(job);
  EXPECT_TRUE(plan.sheet.does_the_job());
  for (const RunStep& step : plan.sheet.steps) {
    EXPECT_EQ(step.setup.front(), 0U);
  }
  job.start = {0, 1, 5};
  ASSERT_EQ(defects(job).size(), 1U);
  EXPECT_EQ(defects(job).front(),
            "a and b are both set at the start, but a test has one value of A; keep one");
  job.start = {};
  job.mounted = {0, 1};
  EXPECT_EQ(defects(job),
            std::vector<std::string>{
                "a and b both stay mounted, but a test has one value of A; keep one"});
}

// A row serves as many pairs as it can, also in haste: two parameters need 64 tests here.
TEST(ModelPlans, StoppedAtOnceTheListIsNotLong) {
  std::string text;
  for (int p = 0; p < 12; ++p) {
    text += "P" + std::to_string(p) + ": ";
    for (int v = 0; v < 8; ++v) {
      text += (v > 0 ? ", v" : "v") + std::to_string(v) + "_" + std::to_string(p);
    }
    text += "\n";
  }
  text += "IF [P0] = \"v0_0\" THEN [P1] <> \"v1_1\";\n";
  const Job job = test::job_of_text(text);
  RunControl control({.time = std::chrono::seconds(0), .threads = 1});
  const RunPlan plan =
      make_run_plan(job, {.objective = PlanObjective::tests, .steps = 0, .attempts = 1}, control);
  EXPECT_EQ(plan.sheet.pairs_tested, job.needed.size());
  EXPECT_LT(plan.sheet.steps.size(), 200U);  // one pair per row would be thousands
}

TEST(ModelPlans, SaysWhichRuleLeavesNoTest) {
  const auto complaint = [](const std::string& text) -> std::string {
    const std::vector<std::string> found =
        defects(job_of(test::model_of(text), Amount{}, Amount{}));
    return found.empty() ? "" : found.front();
  };
  EXPECT_EQ(
      complaint("A: a, b\nB: a, b\n[A] = [B];\n[A] = \"a\";\n[B] = \"b\";\n[A] = \"b\";\n"),
      "m.txt:5: no test obeys this rule and those before it: [B] = \"b\"; change one of them");
  EXPECT_EQ(
      complaint("A: a, b\nB: a, b\n[A] = \"x\";\n"),
      "m.txt:3: no test obeys this rule and those before it: [A] = \"x\"; change one of them");
  EXPECT_EQ(complaint("A: a, b\nB: a, b\n[A] <> \"x\";\n"), "");
  Job job = test::job_of_text("A: a, b\nB: a, b\n[A] = [B];\n");
  job.mounted = {0, 3};
  EXPECT_THAT(defects(job).at(0), HasSubstr("with what stays mounted"));
  job = test::job_of_text("A: a, b\nB: c, d\n");
  job.slots[0].most = 2;
  EXPECT_THAT(defects(job).at(0), HasSubstr("not the values of the model"));
  job = test::job_of_text("A: a, b\nB: c, d\n[A] = \"a\" OR [B] = \"c\";\n");
  job.needed.insert(1, 3);
  EXPECT_EQ(defects(job).at(0),
            "b and d must meet, but no test of the model has both; leave the pair out, or loosen "
            "the rules");
}

TEST(ModelPlans, CostsByWhatIsReplacedAreThoseOfTheParameter) {
  Job job = test::job_of_text("OS: Debian, Windows\nDB: MySQL, SQLite, Oracle\n", "1", "5");
  (void)read_value_costs(
      *input_from_text(
          "OS,Debian,Windows,9\nDB,MySQL,SQLite,Oracle\nMySQL,,1,2\nSQLite,1,,2\nOracle,3,3,\n"),
      job);
  const RunSheet sheet = run_sheet(job, {{0, 2}, {1, 4}, {0, 3}});
  ASSERT_TRUE(sheet.faults.empty());
  EXPECT_EQ(to_string(sheet.steps[0].cost), "11");
  EXPECT_EQ(to_string(sheet.steps[1].cost), "12");  // 1 + 9 + 2
  EXPECT_EQ(to_string(sheet.steps[2].cost), "9");   // 1 + 5 + 3
  EXPECT_EQ(sheet.steps[1].replaced, (std::vector<std::pair<Element, Element>>{{0, 1}, {2, 4}}));
  const RunPlan plan = planned(job);
  EXPECT_EQ(judged(job, plan.candidates.front().setups).cost, plan.sheet.cost.millionths);
  EXPECT_LE(plan.bound.cost, plan.sheet.cost);
}

TEST(ModelPlans, WhatIsNotDoneForModelsIsRefused) {
  Job job = test::job_of_text("A: a, b\nB: c, d\n");
  job.weights.set(0, 2, parse_amount("5"));
  EXPECT_REFUSAL((void)planned(job), BadInput,
                 "plans of a model do not support weights of pairs; leave the weights out");
  RunControl control({.threads = 1});
  EXPECT_REFUSAL(
      (void)make_run_plan(make_job(4, 2, Amount{1}, Amount{1}), {.objective = PlanObjective::tests},
                          control),
      BadInput,
      "only plans of a model can have the objective of fewest tests; choose another objective");
}

}  // namespace
}  // namespace changeover::model_plans_test
