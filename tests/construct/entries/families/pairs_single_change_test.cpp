#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"
#include "oracle_minima.hpp"

namespace changeover {
namespace {

using namespace test;

constexpr const char* entry = "pairs-single-change";

Parameters parameters(std::uint64_t v, Kind kind) { return {v, 2, 1, kind, 2}; }

TEST(PairsSingleChange, IsTightForEveryV) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (std::uint64_t v = 3; v <= 80; ++v) {
      const Parameters p = parameters(v, kind);
      const auto offer = offer_of(entry, p);
      ASSERT_TRUE(offer && offer->tight && offer->expansion_set) << v;
      EXPECT_EQ(offer->b, lower_bound(p).blocks);
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

TEST(PairsSingleChange, AttainsTheKnownMinima) {
  std::size_t rows = 0;
  for (const OracleMinimum& row : oracle_minima()) {
    if (row.parameters.k == 2 && row.parameters.change == 1) {
      ++rows;
      const auto offer = offer_of(entry, row.parameters);
      ASSERT_TRUE(offer);
      EXPECT_EQ(offer->b, row.b) << name(row.parameters);
    }
  }
  EXPECT_EQ(rows, 12U);
}

TEST(PairsSingleChange, ListsVertexAfterVertex) {
  const Design five = standard().build_design(offer_of(entry, parameters(5, Kind::linear))->recipe);
  EXPECT_EQ(blocks_of(five),
            (std::vector<Block>{
                {0, 4}, {0, 1}, {0, 2}, {0, 3}, {1, 3}, {1, 2}, {1, 4}, {2, 4}, {2, 3}, {3, 4}}));
}

TEST(PairsSingleChange, HasAnExpansionSetWhileItsListIsShort) {
  EXPECT_TRUE(offer_of(entry, parameters(1 << 20, Kind::linear))->expansion_set);
  const auto larger = offer_of(entry, parameters((1 << 20) + 1, Kind::linear));
  EXPECT_FALSE(larger->expansion_set);
  EXPECT_FALSE(construction(entry).expansion_set(larger->recipe, standard()));
}

TEST(PairsSingleChange, ServesNothingElse) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (std::uint64_t v = 0; v < 3; ++v) {
      EXPECT_FALSE(offer_of(entry, parameters(v, kind))) << v;
    }
    EXPECT_FALSE(offer_of(entry, {7, 3, 1, kind, 2}));
    EXPECT_FALSE(offer_of(entry, {7, 2, 2, kind, 2}));
    EXPECT_FALSE(offer_of(entry, {7, 2, 1, kind, 3}));
  }
}

TEST(PairsSingleChange, PromisesTheLargestWithoutBuilding) {
  const std::uint64_t v = 0xffff'ffff;
  const auto offer = offer_of(entry, parameters(v, Kind::circular));
  ASSERT_TRUE(offer);
  EXPECT_EQ(offer->b, v * ((v - 1) / 2));
  EXPECT_EQ(standard().build(offer->recipe)->block_count(), offer->b);
}

TEST(PairsSingleChange, RefusesSpoiltRecipes) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    Recipe recipe = offer_of(entry, parameters(3, kind))->recipe;
    recipe.parameters.v = 2;
    expect_refused(recipe, "v = 2");
    recipe.parameters.v = 9;
    recipe.parameters.k = 3;
    expect_refused(recipe, "k = 3");
    recipe.parameters.k = 2;
    recipe.blocks.push_back({0, 1});
    expect_refused(recipe, "a block");
    EXPECT_THROW((void)construction(entry).expansion_set(recipe, standard()), BadInput);
  }
}

TEST(PairsSingleChange, ExplainsItself) {
  EXPECT_EQ(construction(entry).explain(offer_of(entry, parameters(9, Kind::linear))->recipe),
            "For x = 0,…,7, the edges {x,y} with y > x; y = 8 comes first and y = 7 last if x is "
            "even, the other way round if x is odd.");
}

}  // namespace
}  // namespace changeover
