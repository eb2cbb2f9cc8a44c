#include <gtest/gtest.h>

#include "construction_checks.hpp"

namespace changeover {
namespace {

using namespace test;

Parameters parameters(std::uint64_t k) { return {2 * k - 1, k, 1, Kind::circular, 2}; }

TEST(McSorleyCircular, IsTightForEveryBlockSize) {
  for (std::uint64_t k = 2; k <= 60; ++k) {
    const auto offer = offer_of("mcsorley-circular", parameters(k));
    ASSERT_TRUE(offer);
    EXPECT_EQ(offer->b, 2 * k - 1);
    EXPECT_TRUE(offer->tight && offer->economical);
    expect_exactly_as_promised(*offer);
  }
}

TEST(McSorleyCircular, DevelopsConsecutiveResidues) {
  const Design design =
      standard().build_design(offer_of("mcsorley-circular", parameters(3))->recipe);
  EXPECT_EQ(blocks_of(design),
            (std::vector<Block>{{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}}));
}

TEST(McSorleyCircular, ServesNothingElse) {
  EXPECT_FALSE(offer_of("mcsorley-circular", {1, 1, 1, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("mcsorley-circular", {5, 3, 1, Kind::linear, 2}));
  EXPECT_FALSE(offer_of("mcsorley-circular", {5, 3, 2, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("mcsorley-circular", {5, 3, 1, Kind::circular, 3}));
  EXPECT_FALSE(offer_of("mcsorley-circular", {6, 3, 1, Kind::circular, 2}));
}

TEST(McSorleyCircular, RefusesSpoiltRecipes) {
  expect_spoilt_recipes_refused(offer_of("mcsorley-circular", parameters(5))->recipe);
}

TEST(McSorleyCircular, ExplainsItself) {
  const Construction& maker = construction("mcsorley-circular");
  EXPECT_EQ(maker.explain(offer_of("mcsorley-circular", parameters(3))->recipe),
            "Develop the base block {0,1,2} over Z_5.");
  EXPECT_EQ(maker.explain(offer_of("mcsorley-circular", parameters(30))->recipe),
            "Develop the base block {0,…,29} over Z_59.");
}

}  // namespace
}  // namespace changeover
