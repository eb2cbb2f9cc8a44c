#include <gtest/gtest.h>

#include "construction_checks.hpp"

namespace changeover::cyclic_61_4_test {
namespace {

using namespace test;

const Parameters served{61, 4, 2, Kind::circular, 2};

TEST(Cyclic61x4, IsTightWith366Blocks) {
  const auto offer = offer_of("cyclic-61-4", served);
  ASSERT_TRUE(offer);
  EXPECT_EQ(offer->b, 366U);
  EXPECT_TRUE(offer->tight);
  EXPECT_FALSE(offer->expansion_set);
  expect_exactly_as_promised(*offer);
}

TEST(Cyclic61x4, HasNoExpansionSetForTwoDoesNotDivide61) {
  const auto search =
      find_expansion_sets(standard().build_design(offer_of("cyclic-61-4", served)->recipe));
  EXPECT_TRUE(search.complete && search.sets.empty());
  EXPECT_EQ(search.reason, "k - m = 2 does not divide v = 61");
}

TEST(Cyclic61x4, BreaksWhenTheBaseBlockWithTwoIsNotTheLast) {
  BaseBlocks base =
      *construction("cyclic-61-4").base_blocks(offer_of("cyclic-61-4", served)->recipe);
  std::swap(base.blocks[4], base.blocks[5]);
  const DifferenceVerdict verdict = verify_differences(base);
  EXPECT_EQ(verdict.uncovered, 0U);
  EXPECT_EQ(verdict.first_bad_step, 6U);
}

TEST(Cyclic61x4, RefusesSpoiltRecipes) {
  expect_spoilt_recipes_refused(offer_of("cyclic-61-4", served)->recipe);
}

}  // namespace
}  // namespace changeover::cyclic_61_4_test
