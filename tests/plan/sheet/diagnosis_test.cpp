#include "changeover/plan/diagnosis.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "changeover/core/error.hpp"
#include "changeover/plan/run_plan.hpp"
#include "random_jobs.hpp"

namespace changeover::diagnosis_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Amount units(std::uint64_t n) { return Amount{n * 1'000'000}; }

bool fails(const Block& setup, const Suspect& fault) {
  const auto in = [&](Element x) { return std::count(setup.begin(), setup.end(), x) != 0; };
  return in(fault.one) && (!fault.other || in(*fault.other));
}

std::vector<Suspect> all_faults(const Job& job) {
  std::vector<Suspect> all;
  for (Element x = 0; x < job.parts(); ++x) {
    all.push_back({x, std::nullopt});
    for (Element y = x + 1; y < job.parts(); ++y) {
      all.push_back({x, y});
    }
  }
  return all;
}

std::vector<TestedSetup> results_of(const std::vector<Block>& setups,
                                    const std::vector<Suspect>& faults) {
  std::vector<TestedSetup> results;
  for (const Block& setup : setups) {
    results.push_back({setup, std::any_of(faults.begin(), faults.end(), [&](const Suspect& fault) {
                         return fails(setup, fault);
                       })});
  }
  return results;
}

// The suspects that are left once the tree was followed under this fault.
std::vector<Suspect> after_all_tests(const Diagnosis& found, const Suspect& fault, Amount& cost) {
  std::map<std::vector<bool>, const NextTest*> by_results;
  for (const NextTest& test : found.tests) {
    by_results[test.after] = &test;
  }
  std::vector<bool> results;
  std::vector<Suspect> left = found.suspects;
  while (by_results.count(results) != 0) {
    const NextTest& test = *by_results[results];
    const bool failed = fails(test.setup, fault);
    left = failed ? test.if_it_fails : test.if_it_passes;
    cost += test.cost;
    results.push_back(failed);
  }
  return left;
}

// Whether some set-up has all of exactly one of them.
bool can_be_told_apart(const Job& job, const Suspect& a, const Suspect& b) {
  for (unsigned bits = 1; bits < 1U << job.parts(); ++bits) {
    Block setup;
    for (Element x = 0; x < job.parts(); ++x) {
      if ((bits >> x & 1U) != 0) {
        setup.push_back(x);
      }
    }
    if (fails(setup, a) != fails(setup, b) && run_sheet(job, {setup}).faults.empty()) {
      return true;
    }
  }
  return false;
}

TEST(Diagnosis, SuspectsAreThoseThatExplainAndTestsTellThemApart) {
  std::uint64_t told_apart = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Job job =
        seed % 3 == 0 ? test::random_job(seed, 7) : test::random_job_with_slots(seed, 7);
    RunControl control({.threads = 1});
    const std::vector<Block> setups =
        make_run_plan(job, {.steps = 1000, .attempts = 1, .design_moves = 0}, control)
            .candidates.front()
            .setups;
    const std::vector<Suspect> faults = all_faults(job);
    for (const Suspect& fault : faults) {
      const auto results = results_of(setups, {fault});
      const Diagnosis found = diagnose(job, results);
      std::vector<Suspect> expected;
      for (const Suspect& other : faults) {
        bool same = found.failed > 0;
        for (const TestedSetup& test : results) {
          same = same && fails(test.setup, other) == test.failed;
        }
        if (same) {
          expected.push_back(other);
        }
      }
      EXPECT_THAT(found.suspects, testing::UnorderedElementsAreArray(expected)) << seed;
      for (const NextTest& test : found.tests) {
        EXPECT_THAT(run_sheet(job, {test.setup}).faults, IsEmpty());
      }
      for (const Suspect& hidden : found.suspects) {
        Amount cost;
        const std::vector<Suspect> left = after_all_tests(found, hidden, cost);
        EXPECT_LE(cost, found.most_cost);
        EXPECT_EQ(std::count(left.begin(), left.end(), hidden), 1);
        told_apart += left.size() < found.suspects.size() ? 1U : 0U;
        if (job.never.size() > 0 && !job.slots.empty()) {
          continue;  // what fills the slots is not sought among all
        }
        for (const Suspect& other : left) {
          EXPECT_FALSE(!(other == hidden) && can_be_told_apart(job, hidden, other)) << seed;
        }
      }
    }
  }
  EXPECT_GT(told_apart, 1000U);
}

