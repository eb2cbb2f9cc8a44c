#include "changeover/plan/diagnosis.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <numeric>

#include "changeover/core/error.hpp"
#include "changeover/plan/run_plan.hpp"
#include "message_of.hpp"
#include "random_jobs.hpp"
#include "replacing_jobs.hpp"
#include "run/random.hpp"

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

bool fails(const Block& setup, const std::vector<Suspect>& faults) {
  return std::any_of(faults.begin(), faults.end(),
                     [&](const Suspect& fault) { return fails(setup, fault); });
}

// Asks, runs the next test under these faults, and asks again, until no test tells more.
struct Loop {
  Diagnosis last;
  std::uint64_t tests = 0;
  std::size_t first_explanations = 0;
};

Loop ask_to_the_end(Job job, std::vector<TestedSetup> results, const std::vector<Suspect>& faults) {
  Loop loop;
  if (job.start.empty()) {
    job.start = results.back().setup;
  }
  for (;;) {
    loop.last = diagnose(job, results);
    if (loop.tests == 0) {
      loop.first_explanations = loop.last.explanations.size();
    }
    if (!loop.last.next) {
      return loop;
    }
    const NextTest& next = *loop.last.next;
    EXPECT_THAT(run_sheet(job, {next.setup}).faults, IsEmpty());
    EXPECT_EQ(run_sheet(job, {next.setup}).cost, next.cost);
    if (!next.proves) {
      EXPECT_FALSE(next.if_it_fails.empty() || next.if_it_passes.empty());
      EXPECT_EQ(next.if_it_fails.size() + next.if_it_passes.size(), loop.last.explanations.size());
      for (const Explanation& each : next.if_it_fails) {
        EXPECT_TRUE(fails(next.setup, each));
      }
      for (const Explanation& each : next.if_it_passes) {
        EXPECT_FALSE(fails(next.setup, each));
      }
    }
    results.push_back({next.setup, fails(next.setup, faults)});
    job.start = next.setup;
    job.places.clear();
    ++loop.tests;
    if (loop.tests > 200) {
      ADD_FAILURE() << "the loop does not end";
      return loop;
    }
  }
}

// All sets of so many suspects, none of them cleared, that explain the results: by trying all.
std::vector<Explanation> by_trying(const std::vector<Suspect>& all,
                                   const std::vector<TestedSetup>& results, std::size_t size) {
  std::vector<Explanation> found;
  Explanation chosen;
  const std::function<void(std::size_t)> choose = [&](std::size_t from) {
    if (chosen.size() == size) {
      if (std::all_of(results.begin(), results.end(), [&](const TestedSetup& test) {
            return fails(test.setup, chosen) == test.failed;
          })) {
        found.push_back(chosen);
      }
      return;
    }
    for (std::size_t i = from; i < all.size(); ++i) {
      chosen.push_back(all[i]);
      choose(i + 1);
      chosen.pop_back();
    }
  };
  choose(0);
  for (Explanation& each : found) {
    std::sort(each.begin(), each.end());
  }
  return found;
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

std::vector<Block> planned(const Job& job) {
  RunControl control({.threads = 1});
  return make_run_plan(job, {.steps = 1000, .attempts = 1, .design_moves = 0}, control)
      .candidates.front()
      .setups;
}

TEST(Diagnosis, SuspectsAreThoseThatExplainAndTheLoopTellsThemApart) {
  std::uint64_t told_apart = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Job job =
        seed % 3 == 0 ? test::random_job(seed, 7) : test::random_job_with_slots(seed, 7);
    const std::vector<Block> setups = planned(job);
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
      if (found.failed == 0) {
        EXPECT_FALSE(found.next);
        continue;
      }
      const Loop loop = ask_to_the_end(job, results, {fault});
      const std::vector<Suspect>& left = loop.last.suspects;
      EXPECT_EQ(std::count(left.begin(), left.end(), fault), 1)
          << seed << ": " << in_words(fault, job.names);
      told_apart += left.size() < found.suspects.size() ? 1U : 0U;
      if (job.never.size() > 0 && !job.slots.empty()) {
        continue;  // what fills the slots is not sought among all
      }
      for (const Suspect& other : left) {
        EXPECT_FALSE(!(other == fault) && can_be_told_apart(job, fault, other)) << seed;
      }
    }
  }
  EXPECT_GT(told_apart, 300U);
}

