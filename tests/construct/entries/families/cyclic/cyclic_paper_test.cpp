#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "construction_checks.hpp"

namespace changeover::cyclic_paper_test {
namespace {

using namespace test;

Parameters parameters(std::uint64_t c, std::uint64_t k) {
  return {c * (4 * k - 6) + 1, k, 2, Kind::circular, 2};
}

TEST(CyclicPaper, IsTightForEveryBlockSizeAndUpToFiveBaseBlocks) {
  for (std::uint64_t c = 1; c <= 5; ++c) {
    for (std::uint64_t k = 3; k <= (c <= 2 ? 60 : 24); ++k) {
      const auto offer = offer_of("cyclic-paper", parameters(c, k));
      ASSERT_TRUE(offer);
      EXPECT_EQ(offer->b, c * c * (4 * k - 6) + c);
      EXPECT_EQ(offer->recipe.arguments.at("c"), static_cast<std::int64_t>(c));
      EXPECT_TRUE(offer->tight && offer->economical);
      EXPECT_EQ(offer->expansion_set, (2 * c + 1) % (k - 2) == 0);
      expect_exactly_as_promised(*offer);
    }
  }
}

TEST(CyclicPaper, HasADifferenceCertificateForLargeBlocks) {
  for (std::uint64_t c = 1; c <= 5; ++c) {
    for (const std::uint64_t k : {25U, 60U, 61U, 100U, 499U}) {
      const auto base = construction("cyclic-paper")
                            .base_blocks(offer_of("cyclic-paper", parameters(c, k))->recipe);
      ASSERT_TRUE(base);
      ASSERT_EQ(base->blocks.size(), c);
      const DifferenceVerdict verdict = verify_differences(*base);
      EXPECT_TRUE(verdict.valid() && verdict.tight) << "c = " << c << ", k = " << k;
    }
  }
}

TEST(CyclicPaper, HasTheBaseBlocksOfThePrintedExamples) {
  const auto base = [](std::uint64_t c, std::uint64_t k) {
    return construction("cyclic-paper")
        .base_blocks(offer_of("cyclic-paper", parameters(c, k))->recipe)
        ->blocks;
  };
  EXPECT_EQ(base(1, 4), (std::vector<Block>{{0, 1, 2, 5}}));
  EXPECT_EQ(base(2, 4), (std::vector<Block>{{0, 1, 4, 12}, {0, 1, 2, 7}}));
  EXPECT_EQ(base(2, 3), (std::vector<Block>{{0, 2, 7}, {0, 1, 4}}));
}

TEST(CyclicPaper, IsNoLongerADesignIfAnotherBaseBlockComesLast) {
  const auto offer = offer_of("cyclic-paper", parameters(4, 6));
  BaseBlocks base = *construction("cyclic-paper").base_blocks(offer->recipe);
  std::swap(base.blocks.front(), base.blocks.back());
  DevelopedSource source(base);
  const Verdict verdict = verify(source);
  EXPECT_EQ(verdict.uncovered, 0U);
  EXPECT_EQ(verdict.bad_steps, base.parameters.v);
}

TEST(CyclicPaper, ServesNothingElse) {
  EXPECT_FALSE(offer_of("cyclic-paper", parameters(6, 4)));
  EXPECT_FALSE(offer_of("cyclic-paper", {1, 3, 2, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("cyclic-paper", {5, 2, 2, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("cyclic-paper", {11, 4, 2, Kind::linear, 2}));
  EXPECT_FALSE(offer_of("cyclic-paper", {11, 4, 1, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("cyclic-paper", {12, 4, 2, Kind::circular, 2}));
}

TEST(CyclicPaper, RefusesSpoiltRecipes) {
  expect_spoilt_recipes_refused(offer_of("cyclic-paper", parameters(1, 3))->recipe);
  expect_spoilt_recipes_refused(offer_of("cyclic-paper", parameters(3, 9))->recipe);
  expect_spoilt_recipes_refused(offer_of("cyclic-paper", parameters(5, 4))->recipe);
}

TEST(CyclicPaper, HasTheExpansionSetOfThePaper) {
  const auto offer = offer_of("cyclic-paper", parameters(2, 7));  // 5 divides 5
  ASSERT_TRUE(offer->expansion_set);
  const auto set = construction("cyclic-paper").expansion_set(offer->recipe, standard());
  ASSERT_EQ(set->size(), 9U);
  EXPECT_EQ(set->front(), (UnchangedSubset{10, {5, 6, 7, 8, 9}}));
  EXPECT_EQ(set->back(), (UnchangedSubset{90, {0, 1, 2, 3, 4}}));
}

TEST(CyclicPaper, ExplainsItself) {
  EXPECT_EQ(
      construction("cyclic-paper").explain(offer_of("cyclic-paper", parameters(1, 4))->recipe),
      "Develop the base block {0,1,2,5} over Z_11.");
  EXPECT_EQ(
      construction("cyclic-paper").explain(offer_of("cyclic-paper", parameters(2, 20))->recipe),
      "Develop the base blocks {0,…,17,36,92}, {0,…,17,18,55} over Z_149.");
}

RC_GTEST_PROP(CyclicPaper, HasAnExpansionSetExactlyIfItDividesEvenly, ()) {
  const auto c = *rc::gen::inRange<std::uint64_t>(1, 6);
  const auto k = *rc::gen::inRange<std::uint64_t>(3, 40);
  const auto offer = offer_of("cyclic-paper", parameters(c, k));
  const auto set = construction("cyclic-paper").expansion_set(offer->recipe, standard());
  RC_ASSERT(set.has_value() == (offer->recipe.parameters.v % (k - 2) == 0));
  if (set) {
    RC_ASSERT(!expansion_set_defect(standard().build_design(offer->recipe), *set));
  }
}

}  // namespace
}  // namespace changeover::cyclic_paper_test
