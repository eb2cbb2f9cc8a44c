#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"
#include "oracle_minima.hpp"

namespace changeover {
namespace {

using namespace test;

constexpr const char* entry = "triples-double-change";

Parameters parameters(std::uint64_t v, Kind kind) { return {v, 3, 2, kind, 2}; }

// ⌈v/3·⌈(v−1)/2⌉⌉, the least number of triples that cover all pairs.
std::uint64_t covering_number(std::uint64_t v) { return (v * (v / 2) + 2) / 3; }

TEST(TriplesDoubleChange, IsAMinimumCoveringForEveryV) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (std::uint64_t v = 5; v <= 120; ++v) {
      const Parameters p = parameters(v, kind);
      const auto offer = offer_of(entry, p);
      ASSERT_TRUE(offer) << v;
      EXPECT_EQ(offer->b, v == 5 ? 5 : covering_number(v));
      EXPECT_EQ(offer->b, v == 5 ? 5 : lower_bound(p).blocks);
      EXPECT_EQ(offer->tight, v % 6 == 1 || v % 6 == 3);
      expect_as_promised(*offer);
    }
    for (std::uint64_t v = 121; v <= 420; ++v) {
      const auto offer = offer_of(entry, parameters(v, kind));
      ASSERT_TRUE(offer);
      const Verdict verdict = verify(*standard().build(offer->recipe));
      ASSERT_TRUE(verdict.valid()) << v;
      ASSERT_EQ(verdict.b, covering_number(v)) << v;
      ASSERT_EQ(verdict.tight(), offer->tight) << v;
    }
  }
  for (std::uint64_t v = 2000; v < 2006; ++v) {
    const auto offer = offer_of(entry, parameters(v, Kind::circular));
    const Verdict verdict = verify(*standard().build(offer->recipe));
    EXPECT_TRUE(verdict.valid()) << v;
    EXPECT_EQ(verdict.b, covering_number(v)) << v;
  }
}

TEST(TriplesDoubleChange, HasTheExcessThatParityForces) {
  for (std::uint64_t v = 12; v <= 40; ++v) {
    const auto offer = offer_of(entry, parameters(v, Kind::circular));
    const Verdict verdict = verify(*standard().build(offer->recipe));
    const std::uint64_t expected = v % 2 == 1 ? (v % 6 == 5 ? 2 : 0) : v / 2 + (v % 6 == 0 ? 0 : 1);
    EXPECT_EQ(verdict.excess, expected) << v;
  }
}

TEST(TriplesDoubleChange, AttainsTheKnownMinima) {
  std::size_t rows = 0;
  for (const OracleMinimum& row : oracle_minima()) {
    if (row.parameters.k == 3 && row.parameters.change == 2) {
      ++rows;
      const auto offer = offer_of(entry, row.parameters);
      ASSERT_TRUE(offer);
      EXPECT_EQ(offer->b, row.b) << name(row.parameters);
    }
  }
  EXPECT_EQ(rows, 22U);
}

TEST(TriplesDoubleChange, ServesNothingElse) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (std::uint64_t v = 0; v < 5; ++v) {
      EXPECT_FALSE(offer_of(entry, parameters(v, kind))) << v;
    }
    EXPECT_FALSE(offer_of(entry, {7, 4, 2, kind, 2}));
    EXPECT_FALSE(offer_of(entry, {7, 3, 1, kind, 2}));
    EXPECT_FALSE(offer_of(entry, {7, 3, 2, kind, 3}));
  }
}

TEST(TriplesDoubleChange, CanRewindAnywhere) {
  for (std::uint64_t v = 12; v < 18; ++v) {
    const auto offer = offer_of(entry, parameters(v, Kind::circular));
    const auto source = standard().build(offer->recipe);
    const std::vector<Block> all = blocks_of(*source);
    Block block(3);
    for (std::uint64_t read = 0; read <= offer->b; ++read) {
      ASSERT_TRUE(source->rewind());
      for (std::uint64_t i = 0; i < read; ++i) {
        ASSERT_TRUE(source->next(block));
      }
      ASSERT_TRUE(source->rewind());
      ASSERT_EQ(blocks_of(*source), all);
    }
  }
}

TEST(TriplesDoubleChange, PromisesTheLargestWithoutBuilding) {
  const std::uint64_t v = 0xffff'ffff;  // 3 modulo 6
  const auto offer = offer_of(entry, parameters(v, Kind::circular));
  ASSERT_TRUE(offer && offer->tight);
  EXPECT_EQ(offer->b, v / 3 * ((v - 1) / 2));
  const auto source = standard().build(offer->recipe);
  EXPECT_EQ(source->block_count(), offer->b);
  Block block(3);
  ASSERT_TRUE(source->next(block));
  EXPECT_EQ(block, (Block{0, 2, static_cast<Element>(v / 3 + 1)}));
}

TEST(TriplesDoubleChange, RefusesSpoiltRecipes) {
  for (const std::uint64_t v : {5U, 11U, 15U, 16U}) {
    Recipe recipe = offer_of(entry, parameters(v, Kind::circular))->recipe;
    recipe.parameters.k = 4;
    expect_refused(recipe, "k = 4");
    recipe.parameters.k = 3;
    recipe.parameters.change = 1;
    expect_refused(recipe, "m = 1");
    recipe.parameters.change = 2;
    recipe.parameters.v = 4;
    expect_refused(recipe, "v = 4");
    recipe.parameters.v = v;
    recipe.inputs.push_back(recipe);
    expect_refused(recipe, "an input");
    recipe.inputs.clear();
    recipe.arguments["nonsense"] = 0;
    expect_refused(recipe, "an argument");
  }
}

TEST(TriplesDoubleChange, ExplainsItself) {
  const auto explained = [](std::uint64_t v) {
    return construction(entry).explain(offer_of(entry, parameters(v, Kind::circular))->recipe);
  };
  EXPECT_EQ(explained(9), "A list of 12 triples.");
  EXPECT_EQ(
      explained(21),
      "Take Bose's Steiner triple system on Z_7 x Z_3, go round Z_n x Z_3 level by level, and "
      "list at each point triples that contain it.");
  EXPECT_NE(explained(22).find("Then add 21 with 11 pairs"), std::string::npos);
  EXPECT_NE(explained(18).find("excess 9 on Z_6"), std::string::npos);
  EXPECT_NE(explained(19).find("Skolem's"), std::string::npos);
  EXPECT_NE(explained(17).find("excess 2 on Z_5"), std::string::npos);
}

}  // namespace
}  // namespace changeover
