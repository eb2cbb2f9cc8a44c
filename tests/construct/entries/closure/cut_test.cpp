#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "construction_checks.hpp"

namespace changeover::cut_test {
namespace {

using namespace test;

Parameters linear(std::uint64_t v, std::uint64_t k) { return {v, k, 2, Kind::linear, 2}; }

TEST(Cut, OffersALinearDesignForEveryCircularOne) {
  int seen = 0;
  const Registry constructions(registry_entries());  // without what the catalog makes of them
  for (std::uint64_t v = 2; v <= 40; ++v) {
    for (std::uint64_t k = 2; k <= v; ++k) {
      for (const std::uint64_t m : {1U, 2U}) {
        const auto circular = constructions.best({v, k, m, Kind::circular, 2});
        const auto offer = offer_of("cut", {v, k, m, Kind::linear, 2});
        ASSERT_EQ(offer.has_value(), circular.has_value());
        if (offer) {
          ++seen;
          EXPECT_EQ(offer->b, circular->b);
          EXPECT_TRUE(offer->expansion_set || !circular->expansion_set);
          expect_as_promised(*offer);
        }
      }
    }
  }
  EXPECT_GT(seen, 60);
}

TEST(Cut, BeginsAfterTheBlockThatIsAsked) {
  Recipe recipe = offer_of("cut", linear(11, 4))->recipe;
  const std::vector<Block> whole = standard().build_design(recipe).blocks();
  for (std::int64_t at = 0; at < 11; ++at) {
    recipe.arguments["at"] = at;
    std::vector<Block> expected = whole;
    std::rotate(expected.begin(), expected.begin() + at, expected.end());
    const auto source = standard().build(recipe);
    EXPECT_EQ(blocks_of(*source), expected);
    ASSERT_TRUE(source->rewind());
    EXPECT_EQ(blocks_of(*source), expected);
  }
  recipe.arguments["at"] = 11;
  expect_refused(recipe, "at = b");
}

TEST(Cut, CanRewindInTheMiddle) {
  Recipe recipe = offer_of("cut", linear(11, 4))->recipe;
  recipe.arguments["at"] = 4;
  const std::vector<Block> whole = standard().build_design(recipe).blocks();
  for (std::size_t read = 0; read <= 11; ++read) {
    const auto source = standard().build(recipe);
    Block block(4);
    for (std::size_t i = 0; i < read; ++i) {
      ASSERT_TRUE(source->next(block));
    }
    ASSERT_TRUE(source->rewind());
    EXPECT_EQ(blocks_of(*source), whole);
  }
}

RC_GTEST_PROP(Cut, CarriesAnExpansionSetToAnyPlace, ()) {
  const auto [c, k] = *rc::gen::element(std::pair{1, 3}, std::pair{1, 5}, std::pair{2, 7},
                                        std::pair{3, 9}, std::pair{4, 5}, std::pair{5, 13});
  const auto size = static_cast<std::uint64_t>(k);
  const auto v = static_cast<std::uint64_t>(c) * (4 * size - 6) + 1;
  const auto offer = offer_of("cut", linear(v, size));
  Recipe recipe = offer->recipe;
  recipe.arguments["at"] = *rc::gen::inRange<std::int64_t>(0, static_cast<std::int64_t>(offer->b));
  const auto set = construction("cut").expansion_set(recipe, standard());
  RC_ASSERT(set.has_value());
  RC_ASSERT(!expansion_set_defect(standard().build_design(recipe), *set));
}

TEST(Cut, CarriesLabels) {
  const Recipe runs = offer_of("short-long-runs", {8, 5, 2, Kind::circular, 2})->recipe;
  const Design design = standard().build_design({"cut", linear(8, 5), {{"at", 2}}, {runs}, {}});
  EXPECT_EQ(design.label(0), "∞_s");
}

TEST(Cut, ExplainsItself) {
  Recipe recipe = offer_of("cut", linear(11, 4))->recipe;
  EXPECT_EQ(construction("cut").explain(recipe), "Read the circular DCCD(11,4) as a linear list.");
  recipe.arguments["at"] = 3;
  EXPECT_EQ(construction("cut").explain(recipe),
            "Read the circular DCCD(11,4) as a linear list that begins after block 3.");
}

TEST(Cut, RefusesSpoiltRecipes) {
  expect_spoilt_recipes_refused(offer_of("cut", linear(11, 4))->recipe, {.arguments = {"at"}});
  expect_spoilt_recipes_refused(offer_of("cut", linear(15, 3))->recipe, {.arguments = {"at"}});
}

}  // namespace
}  // namespace changeover::cut_test
