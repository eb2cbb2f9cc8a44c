// Starts of local search with fewer blocks than a design has.
#include "search/local/fewer_blocks.hpp"

#include <gtest/gtest.h>

#include "changeover/construct/registry.hpp"
#include "core/sorted.hpp"
#include "naive_verdict.hpp"

namespace changeover::test::fewer_blocks_test {
namespace {

constexpr Parameters linear{.v = 26, .k = 8, .change = 1};

// The even visits of SCCD(26,8), which have 49 blocks; the minimum linear design has 47.
Design circle() {
  const Registry& registry = Registry::standard();
  const auto offer = registry.find("even-visits")->offer(linear.as(Kind::circular), registry);
  return registry.build_design(offer.value().recipe);
}

OpenedOutcome opened(std::uint64_t aim, std::uint64_t moves, std::uint64_t stop_after = 0) {
  RunControl control({.threads = 1});
  Random random(4);
  return anneal_opened(circle(), linear, {.aim = aim, .moves = moves}, random, control,
                       [&](std::uint64_t before) -> AnnealWatch {
                         return
                             [before, stop_after](std::uint64_t done, std::uint64_t /*missing*/) {
                               return stop_after == 0 || before + done < stop_after;
                             };
                       });
}

TEST(FewerBlocks, OpenedCirclesGiveMinimumLinearDesigns) {
  ASSERT_EQ(circle().block_count(), 49U);
  const OpenedOutcome found = opened(47, 30'000'000);
  ASSERT_TRUE(found.design);
  EXPECT_EQ(found.design->block_count(), 47U);
  EXPECT_EQ(found.design->parameters(), linear);
  EXPECT_TRUE(naive_verdict(*found.design).valid);
  EXPECT_EQ(found.least, 0U);
  EXPECT_LE(found.moves, 30'000'000U);
}

TEST(FewerBlocks, WhatCannotBeIsNotFound) {
  const OpenedOutcome found = opened(46, 1'000'000);
  EXPECT_FALSE(found.design);
  EXPECT_GT(found.least, 0U);
  EXPECT_FALSE(found.stopped);
  // An equal share for each of 49 places to begin at.
  EXPECT_EQ(found.moves, 1'000'000U / 49 * 49);
}

TEST(FewerBlocks, TheWatchStopsAllPlaces) {
  const OpenedOutcome found = opened(46, 100'000'000, 3'000'000);
  EXPECT_TRUE(found.stopped);
  EXPECT_LT(found.moves, 10'000'000U);
}

TEST(FewerBlocks, ACircleIsKnownForLinearDesignsOnly) {
  EXPECT_FALSE(known_circle(linear.as(Kind::circular)));
  const auto known = known_circle(linear);
  ASSERT_TRUE(known);
  EXPECT_EQ(known->parameters(), linear.as(Kind::circular));
  EXPECT_TRUE(naive_verdict(*known).valid);
}

TEST(FewerBlocks, WithoutABlockEachStepStillChangesOneElement) {
  Random random(1);
  const Design whole = circle();
  const auto shorter = without_a_block(whole, random);
  ASSERT_TRUE(shorter);
  ASSERT_EQ(shorter->block_count() + 1, whole.block_count());
  for (std::size_t i = 0; i < shorter->block_count(); ++i) {
    const std::size_t next = (i + 1) % shorter->block_count();
    EXPECT_EQ(difference(shorter->block(next), shorter->block(i)).size(), 1U) << i;
  }
}

}  // namespace
}  // namespace changeover::test::fewer_blocks_test
