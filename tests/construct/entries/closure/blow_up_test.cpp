#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "changeover/construct/closure.hpp"
#include "construction_checks.hpp"

namespace changeover {
namespace {

using namespace test;

Recipe best(const Parameters& p) { return standard().best(p)->recipe; }

TEST(BlowUp, OfMcSorleyByTwoIsDoubling) {
  for (std::uint64_t k = 2; k <= 20; ++k) {
    const Recipe recipe = blow_up_recipe(best({2 * k - 1, k, 1, Kind::circular, 2}), 2);
    const auto doubling = offer_of("doubling", recipe.parameters);
    ASSERT_TRUE(doubling);
    EXPECT_EQ(standard().build_design(recipe).blocks(),
              standard().build_design(doubling->recipe).blocks());
  }
}

TEST(BlowUp, MultipliesTheChange) {
  const Recipe recipe = blow_up_recipe(best({6, 4, 2, Kind::circular, 2}), 3);
  EXPECT_EQ(recipe.parameters, (Parameters{18, 12, 6, Kind::circular, 2}));
  const Verdict verdict = verify(standard().build_design(recipe));
  EXPECT_TRUE(verdict.valid());
  EXPECT_TRUE(verdict.tight());
  EXPECT_EQ(verdict.b, 3U);
}

TEST(BlowUp, AndFixMakeTheExampleOfTheHeader) {
  const Parameters p{.v = 5, .k = 3, .change = 1, .kind = Kind::circular};
  const Recipe core{"mcsorley-circular", p, {}, {}, {}};
  const Recipe larger = fix_recipe(blow_up_recipe(core, 3), 2);
  EXPECT_EQ(larger.parameters, (Parameters{17, 11, 3, Kind::circular, 2}));
  const Verdict verdict = verify(*standard().build(larger));
  EXPECT_TRUE(verdict.valid());
  EXPECT_EQ(verdict.b, 5U);
}

TEST(BlowUp, IntoOneCopyIsTheInput) {
  const Recipe input = best({11, 4, 2, Kind::circular, 2});
  EXPECT_EQ(blow_up_recipe(input, 1), input);
  EXPECT_EQ(blow_up_recipe(blow_up_recipe(input, 1), 1), input);
}

TEST(BlowUp, RefusesNumbersThatDoNotFit) {
  const Recipe input = best({11, 4, 2, Kind::circular, 2});
  EXPECT_THROW((void)blow_up_recipe(input, 0), BadInput);
  EXPECT_THROW((void)blow_up_recipe(input, ~std::uint64_t{0}), ImpossibleParameters);
  for (const std::uint64_t s : {std::uint64_t{0xffff'ffff}, std::uint64_t{1} << 60U}) {
    expect_refused(blow_up_recipe(input, s), "v too large");
  }
}

TEST(BlowUp, MakesNoOffersOfItsOwn) {
  for (std::uint64_t k = 2; k <= 12; ++k) {
    EXPECT_FALSE(offer_of("blow-up", {2 * k - 2, k, 2, Kind::circular, 2}));
  }
}

TEST(BlowUp, KeepsAnyStrength) {
  const Parameters p{5, 4, 1, Kind::linear, 3};
  Recipe input{"literal", p, {}, {}, {}};
  input.blocks = {{0, 1, 2, 3}, {1, 2, 3, 4}, {0, 1, 3, 4}, {0, 2, 3, 4}, {0, 1, 2, 4}};
  const Design design = standard().build_design(blow_up_recipe(input, 2));
  EXPECT_EQ(design.parameters(), (Parameters{10, 8, 2, Kind::linear, 3}));
  EXPECT_TRUE(verify(design).valid());
  EXPECT_TRUE(naive_verdict(design).valid);
}

TEST(BlowUp, CarriesAnExpansionSet) {
  const Recipe recipe = blow_up_recipe(best({6, 4, 2, Kind::circular, 2}), 3);
  const auto set = construction("blow-up").expansion_set(recipe, standard());
  ASSERT_TRUE(set);
  EXPECT_EQ(set->size(), 3U);
  EXPECT_EQ(expansion_set_defect(standard().build_design(recipe), *set), std::nullopt);
  EXPECT_FALSE(construction("blow-up").expansion_set(
      blow_up_recipe(best({8, 5, 2, Kind::circular, 2}), 2), standard()));
}

TEST(BlowUp, NumbersTheCopiesOfNamedElements) {
  const Design design =
      standard().build_design(blow_up_recipe(best({8, 5, 2, Kind::circular, 2}), 2));
  EXPECT_EQ(design.label(0), "∞_s.1");
  EXPECT_EQ(design.label(1), "∞_s.2");
  EXPECT_EQ(design.label(2), "0_s.1");
}

TEST(BlowUp, ExplainsItself) {
  const Recipe input = best({5, 3, 1, Kind::circular, 2});
  const Construction& maker = construction("blow-up");
  EXPECT_EQ(maker.explain(blow_up_recipe(input, 2)),
            "Replace every element x in the blocks of the circular SCCD(5,3) by 2x and 2x+1.");
  EXPECT_EQ(maker.explain(blow_up_recipe(input, 4)),
            "Replace every element x in the blocks of the circular SCCD(5,3) by 4x,…,4x+3.");
}

TEST(BlowUp, RefusesSpoiltRecipes) {
  expect_spoilt_recipes_refused(blow_up_recipe(best({6, 4, 2, Kind::circular, 2}), 2));
  expect_spoilt_recipes_refused(blow_up_recipe(best({9, 5, 1, Kind::linear, 2}), 7));
}

RC_GTEST_PROP(BlowUp, MakesAValidDesignOfAnyValidOne, ()) {
  const auto m = *rc::gen::inRange<std::uint64_t>(1, 4);
  const auto k = *rc::gen::inRange<std::uint64_t>(std::max<std::uint64_t>(m, 2), 10);
  const auto v = *rc::gen::inRange<std::uint64_t>(k, 22);
  const Kind kind = *rc::gen::element(Kind::linear, Kind::circular);
  const auto s = *rc::gen::inRange<std::uint64_t>(2, 5);
  const std::vector<Offer> offers = standard().offers({v, k, m, kind, 2});
  RC_PRE(!offers.empty());
  const Offer input = *rc::gen::elementOf(offers);

  const Recipe recipe = blow_up_recipe(input.recipe, s);
  RC_ASSERT(recipe.parameters == (Parameters{s * v, s * k, s * m, kind, 2}));
  const auto source = standard().build(recipe);
  RC_ASSERT(source->block_count() == input.b);
  const Verdict verdict = verify(*source);
  RC_ASSERT(verdict.valid());
  RC_ASSERT(verdict.b == input.b);
  RC_ASSERT(source->rewind());
  const Design design = standard().build_design(recipe);
  RC_ASSERT(blocks_of(*source) == design.blocks());
  RC_ASSERT(*design.recipe == recipe);
  if (s * v <= 16 && input.b <= 40) {
    RC_ASSERT(naive_verdict(design).valid);
  }
}

RC_GTEST_PROP(BlowUp, AndFixMayBeNestedInAnyOrder, ()) {
  Recipe recipe = offer_of("doubling", {6, 4, 2, Kind::circular, 2})->recipe;
  for (const bool fixed : *rc::gen::container<std::vector<bool>>(3, rc::gen::arbitrary<bool>())) {
    recipe = fixed ? fix_recipe(recipe, *rc::gen::inRange<std::uint64_t>(0, 4))
                   : blow_up_recipe(recipe, *rc::gen::inRange<std::uint64_t>(1, 4));
  }
  const Verdict verdict = verify(standard().build_design(recipe));
  RC_ASSERT(verdict.valid());
  RC_ASSERT(verdict.b == 3U);
}

}  // namespace
}  // namespace changeover
