// Verdicts where a small fault of them would hide: what is true of nothing, how many examples are
// listed, messages with their numbers. Most of these were missing until planted faults survived.
#include <gtest/gtest.h>

#include <string>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "changeover/verify/difference.hpp"
#include "changeover/verify/verdict.hpp"
#include "message_of.hpp"

namespace changeover::verdict_details_test {
namespace {

template <typename Action>
std::string refusal(Action&& action) {
  return message_of([&] { action(); });
}

TEST(VerdictDetails, NothingIsNotValid) {
  EXPECT_FALSE(Verdict{}.valid());
  EXPECT_FALSE(Verdict{}.tight());
  EXPECT_FALSE(Verdict{}.economical());
  EXPECT_FALSE(DifferenceVerdict{}.valid());
  const Verdict empty;
  EXPECT_EQ(empty.b + empty.bad_steps + empty.subsets + empty.uncovered, 0U);
  EXPECT_EQ(empty.covered + empty.never_newly_covered + empty.excess + empty.counting_bound, 0U);
  EXPECT_EQ(BadStep{}, (BadStep{0, 0, 0}));
  const ElementCount none;
  EXPECT_EQ(none.introductions + none.blocks + none.covered + none.excess, 0U);
  const Parameters p{.v = 5, .k = 3};
  const Verdict verdict = verify(Design(p));
  EXPECT_EQ(verdict.b, 0U);
  EXPECT_EQ(verdict.uncovered, 10U);
  EXPECT_EQ(verdict.excess, 0U);
  EXPECT_TRUE(verdict.fixed.empty());
  EXPECT_FALSE(verdict.valid() || verdict.degree_identity || verdict.unchanged_subsets);
}

// One block is enough to be a list.
TEST(VerdictDetails, OneBlockCanBeValid) {
  DifferenceVerdict differences;
  differences.b = 1;
  EXPECT_TRUE(differences.valid());
  EXPECT_TRUE(verify(Design({.v = 3, .k = 3}, std::vector<Block>{{0, 1, 2}})).valid());
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
  const DifferenceVerdict intervals =
      verify_differences(IntervalBaseBlocks{{100, 2, 1, Kind::circular, 2}, 0, 1, {1}});
  EXPECT_EQ(intervals.uncovered, 49U);
  EXPECT_EQ(intervals.uncovered_examples, differences.uncovered_examples);
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

// By hand: ⌈(C(v,t) − C(k,t)) / p⌉ + 1 and ⌈C(v,t) / p⌉, with p the t-subsets of a block that have
// a new element.
TEST(VerdictDetails, CountingBoundsAreThoseOfTheTheorem) {
  const auto bound = [](const Parameters& p) { return verify(Design(p)).counting_bound; };
  EXPECT_EQ(bound({.v = 10, .k = 4, .change = 2}), 9U);  // (45 − 6) / 5
  EXPECT_EQ(bound({.v = 10, .k = 4, .change = 2, .kind = Kind::circular}), 9U);
  EXPECT_EQ(bound({.v = 10, .k = 4, .change = 1}), 14U);  // 39 / 3
  EXPECT_EQ(bound({.v = 10, .k = 4, .change = 1, .kind = Kind::circular}), 15U);
  EXPECT_EQ(bound({.v = 8, .k = 4, .change = 2, .strength = 3}), 14U);  // (56 − 4) / 4
  EXPECT_EQ(bound({.v = 8, .k = 4, .change = 2, .kind = Kind::circular, .strength = 3}), 14U);
  EXPECT_EQ(bound({.v = 4, .k = 4}), 1U);
}

TEST(VerdictDetails, BadStepsHaveTheirPlaces) {
  const Parameters p{.v = 6, .k = 3, .change = 2};
  const std::vector<Block> blocks{{0, 1, 2}, {2, 3, 4}, {2, 3, 5}, {0, 1, 4}, {0, 1, 4}};
  const Verdict verdict = verify(Design(p, blocks));
  EXPECT_EQ(verdict.parameters, p);
  const std::vector<BadStep> wanted{{2, 3, 1}, {3, 4, 3}, {4, 5, 0}};
  EXPECT_EQ(verdict.bad_step_examples, wanted);
  EXPECT_FALSE(verdict.degree_identity);
}

TEST(VerdictDetails, RunningVerdictsAreTheSameForLargerSubsets) {
  const Parameters p{.v = 5, .k = 4, .change = 1, .kind = Kind::linear, .strength = 3};
  const std::vector<Block> blocks{{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 3, 4}};
  RunningVerdict running(p);
  for (const Block& block : blocks) {
    running.add(block);
  }
  const Verdict verdict = running.finish();
  EXPECT_EQ(verdict, verify(Design(p, blocks)));
  EXPECT_EQ(verdict.uncovered, 1U);
}

// The identity holds of these lists too, but it is said of designs only.
TEST(VerdictDetails, SaysNothingOfDegreesIfInvalid) {
  std::vector<Block> blocks{{0, 1, 2}, {1, 2, 3}};
  const Verdict verdict = verify(Design({.v = 5, .k = 3, .change = 1}, blocks));
  EXPECT_EQ(verdict.bad_steps, 0U);
  EXPECT_FALSE(verdict.valid());
  EXPECT_FALSE(verdict.degree_identity);
}

TEST(VerdictDetails, RefusesWhatNoDesignCanBe) {
  EXPECT_THROW(RunningVerdict({.v = 3, .k = 5}), ImpossibleParameters);
  EXPECT_EQ(refusal([] {
              RunningVerdict running({.v = 9, .k = 4});
              running.add(Block{0, 1, 2, 3});
              running.add(Block{5, 7, 8, 5});
            }),
            "block 2 repeats the element 5");
  try {
    // C(6500,3) bits are 5.3 GiB.
    const RunningVerdict running({.v = 6500, .k = 3, .strength = 3});
    ADD_FAILURE() << "4 GiB are the limit";
  } catch (const MissingResource& fault) {
    EXPECT_NE(
        std::string(fault.what())
            .find(" subsets to verify need more than 4 GiB of memory; use a smaller v or strength"),
        std::string::npos);
  }
  try {
    const RunningVerdict running({.v = 65'536, .k = 3});
    ADD_FAILURE() << "65,535 elements are the limit";
  } catch (const MissingResource& fault) {
    EXPECT_STREQ(
        fault.what(),
        "v = 65536 exceeds the 65535 elements that verification can hold; give a smaller v");
  }
  EXPECT_EQ(refusal([] {
              RunningVerdict running({.v = 9, .k = 4});
              running.add(Block{0, 1, 2, 3, 4, 5, 6});
            }),
            "a block of 3 elements, not k = 4");
}

// Blocks with many new elements are taken as rows of bits, several blocks together: none has a part
// of the next one.
TEST(VerdictDetails, BlocksTakenTogetherAreApart) {
  constexpr Element k = 64;
  std::vector<Block> blocks(4, Block(k));
  for (Element i = 0; i < 4 * k; ++i) {
    blocks[i / k][i % k] = i;
  }
  const Verdict verdict = verify(Design({.v = 4 * k, .k = k, .change = k}, blocks));
  EXPECT_EQ(verdict.bad_steps, 0U);
  EXPECT_EQ(verdict.uncovered, 6U * k * k);  // each pair of two blocks
  EXPECT_EQ(verdict.excess, 0U);
}

TEST(VerdictDetails, AVerificationStopsWhenItsScopeDoes) {
  const Design design({.v = 4, .k = 3, .change = 1},
                      std::vector<Block>{{0, 1, 2}, {1, 2, 3}, {0, 1, 3}});
  RunControl control({});
  const RunScope scope(control);
  EXPECT_TRUE(verify(design).valid());
  control.stop(WhyStopped::interrupted);
  EXPECT_THROW((void)verify(design), Stopped);
}

TEST(VerifiedDesigns, AreValidOrThereIsNone) {
  const Parameters p{.v = 4, .k = 3, .change = 1};
  const std::vector<Block> blocks{{0, 1, 2}, {1, 2, 3}, {0, 1, 3}};
  const auto good = verified(Design(p, blocks));
  ASSERT_TRUE(good);
  EXPECT_EQ(good->design().blocks(), blocks);
  EXPECT_TRUE(good->verdict().valid());
  EXPECT_EQ(surely_verified(Design(p, blocks), "this").verdict(), good->verdict());
  VerifiedDesign named = *good;
  Recipe recipe;
  recipe.construction = "some";
  named.set_recipe(recipe);
  EXPECT_EQ(named.design().recipe, recipe);
  EXPECT_EQ(named.design().blocks(), blocks);
  EXPECT_FALSE(good->design().recipe);
  const std::vector<Block> one{{0, 1, 2}};
  EXPECT_FALSE(verified(Design(p, one)));
  try {
    (void)surely_verified(Design(p, one), "a list of one block");
    ADD_FAILURE() << "no design is no design";
  } catch (const InternalError& fault) {
    EXPECT_STREQ(fault.what(), "a list of one block fails verification");
  }
}

// The largest difference is v/2: where the bits of the differences fill their words, there is one
// word more.
TEST(DifferenceDetails, HasRoomForEachDifference) {
  for (const std::uint64_t v : {126U, 127U, 128U, 129U, 400U}) {
    for (std::uint64_t d = 1; d <= v / 2; ++d) {
      const DifferenceVerdict verdict = verify_differences(
          BaseBlocks{{v, 2, 1, Kind::circular, 2}, {{0, static_cast<Element>(d)}}});
      ASSERT_EQ(verdict.uncovered, v / 2 - 1) << v << ", " << d;
      ASSERT_EQ(verdict.uncovered_examples.front(), d == 1 ? 2U : 1U);
    }
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

TEST(DifferenceDetails, AreOfPairsOnly) {
  const Parameters triples{11, 4, 2, Kind::circular, 3};
  EXPECT_REFUSAL((void)verify_differences(BaseBlocks{triples, {{0, 1, 2, 5}}}),
                 ImpossibleParameters, "differences certify pairs only: use strength 2");
  EXPECT_REFUSAL((void)verify_differences(IntervalBaseBlocks{triples, 0, 3, {5}}),
                 ImpossibleParameters, "differences certify pairs only: use strength 2");
}

TEST(IntervalDifferenceDetails, MessagesHaveTheNumbers) {
  const auto of = [](std::uint64_t v, std::uint64_t start, std::uint64_t length, Block points) {
    return refusal([&] {
      (void)verify_differences(
          IntervalBaseBlocks{{v, 4, 2, Kind::circular, 2}, start, length, points});
    });
  };
  EXPECT_EQ(of(21, 0, 2, {4, 12, 7, 7}), "base block 2 repeats the element 7");
  EXPECT_EQ(of(21, 0, 2, {4, 4, 2, 7}), "base block 1 repeats the element 4");
  for (const Element x : {5U, 6U, 7U}) {
    EXPECT_EQ(of(21, 5, 3, {8, x}), "base block 2: the point " + std::to_string(x) +
                                        " is in the interval from 5 of 3 elements");
  }
  EXPECT_EQ(of(21, 5, 3, {8, 4}), "");
  EXPECT_EQ(of(21, 19, 3, {1, 0}),
            "base block 2: the point 0 is in the interval from 19 of 3 elements");
  // Where every block is everything, each base block is read all the same.
  EXPECT_EQ(of(4, 0, 2, {2, 3, 2, 3, 3, 3}), "base block 3 repeats the element 3");
}

}  // namespace
}  // namespace changeover::verdict_details_test
