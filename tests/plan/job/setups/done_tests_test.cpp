// What tests that were done leave to be tested, against a checker that looks at one pair at a time.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "changeover/core/error.hpp"
#include "changeover/plan/run_plan.hpp"
#include "message_of.hpp"

namespace changeover::done_tests_test {
namespace {

bool holds(const Block& setup, const Block& parts) {
  return std::all_of(parts.begin(), parts.end(), [&](Element x) {
    return std::find(setup.begin(), setup.end(), x) != setup.end();
  });
}

struct Wanted {
  std::set<Block> needed;
  std::uint64_t only_in_failed = 0;
};

// By definition, for parts that must meet in groups of `size`.
Wanted by_definition(std::uint64_t v, std::size_t size, const std::vector<DoneTest>& tests,
                     const std::set<Block>& asked, bool trusted) {
  Wanted wanted;
  std::vector<bool> chosen(v);
  std::fill(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(size), true);
  do {
    Block group;
    for (Element x = 0; x < v; ++x) {
      if (chosen[x]) {
        group.push_back(x);
      }
    }
    if (asked.count(group) == 0) {
      continue;
    }
    bool sound = false;
    bool doubtful = false;
    for (const DoneTest& test : tests) {
      if (!holds(test.setup, group) || test.result == TestResult::not_run) {
        continue;
      }
      const bool doubt = test.result == TestResult::fail || test.result == TestResult::unread;
      (doubt ? doubtful : sound) = true;
    }
    wanted.only_in_failed += doubtful && !sound ? 1U : 0U;
    if (!sound && !(doubtful && trusted)) {
      wanted.needed.insert(group);
    }
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  return wanted;
}

std::set<Block> pairs_of(const Job& job) {
  std::set<Block> all;
  job.needed.for_each(~std::uint64_t{0}, [&](Element x, Element y) {
    all.insert({std::min(x, y), std::max(x, y)});
  });
  return all;
}

std::set<Block> triples_of(const Job& job) {
  std::set<Block> all;
  for (const Triple& t : job.triples) {
    all.insert(Block(t.begin(), t.end()));
  }
  return all;
}

std::vector<DoneTest> some_tests(std::mt19937& random, std::uint64_t v, std::uint64_t k) {
  constexpr std::array<TestResult, 6> results{TestResult::none,    TestResult::pass,
                                              TestResult::fail,    TestResult::done,
                                              TestResult::not_run, TestResult::unread};
  std::vector<DoneTest> tests(random() % 12);
  for (DoneTest& test : tests) {
    Block parts(v);
    std::iota(parts.begin(), parts.end(), Element{0});
    std::shuffle(parts.begin(), parts.end(), random);
    parts.resize(1 + random() % k);
    test = {parts, results.at(random() % results.size())};
  }
  return tests;
}

TEST(DoneTests, LeaveWhatTheirResultsSayAndThePlanTestsIt) {
  std::mt19937 random(7);
  std::uint64_t again = 0;
  for (int i = 0; i < 400; ++i) {
    const std::uint64_t v = 4 + random() % 5;
    const std::uint64_t k = 3 + random() % 2;
    const bool triples = i % 3 == 0;
    const bool trusted = i % 2 == 0;
    Job job = make_job(v, k, Amount{2'000'000}, Amount{1'000'000});
    if (triples) {
      (void)need_triples(job);
    } else if (i % 5 == 0) {
      job.needed = PairSet(v);
      job.needed.insert(0, 1);
      job.needed.insert(1, 3);
    }
    const std::vector<DoneTest> tests = some_tests(random, v, k);
    const Wanted wanted = by_definition(v, triples ? 3 : 2, tests,
                                        triples ? triples_of(job) : pairs_of(job), trusted);
    mark_tested(job, tests, trusted ? FailedTests::trusted : FailedTests::again);
    EXPECT_EQ(triples ? triples_of(job) : pairs_of(job), wanted.needed) << i;
    EXPECT_EQ(job.met_only_in_failed, wanted.only_in_failed) << i;
    EXPECT_EQ(job.trust_failed, trusted);
    again += trusted ? 0 : wanted.only_in_failed;
    RunControl control({.threads = 1});
    const RunPlan plan =
        make_run_plan(job, {.steps = 100, .attempts = 1, .design_moves = 0, .states = 0}, control);
    for (const Block& group : wanted.needed) {
      EXPECT_TRUE(std::any_of(plan.sheet.steps.begin(), plan.sheet.steps.end(),
                              [&](const RunStep& step) { return holds(step.setup, group); }))
          << i;
    }
    EXPECT_EQ(triples ? plan.sheet.triples_needed : plan.sheet.pairs_needed, wanted.needed.size());
  }
  EXPECT_GT(again, 100U) << "or nothing was tried";
}

TEST(DoneTests, OnesThatWereNotRunAreNotCountedAndNotOnTheBench) {
  Job job = make_job(5, 3, Amount{1}, Amount{1});
  mark_tested(job, {{{0, 1}, TestResult::fail}, {{2, 3}, TestResult::not_run}});
  EXPECT_EQ(job.tests_done, 1U);
  EXPECT_EQ(job.start, (Block{0, 1}));
  EXPECT_EQ(job.needed.size(), 10U);
  EXPECT_EQ(job.met_only_in_failed, 1U);
}

TEST(DoneTests, AFaultLeavesTheJobAsItWas) {
  Job job = make_job(5, 3, Amount{1}, Amount{1});
  EXPECT_REFUSAL(mark_tested(job, {{{0, 1}, TestResult::pass}, {{2, 2}, TestResult::fail}}),
                 BadInput, "a test that was done has 3 twice; name each part once");
  EXPECT_EQ(job.needed.size(), 10U);
  EXPECT_EQ(job.tests_done, 0U);
}

TEST(DoneTests, ALongRestOfASheetIsCutToWhatBringsSomething) {
  const Job job = make_job(6, 3, Amount{1'000'000}, Amount{1'000'000});
  std::vector<Block> rest;
  for (int i = 0; i < 50; ++i) {
    for (Element x = 0; x < 6; ++x) {
      rest.push_back({x, (x + 1) % 6, (x + 3) % 6});
    }
  }
  RunControl control({.threads = 1});
  const RunPlan plan = make_run_plan(
      job, {.steps = 1, .attempts = 1, .rest = rest, .design_moves = 0, .states = 0}, control);
  EXPECT_TRUE(plan.sheet.does_the_job());
  for (const Candidate& candidate : plan.candidates) {
    EXPECT_LE(candidate.tests(), 15U) << candidate.name;
  }
}

}  // namespace
}  // namespace changeover::done_tests_test
