#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"
#include "oracle_minima.hpp"

namespace changeover {
namespace {

using namespace test;

constexpr const char* entry = "triples-single-change";

Parameters parameters(std::uint64_t v, Kind kind) { return {v, 3, 1, kind, 2}; }

TEST(TriplesSingleChange, IsEconomicalForEveryV) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (std::uint64_t v = 4; v <= 100; ++v) {
      const Parameters p = parameters(v, kind);
      const auto offer = offer_of(entry, p);
      ASSERT_TRUE(offer && offer->economical) << v;
      EXPECT_EQ(offer->b, lower_bound(p).blocks);
      EXPECT_EQ(offer->expansion_set, v % 2 == 0 && v >= 6);
      expect_as_promised(*offer);
    }
    for (std::uint64_t v = 101; v <= 400; ++v) {
      const auto offer = offer_of(entry, parameters(v, kind));
      ASSERT_TRUE(offer && offer->economical);
      const Verdict verdict = verify(*standard().build(offer->recipe));
      ASSERT_TRUE(verdict.economical()) << v;
      ASSERT_EQ(verdict.tight(), offer->tight) << v;
      ASSERT_EQ(verdict.b, offer->b) << v;
    }
    for (std::uint64_t v = 1500; v < 1504; ++v) {
      const auto offer = offer_of(entry, parameters(v, kind));
      EXPECT_TRUE(verify(*standard().build(offer->recipe)).economical()) << v;
    }
  }
}

TEST(TriplesSingleChange, IsTightWhereTheCountingBoundIsAWholeNumber) {
  for (std::uint64_t v = 4; v <= 40; ++v) {
    EXPECT_EQ(offer_of(entry, parameters(v, Kind::linear))->tight, v % 4 == 2 || v % 4 == 3) << v;
    EXPECT_EQ(offer_of(entry, parameters(v, Kind::circular))->tight, v % 4 == 0 || v % 4 == 1) << v;
  }
}

TEST(TriplesSingleChange, AttainsTheKnownMinima) {
  std::size_t rows = 0;
  for (const OracleMinimum& row : oracle_minima()) {
    if (row.parameters.k == 3 && row.parameters.change == 1) {
      ++rows;
      const auto offer = offer_of(entry, row.parameters);
      ASSERT_TRUE(offer);
      EXPECT_EQ(offer->b, row.b) << name(row.parameters);
    }
  }
  EXPECT_EQ(rows, 18U);
}

TEST(TriplesSingleChange, ServesNothingElse) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (std::uint64_t v = 0; v < 4; ++v) {
      EXPECT_FALSE(offer_of(entry, parameters(v, kind))) << v;
    }
    EXPECT_FALSE(offer_of(entry, {7, 2, 1, kind, 2}));
    EXPECT_FALSE(offer_of(entry, {7, 3, 2, kind, 2}));
    EXPECT_FALSE(offer_of(entry, {7, 3, 1, kind, 3}));
  }
}

TEST(TriplesSingleChange, PromisesTheLargestWithoutBuilding) {
  for (std::uint64_t v = 0xffff'fffc; v <= 0xffff'ffff; ++v) {
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      const auto offer = offer_of(entry, parameters(v, kind));
      ASSERT_TRUE(offer && offer->economical && !offer->expansion_set);
      EXPECT_EQ(offer->b, lower_bound(parameters(v, kind)).blocks);
      EXPECT_EQ(standard().build(offer->recipe)->block_count(), offer->b);
    }
  }
}

TEST(TriplesSingleChange, RefusesSpoiltRecipes) {
  for (const std::uint64_t v : {6U, 14U}) {
    Recipe recipe = offer_of(entry, parameters(v, Kind::circular))->recipe;
    recipe.parameters.k = 4;
    expect_refused(recipe, "k = 4");
    recipe.parameters.k = 3;
    recipe.parameters.change = 2;
    expect_refused(recipe, "m = 2");
    recipe.parameters.change = 1;
    recipe.parameters.v = 3;
    expect_refused(recipe, "v = 3");
    recipe.parameters.v = v;
    recipe.inputs.push_back(recipe);
    expect_refused(recipe, "an input");
    EXPECT_THROW((void)construction(entry).expansion_set(recipe, standard()), BadInput);
    EXPECT_THROW((void)construction(entry).explain(recipe), BadInput);
  }
}

TEST(TriplesSingleChange, ExplainsItself) {
  const auto explained = [](std::uint64_t v) {
    return construction(entry).explain(offer_of(entry, parameters(v, Kind::linear))->recipe);
  };
  EXPECT_EQ(explained(8), "A list of 14 blocks.");
  EXPECT_EQ(explained(12),
            "Extend a listed linear SCCD(8,3) of 14 blocks once by 4 elements: two sets of 2 new "
            "elements are held beside almost every old one.");
  EXPECT_NE(explained(17).find("SCCD(5,3) of 5 blocks 3 times"), std::string::npos);
}

}  // namespace
}  // namespace changeover