// Without constraints the loop ends at the fault, and takes no more tests than the suspects must,
// and a few.
TEST(Diagnosis, OneFaultIsFoundInAboutAsFewTestsAsAnyWayNeeds) {
  std::uint64_t tests = 0;
  std::uint64_t least = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed, 3);
    const std::uint32_t v = 12 + random.below(30);
    Job job = make_job(v, 4 + random.below(6), units(1), units(0));
    const std::vector<Block> setups = planned(job);
    Suspect fault{random.below(v), std::nullopt};
    if (seed % 3 != 0) {
      const Element other = random.below(v - 1);
      fault = {std::min(fault.one, other), std::max(fault.one, other)};
      fault = fault.one == *fault.other ? Suspect{fault.one, fault.one + 1} : fault;
    }
    const Loop loop = ask_to_the_end(job, results_of(setups, {fault}), {fault});
    EXPECT_THAT(loop.last.suspects, ElementsAre(fault)) << seed;
    EXPECT_THAT(loop.last.faults, ElementsAre(fault)) << seed;
    const auto bound = static_cast<std::uint64_t>(std::bit_width(loop.first_explanations - 1));
    EXPECT_LE(loop.tests, bound + 3) << seed << ": of " << loop.first_explanations;
    tests += loop.tests;
    least += bound;
  }
  EXPECT_LE(tests, least + 60) << "of 40 searches";
}

// What the next test costs may depend on what it replaces.
TEST(Diagnosis, CountsWhatIsReplaced) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Job job = test::replacing(make_job(6, 3, Amount{1'000'000}, Amount{1'000'000}), seed);
    const Suspect fault{0, Element{1}};
    const Loop loop = ask_to_the_end(job, results_of(planned(job), {fault}), {fault});
    EXPECT_THAT(loop.last.faults, ElementsAre(fault)) << seed;
  }
}

TEST(Diagnosis, TwoFaultsAreFoundOut) {
  std::uint64_t tests = 0;
  std::uint64_t least = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed, 4);
    const std::uint32_t v = 9 + random.below(12);
    const Job job = make_job(v, 3 + random.below(4), units(1), units(0));
    const std::vector<Suspect> all = all_faults(job);
    const auto some = [&] { return all[random.below(static_cast<std::uint32_t>(all.size()))]; };
    std::vector<Suspect> faults{some(), some()};
    std::sort(faults.begin(), faults.end());
    const auto covers = [](const Suspect& a, const Suspect& b) {  // b is of no consequence
      return a == b || (!a.other && (b.one == a.one || b.other == a.one));
    };
    if (covers(faults[0], faults[1]) || covers(faults[1], faults[0])) {
      continue;
    }
    const Loop loop = ask_to_the_end(job, results_of(planned(job), faults), faults);
    ASSERT_EQ(loop.last.explanations.size(), 1U) << seed;
    // What was found is true; a fault may have been in tests that failed because of the other only.
    for (const Suspect& found : loop.last.explanations.front()) {
      EXPECT_EQ(std::count(faults.begin(), faults.end(), found), 1)
          << seed << ": " << in_words(found, job.names);
    }
    if (loop.last.at_least == 2) {
      tests += loop.tests;
      least += static_cast<std::uint64_t>(std::bit_width(loop.first_explanations - 1));
    }
  }
  EXPECT_GT(tests, 100U);
  EXPECT_LE(tests, 2 * least);
}

