#include <gtest/gtest.h>

#include "construction_checks.hpp"

namespace changeover::developed_test {
namespace {

using namespace test;

Recipe developed(const Parameters& p, std::int64_t n, std::int64_t f, std::int64_t shift,
                 std::vector<Block> blocks) {
  return {"developed", p, {{"n", n}, {"f", f}, {"shift", shift}}, {}, std::move(blocks)};
}

constexpr Parameters eleven{11, 4, 2, Kind::circular, 2};
constexpr Parameters six{6, 4, 2, Kind::circular, 2};

TEST(Developed, OverZvIsTheDevelopmentOfBaseBlocks) {
  const Recipe recipe = developed(eleven, 11, 0, 1, {{0, 1, 2, 5}});
  const Design design = standard().build_design(recipe);
  EXPECT_TRUE(verify(design).tight());
  EXPECT_EQ(design.block_count(), 11U);
  EXPECT_TRUE(design.labels().empty());
  const auto base = construction("developed").base_blocks(recipe);
  ASSERT_TRUE(base);
  DevelopedSource source(*base);
  EXPECT_EQ(blocks_of(source), design.blocks());
  EXPECT_EQ(construction("developed").explain(recipe),
            "Develop the base block {0,1,2,5} over Z_11.");
}

TEST(Developed, EveryUnitShiftIsTheSameDesignWithOtherNames) {
  for (Element shift = 2; shift < 11; ++shift) {
    const Block base{0, shift, 2 * shift % 11, 5 * shift % 11};
    const Recipe recipe = developed(eleven, 11, 0, shift, {base});
    EXPECT_TRUE(verify(standard().build_design(recipe)).tight()) << shift;
    EXPECT_FALSE(construction("developed").base_blocks(recipe));
  }
}

TEST(Developed, TakesSeveralCycles) {
  // {0,1},{2,3},{4,5} as one base block over two cycles of length 3.
  const Recipe recipe = developed(six, 3, 0, 1, {{0, 3, 1, 4}});
  const Design design = standard().build_design(recipe);
  EXPECT_EQ(design.blocks(), (std::vector<Block>{{0, 3, 1, 4}, {1, 4, 2, 5}, {2, 5, 0, 3}}));
  EXPECT_TRUE(verify(design).tight());
  EXPECT_EQ(design.labels(), (std::vector<std::string>{"0_0", "1_0", "2_0", "0_1", "1_1", "2_1"}));
}

TEST(Developed, LeavesFixedElementsWhereTheyAre) {
  const Recipe recipe = developed({7, 5, 2, Kind::circular, 2}, 3, 1, 2, {{0, 3, 1, 4, 6}});
  const Design design = standard().build_design(recipe);
  EXPECT_EQ(design.blocks(),
            (std::vector<Block>{{0, 3, 1, 4, 6}, {2, 5, 0, 3, 6}, {1, 4, 2, 5, 6}}));
  EXPECT_TRUE(verify(design).tight());
  EXPECT_EQ(design.label(6), "∞");
  const Recipe two = developed({8, 6, 2, Kind::circular, 2}, 3, 2, 1, {{0, 3, 1, 4, 6, 7}});
  EXPECT_EQ(standard().build_design(two).label(7), "∞_1");
  EXPECT_TRUE(verify(standard().build_design(two)).valid());
}

TEST(Developed, IsReadTwice) {
  const auto source = standard().build(developed(six, 3, 0, 2, {{0, 3, 1, 4}}));
  EXPECT_EQ(source->block_count(), 3U);
  const auto once = blocks_of(*source);
  ASSERT_TRUE(source->rewind());
  EXPECT_EQ(blocks_of(*source), once);
  EXPECT_EQ(once.size(), 3U);
}

TEST(Developed, NamesItsSource) {
  Recipe recipe = developed(six, 3, 0, 1, {{0, 3, 1, 4}});
  recipe.provenance = "a search";
  EXPECT_EQ(construction("developed").explain(recipe),
            "Develop the base block {0,3,1,4} over 2 copies of Z_3: 3j + i is i of copy j, "
            "written i_j; from: a search.");
}

TEST(Developed, SaysWhichNumberIsWhichElement) {
  const Recipe one = developed({7, 4, 2, Kind::circular, 2}, 3, 1, 1, {{0, 3, 1, 6}});
  EXPECT_EQ(construction("developed").explain(one),
            "Develop the base block {0,3,1,6} over 2 copies of Z_3 and a fixed element: 3j + i is "
            "i of copy j, written i_j; 6 is fixed, written ∞.");
  const Recipe two = developed({8, 6, 2, Kind::circular, 2}, 6, 2, 1, {{0, 3, 1, 4, 6, 7}});
  EXPECT_EQ(construction("developed").explain(two),
            "Develop the base block {0,3,1,4,6,7} over Z_6 and 2 fixed elements: 6 to 7 are fixed, "
            "written ∞_0 to ∞_1.");
}

TEST(Developed, OffersNothing) {
  EXPECT_FALSE(offer_of("developed", eleven));
  EXPECT_FALSE(offer_of("developed", six));
}

TEST(Developed, RefusesWhatDoesNotFit) {
  const Block block{0, 3, 1, 4};
  expect_refused(developed(six, 3, 0, 1, {}), "no base block");
  expect_refused(developed(six, 3, 0, 1, {{0, 1, 2}}), "a short block");
  expect_refused(developed(six, 3, 0, 1, {{0, 1, 2, 6}}), "an element that is not below v");
  expect_refused(developed(six, 3, 0, 1, {{0, 1, 2, 2}}), "a repeated element");
  expect_refused(developed(six, 4, 0, 1, {block}), "n does not divide v - f");
  expect_refused(developed(six, 3, 1, 1, {block}), "f does not fit");
  expect_refused(developed(six, 3, 6, 1, {block}), "nothing but fixed points");
  expect_refused(developed(six, 3, -3, 1, {block}), "f below 0");
  expect_refused(developed(six, 1, 0, 1, {block}), "cycles of length 1");
  expect_refused(developed(six, 3, 0, 0, {block}), "no shift");
  expect_refused(developed(six, 3, 0, 3, {block}), "a shift that is no unit");
  expect_refused(developed(six, 6, 0, 2, {block}), "another one");
  Recipe recipe = developed(six, 3, 0, 1, {block});
  recipe.parameters.kind = Kind::linear;
  expect_refused(recipe, "linear");
  for (const char* argument : {"n", "f", "shift"}) {
    recipe = developed(six, 3, 0, 1, {block});
    recipe.arguments.erase(argument);
    expect_refused(recipe, argument);
  }
  recipe = developed(six, 3, 0, 1, {block});
  recipe.arguments["c"] = 1;
  expect_refused(recipe, "an unknown argument");
  recipe = developed(six, 3, 0, 1, {block});
  recipe.inputs.push_back(recipe);
  expect_refused(recipe, "an input");
}

}  // namespace
}  // namespace changeover::developed_test
