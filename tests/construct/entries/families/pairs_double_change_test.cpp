#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"
#include "oracle_minima.hpp"

namespace changeover {
namespace {

using namespace test;

constexpr const char* entry = "pairs-double-change";

Parameters parameters(std::uint64_t v, Kind kind) { return {v, 2, 2, kind, 2}; }

TEST(PairsDoubleChange, IsMinimumForEveryV) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (std::uint64_t v = 5; v <= 80; ++v) {
      const Parameters p = parameters(v, kind);
      const auto offer = offer_of(entry, p);
      ASSERT_TRUE(offer) << v;
      EXPECT_EQ(offer->b, v == 5 && kind == Kind::circular ? 11 : lower_bound(p).blocks);
      expect_as_promised(*offer);
    }
    for (std::uint64_t v = 81; v <= 300; ++v) {
      const auto offer = offer_of(entry, parameters(v, kind));
      ASSERT_TRUE(offer && offer->tight);
      const Verdict verdict = verify(*standard().build(offer->recipe));
      ASSERT_TRUE(verdict.tight()) << v;
      ASSERT_EQ(verdict.b, offer->b) << v;
    }
  }
  for (const std::uint64_t v : {1000U, 1001U}) {
    const auto offer = offer_of(entry, parameters(v, Kind::circular));
    EXPECT_TRUE(verify(*standard().build(offer->recipe)).tight()) << v;
  }
}

TEST(PairsDoubleChange, AttainsTheKnownMinima) {
  std::size_t rows = 0;
  for (const OracleMinimum& row : oracle_minima()) {
    if (row.parameters.k == 2 && row.parameters.change == 2) {
      ++rows;
      const auto offer = offer_of(entry, row.parameters);
      ASSERT_TRUE(offer);
      EXPECT_EQ(offer->b, row.b) << name(row.parameters);
    }
  }
  EXPECT_EQ(rows, 8U);
}

TEST(PairsDoubleChange, ListsFactorAfterFactor) {
  const Design six = standard().build_design(offer_of(entry, parameters(6, Kind::linear))->recipe);
  EXPECT_EQ(blocks_of(six), (std::vector<Block>{{3, 2},
                                                {4, 1},
                                                {0, 5},
                                                {4, 3},
                                                {0, 2},
                                                {1, 5},
                                                {0, 4},
                                                {1, 3},
                                                {2, 5},
                                                {1, 0},
                                                {2, 4},
                                                {3, 5},
                                                {2, 1},
                                                {3, 0},
                                                {4, 5}}));
  const Design nine = standard().build_design(offer_of(entry, parameters(9, Kind::linear))->recipe);
  EXPECT_EQ(Block(nine.block(0).begin(), nine.block(0).end()), (Block{8, 1}));
  EXPECT_EQ(Block(nine.block(3).begin(), nine.block(3).end()), (Block{6, 3}));
  EXPECT_EQ(Block(nine.block(4).begin(), nine.block(4).end()), (Block{0, 2}));
}

TEST(PairsDoubleChange, ServesNothingElse) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (std::uint64_t v = 0; v < 5; ++v) {
      EXPECT_FALSE(offer_of(entry, parameters(v, kind))) << v;
    }
    EXPECT_FALSE(offer_of(entry, {7, 3, 2, kind, 2}));
    EXPECT_FALSE(offer_of(entry, {7, 2, 1, kind, 2}));
    EXPECT_FALSE(offer_of(entry, {7, 2, 2, kind, 3}));
  }
}

TEST(PairsDoubleChange, PromisesTheLargestWithoutBuilding) {
  const std::uint64_t v = 0xffff'ffff;
  const auto offer = offer_of(entry, parameters(v, Kind::circular));
  ASSERT_TRUE(offer);
  EXPECT_EQ(offer->b, v * ((v - 1) / 2));
  const auto source = standard().build(offer->recipe);
  Block block(2);
  ASSERT_TRUE(source->next(block));
  EXPECT_EQ(block, (Block{0xffff'fffe, 1}));
}

TEST(PairsDoubleChange, RefusesSpoiltRecipes) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    Recipe recipe = offer_of(entry, parameters(5, kind))->recipe;
    recipe.parameters.v = 4;
    expect_refused(recipe, "v = 4");
    recipe = offer_of(entry, parameters(9, kind))->recipe;
    recipe.parameters.k = 3;
    expect_refused(recipe, "k = 3");
    recipe.parameters.k = 2;
    recipe.parameters.change = 1;
    expect_refused(recipe, "m = 1");
    recipe.parameters.change = 2;
    recipe.arguments["nonsense"] = 1;
    expect_refused(recipe, "an argument");
  }
}

TEST(PairsDoubleChange, ExplainsItself) {
  const Construction& maker = construction(entry);
  EXPECT_EQ(maker.explain(offer_of(entry, parameters(6, Kind::linear))->recipe),
            "For i = 0,…,4, the edges {i-j,i+j} over Z_5, j = 2,…,1, and {i,5}.");
  EXPECT_EQ(maker.explain(offer_of(entry, parameters(9, Kind::linear))->recipe),
            "For i = 0,…,8, the edges {i-j,i+j} over Z_9, j = 1,…,4 with 3 last.");
  EXPECT_NE(maker.explain(offer_of(entry, parameters(5, Kind::circular))->recipe),
            maker.explain(offer_of(entry, parameters(5, Kind::linear))->recipe));
}

}  // namespace
}  // namespace changeover
