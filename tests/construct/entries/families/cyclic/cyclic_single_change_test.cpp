#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "changeover/verify/difference.hpp"
#include "construct/tools/cyclic.hpp"
#include "construction_checks.hpp"
#include "message_of.hpp"

namespace changeover::cyclic_single_change_test {
namespace {

using namespace test;
using Numbers = std::vector<std::uint64_t>;

Parameters parameters(std::uint64_t c, std::uint64_t k) {
  return {2 * c * (k - 1) + 1, k, 1, Kind::circular, 2};
}

Offer offer_for(std::uint64_t c, std::uint64_t k) {
  return *offer_of("cyclic-single-change", parameters(c, k));
}

IntervalBaseBlocks base_blocks_of(std::uint64_t c, std::uint64_t k) {
  return *construction("cyclic-single-change").interval_base_blocks(offer_for(c, k).recipe);
}

const Construction& maker() { return construction("cyclic-single-change"); }

TEST(CyclicSingleChange, IsTightForEveryBlockSizeAndNumberOfBaseBlocks) {
  for (std::uint64_t c = 1; c <= 40; ++c) {
    for (const std::uint64_t k : Numbers{2, 3, 4, 5, 6, 9, 14, 20}) {
      if (c * k > 240) {
        continue;
      }
      const auto offer = offer_of("cyclic-single-change", parameters(c, k));
      ASSERT_TRUE(offer);
      EXPECT_EQ(offer->b, 2 * c * c * (k - 1) + c);
      EXPECT_TRUE(offer->tight && offer->economical);
      EXPECT_EQ(offer->expansion_set, offer->recipe.parameters.v % (k - 1) == 0);
      EXPECT_EQ(offer->expansion_set, k == 2);
      expect_as_promised(*offer);
    }
  }
}

TEST(CyclicSingleChange, HasACertificateForThousandsOfBaseBlocks) {
  for (std::uint64_t c = 1; c <= 5000; c += c < 500 ? 1 : 29) {
    const Offer offer = offer_for(c, 2 + c % 61);
    const auto base = maker().interval_base_blocks(offer.recipe);
    ASSERT_TRUE(base);
    const DifferenceVerdict verdict = verify_differences(*base);
    ASSERT_TRUE(verdict.valid() && verdict.tight) << c;
    ASSERT_EQ(verdict.b, offer.b);
    if (c <= 40) {
      EXPECT_EQ(base->written_out(), *maker().base_blocks(offer.recipe));
      EXPECT_TRUE(verify_differences(base->written_out()).tight);
    }
  }
}

TEST(CyclicSingleChange, StreamsAndCertifiesAMillionBaseBlocks) {
  const Offer offer = offer_for(1'000'000, 1001);
  EXPECT_FALSE(maker().base_blocks(offer.recipe));
  const auto base = maker().interval_base_blocks(offer.recipe);
  ASSERT_TRUE(base);
  const DifferenceVerdict verdict = verify_differences(*base);
  EXPECT_TRUE(verdict.tight);
  EXPECT_EQ(verdict.b, offer.b);
  const auto source = standard().build(offer.recipe);
  Block block(1001);
  for (std::size_t i = 0; i < 1000; ++i) {
    ASSERT_TRUE(source->next(block));
    ASSERT_EQ(block[999], 999U);
    ASSERT_EQ(block[1000], base->points[i]);
  }
}

TEST(CyclicSingleChange, HasTheParametersOfMcSorleyForOneBaseBlock) {
  for (std::uint64_t k = 2; k <= 40; ++k) {
    const Offer ours = offer_for(1, k);
    const auto mcsorley = offer_of("mcsorley-circular", parameters(1, k));
    ASSERT_TRUE(mcsorley);
    EXPECT_EQ(ours.b, mcsorley->b);
    EXPECT_EQ(standard().build_design(ours.recipe).blocks(),
              standard().build_design(mcsorley->recipe).blocks());
  }
}

TEST(CyclicSingleChange, CoversAllPairsButBreaksTheChangeIfTheLinkBlockIsElsewhere) {
  for (std::uint64_t c = 2; c <= 9; ++c) {
    for (const std::uint64_t k : Numbers{3, 4, 8}) {
      const IntervalBaseBlocks right = base_blocks_of(c, k);
      EXPECT_EQ(right.points.back(), k - 1);
      expect_link_block_is_last(right);
    }
  }
}

TEST(CyclicSingleChange, NoticesEveryChangeOfOnePoint) {
  const IntervalBaseBlocks right = base_blocks_of(5, 4);
  for (std::size_t place = 0; place < right.points.size(); ++place) {
    for (Element x = 3; x < right.parameters.v; ++x) {
      IntervalBaseBlocks wrong = right;
      wrong.points[place] = x;
      const DifferenceVerdict verdict = verify_differences(wrong);
      IntervalDevelopedSource source(wrong);
      EXPECT_EQ(verdict.valid(), verify(source).valid());
      // A ∪ {x} and A ∪ {2 − x} have the same differences; in the link block only x = 3 will do.
      const Element mirror = static_cast<Element>(right.parameters.v) + 2 - right.points[place];
      const bool same = x == right.points[place] || (place + 1 < 5 && x == mirror);
      EXPECT_EQ(verdict.valid(), same) << place << " " << x;
    }
  }
}

TEST(CyclicSingleChange, ServesNothingElse) {
  EXPECT_FALSE(offer_of("cyclic-single-change", {1, 1, 1, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("cyclic-single-change", {9, 5, 1, Kind::linear, 2}));
  EXPECT_FALSE(offer_of("cyclic-single-change", {9, 5, 2, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("cyclic-single-change", {9, 5, 1, Kind::circular, 3}));
  EXPECT_FALSE(offer_of("cyclic-single-change", {10, 5, 1, Kind::circular, 2}));
}

TEST(CyclicSingleChange, ServesTheLargestParametersWithoutWrapping) {
  for (const auto& [c, k] : {std::pair<std::uint64_t, std::uint64_t>{0x7fff'ffff, 2},
                             {1, 0x8000'0000},
                             {65'535, 32'769}}) {
    const auto offer = offer_of("cyclic-single-change", parameters(c, k));
    ASSERT_TRUE(offer);
    EXPECT_EQ(offer->b, c * offer->recipe.parameters.v);
    EXPECT_EQ(maker().interval_base_blocks(offer->recipe).has_value(), c <= max_listed_points);
    EXPECT_FALSE(maker().explain(offer->recipe).empty());
  }
}

TEST(CyclicSingleChange, RefusesSpoiltRecipes) {
  expect_spoilt_recipes_refused(offer_for(1, 2).recipe);
  expect_spoilt_recipes_refused(offer_for(6, 4).recipe);
  expect_spoilt_recipes_refused(offer_for(100, 9).recipe);
}

TEST(CyclicSingleChange, ExplainsItself) {
  EXPECT_EQ(maker().explain(offer_for(1, 4).recipe), "Develop the base block {0,1,2,3} over Z_7.");
  EXPECT_EQ(maker().explain(offer_for(3, 4).recipe),
            "Develop the base blocks {0,1,2,6}, {0,1,2,9}, {0,1,2,3} over Z_19.");
  EXPECT_EQ(maker().explain(offer_for(10, 4).recipe),
            "Develop the 10 base blocks {0,1,2,6}, {0,1,2,9}, {0,1,2,12}, …, {0,1,2,3} over Z_61.");
}

}  // namespace
}  // namespace changeover::cyclic_single_change_test
