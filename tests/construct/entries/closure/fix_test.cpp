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

TEST(Fix, AddsTheNewElementsToEveryBlock) {
  const Recipe input = best({6, 4, 2, Kind::circular, 2});
  const Recipe recipe = fix_recipe(input, 3);
  EXPECT_EQ(recipe.parameters, (Parameters{9, 7, 2, Kind::circular, 2}));
  std::vector<Block> expected = standard().build_design(input).blocks();
  for (Block& block : expected) {
    block.insert(block.end(), {6, 7, 8});
  }
  EXPECT_EQ(standard().build_design(recipe).blocks(), expected);
}

TEST(Fix, ByNothingIsTheInput) {
  const Recipe input = best({11, 4, 2, Kind::circular, 2});
  EXPECT_EQ(fix_recipe(input, 0), input);
}

TEST(Fix, RefusesNumbersThatDoNotFit) {
  const Recipe input = best({11, 4, 2, Kind::circular, 2});
  EXPECT_THROW((void)fix_recipe(input, ~std::uint64_t{0}), ImpossibleParameters);
  for (const std::uint64_t f :
       {std::uint64_t{0xffff'ffff}, std::uint64_t{1} << 62U, ~std::uint64_t{11}}) {
    expect_refused(fix_recipe(input, f), "v too large");
  }
}

TEST(Fix, MakesNoOffersOfItsOwn) {
  for (std::uint64_t k = 2; k <= 12; ++k) {
    EXPECT_FALSE(offer_of("fix", {2 * k - 2, k, 2, Kind::circular, 2}));
  }
}

TEST(Fix, KeepsAnyStrength) {
  const Parameters p{5, 4, 1, Kind::linear, 3};
  Recipe input{"literal", p, {}, {}, {}};
  input.blocks = {{0, 1, 2, 3}, {1, 2, 3, 4}, {0, 1, 3, 4}, {0, 2, 3, 4}, {0, 1, 2, 4}};
  ASSERT_TRUE(verify(standard().build_design(input)).valid());
  const Design design = standard().build_design(fix_recipe(input, 2));
  EXPECT_EQ(design.parameters().strength, 3U);
  EXPECT_TRUE(verify(design).valid());
  EXPECT_TRUE(naive_verdict(design).valid);
}

TEST(Fix, NamesNewElementsIfTheOldOnesHaveNames) {
  const Design design = standard().build_design(fix_recipe(best({8, 5, 2, Kind::circular, 2}), 2));
  EXPECT_EQ(design.label(0), "∞_s");
  EXPECT_EQ(design.label(8), "8");
  EXPECT_TRUE(
      standard().build_design(fix_recipe(best({6, 4, 2, Kind::circular, 2}), 2)).labels().empty());
}

TEST(Fix, ExplainsItself) {
  const Recipe input = best({6, 4, 2, Kind::circular, 2});
  const Construction& maker = construction("fix");
  EXPECT_EQ(maker.explain(fix_recipe(input, 1)),
            "Add the new element 6 to every block of the circular DCCD(6,4).");
  EXPECT_EQ(maker.explain(fix_recipe(input, 2)),
            "Add the new elements 6 and 7 to every block of the circular DCCD(6,4).");
  EXPECT_EQ(maker.explain(fix_recipe(input, 3)),
            "Add the new elements 6,…,8 to every block of the circular DCCD(6,4).");
}

TEST(Fix, RefusesSpoiltRecipes) {
  expect_spoilt_recipes_refused(fix_recipe(best({6, 4, 2, Kind::circular, 2}), 1));
  expect_spoilt_recipes_refused(fix_recipe(best({9, 5, 1, Kind::linear, 2}), 7));
  Recipe unbalanced = fix_recipe(best({6, 4, 2, Kind::circular, 2}), 2);
  --unbalanced.parameters.k;
  unbalanced.arguments["f"] = 1;
  expect_refused(unbalanced, "two elements, one of them in blocks");
}

RC_GTEST_PROP(Fix, MakesAValidDesignOfAnyValidOne, ()) {
  const auto m = *rc::gen::inRange<std::uint64_t>(1, 4);
  const auto k = *rc::gen::inRange<std::uint64_t>(std::max<std::uint64_t>(m, 2), 10);
  const auto v = *rc::gen::inRange<std::uint64_t>(k, 22);
  const Kind kind = *rc::gen::element(Kind::linear, Kind::circular);
  const auto f = *rc::gen::inRange<std::uint64_t>(1, 6);
  const std::vector<Offer> offers = standard().offers({v, k, m, kind, 2});
  RC_PRE(!offers.empty());
  const Offer input = *rc::gen::elementOf(offers);

  const Recipe recipe = fix_recipe(input.recipe, f);
  RC_ASSERT(recipe.parameters == (Parameters{v + f, k + f, m, kind, 2}));
  const auto source = standard().build(recipe);
  RC_ASSERT(source->block_count() == input.b);
  const Verdict verdict = verify(*source);
  RC_ASSERT(verdict.valid());
  RC_ASSERT(verdict.b == input.b);
  RC_ASSERT(verdict.fixed.size() >= f);
  if (kind == Kind::circular && input.b > 1) {
    RC_ASSERT(verdict.never_newly_covered >= f * (f - 1) / 2);
  }
  RC_ASSERT(source->rewind());
  const Design design = standard().build_design(recipe);
  RC_ASSERT(blocks_of(*source) == design.blocks());
  RC_ASSERT(*design.recipe == recipe);
  if (v + f <= 12 && input.b <= 40) {
    RC_ASSERT(naive_verdict(design).valid);
  }
}

}  // namespace
}  // namespace changeover