TEST(Diagnosis, ExplanationsAreTheSmallestSetsThatExplain) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed, 5);
    const Job job = make_job(7, 3, units(2), units(1));
    const std::vector<Suspect> all = all_faults(job);
    std::vector<Suspect> faults;
    for (std::uint32_t i = 1 + random.below(3); i > 0; --i) {
      faults.push_back(all[random.below(static_cast<std::uint32_t>(all.size()))]);
    }
    const auto results = results_of(planned(job), faults);
    const Diagnosis found = diagnose(job, results);
    for (std::size_t size = 1; size <= 3; ++size) {
      const auto expected = by_trying(all, results, size);
      if (expected.empty()) {
        continue;
      }
      EXPECT_EQ(found.at_least, size) << seed;
      EXPECT_TRUE(found.all_explanations);
      // What is proven is in all of them.
      std::vector<Explanation> with_proven = expected;
      std::erase_if(with_proven, [&](const Explanation& each) {
        return !std::includes(each.begin(), each.end(), found.faults.begin(), found.faults.end());
      });
      EXPECT_THAT(found.explanations, testing::UnorderedElementsAreArray(with_proven)) << seed;
      break;
    }
    for (const Suspect& proven : found.faults) {
      if (proven.other) {
        EXPECT_EQ(std::count(faults.begin(), faults.end(), proven), 1) << seed;
      }
    }
  }
}

TEST(Diagnosis, OfTwoFaultsItSaysWhatIsKnown) {
  const Job job = make_job(7, 3, units(2), units(1));
  const std::vector<Block> fano{{0, 1, 2}, {0, 3, 4}, {0, 5, 6}, {1, 3, 5},
                                {1, 4, 6}, {2, 3, 6}, {2, 4, 5}};
  const Diagnosis found = diagnose(job, results_of(fano, {{0, 1}, {4, 5}}));
  EXPECT_THAT(found.suspects, IsEmpty());
  EXPECT_EQ(found.at_least, 2U);
  const Explanation faults{{0, 1}, {4, 5}};
  EXPECT_EQ(std::count(found.explanations.begin(), found.explanations.end(), faults), 1);
  const std::string text = written(job, found, "table", 80);
  EXPECT_THAT(text, HasSubstr("No part and no pair alone explains all results."));
  EXPECT_THAT(text, HasSubstr("There are 2 faults at least; "));
  EXPECT_THAT(text, HasSubstr("\nNext test, cost "));
}

TEST(Diagnosis, FourFaultsAreFoundOneByOne) {
  const Job job = make_job(24, 4, units(2), units(1));
  const std::vector<Suspect> faults{{0, 1}, {5, 6}, {11, 12}, {17, 18}};
  const auto results = results_of(planned(job), faults);
  const Diagnosis found = diagnose(job, results);
  EXPECT_GE(found.at_least, 4U);
  const Loop loop = ask_to_the_end(job, results, faults);
  EXPECT_EQ(loop.last.faults, faults);
  EXPECT_THAT(written(job, loop.last, "table", 80), HasSubstr("Nothing is left to find out"));
}

// Three faults explain four tests that failed, but too many sets have to be tried before they are
// found: so many are not ruled out.
TEST(Diagnosis, WhatWasNotTriedIsNotRuledOut) {
  constexpr Element many = 60;
  const Job job = make_job(4 * many - 1, many, units(2), units(1));
  std::vector<TestedSetup> results;
  for (const Element first : {0U, many - 1, 2 * many - 1, 3 * many - 1}) {
    Block setup(many);
    std::iota(setup.begin(), setup.end(), first);
    results.push_back({setup, true});
  }
  const Diagnosis found = diagnose(job, results);
  EXPECT_THAT(found.at_least, testing::AllOf(testing::Ge(2U), testing::Le(3U)));
  ASSERT_TRUE(found.next);
  EXPECT_TRUE(run_sheet(job, {found.next->setup}).faults.empty());
}

