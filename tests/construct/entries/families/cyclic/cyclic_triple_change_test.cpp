#include <gtest/gtest.h>

#include <vector>

#include "changeover/verify/difference.hpp"
#include "construction_checks.hpp"

namespace changeover::cyclic_triple_change_test {
namespace {

using namespace test;

Parameters parameters(std::uint64_t c, std::uint64_t k) {
  return {6 * c * (k - 2) + 1, k, 3, Kind::circular, 2};
}

const Construction& maker() { return construction("cyclic-triple-change"); }

// 1 and 3, …, 19.
const std::vector<std::uint64_t> served = [] {
  std::vector<std::uint64_t> all{1};
  for (std::uint64_t c = 3; c <= 19; ++c) {
    all.push_back(c);
  }
  return all;
}();

TEST(CyclicTripleChange, IsTightForEveryBlockSize) {
  for (const std::uint64_t c : served) {
    for (std::uint64_t k = 4; k <= 24; ++k) {
      const auto offer = offer_of("cyclic-triple-change", parameters(c, k));
      ASSERT_TRUE(offer) << c;
      EXPECT_EQ(offer->b, c * offer->recipe.parameters.v);
      EXPECT_TRUE(offer->tight && offer->economical);
      if (c * k <= 60) {
        expect_as_promised(*offer);
      }
      const auto base = maker().interval_base_blocks(offer->recipe);
      ASSERT_TRUE(base);
      EXPECT_TRUE(verify_differences(*base).tight) << c << " " << k;
    }
  }
}

TEST(CyclicTripleChange, CertifiesLargeBlocks) {
  for (const std::uint64_t c : served) {
    const auto offer = offer_of("cyclic-triple-change", parameters(c, 100'003));
    ASSERT_TRUE(offer);
    EXPECT_TRUE(verify_differences(*maker().interval_base_blocks(offer->recipe)).tight);
  }
}

TEST(CyclicTripleChange, BreaksTheChangeIfTheLinkBlockIsElsewhere) {
  for (const std::uint64_t c : {3U, 4U, 5U, 6U, 8U}) {
    const auto offer = offer_of("cyclic-triple-change", parameters(c, 6));
    expect_link_block_is_last(*maker().interval_base_blocks(offer->recipe));
  }
}

TEST(CyclicTripleChange, ServesNothingElse) {
  EXPECT_FALSE(offer_of("cyclic-triple-change", parameters(2, 5)));
  EXPECT_FALSE(offer_of("cyclic-triple-change", parameters(20, 5)));
  EXPECT_FALSE(offer_of("cyclic-triple-change", {7, 3, 3, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("cyclic-triple-change", {13, 4, 3, Kind::linear, 2}));
  EXPECT_FALSE(offer_of("cyclic-triple-change", {13, 4, 2, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("cyclic-triple-change", {14, 4, 3, Kind::circular, 2}));
}

TEST(CyclicTripleChange, RefusesSpoiltRecipes) {
  expect_spoilt_recipes_refused(offer_of("cyclic-triple-change", parameters(1, 4))->recipe);
  expect_spoilt_recipes_refused(offer_of("cyclic-triple-change", parameters(5, 7))->recipe);
}

TEST(CyclicTripleChange, ExplainsItself) {
  EXPECT_EQ(maker().explain(offer_of("cyclic-triple-change", parameters(1, 4))->recipe),
            "Develop the base block {0,1,8,10} over Z_13.");
}

}  // namespace
}  // namespace changeover::cyclic_triple_change_test
