#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <array>

#include "construction_checks.hpp"

namespace changeover::expansion_entry_test {
namespace {

using namespace test;

struct Row {
  std::uint64_t v, k, b;
};

// The eleven of [ChafeeStevens2025, Corollary 15], with (51,3,425) and (171,11,765) in place of the
// two that are below the lower bound.
constexpr std::array<Row, 11> corollary{{{15, 3, 35},
                                         {21, 5, 30},
                                         {27, 3, 117},
                                         {55, 7, 135},
                                         {39, 3, 247},
                                         {105, 9, 364},
                                         {51, 3, 425},
                                         {77, 5, 418},
                                         {171, 11, 765},
                                         {63, 3, 651},
                                         {253, 13, 1386}}};

TEST(ExpansionEntry, MakesTheElevenDesignsOfTheCorollary) {
  for (const Row& row : corollary) {
    const auto offer = offer_of("expansion", {row.v, row.k, 2, Kind::circular, 2});
    ASSERT_TRUE(offer) << row.v << " " << row.k;
    EXPECT_EQ(offer->b, row.b);
    EXPECT_TRUE(offer->tight && offer->economical);
    EXPECT_FALSE(offer->expansion_set);
    expect_exactly_as_promised(*offer);
  }
}

TEST(ExpansionEntry, MakesThemReadAsLinearToo) {
  for (const Row& row : corollary) {
    const auto offer = offer_of("expansion", {row.v, row.k, 2, Kind::linear, 2});
    ASSERT_TRUE(offer);
    EXPECT_EQ(offer->b, row.b);
    EXPECT_EQ(offer->tight, row.k == 3);
    expect_exactly_as_promised(*offer);
  }
}

TEST(ExpansionEntry, MakesTheDesignOnTenElementsFromTheOneOnSix) {
  const auto offer = offer_of("expansion", {10, 4, 2, Kind::circular, 2});
  ASSERT_TRUE(offer);
  EXPECT_EQ(offer->b, 9U);
  EXPECT_EQ(offer->recipe.arguments.at("w"), 4);
  EXPECT_EQ(offer->recipe.inputs.front().construction, "doubling");
  expect_exactly_as_promised(*offer);
}

TEST(ExpansionEntry, MakesTheLinearDesignOnFifteenElementsFromThePrintedOneOnSeven) {
  const auto offer = offer_of("expansion", {15, 3, 2, Kind::linear, 2});
  ASSERT_TRUE(offer);
  EXPECT_EQ(offer->b, 35U);
  EXPECT_EQ(offer->recipe.inputs.front().construction, "printed");
  EXPECT_TRUE(offer->tight);
  // The first four blocks hold element 2, which is placed before the first block.
  const Design design = standard().build_design(offer->recipe);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(design.block(i)[0], 2U);
  }
  EXPECT_EQ(design.block(4)[0], 0U);
}

TEST(ExpansionEntry, ServesOnlyWhatHasAnInputWithAnExpansionSet) {
  for (std::uint64_t v = 3; v <= 120; ++v) {
    for (std::uint64_t k = 3; k <= v; ++k) {
      for (const Kind kind : {Kind::linear, Kind::circular}) {
        const auto offer = offer_of("expansion", {v, k, 2, kind, 2});
        if (offer) {
          const Recipe& input = offer->recipe.inputs.front();
          EXPECT_TRUE(standard().construction_of(input).expansion_set(input, standard()));
          EXPECT_EQ((v - 1) % (k - 1), 0U);
          EXPECT_EQ((v - 1) / (k - 1) % 2, 1U);
        }
      }
    }
  }
  EXPECT_FALSE(offer_of("expansion", {15, 3, 1, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("expansion", {15, 3, 2, Kind::circular, 3}));
}

RC_GTEST_PROP(ExpansionEntry, IsVerifiedForEveryCyclicInput, ()) {
  const auto c = *rc::gen::inRange<std::uint64_t>(1, 6);
  const auto n = *rc::gen::suchThat(rc::gen::inRange<std::uint64_t>(1, 2 * c + 2),
                                    [c](std::uint64_t d) { return (2 * c + 1) % d == 0; });
  const std::uint64_t k = n + 2;
  const std::uint64_t subsets = (c * (4 * k - 6) + 1) / n;
  const Kind kind = *rc::gen::element(Kind::linear, Kind::circular);
  const auto offer = offer_of("expansion", {subsets * (k - 1) + 1, k, 2, kind, 2});
  RC_ASSERT(offer.has_value());
  const auto source = standard().build(offer->recipe);
  const Verdict verdict = verify(*source);
  RC_ASSERT(verdict.valid());
  RC_ASSERT(verdict.b == offer->b);
  RC_ASSERT(verdict.tight() == offer->tight);
  RC_ASSERT(verdict.never_unchanged.size() == subsets + 1);
}

TEST(ExpansionEntry, RefusesSpoiltRecipes) {
  expect_spoilt_recipes_refused(offer_of("expansion", {15, 3, 2, Kind::circular, 2})->recipe);
  expect_spoilt_recipes_refused(offer_of("expansion", {15, 3, 2, Kind::linear, 2})->recipe);
}

TEST(ExpansionEntry, RefusesAnInputWithoutAnExpansionSet) {
  Recipe recipe = offer_of("expansion", {15, 3, 2, Kind::circular, 2})->recipe;
  recipe.inputs.front() = offer_of("printed", {7, 3, 2, Kind::circular, 2})->recipe;
  expect_refused(recipe, "a circular design in which element 2 is never kept");
}

TEST(ExpansionEntry, RefusesAnEvenNumberOfSubsets) {
  const Recipe eight{
      "literal", {8, 4, 2, Kind::linear, 2}, {}, {}, {{0, 1, 2, 3}, {2, 3, 4, 5}, {4, 5, 6, 7}}};
  EXPECT_TRUE(construction("literal").expansion_set(eight, standard()));
  expect_refused({"expansion", {13, 4, 2, Kind::linear, 2}, {{"w", 5}}, {eight}, {}}, "K_5");
}

TEST(ExpansionEntry, ExplainsItself) {
  EXPECT_EQ(construction("expansion")
                .explain(offer_of("expansion", {15, 3, 2, Kind::circular, 2})->recipe),
            "At each of the 7 positions of an expansion set of the circular DCCD(7,3), insert its "
            "unchanged subset with the edges of one 1-factor of K_8 on the new elements 7,…,14.");
}

}  // namespace
}  // namespace changeover::expansion_entry_test
