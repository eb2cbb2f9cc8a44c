#include <gtest/gtest.h>

#include <set>

#include "construction_checks.hpp"

namespace changeover {
namespace {

using namespace test;

Parameters parameters(std::uint64_t k) { return {2 * k - 2, k, 2, Kind::circular, 2}; }

TEST(Doubling, IsTightForEveryEvenBlockSize) {
  for (std::uint64_t k = 2; k <= 60; k += 2) {
    const auto offer = offer_of("doubling", parameters(k));
    ASSERT_TRUE(offer);
    EXPECT_EQ(offer->b, k - 1);
    EXPECT_TRUE(offer->tight && offer->economical);
    EXPECT_EQ(offer->expansion_set, k == 4);
    expect_exactly_as_promised(*offer);
  }
}

TEST(Doubling, MakesThePrintedDesignForBlockSizeFour) {
  const Design design = standard().build_design(offer_of("doubling", parameters(4))->recipe);
  const std::vector<std::set<Element>> printed{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 1}};
  std::vector<std::set<Element>> made;
  for (const Block& block : blocks_of(design)) {
    made.emplace_back(block.begin(), block.end());
  }
  EXPECT_EQ(made, printed);
}

TEST(Doubling, HasOneBlockForBlockSizeTwo) {
  EXPECT_EQ(blocks_of(standard().build_design(offer_of("doubling", parameters(2))->recipe)),
            (std::vector<Block>{{0, 1}}));
}

TEST(Doubling, ServesNoOddBlockSizeNorAnyOtherParameters) {
  for (std::uint64_t k = 3; k <= 59; k += 2) {
    EXPECT_FALSE(offer_of("doubling", parameters(k)));
  }
  EXPECT_FALSE(offer_of("doubling", {6, 4, 2, Kind::linear, 2}));
  EXPECT_FALSE(offer_of("doubling", {6, 4, 1, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("doubling", {7, 4, 2, Kind::circular, 2}));
}

TEST(Doubling, NeedsTheSingleChangeDesignInTheRegistry) {
  const Registry alone({&construction("doubling")});
  EXPECT_FALSE(alone.best(parameters(4)));
  EXPECT_TRUE(alone.best(parameters(2)));
}

TEST(Doubling, RefusesSpoiltRecipes) {
  expect_spoilt_recipes_refused(offer_of("doubling", parameters(8))->recipe);
  expect_spoilt_recipes_refused(offer_of("doubling", parameters(2))->recipe);
}

TEST(Doubling, ExplainsItself) {
  EXPECT_EQ(construction("doubling").explain(offer_of("doubling", parameters(4))->recipe),
            "Replace every element x in the blocks of the circular SCCD(3,2) by 2x and 2x+1.");
  EXPECT_EQ(construction("doubling").explain(offer_of("doubling", parameters(2))->recipe),
            "The one block {0,1}.");
}

}  // namespace
}  // namespace changeover
