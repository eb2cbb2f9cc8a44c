#include <gtest/gtest.h>

#include "construction_checks.hpp"

namespace changeover {
namespace {

using namespace test;

Parameters parameters(std::uint64_t k) { return {2 * k - 3, k, 2, Kind::circular, 2}; }

TEST(FixedElement, IsTightForEveryOddBlockSize) {
  for (std::uint64_t k = 3; k <= 61; k += 2) {
    const auto offer = offer_of("fixed-element", parameters(k));
    ASSERT_TRUE(offer);
    EXPECT_EQ(offer->b, k - 2);
    EXPECT_TRUE(offer->tight && offer->economical);
    expect_exactly_as_promised(*offer);
  }
}

TEST(FixedElement, HasItsNewElementInEveryBlock) {
  for (std::uint64_t k = 5; k <= 15; k += 2) {
    const auto source = standard().build(offer_of("fixed-element", parameters(k))->recipe);
    EXPECT_EQ(verify(*source).fixed, (std::vector<Element>{static_cast<Element>(2 * k - 4)}));
  }
}

TEST(FixedElement, HasOneBlockForBlockSizeThree) {
  EXPECT_EQ(blocks_of(standard().build_design(offer_of("fixed-element", parameters(3))->recipe)),
            (std::vector<Block>{{0, 1, 2}}));
}

TEST(FixedElement, ServesNoEvenBlockSizeNorAnyOtherParameters) {
  for (std::uint64_t k = 4; k <= 60; k += 2) {
    EXPECT_FALSE(offer_of("fixed-element", parameters(k)));
  }
  EXPECT_FALSE(offer_of("fixed-element", {7, 5, 2, Kind::linear, 2}));
  EXPECT_FALSE(offer_of("fixed-element", {7, 5, 1, Kind::circular, 2}));
}

TEST(FixedElement, RefusesSpoiltRecipes) {
  expect_spoilt_recipes_refused(offer_of("fixed-element", parameters(7))->recipe);
}

TEST(FixedElement, ExplainsItself) {
  EXPECT_EQ(construction("fixed-element").explain(offer_of("fixed-element", parameters(5))->recipe),
            "Add the new element 6 to every block of the circular DCCD(6,4).");
}

}  // namespace
}  // namespace changeover
