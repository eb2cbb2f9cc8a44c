#include <gtest/gtest.h>

#include "construction_checks.hpp"

namespace changeover::literal_test {
namespace {

using namespace test;

Recipe literal(const Parameters& p, std::vector<Block> blocks) {
  return {"literal", p, {}, {}, std::move(blocks)};
}

const Parameters six{6, 4, 2, Kind::circular, 2};
const std::vector<Block> three_blocks{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 1}};

TEST(Literal, BuildsTheBlocksAsGiven) {
  const Design design = standard().build_design(literal(six, three_blocks));
  EXPECT_EQ(design.blocks(), three_blocks);
  EXPECT_EQ(construction("literal").explain(literal(six, three_blocks)),
            "The 3 blocks are stored with the design.");
}

TEST(Literal, BuildsListsThatAreNoDesigns) {
  const auto source = standard().build(literal(six, {{0, 1, 2, 3}, {0, 1, 2, 4}}));
  EXPECT_FALSE(verify(*source).valid());
}

TEST(Literal, OffersNothing) {
  for (std::uint64_t v = 2; v <= 20; ++v) {
    for (std::uint64_t k = 2; k <= v; ++k) {
      EXPECT_FALSE(offer_of("literal", {v, k, 2, Kind::circular, 2}));
    }
  }
}

TEST(Literal, FindsItsExpansionSet) {
  const auto set = construction("literal").expansion_set(literal(six, three_blocks), standard());
  ASSERT_TRUE(set);
  EXPECT_EQ(*set, (ExpansionSet{{1, {2, 3}}, {2, {4, 5}}, {3, {0, 1}}}));
  const Parameters linear_seven{7, 4, 2, Kind::linear, 2};
  EXPECT_FALSE(
      construction("literal").expansion_set(literal(linear_seven, three_blocks), standard()));
}

TEST(Literal, CanBeExpanded) {
  const Parameters ten{10, 4, 2, Kind::circular, 2};
  const Recipe recipe{"expansion", ten, {{"w", 4}}, {literal(six, three_blocks)}, {}};
  const Verdict verdict = verify(standard().build_design(recipe));
  EXPECT_TRUE(verdict.tight());
  EXPECT_EQ(verdict.b, 9U);
}

TEST(Literal, RefusesMalformedBlocks) {
  expect_refused(literal(six, {}), "no blocks");
  expect_refused(literal(six, {{0, 1, 2}}), "a short block");
  expect_refused(literal(six, {{0, 1, 2, 3, 4}}), "a long block");
  expect_refused(literal(six, {{0, 1, 2, 6}}), "an element that is not below v");
  expect_refused(literal(six, {{0, 1, 2, 2}}), "a repeated element");
  expect_refused(literal({3, 4, 2, Kind::circular, 2}, {{0, 1, 2, 3}}), "k > v");
  expect_refused(literal({0, 0, 2, Kind::circular, 2}, {{}}), "v = 0");
  Recipe recipe = literal(six, three_blocks);
  recipe.arguments["w"] = 4;
  expect_refused(recipe, "an argument");
  recipe = literal(six, three_blocks);
  recipe.inputs.push_back(recipe);
  expect_refused(recipe, "an input");
}

}  // namespace
}  // namespace changeover::literal_test
