#include <gtest/gtest.h>

#include "construction_checks.hpp"

namespace changeover::printed_test {
namespace {

using namespace test;

TEST(Printed, DesignsAreTightInBothKinds) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (const auto& [v, b] : {std::pair{7, 7}, std::pair{9, 12}}) {
      const auto offer = offer_of("printed", {static_cast<std::uint64_t>(v), 3, 2, kind, 2});
      ASSERT_TRUE(offer);
      EXPECT_EQ(offer->b, static_cast<std::uint64_t>(b));
      EXPECT_TRUE(offer->tight);
      EXPECT_EQ(offer->expansion_set, v == 7 && kind == Kind::linear);
      expect_exactly_as_promised(*offer);
    }
  }
}

TEST(Printed, ElementsOfTheNineAreNamedFromOne) {
  const Design design =
      standard().build_design(offer_of("printed", {9, 3, 2, Kind::circular, 2})->recipe);
  EXPECT_EQ(design.label(0), "1");
  EXPECT_EQ(design.label(8), "9");
}

TEST(Printed, ExpansionSetsAreThoseThatSearchingFinds) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (const std::uint64_t v : {7U, 9U}) {
      const auto offer = offer_of("printed", {v, 3, 2, kind, 2});
      const auto search =
          find_expansion_sets(standard().build_design(offer->recipe),
                              {.how_many = 10, .count = true, .partial = false, .limits = {}});
      ASSERT_TRUE(search.complete);
      EXPECT_EQ(search.count, offer->expansion_set ? 2U : 0U);
      const auto set = construction("printed").expansion_set(offer->recipe, standard());
      EXPECT_EQ(set.has_value(), offer->expansion_set);
      if (set) {
        EXPECT_EQ(std::count(search.sets.begin(), search.sets.end(), *set), 1);
      }
    }
  }
}

TEST(Printed, RefusesSpoiltRecipesAndOtherBlocks) {
  Recipe recipe = offer_of("printed", {9, 3, 2, Kind::linear, 2})->recipe;
  expect_spoilt_recipes_refused(recipe, {.any_kind = true});
  std::swap(recipe.blocks[0], recipe.blocks[1]);
  expect_refused(recipe, "two blocks swapped");
  recipe.blocks.clear();
  expect_refused(recipe, "no blocks");
}

}  // namespace
}  // namespace changeover::printed_test
