// Plans of models for several benches: against looking at all plans of tiny ones, and against the
// definition for others.
#include <gtest/gtest.h>
#include <array>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "../../bench_checker.hpp"
#include "../../random_models.hpp"
#include "../../some_models.hpp"
#include "changeover/core/error.hpp"
#include "changeover/plan/benches.hpp"
#include "changeover/plan/model.hpp"
#include "plan/job/setups/setup_list.hpp"
#include "run/random.hpp"

namespace changeover::model_benches_test {
namespace {

using test::all_tests;
using test::model_of;
using test::random_model_text;
using test::shows;

bool has_any(const Block& row, const Block& values) {
  return std::ranges::any_of(row, [&](Element x) { return std::ranges::count(values, x) > 0; });
}

// The tests of a model that a bench can run.
std::vector<Block> rows_of(const Model& model, const Bench& bench) {
  std::vector<Block> rows = bench.down ? std::vector<Block>() : all_tests(model);
  std::erase_if(rows, [&](const Block& row) {
    return has_any(row, bench.without) ||
           std::ranges::any_of(bench.mounted.value_or(Block()),
                               [&](Element m) { return std::ranges::count(row, m) == 0; });
  });
  return rows;
}

using Pairs = std::vector<std::pair<Element, Element>>;

// The pairs of values that some bench can test.
Pairs possible_pairs(const Model& model, const std::vector<Bench>& benches) {
  std::set<std::pair<Element, Element>> found;
  for (const Bench& bench : benches) {
    for (const Block& row : rows_of(model, bench)) {
      for (const Element y : row) {
        for (const Element x : row) {
          // Two values out of range are in no test.
          if (x < y && shows(model, row, x, y)) {
            found.insert({x, y});
          }
        }
      }
    }
  }
  return {found.begin(), found.end()};
}

Job job_for(const std::string& text, const std::vector<Bench>& benches, Random& random) {
  Job job = job_of(model_of(text), Amount{(1 + random.below(4)) * 1'000'000ULL}, Amount{});
  for (Amount& cost : job.change_costs) {
    cost = Amount{(1 + random.below(4)) * 1'000'000ULL};
  }
  drop_needed(job, cannot_meet(job, benches));
  return job;
}

struct Least {
  std::uint64_t cost = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t makespan = std::numeric_limits<std::uint64_t>::max();
  std::pair<std::size_t, std::uint64_t> tests{std::numeric_limits<std::size_t>::max(), 0};
};

// The least cost, the least makespan, and the fewest tests with the least makespan that these can
// have, of two benches: all that can be tested, the last tests of both and the number of tests,
// with what each bench has cost. A test that shows nothing new can be left out.
Least by_looking(const Job& job, const std::vector<Bench>& benches, const Pairs& pairs) {
  const Model& model = *job.model;
  using Costs = std::set<std::pair<std::uint64_t, std::uint64_t>>;
  const auto last = static_cast<std::size_t>(-1);
  struct State {
    std::size_t one;
    std::size_t other;
    std::size_t tests;
    auto operator<=>(const State&) const = default;
  };
  std::vector<std::map<State, Costs>> states(std::size_t{1} << pairs.size());
  states[0][{last, last, 0}].insert({0, 0});
  const std::vector<Block> rows[2] = {rows_of(model, benches[0]), rows_of(model, benches[1])};
  const auto shown = [&](const Block& row) {
    std::size_t mask = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      mask |= std::size_t{shows(model, row, pairs[i].first, pairs[i].second)} << i;
    }
    return mask;
  };
  const auto step = [&](std::size_t b, const Block& before, const Block& row) {
    std::uint64_t cost = benches[b].test_cost.value_or(job.test_cost).millionths;
    for (const Element x : row) {
      if (std::ranges::count(before, x) == 0) {
        cost += job.change_costs[x].millionths * benches[b].change_factor.millionths / 1'000'000;
      }
    }
    return cost;
  };
  Least least;
  for (std::size_t mask = 0; mask < states.size(); ++mask) {
    for (const auto& [ends, costs] : states[mask]) {
      Costs kept;  // those that no other one beats
      std::uint64_t best = std::numeric_limits<std::uint64_t>::max();
      for (const auto& [one, other] : costs) {
        if (other < best) {
          best = other;
          kept.insert({one, other});
        }
      }
      if (mask + 1 == states.size()) {
        for (const auto& [one, other] : kept) {
          least.cost = std::min(least.cost, one + other);
          least.makespan = std::min(least.makespan, std::max(one, other));
          least.tests = std::min(least.tests, std::pair(ends.tests, std::max(one, other)));
        }
        continue;
      }
      for (std::size_t b = 0; b < 2; ++b) {
        const std::size_t at = b == 0 ? ends.one : ends.other;
        const Block before = at == last ? benches[b].start.value_or(Block()) : rows[b][at];
        for (std::size_t r = 0; r < rows[b].size(); ++r) {
          const std::size_t next = mask | shown(rows[b][r]);
          if (next == mask) {
            continue;
          }
          const std::uint64_t cost = step(b, before, rows[b][r]);
          Costs& there =
              states[next][{b == 0 ? r : ends.one, b == 1 ? r : ends.other, ends.tests + 1}];
          for (const auto& [one, other] : kept) {
            there.insert({one + (b == 0 ? cost : 0), other + (b == 1 ? cost : 0)});
          }
        }
      }
    }
    states[mask].clear();
  }
  return least;
}

BenchPlan planned(const Job& job, const std::vector<Bench>& benches, BenchObjective objective,
                  std::uint64_t steps = 20'000) {
  RunControl control({.threads = 1});
  return make_bench_plan(
      job, {.objective = objective, .plan = {.steps = steps, .attempts = 2}, .each = benches},
      control);
}

// By the definitions alone: the rows of a plan, what they show, and what they cost.
void expect_is_a_plan(const Job& job, const BenchPlan& plan, const Pairs& pairs) {
  const auto checked = test::check_schedule(job, plan.benches, plan.schedule);
  EXPECT_TRUE(checked.faults.empty()) << checked.faults.front();
  EXPECT_EQ(checked.makespan, plan.makespan.millionths);
  EXPECT_EQ(checked.cost, plan.cost.millionths);
  std::set<std::pair<Element, Element>> met;
  for (std::size_t b = 0; b < plan.schedule.size(); ++b) {
    for (const BenchStep& step : plan.schedule[b]) {
      EXPECT_EQ(broken_rule(*job.model, step.setup), std::nullopt);
      EXPECT_FALSE(has_any(step.setup, plan.benches[b].without));
      for (const auto& [x, y] : pairs) {
        if (shows(*job.model, step.setup, x, y)) {
          met.insert({x, y});
        }
      }
    }
  }
  EXPECT_EQ(met.size(), pairs.size());
  EXPECT_TRUE(plan.does_the_job());
  EXPECT_GE(plan.cost, plan.bound.cost);
  EXPECT_GE(plan.makespan, plan.makespan_bound);
}

// Two or three benches that lack values, at other costs, from other starts.
std::vector<Bench> random_benches(const Model& model, std::size_t number, Random& random) {
  const std::vector<Block> rows = all_tests(model);
  std::vector<Bench> benches(number);
  for (Bench& bench : benches) {
    for (Element x = 0; x < model.values(); ++x) {
      if (random.below(5) == 0) {
        bench.without.push_back(x);
      }
    }
    if (rows_of(model, bench).empty()) {
      bench.without.clear();
    }
    const std::vector<Block> own = rows_of(model, bench);
    if (random.below(3) == 0) {
      bench.start = own[random.below(static_cast<std::uint32_t>(own.size()))];
      if (random.one_in_two()) {
        bench.start->pop_back();
      }
    }
    if (random.below(6) == 0) {
      bench.mounted = Block{own[random.below(static_cast<std::uint32_t>(own.size()))].front()};
    }
    if (random.below(3) == 0) {
      bench.change_factor = Amount{2'000'000};
      bench.test_cost = Amount{5'000'000};
    }
  }
  return benches;
}

TEST(ModelBenches, TinyOnesAreSolvedAndBoundedFromBelow) {
  std::size_t looked_at = 0;
  std::size_t cheapest = 0;
  std::size_t shortest = 0;
  std::size_t fewest = 0;
  std::size_t best = 0;
  for (std::uint64_t seed = 1; looked_at < 40; ++seed) {
    const std::string text = random_model_text(seed, 3, 3);
    const Model model = model_of(text);
    if (model.parameters.size() < 2) {
      continue;
    }
    Random random(seed, 1);
    const std::vector<Bench> benches = random_benches(model, 2, random);
    const Pairs pairs = possible_pairs(model, benches);
    const Job job = job_for(text, benches, random);
    ASSERT_EQ(job.needed.size(), pairs.size()) << text;
    if (pairs.empty() || pairs.size() > 10) {
      continue;
    }
    SCOPED_TRACE(seed);
    SCOPED_TRACE(text);
    ++looked_at;
    const Least least = by_looking(job, benches, pairs);
    for (const BenchObjective objective :
         {BenchObjective::cost, BenchObjective::makespan, BenchObjective::tests}) {
      const BenchPlan plan = planned(job, benches, objective);
      expect_is_a_plan(job, plan, pairs);
      EXPECT_LE(plan.bound.cost.millionths, least.cost) << plan.bound.reason;
      EXPECT_LE(plan.makespan_bound.millionths, least.makespan) << plan.makespan_reason;
      EXPECT_GE(plan.cost.millionths, least.cost);
      EXPECT_GE(plan.makespan.millionths, least.makespan);
      EXPECT_LE(plan.bound.tests, least.tests.first);
      EXPECT_GE(plan.tests, least.tests.first);
      if (objective == BenchObjective::tests) {
        EXPECT_EQ(plan.proved_fewest(), plan.tests == plan.bound.tests);
        fewest += plan.tests == least.tests.first ? 1U : 0U;
        best += std::pair<std::size_t, std::uint64_t>(plan.tests, plan.makespan.millionths) ==
                        least.tests
                    ? 1U
                    : 0U;
      } else if (objective == BenchObjective::cost) {
        cheapest += plan.cost.millionths == least.cost ? 1U : 0U;
      } else {
        shortest += plan.makespan.millionths == least.makespan ? 1U : 0U;
      }
    }
  }
  EXPECT_EQ(cheapest, looked_at);
  EXPECT_EQ(shortest, looked_at);
  EXPECT_EQ(fewest, looked_at);
  EXPECT_EQ(best, looked_at);
}

TEST(ModelBenches, AnyModelIsCoveredOnBenchesThatLackValues) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const std::string text = random_model_text(1000 + seed, 5, 4);
    const Model model = model_of(text);
    SCOPED_TRACE(text);
    Random random(seed, 2);
    std::vector<Bench> benches = random_benches(model, 2 + seed % 2, random);
    benches.back().down = seed % 7 == 0;
    const Pairs pairs = possible_pairs(model, benches);
    const Job job = job_for(text, benches, random);
    ASSERT_EQ(job.needed.size(), pairs.size());
    constexpr std::array objectives{BenchObjective::makespan, BenchObjective::cost,
                                    BenchObjective::tests};
    expect_is_a_plan(job, planned(job, benches, objectives[seed % objectives.size()], 3'000),
                     pairs);
  }
}

