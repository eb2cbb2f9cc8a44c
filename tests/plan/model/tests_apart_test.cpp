// What needs a test each, against all tests.
#include <gtest/gtest.h>

#include <algorithm>

#include "changeover/plan/run_plan.hpp"
#include "plan/search/choices/tests_apart.hpp"
#include "random_models.hpp"

namespace changeover::tests_apart_test {
namespace {

bool tests_both(const Job& job, const Block& test, const Block& one, const Block& other) {
  return test::shows(*job.model, test, one[0], one[1]) &&
         test::shows(*job.model, test, other[0], other[1]);
}

TEST(TestsApart, NoTestHasTwoOfThePairs) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const std::string text = test::random_model_text(seed, 4, 3);
    const Job job = test::job_of_text(text);
    const std::vector<Block> tests = test::all_tests(*job.model);
    const std::vector<Block> pairs = tuples_for_tests_apart(job);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      EXPECT_TRUE(job.needed.contains(pairs[i][0], pairs[i][1])) << text;
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_TRUE(std::ranges::none_of(tests, [&](const Block& test) {
          return tests_both(job, test, pairs[i], pairs[j]);
        })) << text;
      }
    }
    found += pairs.size();
  }
  EXPECT_GT(found, 300U);
}

TEST(TestsApart, RulesAskForMoreTestsThanTwoParametersHavePairs) {
  // The three of Edge are on Windows; Windows meets two more browsers, the others three locales.
  const Job job = test::job_of_text(
      "OS: Debian, Fedora, Windows\nBrowser: Firefox, Chrome, Edge\nLocale: de, en, ja\n"
      "IF [Browser] = \"Edge\" THEN [OS] = \"Windows\";\n");
  EXPECT_EQ(tuples_for_tests_apart(job).size(), 11U);
  EXPECT_EQ(cost_bound(job).tests, 11U);
}

TEST(TestsApart, NothingIsNeededNothingIsFound) {
  Job job = test::job_of_text("A: a, b\nB: c, d\n");
  job.needed = PairSet(job.parts());
  EXPECT_TRUE(tuples_for_tests_apart(job).empty());
}

}  // namespace
}  // namespace changeover::tests_apart_test
