#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"
#include "oracle_minima.hpp"

namespace changeover {
namespace {

using namespace test;

constexpr const char* entry = "quadruples-single-change";

Parameters parameters(std::uint64_t v, Kind kind) { return {v, 4, 1, kind, 2}; }

bool has_the_counting_bound(std::uint64_t v, Kind kind) {
  return kind == Kind::circular ? v >= 6 : v == 5 || v == 8 || v >= 11;
}

TEST(QuadruplesSingleChange, IsEconomicalForEveryVButSomeSmallOnes) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (std::uint64_t v = 5; v <= 100; ++v) {
      const Parameters p = parameters(v, kind);
      const auto offer = offer_of(entry, p);
      ASSERT_TRUE(offer) << v;
      EXPECT_EQ(offer->economical, has_the_counting_bound(v, kind)) << v;
      if (offer->economical || v == 5) {
        EXPECT_EQ(offer->b, lower_bound(p).blocks) << v;
      }
      EXPECT_EQ(offer->expansion_set,
                v % 3 == 0 && (v >= 12 || (kind == Kind::circular && v == 9)));
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
    for (std::uint64_t v = 1500; v < 1506; ++v) {
      const auto offer = offer_of(entry, parameters(v, kind));
      EXPECT_TRUE(verify(*standard().build(offer->recipe)).economical()) << v;
    }
  }
}

TEST(QuadruplesSingleChange, IsTightWhereTheCountingBoundIsAttainedAndAWholeNumber) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (std::uint64_t v = 5; v <= 40; ++v) {
      EXPECT_EQ(offer_of(entry, parameters(v, kind))->tight,
                v % 3 != 2 && has_the_counting_bound(v, kind))
          << v;
    }
  }
}

TEST(QuadruplesSingleChange, AttainsTheKnownMinima) {
  std::size_t rows = 0;
  for (const OracleMinimum& row : oracle_minima()) {
    if (row.parameters.k == 4 && row.parameters.change == 1) {
      ++rows;
      const auto offer = offer_of(entry, row.parameters);
      ASSERT_TRUE(offer);
      EXPECT_EQ(offer->b, row.b) << name(row.parameters);
    }
  }
  EXPECT_EQ(rows, 16U);
}

TEST(QuadruplesSingleChange, ServesNothingElse) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (std::uint64_t v = 0; v < 5; ++v) {
      EXPECT_FALSE(offer_of(entry, parameters(v, kind))) << v;
    }
    EXPECT_FALSE(offer_of(entry, {7, 2, 1, kind, 2}));
    EXPECT_FALSE(offer_of(entry, {7, 4, 2, kind, 2}));
    EXPECT_FALSE(offer_of(entry, {7, 4, 1, kind, 3}));
  }
}

TEST(QuadruplesSingleChange, PromisesTheLargestWithoutBuilding) {
  for (std::uint64_t v = 0xffff'fffa; v <= 0xffff'ffff; ++v) {
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      const auto offer = offer_of(entry, parameters(v, kind));
      ASSERT_TRUE(offer && offer->economical && !offer->expansion_set);
      EXPECT_EQ(offer->b, lower_bound(parameters(v, kind)).blocks);
      EXPECT_EQ(standard().build(offer->recipe)->block_count(), offer->b);
    }
  }
}

TEST(QuadruplesSingleChange, RefusesSpoiltRecipes) {
  for (const std::uint64_t v : {6U, 18U}) {
    Recipe recipe = offer_of(entry, parameters(v, Kind::circular))->recipe;
    recipe.parameters.k = 5;
    expect_refused(recipe, "k = 5");
    recipe.parameters.k = 4;
    recipe.parameters.change = 2;
    expect_refused(recipe, "m = 2");
    recipe.parameters.change = 1;
    recipe.parameters.v = 4;
    expect_refused(recipe, "v = 4");
    recipe.parameters.v = v;
    recipe.inputs.push_back(recipe);
    expect_refused(recipe, "an input");
    EXPECT_THROW((void)construction(entry).expansion_set(recipe, standard()), BadInput);
    EXPECT_THROW((void)construction(entry).explain(recipe), BadInput);
  }
}

TEST(QuadruplesSingleChange, ExplainsItself) {
  const auto explained = [](std::uint64_t v) {
    return construction(entry).explain(offer_of(entry, parameters(v, Kind::linear))->recipe);
  };
  EXPECT_EQ(explained(8), "A list of 9 blocks.");
  EXPECT_EQ(explained(18),
            "Extend a listed linear SCCD(12,4) of 21 blocks once by 6 elements: two sets of 3 new "
            "elements are held beside almost every old one.");
  EXPECT_NE(explained(29).find("SCCD(11,4) of 18 blocks 3 times"), std::string::npos);
}

}  // namespace
}  // namespace changeover