TEST(ModelBenches, ScarceValuesAndHoursAreKept) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const std::string text = random_model_text(2000 + seed, 4, 3);
    const Model model = model_of(text);
    SCOPED_TRACE(text);
    Random random(seed, 3);
    std::vector<Bench> benches(2);
    benches.front().hours = Amount{8'000'000};
    Job job = job_for(text, benches, random);
    job.quantities.assign(job.names.size(), enough_for_all);
    for (std::uint64_t& quantity : job.quantities) {
      quantity = random.below(4) == 0 ? 1 : quantity;
    }
    expect_is_a_plan(job, planned(job, benches, BenchObjective::makespan, 2'000),
                     possible_pairs(model, benches));
  }
}

TEST(ModelBenches, TheFewestTestsAreNoMoreThanOnOneBench) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const std::string text = random_model_text(4000 + seed, 5, 4);
    SCOPED_TRACE(text);
    Random random(seed, 7);
    const std::vector<Bench> benches(1 + seed % 4);
    const Pairs pairs = possible_pairs(model_of(text), benches);
    const Job job = job_for(text, benches, random);
    const BenchPlan plan = planned(job, benches, BenchObjective::tests, 3'000);
    expect_is_a_plan(job, plan, pairs);
    RunControl control({.threads = 1});
    const RunPlan one = make_run_plan(
        job, {.objective = PlanObjective::tests, .steps = 3'000, .attempts = 2}, control);
    EXPECT_LE(plan.tests, one.sheet.steps.size());
    EXPECT_GE(plan.bound.tests, one.bound.tests);
    EXPECT_LE(plan.makespan, plan.candidates.front().cost);
    for (const BenchCandidate& each : plan.candidates) {
      EXPECT_LE(std::pair(plan.tests, plan.makespan), std::pair(each.tests, each.makespan));
    }
  }
}

TEST(ModelBenches, FirstTestsCountAmongTheFewest) {
  const std::string text = "A: a, b\nB: x, y\nC: p, q\n";
  std::vector<Bench> benches(2);
  Random random(1, 8);
  const Job job = job_for(text, benches, random);
  benches[1].first = std::vector<Block>{{0, 2, 4}, {0, 2, 5}};
  const BenchPlan plan = planned(job, benches, BenchObjective::tests);
  expect_is_a_plan(job, plan, possible_pairs(model_of(text), benches));
  EXPECT_EQ(plan.tests, 5);  // two given, and each of four pairs of A and C takes a test
  EXPECT_LE(plan.bound.tests, plan.tests);
  EXPECT_GT(plan.bound.tests, 2);
}

TEST(ModelBenches, OnlyModelsCanHaveFewestTests) {
  Job job = job_of(model_of("A: a, b\nB: x, y\n"), Amount{1}, Amount{1});
  job.model = nullptr;
  RunControl control({.threads = 1});
  EXPECT_THROW(
      (void)make_bench_plan(job, {.benches = 2, .objective = BenchObjective::tests}, control),
      BadInput);
}

// Costs by what is replaced, and triples: counted by the library's own check, which knows both.
TEST(ModelBenches, ReplacementCostsAndTriplesAreServed) {
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const std::string text = random_model_text(3000 + seed, 4, 3);
    const Model model = model_of(text);
    SCOPED_TRACE(text);
    Random random(seed, 6);
    const std::vector<Bench> benches = random_benches(model, 2, random);
    Job job = job_for(text, benches, random);
    if (seed % 2 == 0) {
      for (Element out = 0; out < job.parts(); ++out) {
        for (Element in = 0; in < job.parts(); ++in) {
          job.replace_costs.push_back(Amount{(1 + random.below(5)) * 1'000'000ULL});
        }
      }
    } else if (model.parameters.size() > 2) {
      std::set<Triple> possible;
      for (const Bench& bench : benches) {
        for (const Block& row : rows_of(model, bench)) {
          for (std::size_t i = 0; i < row.size(); ++i) {
            for (std::size_t j = i + 1; j < row.size(); ++j) {
              for (std::size_t l = j + 1; l < row.size(); ++l) {
                const bool hidden = std::ranges::any_of(row, [&](Element x) {
                  return model.value(x).negative && x != row[i] && x != row[j] && x != row[l];
                });
                if (!hidden) {
                  possible.insert({row[i], row[j], row[l]});
                }
              }
            }
          }
        }
      }
      job.triples.assign(possible.begin(), possible.end());
    }
    const BenchPlan plan = planned(job, benches, BenchObjective::makespan, 2'000);
    EXPECT_TRUE(plan.does_the_job());
    EXPECT_EQ(plan.triples_tested, job.triples.size());
    EXPECT_GE(plan.cost, plan.bound.cost);
    for (const std::vector<BenchStep>& steps : plan.schedule) {
      for (const BenchStep& step : steps) {
        EXPECT_TRUE(follows(model, step.setup));
      }
    }
  }
}

constexpr const char* office =
    "OS: Debian, Windows, ARM\nBrowser: Firefox, Edge, Safari\nLocale: de, en\n"
    "Cache: on, off\n"
    "IF [Browser] = \"Edge\" THEN [OS] = \"Windows\";\n"
    "IF [Browser] = \"Safari\" AND [Locale] = \"de\" THEN [Cache] = \"on\";\n";

// Each fault planted in a plan is found.
TEST(ModelBenches, ChangedPlansAreRejected) {
  std::vector<Bench> benches(2);
  benches[0].without = {2};
  Random random(1, 4);
  const Job job = job_for(office, benches, random);
  const BenchPlan plan = planned(job, benches, BenchObjective::makespan);
  ASSERT_TRUE(plan.does_the_job());
  std::size_t rules = 0;
  std::size_t lacks = 0;
  std::size_t open = 0;
  for (std::size_t b = 0; b < plan.schedule.size(); ++b) {
    for (std::size_t i = 0; i < plan.schedule[b].size(); ++i) {
      BenchSchedule less = plan.schedule;
      less[b].erase(less[b].begin() + static_cast<std::ptrdiff_t>(i));
      open += count_benches(job, benches, less).pairs_tested < job.needed.size() ? 1U : 0U;
      for (Element x = 0; x < job.parts(); ++x) {
        BenchSchedule other = plan.schedule;
        Element& cell = other[b][i].setup[job.slot_of[x]];
        if (cell == x) {
          continue;
        }
        cell = x;
        const bool is_test = follows(*job.model, other[b][i].setup);
        const bool is_there = !has_any(other[b][i].setup, benches[b].without);
        rules += is_test ? 0U : 1U;
        lacks += is_there ? 0U : 1U;
        // The times of the steps may be wrong, too: the fault must be that of the row.
        const BenchCount count = count_benches(job, benches, other);
        const auto says = [&](const std::string& words) {
          return std::ranges::any_of(count.faults, [&](const std::string& fault) {
            return fault.find(words) != std::string::npos;
          });
        };
        EXPECT_EQ(says("is not a test of the model"), !is_test);
        EXPECT_EQ(says("which the bench cannot have"), !is_there);
      }
    }
  }
  EXPECT_GT(rules, 0U);
  EXPECT_GT(lacks, 0U);
  EXPECT_GT(open, 0U);
}

TEST(ModelBenches, ARowWithAValueThatIsNotThereIsNoSetUp) {
  Random random(1, 8);
  Job job = job_for(office, std::vector<Bench>(2), random);
  EXPECT_EQ(setup_defect(job, {2, 3, 6, 8}), std::nullopt);
  job.barred = {2};
  EXPECT_EQ(setup_defect(job, {2, 3, 6, 8}), "ARM cannot be set here; change it");
  EXPECT_EQ(setup_defect(job, {1, 3, 6, 8}), std::nullopt);
}

TEST(ModelBenches, WhatHasNoMeaningWithAModelIsRefused) {
  Random random(1, 5);
  const std::vector<Bench> alike(2);
  const Job job = job_for(office, alike, random);
  const auto defect = [&](const Bench& bench) {
    const std::vector<std::string> found = bench_defects(job, {bench, Bench{}});
    return found.empty() ? std::string() : found.front();
  };
  EXPECT_EQ(defect({}), "");
  EXPECT_EQ(defect({.at_once = 3}),
            "Bench 1: at_once has no meaning with a model, of whose parameters every test has one "
            "value each; leave it out, and give what the bench lacks as without");
  EXPECT_EQ(defect({.without = {0, 1, 2}}), "Bench 1: it has no value of 'OS'; let it have one");
  EXPECT_EQ(defect({.mounted = Block{4}, .without = {1}}),
            "Bench 1: m.txt:5: no test obeys this rule and those before it, without what the bench "
            "lacks: IF [Browser] = \"Edge\" THEN [OS] = \"Windows\"; change one of them");
}

}  // namespace
}  // namespace changeover::model_benches_test