// A hundred parts and thousands of results.
TEST(Diagnosis, OfRealSize) {
  const Job job = make_job(100, 12, units(2), units(1));
  Random random(5, 6);
  const std::vector<Suspect> faults{{17, 71}, {40, std::nullopt}};
  std::vector<TestedSetup> results;
  while (results.size() < 5000) {
    Block setup;
    while (setup.size() < 12) {
      const Element x = random.below(100);
      if (std::count(setup.begin(), setup.end(), x) == 0) {
        setup.push_back(x);
      }
    }
    results.push_back({setup, fails(setup, faults)});
  }
  EXPECT_EQ(diagnose(job, results).explanations.size(), 1U);
  results.resize(60);
  const Loop loop = ask_to_the_end(job, results, faults);
  ASSERT_EQ(loop.last.explanations.size(), 1U);
  EXPECT_THAT(loop.last.faults, testing::IsSubsetOf(faults));
  EXPECT_LE(loop.tests, 40U);
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
  EXPECT_THAT(text, HasSubstr("Next test: it fails under 2 of the 4 explanations, so either "
                              "result rules out at least 2;"));
  EXPECT_THAT(text, HasSubstr("  If it fails, 2 are left: "));
  const std::string json = written(job, found, "json");
  EXPECT_THAT(json, HasSubstr("\"suspects\":[[\"Motor\"],[\"Pump\",\"Motor\"]"));
  EXPECT_THAT(json, HasSubstr("\"next\":{\"set_up\":["));
  EXPECT_THAT(json, HasSubstr("\"least_tests\":2}"));
  EXPECT_THAT(written(job, diagnose(job, {{{0, 1}, false}}), "table", 80),
              HasSubstr("No test failed"));
  const Diagnosis one = diagnose(job, {{{0, 1}, true}, {{0, 2}, false}, {{1, 2}, false}});
  EXPECT_THAT(
      written(job, one, "table", 80),
      HasSubstr("One fault alone explains all results, and is proven:\n  pair Pump with Motor\n"
                "Nothing is left to find out"));
  EXPECT_REFUSAL((void)diagnose(job, {{{0, 0}, true}}), BadInput,
                 "a test that was done has a repeated or unknown part; name each part once");
  EXPECT_REFUSAL((void)diagnose(job, {{{0, 9}, true}}), BadInput,
                 "a test that was done has a repeated or unknown part; name each part once");
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
  EXPECT_EQ(found.least_tests, 8U);
  const std::string text = written(job, found, "table", 80);
  EXPECT_THAT(text, HasSubstr("one of the 210 suspects below."));
  EXPECT_THAT(text, HasSubstr("\npart  alone    or with one of"));
  const std::vector<Suspect> fault{{3, 17}};
  EXPECT_LE(ask_to_the_end(job, {{half, true}}, fault).tests, 8U + 3U);
}

TEST(Diagnosis, ContradictionsAreNamed) {
  const Job job = make_job(6, 3, parse_amount("1"), parse_amount("1"));
  const Diagnosis found =
      diagnose(job, {{{0, 1, 2}, true}, {{2, 1, 0}, false}, {{3, 4}, true}, {{3, 4, 5}, false}});
  ASSERT_EQ(found.contradictions.size(), 2U);
  EXPECT_EQ(found.contradictions[1].second, (Block{3, 4, 5}));
  const std::string text = written(job, found, "table", 100);
  EXPECT_NE(text.find("  1, 2, 3 failed and passed; run it again\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  4, 5 failed, and passed as part of 4, 5, 6; run"), std::string::npos)
      << text;
  EXPECT_NE(written(job, found, "json").find("\"contradictions\":[{\"failed\":[\"1\""),
            std::string::npos);
  EXPECT_TRUE(diagnose(job, {{{0, 1, 2}, true}, {{0, 1}, false}}).contradictions.empty());
  // Three parts may be needed for a fault.
  const Diagnosis three =
      diagnose(job, {{{0, 1, 2}, true}, {{0, 1}, false}, {{0, 2}, false}, {{1, 2}, false}});
  EXPECT_THAT(three.contradictions, ElementsAre(std::pair(Block{0, 1, 2}, Block())));
  EXPECT_THAT(written(job, three, "table", 100), HasSubstr("three parts together may be"));
}

}  // namespace
}  // namespace changeover::diagnosis_test