TEST(Diagnosis, TwoFaultsAreFoundOut) {
  const Job job = make_job(7, 3, units(2), units(1));
  const std::vector<Block> fano{{0, 1, 2}, {0, 3, 4}, {0, 5, 6}, {1, 3, 5},
                                {1, 4, 6}, {2, 3, 6}, {2, 4, 5}};
  const Diagnosis found = diagnose(job, results_of(fano, {{0, 1}, {4, 5}}));
  EXPECT_THAT(found.suspects, IsEmpty());
  EXPECT_THAT(found.tests, IsEmpty());
  const std::pair<Suspect, Suspect> faults{{0, 1}, {4, 5}};
  EXPECT_EQ(std::count(found.two.begin(), found.two.end(), faults), 1);
  for (const auto& [one, other] : found.two) {
    EXPECT_EQ(std::count(found.two.begin(), found.two.end(), std::pair(other, one)), 0);  // once
    for (const TestedSetup& test : results_of(fano, {{0, 1}, {4, 5}})) {
      EXPECT_EQ(fails(test.setup, one) || fails(test.setup, other), test.failed);
    }
  }
  const Diagnosis three = diagnose(job, results_of(fano, {{0, 1}, {3, 5}, {2, 6}}));
  EXPECT_THAT(three.two, IsEmpty());
  EXPECT_THAT(written(job, three, "table", 80), HasSubstr("three at least"));
}

TEST(Diagnosis, SaysSo) {
  Job job = make_job(5, 3, units(2), units(1));
  job.names = {"Pump", "Motor", "Belt", "Fan", "Hose"};
  const Diagnosis found = diagnose(job, {{{0, 1, 2}, true}, {{0, 3, 4}, false}, {{2, 3}, false}});
  EXPECT_THAT(found.suspects,
              ElementsAre(Suspect{1, std::nullopt}, Suspect{0, 1}, Suspect{0, 2}, Suspect{1, 2}));
  const std::string text = written(job, found, "table", 200);
  EXPECT_THAT(text, HasSubstr("3 tests: 2 passed, 1 failed"));
  EXPECT_THAT(text, HasSubstr("  part Motor\n  pair Pump with Motor\n"));
  const std::string json = written(job, found, "json");
  EXPECT_THAT(json, HasSubstr("\"suspects\":[[\"Motor\"],[\"Pump\",\"Motor\"]"));
  EXPECT_THAT(json, HasSubstr("\"after\":[],\"set_up\":["));
  EXPECT_THAT(written(job, diagnose(job, {{{0, 1}, false}}), "table", 80),
              HasSubstr("No test failed"));
  const Diagnosis one = diagnose(job, {{{0, 1}, true}, {{0, 2}, false}, {{1, 2}, false}});
  EXPECT_THAT(written(job, one, "table", 80),
              HasSubstr("One fault alone explains all results:\n  pair Pump with Motor"));
  EXPECT_THROW((void)diagnose(job, {{{0, 0}, true}}), BadInput);
  EXPECT_THROW((void)diagnose(job, {{{0, 9}, true}}), BadInput);
}

TEST(Diagnosis, IsOpenWhereResultsAreNotUnderstood) {
  const Job job = make_job(5, 3, Amount{1}, Amount{1});
  Diagnosis found = diagnose(job, {{{0, 1}, false}});
  found.unread = 2;
  found.first_unread = {{"s.csv:3:4", "hot"}};
  const std::string text = written(job, found, "table", 80);
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("nothing is suspect")));
  EXPECT_THAT(text,
              testing::HasSubstr("Diagnosis of 3 tests: 1 passed, 0 failed, 2 not understood"));
  EXPECT_THAT(text, testing::HasSubstr("s.csv:3:4: the result 'hot' is not understood"));
  EXPECT_THAT(text, testing::HasSubstr("and 1 more"));
}

TEST(Diagnosis, OfManySuspects) {
  const Job job = make_job(40, 20, units(2), units(1));
  Block half;
  for (Element x = 0; x < 20; ++x) {
    half.push_back(x);
  }
  const Diagnosis found = diagnose(job, {{half, true}});
  EXPECT_EQ(found.suspects.size(), 20U + 190U);
  Amount cost;
  EXPECT_LT(after_all_tests(found, {3, 17}, cost).size(), 20U);
}

TEST(Diagnosis, ContradictionsAreNamed) {
  const Job job = make_job(6, 3, parse_amount("1"), parse_amount("1"));
  const Diagnosis found =
      diagnose(job, {{{0, 1, 2}, true}, {{2, 1, 0}, false}, {{3, 4}, true}, {{3, 4, 5}, false}});
  ASSERT_EQ(found.contradictions.size(), 2U);
  EXPECT_EQ(found.contradictions[1].second, (Block{3, 4, 5}));
  const std::string text = written(job, found, "table", 100);
  EXPECT_NE(text.find("  1, 2, 3 failed and passed\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  4, 5 failed, and passed as part of 4, 5, 6\n"), std::string::npos) << text;
  EXPECT_NE(written(job, found, "json").find("\"contradictions\":[{\"failed\":[\"1\""),
            std::string::npos);
  EXPECT_TRUE(diagnose(job, {{{0, 1, 2}, true}, {{0, 1}, false}}).contradictions.empty());
}

}  // namespace
}  // namespace changeover::diagnosis_test
