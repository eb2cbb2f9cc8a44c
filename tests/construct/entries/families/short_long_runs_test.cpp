#include <gtest/gtest.h>

#include <set>

#include "construction_checks.hpp"

namespace changeover {
namespace {

using namespace test;

using Labelled = std::vector<std::set<std::string>>;

Parameters parameters(std::uint64_t k) { return {2 * k - 2, k, 2, Kind::circular, 2}; }

Labelled labelled_blocks(std::uint64_t k) {
  const Design design = standard().build_design(offer_of("short-long-runs", parameters(k))->recipe);
  Labelled blocks;
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    std::set<std::string>& block = blocks.emplace_back();
    for (const Element x : design.block(i)) {
      block.insert(design.label(x));
    }
  }
  return blocks;
}

TEST(ShortLongRuns, IsValidWithKBlocksForEveryOddBlockSize) {
  for (std::uint64_t k = 5; k <= 61; k += 2) {
    const auto offer = offer_of("short-long-runs", parameters(k));
    ASSERT_TRUE(offer);
    EXPECT_EQ(offer->b, k);
    expect_exactly_as_promised(*offer);
  }
}

TEST(ShortLongRuns, MakesThePrintedDesignForBlockSizeFive) {
  EXPECT_EQ(labelled_blocks(5), (Labelled{{"∞_l", "0_l", "0_s", "1_l", "2_s"},
                                          {"1_s", "0_l", "0_s", "1_l", "2_l"},
                                          {"1_s", "0_l", "∞_l", "∞_s", "2_l"},
                                          {"1_s", "0_l", "1_l", "2_s", "2_l"},
                                          {"0_s", "∞_s", "1_l", "2_s", "2_l"}}));
}

TEST(ShortLongRuns, MakesThePrintedDesignForBlockSizeSeven) {
  EXPECT_EQ(labelled_blocks(7), (Labelled{{"∞_l", "0_l", "0_s", "1_l", "4_s", "3_l", "2_s"},
                                          {"3_s", "0_l", "0_s", "1_l", "2_l", "3_l", "2_s"},
                                          {"3_s", "0_l", "0_s", "4_l", "2_l", "3_l", "1_s"},
                                          {"3_s", "0_l", "∞_s", "4_l", "2_l", "∞_l", "1_s"},
                                          {"3_s", "0_l", "1_l", "4_l", "2_l", "4_s", "1_s"},
                                          {"2_s", "3_l", "1_l", "4_l", "2_l", "4_s", "1_s"},
                                          {"2_s", "3_l", "1_l", "4_l", "0_s", "4_s", "∞_s"}}));
}

TEST(ShortLongRuns, ServesNoEvenNorSmallBlockSize) {
  for (std::uint64_t k = 4; k <= 60; k += 2) {
    EXPECT_FALSE(offer_of("short-long-runs", parameters(k)));
  }
  EXPECT_FALSE(offer_of("short-long-runs", parameters(3)));
  EXPECT_FALSE(offer_of("short-long-runs", {8, 5, 2, Kind::linear, 2}));
}

TEST(ShortLongRuns, RefusesSpoiltRecipes) {
  expect_spoilt_recipes_refused(offer_of("short-long-runs", parameters(9))->recipe);
}

}  // namespace
}  // namespace changeover
