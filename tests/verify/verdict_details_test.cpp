// Verdicts where a small fault of them would hide: what is true of nothing, how many examples are listed, messages
// with their numbers. Most of these were missing until planted faults survived.
#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "changeover/verify/difference.hpp"
#include "changeover/verify/verdict.hpp"
#include "changeover/verify/verified_design.hpp"

namespace changeover {
namespace {

template <typename Action>
std::string refusal(Action&& action) {
  try {
    action();
  } catch (const BadInput& fault) {
    return fault.what();
  }
  return "";
}

TEST(VerdictDetails, NothingIsNotValid) {
  EXPECT_FALSE(Verdict{}.valid());
  EXPECT_FALSE(Verdict{}.tight());
  EXPECT_FALSE(Verdict{}.economical());
  EXPECT_FALSE(DifferenceVerdict{}.valid());
  const Parameters p{.v = 5, .k = 3};
  const Verdict verdict = verify(Design(p));
  EXPECT_EQ(verdict.b, 0U);
  EXPECT_EQ(verdict.uncovered, 10U);
  EXPECT_EQ(verdict.excess, 0U);
  EXPECT_TRUE(verdict.fixed.empty());
  EXPECT_FALSE(verdict.valid() || verdict.degree_identity || verdict.unchanged_subsets);
}

// As many blocks as counting asks for make no design economical that is none.
TEST(VerdictDetails, IsEconomicalOnlyIfValid) {
  const Parameters p{.v = 5, .k = 3, .change = 2};
  const std::vector<Block> blocks{{0, 1, 2}, {2, 3, 4}, {0, 1, 3}, {1, 2, 4}};
  Verdict verdict = verify(Design(p, blocks));
  verdict.counting_bound = verdict.b;
  EXPECT_FALSE(verdict.valid());
  EXPECT_FALSE(verdict.economical());
}

TEST(VerdictDetails, ListsTwentyExamplesUnlessToldOtherwise) {
  std::vector<Block> blocks(40, Block{0, 1, 2});  // no step changes anything
  const Design design({.v = 12, .k = 3}, blocks);
  const Verdict verdict = verify(design);
  EXPECT_EQ(verdict.bad_steps, 39U);
  EXPECT_EQ(verdict.bad_step_examples.size(), 20U);
  EXPECT_EQ(verdict.uncovered, 63U);
  EXPECT_EQ(verdict.uncovered_examples.size(), 20U);
  EXPECT_FALSE(verdict.unchanged_subsets);
  const Verdict more = verify(design, {.examples = 38, .unchanged = true});
  EXPECT_EQ(more.bad_step_examples.size(), 38U);
  EXPECT_EQ(more.uncovered_examples.size(), 38U);
  EXPECT_EQ(more.unchanged_subsets, 1U);
  EXPECT_EQ(verify(design, {.examples = 0}).uncovered_examples.size(), 0U);
  // Differences: {0,1} has one of the fifty.
  const DifferenceVerdict differences =
      verify_differences(BaseBlocks{{100, 2, 1, Kind::circular, 2}, {{0, 1}}});
  EXPECT_EQ(differences.uncovered, 49U);
  ASSERT_EQ(differences.uncovered_examples.size(), 20U);
  EXPECT_EQ(differences.uncovered_examples.back(), 21U);
}

// Pairs are counted for each element; larger subsets are not.
TEST(VerdictDetails, CountsPairsOfElementsForStrengthTwoOnly) {
  const std::vector<Block> blocks{
      {0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}};
  const Verdict triples =
      verify(Design({.v = 5, .k = 4, .change = 1, .kind = Kind::linear, .strength = 3}, blocks));
  EXPECT_TRUE(triples.valid());
  EXPECT_FALSE(triples.degree_identity);
  for (const ElementCount& count : triples.elements) {
    EXPECT_EQ(count.covered, 0U);
    EXPECT_EQ(count.excess, 0U);
    EXPECT_EQ(count.blocks, 4U);
  }
}

TEST(VerifiedDesigns, AreValidOrThereIsNone) {
  const Parameters p{.v = 4, .k = 3, .change = 1};
  const std::vector<Block> blocks{{0, 1, 2}, {1, 2, 3}, {0, 1, 3}};
  const auto good = verified(Design(p, blocks));
  ASSERT_TRUE(good);
  EXPECT_EQ(good->design().blocks(), blocks);
  EXPECT_TRUE(good->verdict().valid());
  EXPECT_EQ(surely_verified(Design(p, blocks), "this").verdict(), good->verdict());
  const std::vector<Block> one{{0, 1, 2}};
  EXPECT_FALSE(verified(Design(p, one)));
  try {
    (void)surely_verified(Design(p, one), "a list of one block");
    ADD_FAILURE() << "no design is no design";
  } catch (const InternalError& fault) {
    EXPECT_STREQ(fault.what(), "a list of one block fails verification");
  }
}

TEST(DifferenceDetails, MessagesHaveTheNumbers) {
  const auto of = [](std::vector<Block> blocks) {
    return refusal([&] {
      (void)verify_differences(BaseBlocks{{11, 4, 2, Kind::circular, 2}, blocks});
    });
  };
  EXPECT_EQ(of({{0, 1, 2, 5}, {0, 1, 2}}), "base block 2 has 3 elements, not k = 4");
  EXPECT_EQ(of({{0, 1, 2, 5, 6}, {0, 1, 2, 5}}), "base block 1 has 5 elements, not k = 4");
  EXPECT_EQ(of({{0, 1, 2, 5}, {0, 1, 2, 11}}), "base block 2: element 11 is not below v = 11");
  EXPECT_EQ(of({{0, 1, 2, 5}, {0, 7, 2, 7}, {0, 1, 2, 5}}), "base block 2 repeats the element 7");
  EXPECT_EQ(of({}), "no base blocks: give at least one");
  EXPECT_THROW((void)verify_differences(BaseBlocks{{3, 4, 2, Kind::circular, 2}, {{0, 1, 2, 3}}}),
               ImpossibleParameters);
}

}  // namespace
}  // namespace changeover
