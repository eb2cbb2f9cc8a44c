#include "changeover/search/exact.hpp"

#include <gtest/gtest.h>

#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "message_of.hpp"
#include "naive_verdict.hpp"
#include "oracle_minima.hpp"

namespace changeover::minimum_search_test {
namespace {

std::optional<Design> from_construction(const Parameters& p) {
  const auto offer = Registry::standard().best(p);
  return offer ? std::optional(Registry::standard().build_design(offer->recipe)) : std::nullopt;
}

void expect_minimum(const Parameters& p, std::uint64_t b, const std::optional<Design>& known) {
  RunControl control({});
  const MinimumResult result = find_minimum(p, {}, control, known);
  EXPECT_EQ(result.lower, b) << name(p);
  EXPECT_EQ(result.upper(), b) << name(p);
  EXPECT_TRUE(result.settled());
  EXPECT_EQ(result.why_stopped, WhyStopped::exhausted);
  ASSERT_TRUE(result.best.has_value());
  EXPECT_TRUE(test::naive_verdict(*result.best).valid) << name(p);
  for (const Decision& step : result.steps) {
    EXPECT_EQ(step.outcome, step.b < b ? Outcome::none : Outcome::found);
    EXPECT_EQ(step.excluded(), step.b < b);
  }
  // Every number between the bound on paper and the minimum was excluded, one after another.
  for (std::uint64_t i = 0; result.start.blocks + i < b; ++i) {
    EXPECT_EQ(result.steps.at(i).b, result.start.blocks + i);
    EXPECT_EQ(result.steps.at(i).parts.size(), 1U);
  }
}

TEST(FindMinimum, KeepsWhatIsKnownWhenAResourceIsMissing) {
  const Parameters p{.v = 12, .k = 4};
  const auto known = from_construction(p);
  ASSERT_TRUE(known);
  MinimumOptions options;
  options.decider = [](std::uint64_t, const ExactOptions&) -> Decision {
    throw MissingResource("the disk is full");
  };
  RunControl control({});
  const MinimumResult result = find_minimum(p, options, control, known);
  ASSERT_TRUE(result.best.has_value());
  EXPECT_EQ(result.why_stopped, WhyStopped::fault);
  EXPECT_THROW(std::rethrow_exception(result.fault), MissingResource);
  EXPECT_THROW((void)find_minimum(p, options, control), MissingResource);  // nothing to keep
}

TEST(FindMinimum, ProvesTheKnownMinimaAgain) {
  std::size_t beyond_paper = 0;
  for (const auto& row : test::oracle_minima()) {
    const Parameters& p = row.parameters;
    if (p.v <= 10 || (p.v == 11 && p.k < 5)) {
      expect_minimum(p, row.b, from_construction(p));
      beyond_paper += lower_bound_on_paper(p).blocks < row.b ? 1U : 0U;
    }
  }
  EXPECT_GE(beyond_paper, 2U);
}

// Everything that is needed is excluded; some designs with the minimum take longer to find than
// this.
TEST(FindMinimum, ProvesThatNoKnownMinimumCanBeBeatenSlow) {
  std::size_t beyond_paper = 0;
  std::size_t settled = 0;
  const auto minima = test::oracle_minima();
  for (const auto& [p, b] : minima) {
    RunControl control({});
    MinimumOptions options;
    options.exact.conflicts_per_step = 200'000;
    const MinimumResult result = find_minimum(p, options, control, from_construction(p));
    EXPECT_EQ(result.lower, b) << name(p);
    EXPECT_TRUE(!result.upper() || *result.upper() >= b) << name(p);
    settled += result.settled() ? 1U : 0U;
    beyond_paper += result.start.blocks < b ? 1U : 0U;
  }
  EXPECT_EQ(beyond_paper, 5U);  // the theorems give the others
  EXPECT_GT(10 * settled, 9 * minima.size());
}

TEST(FindMinimum, NeedsNoConstruction) {
  for (const auto& row : test::oracle_minima()) {
    if (row.parameters.v <= 8) {
      expect_minimum(row.parameters, row.b, std::nullopt);
    }
  }
}

TEST(FindMinimum, WorksForLargerStrengths) {
  // Strength 3: the least number of blocks for which search finds one, starting at 1.
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    const Parameters p{.v = 6, .k = 4, .change = 1, .kind = kind, .strength = 3};
    RunControl control({});
    const MinimumResult result = find_minimum(p, {}, control);
    ASSERT_TRUE(result.settled());
    EXPECT_TRUE(test::naive_verdict(*result.best).valid);
    for (std::uint64_t b = 1; b < result.lower; ++b) {
      EXPECT_EQ(
          decide(p, b, {.prove = false, .encoding = {.order = false, .degrees = false}}, control)
              .outcome,
          Outcome::none);
    }
  }
}

TEST(FindMinimum, SaysThatNothingIsPossible) {
  RunControl control({});
  const MinimumResult result = find_minimum({.v = 4, .k = 2}, {}, control);
  EXPECT_TRUE(result.impossible.has_value());
  EXPECT_FALSE(result.settled());
  EXPECT_TRUE(result.steps.empty());
}

TEST(FindMinimum, LeavesAnIntervalWhenItIsStopped) {
  const Parameters p{.v = 40, .k = 8, .change = 1};  // 4 blocks above the bound
  const auto known = from_construction(p);
  ASSERT_TRUE(known.has_value());
  RunControl none({.time = std::chrono::seconds(0)});
  const MinimumResult nothing = find_minimum(p, {}, none, known);
  EXPECT_EQ(nothing.lower, nothing.start.blocks);
  EXPECT_EQ(nothing.upper(), known->block_count());
  EXPECT_FALSE(nothing.settled());
  EXPECT_EQ(nothing.why_stopped, WhyStopped::time_limit);

  RunControl control({});
  MinimumOptions options;
  options.exact.time_per_step = std::chrono::milliseconds(100);
  options.tries_above = 2;
  const MinimumResult result = find_minimum(p, options, control);
  EXPECT_FALSE(result.settled());
  EXPECT_EQ(result.why_stopped, WhyStopped::time_limit);
  EXPECT_LE(result.steps.size(), 3U);
  EXPECT_GE(result.steps.size(), 2U);
}

TEST(FindMinimum, RefusesAWrongDesign) {
  RunControl control({});
  const Parameters p{.v = 6, .k = 4, .kind = Kind::circular};
  const Design half(p, std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}});
  EXPECT_REFUSAL((void)find_minimum(p, {}, control, half), BadInput,
                 "the design that was given is not a circular DCCD(6,4)");
  const Design whole(p, std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 1}});
  EXPECT_TRUE(find_minimum(p, {}, control, whole).settled());
  EXPECT_REFUSAL((void)find_minimum({.v = 6, .k = 4}, {}, control, whole), BadInput,
                 "the design that was given is not a linear DCCD(6,4)");
}

TEST(LowerBoundOnPaper, IsNeverWhatExhaustiveSearchFound) {
  std::size_t differ = 0;
  for (const auto& row : test::oracle_minima()) {
    const Bound bound = lower_bound_on_paper(row.parameters);
    EXPECT_NE(bound.name, "checked proofs");
    differ += bound.blocks < lower_bound(row.parameters).blocks ? 1U : 0U;
  }
  EXPECT_GE(differ, 4U);
}

}  // namespace
}  // namespace changeover::minimum_search_test
