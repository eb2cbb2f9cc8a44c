#include "changeover/construct/expansion.hpp"

#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "message_of.hpp"
#include "partial_expansion_designs.hpp"

namespace changeover::enlarge_test {
namespace {

using namespace test;

TEST(Enlarge, MakesADesignOutOfEachDesign) {
  std::size_t by_sets = 0;
  std::size_t by_covers = 0;
  for (const Design& design : some_designs()) {
    Enlarged larger{.design = design, .at = {}};
    try {
      larger = enlarge(design);
    } catch (const MissingResource&) {
      continue;
    } catch (const ImpossibleParameters&) {
      continue;
    }
    SCOPED_TRACE(title(design, larger.new_elements));
    EXPECT_TRUE(verify(larger.design).valid());
    EXPECT_EQ(larger.design.v(), design.v() + larger.new_elements);
    EXPECT_FALSE(larger.at.empty());
    if (larger.by_expansion_set) {
      EXPECT_EQ(expansion_set_defect(design, larger.at), std::nullopt);
      EXPECT_EQ(larger.at.size() % 2, 1U);
    }
    ++(larger.by_expansion_set ? by_sets : by_covers);
  }
  EXPECT_GT(by_sets, 3U);
  EXPECT_GT(by_covers, 10U);
}

TEST(Enlarge, GivesTheNumberOfElementsThatIsAskedFor) {
  const Design design = built("cyclic-paper", 15, 5);
  for (std::uint64_t w = 1; w <= 8; ++w) {
    const Enlarged larger = enlarge(design, {.new_elements = w});
    EXPECT_EQ(larger.design.v(), 15 + w);
    EXPECT_TRUE(verify(larger.design).valid());
  }
}

TEST(Enlarge, SetsAreNumberedFromOne) {
  const Design design = built("cyclic-paper", 15, 5);
  const ExpansionSearch all = find_expansion_sets(design, {.how_many = 100});
  ASSERT_TRUE(all.complete);
  ASSERT_GT(all.sets.size(), 1U);
  for (std::size_t i = 0; i < all.sets.size(); ++i) {
    EXPECT_EQ(enlarge(design, {.set = i + 1}).at, all.sets[i]);
  }
  EXPECT_THROW((void)enlarge(design, {.set = all.sets.size() + 1}), MissingResource);
  EXPECT_THROW((void)enlarge(design, {.set = 0}), BadInput);
  EXPECT_THROW((void)enlarge(design, {.new_elements = 4, .set = 1}), BadInput);
}

TEST(Enlarge, TakesNothingElseForASetThatCannotServe) {
  // {0,1,2,3} and {4,5,6,7} are an expansion set, with two members.
  const std::vector<Block> blocks{
      {0, 1, 2, 3, 4, 5}, {0, 1, 2, 3, 6, 7}, {0, 1, 4, 5, 6, 7}, {2, 3, 4, 5, 6, 7}};
  const Design even({.v = 8, .k = 6, .change = 2, .kind = Kind::circular}, blocks);
  ASSERT_TRUE(verify(even).valid());
  ASSERT_EQ(find_expansion_sets(even, {.how_many = 1}).sets.at(0).size(), 2U);
  EXPECT_FALSE(enlarge(even).by_expansion_set);
  EXPECT_REFUSAL(
      (void)enlarge(even, {.set = 1}), MissingResource,
      "no expansion set serves: each has an even number of members; ask for a number of new elements");

  EXPECT_REFUSAL(
      (void)enlarge(built("mcsorley-circular", 5, 3, 1), {.set = 1}), MissingResource,
      "no expansion set serves: the recursion is for change number 2; ask for a number of new elements");
}

TEST(Enlarge, SaysWhyNothingCanBeInserted) {
  Design pairs({.v = 4, .k = 2, .change = 2, .kind = Kind::linear});
  const Block first{0, 1};
  const Block second{2, 3};
  pairs.append(first);
  pairs.append(second);
  EXPECT_THROW((void)enlarge(pairs), MissingResource);
}

}  // namespace
}  // namespace changeover::enlarge_test
