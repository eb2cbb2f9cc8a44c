// The rules with one number: f fixed elements, s copies of every element.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "changeover/construct/closure.hpp"
#include "construction_checks.hpp"
#include "message_of.hpp"

namespace changeover::rules_with_a_number_test {
namespace {

using namespace test;

Recipe best(const Parameters& p) { return standard().best(p)->recipe; }

using Rule = Recipe (*)(const Recipe& input, std::uint64_t number);

constexpr std::uint64_t beyond = 0xffff'ffff;

TEST(RulesWithANumber, AreNothingForNothing) {
  const Recipe input = best({11, 4, 2, Kind::circular, 2});
  EXPECT_EQ(fix_recipe(input, 0), input);
  EXPECT_EQ(blow_up_recipe(input, 1), input);
}

TEST(RulesWithANumber, RefuseNumbersThatDoNotFit) {
  const Recipe input = best({11, 4, 2, Kind::circular, 2});
  EXPECT_REFUSAL((void)blow_up_recipe(input, 0), BadInput,
                 "an element cannot be replaced by no copies at all");
  EXPECT_THROW((void)blow_up_recipe(input, ~std::uint64_t{0}), ImpossibleParameters);
  EXPECT_THROW((void)fix_recipe(input, ~std::uint64_t{0}), ImpossibleParameters);
  for (const std::uint64_t s : {beyond, std::uint64_t{1} << 60U}) {
    expect_refused(blow_up_recipe(input, s), "v too large");
  }
  for (const std::uint64_t f : {beyond, std::uint64_t{1} << 62U, ~std::uint64_t{11}}) {
    expect_refused(fix_recipe(input, f), "v too large");
  }
}

TEST(RulesWithANumber, MakeNoOffersOfTheirOwn) {
  for (std::uint64_t k = 2; k <= 12; ++k) {
    EXPECT_FALSE(offer_of("fix", {2 * k - 2, k, 2, Kind::circular, 2}));
    EXPECT_FALSE(offer_of("blow-up", {2 * k - 2, k, 2, Kind::circular, 2}));
  }
}

TEST(RulesWithANumber, KeepAnyStrength) {
  const Parameters p{5, 4, 1, Kind::linear, 3};
  Recipe input{"literal", p, {}, {}, {}};
  input.blocks = {{0, 1, 2, 3}, {1, 2, 3, 4}, {0, 1, 3, 4}, {0, 2, 3, 4}, {0, 1, 2, 4}};
  ASSERT_TRUE(verify(standard().build_design(input)).valid());
  for (const Rule rule : {fix_recipe, blow_up_recipe}) {
    const Design design = standard().build_design(rule(input, 2));
    EXPECT_EQ(design.parameters().strength, 3U);
    EXPECT_TRUE(verify(design).valid());
    EXPECT_TRUE(naive_verdict(design).valid);
  }
}

// A valid design of the rule's making; its verdict, and the offer that it was made of.
std::pair<Verdict, Offer> made_by(Rule rule, std::uint64_t number) {
  const auto m = *rc::gen::inRange<std::uint64_t>(1, 4);
  const auto k = *rc::gen::inRange<std::uint64_t>(std::max<std::uint64_t>(m, 2), 10);
  const auto v = *rc::gen::inRange<std::uint64_t>(k, 22);
  const Kind kind = *rc::gen::element(Kind::linear, Kind::circular);
  const std::vector<Offer> offers = standard().offers({v, k, m, kind, 2});
  RC_PRE(!offers.empty());
  const Offer input = *rc::gen::elementOf(offers);

  const Recipe recipe = rule(input.recipe, number);
  const auto source = standard().build(recipe);
  RC_ASSERT(source->block_count() == input.b);
  RC_ASSERT(source->parameters() == recipe.parameters);
  const Verdict verdict = verify(*source);
  RC_ASSERT(verdict.valid());
  RC_ASSERT(verdict.b == input.b);
  RC_ASSERT(source->rewind());
  const Design design = standard().build_design(recipe);
  RC_ASSERT(blocks_of(*source) == design.blocks());
  RC_ASSERT(*design.recipe == recipe);
  if (design.v() <= 16 && input.b <= 40) {
    RC_ASSERT(naive_verdict(design).valid);
  }
  return {verdict, input};
}

RC_GTEST_PROP(Fix, MakesAValidDesignOfAnyValidOne, ()) {
  const auto f = *rc::gen::inRange<std::uint64_t>(1, 6);
  const auto [verdict, input] = made_by(fix_recipe, f);
  const Parameters& p = input.recipe.parameters;
  RC_ASSERT(fix_recipe(input.recipe, f).parameters ==
            (Parameters{p.v + f, p.k + f, p.change, p.kind, 2}));
  RC_ASSERT(verdict.fixed.size() >= f);
  if (p.kind == Kind::circular && input.b > 1) {
    RC_ASSERT(verdict.never_newly_covered >= f * (f - 1) / 2);
  }
}

RC_GTEST_PROP(BlowUp, MakesAValidDesignOfAnyValidOne, ()) {
  const auto s = *rc::gen::inRange<std::uint64_t>(2, 5);
  const auto [verdict, input] = made_by(blow_up_recipe, s);
  const Parameters& p = input.recipe.parameters;
  RC_ASSERT(blow_up_recipe(input.recipe, s).parameters ==
            (Parameters{s * p.v, s * p.k, s * p.change, p.kind, 2}));
}

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
}  // namespace changeover::rules_with_a_number_test
