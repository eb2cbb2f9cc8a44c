#include "construct/expansion/single_change_expansion.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"
#include "message_of.hpp"
#include "oracle_minima.hpp"

namespace changeover::single_change_expansion_test {
namespace {

using namespace test;

constexpr const char* entry = "single-change-expansion";

Parameters parameters(std::uint64_t v, std::uint64_t k, Kind kind) { return {v, k, 1, kind, 2}; }

Design design_of(const char* maker, const Parameters& p) {
  return standard().build_design(offer_of(maker, p)->recipe);
}

Design linear_four() {
  return Design(parameters(4, 3, Kind::linear),
                std::vector<Block>{{0, 1, 2}, {0, 2, 3}, {1, 2, 3}});
}

TEST(SingleChangeExpansion, IsTightWhereTheSmallerDesignIs) {
  std::size_t tight = 0;
  for (std::uint64_t k = 2; k <= 4; ++k) {
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      for (std::uint64_t v = k + 1; v <= 100; ++v) {
        const auto offer = offer_of(entry, parameters(v, k, kind));
        EXPECT_TRUE((v - 1) % (k - 1) == 0 || !offer);
        if (offer) {
          tight += offer->tight ? 1U : 0U;
          EXPECT_GE(offer->b, lower_bound(offer->recipe.parameters).blocks);
          expect_as_promised(*offer);
        }
      }
    }
  }
  EXPECT_GT(tight, 150U);
}

TEST(SingleChangeExpansion, NeverBeatsTheKnownMinima) {
  std::size_t attained = 0;
  for (const OracleMinimum& row : oracle_minima()) {
    if (const auto offer = offer_of(entry, row.parameters)) {
      EXPECT_GE(offer->b, row.b) << name(row.parameters);
      attained += offer->b == row.b ? 1U : 0U;
    }
  }
  EXPECT_GE(attained, 15U);
}

TEST(SingleChangeExpansion, InsertsAtAGivenListOfPositions) {
  const Design larger = expand_single_change(linear_four(), {2, 0});
  EXPECT_EQ(larger.parameters(), parameters(5, 3, Kind::linear));
  EXPECT_EQ(larger.blocks(),
            (std::vector<Block>{{0, 1, 4}, {0, 1, 2}, {0, 2, 3}, {2, 3, 4}, {1, 2, 3}}));
  EXPECT_TRUE(naive_verdict(larger).valid);
  EXPECT_EQ(expand_single_change(linear_four(), ExpansionSet{{0, {0, 1}}, {2, {2, 3}}}).blocks(),
            larger.blocks());
}

// ⌈v/(k−1)⌉ intervals cover Z_v: economical designs for v + 1 out of tight ones.
TEST(SingleChangeExpansion, TakesSubsetsThatOverlap) {
  for (std::uint64_t k = 3; k <= 12; ++k) {
    const Design design = design_of("mcsorley-circular", parameters(2 * k - 1, k, Kind::circular));
    const std::vector<std::size_t> positions{1, static_cast<std::size_t>(k),
                                             static_cast<std::size_t>(2 * k - 1)};
    const Design larger = expand_single_change(design, positions);
    const Verdict verdict = verify(larger);
    EXPECT_TRUE(verdict.economical()) << k;
    EXPECT_EQ(verdict.b, 2 * k + 2);
    EXPECT_EQ(verdict.excess, 3 * (k - 1) - (2 * k - 1));
    const auto found = unchanged_subsets(design);
    const auto source =
        expand_single_change(standard().build(*design.recipe),
                             {found[0], found[static_cast<std::size_t>(k - 1)], found.back()});
    EXPECT_EQ(blocks_of(*source), larger.blocks());
    ASSERT_TRUE(source->rewind());
    EXPECT_EQ(blocks_of(*source), larger.blocks());
  }
}

TEST(SingleChangeExpansion, NamesTheNewElement) {
  Design design = linear_four();
  design.set_labels({"a", "b", "c", "d"});
  EXPECT_EQ(expand_single_change(design, {0, 2}).label(4), "4");
}

TEST(SingleChangeExpansion, NamesWhatStandsInTheWay) {
  const auto defect = [](const ExpansionSet& set) {
    return single_change_expansion_defect(linear_four(), set).value_or("none");
  };
  EXPECT_EQ(defect({{0, {0, 1}}, {2, {2, 3}}}), "none");
  EXPECT_EQ(defect({{0, {0, 1}}}), "element 2 is in no chosen subset");
  EXPECT_EQ(defect({{2, {2, 3}}, {0, {0, 1}}}),
            "position 0 follows position 2: positions must increase");
  EXPECT_EQ(defect({{0, {0, 1, 2}}}), "the subset at position 0 has 3 elements, not k - 1 = 2");
  EXPECT_EQ(defect({{0, {0, 4}}}), "the subset at position 0 holds 4, which is not below v = 4");
  EXPECT_EQ(defect({{0, {1, 0}}}), "the elements of the subset at position 0 do not increase");
  EXPECT_EQ(defect({{0, {0, 1}}, {4, {2, 3}}}),
            "there is no position 4 in a linear design of 3 blocks");
  EXPECT_EQ(defect({{0, {0, 3}}, {3, {1, 2}}}),
            "the subset at position 0 is not in the first block");
  EXPECT_EQ(defect({{1, {0, 1}}, {2, {2, 3}}}),
            "the subset at position 1 is not what blocks 1 and 2 have in common");
  Design circular = linear_four();
  circular.set_kind(Kind::circular);
  EXPECT_TRUE(single_change_expansion_defect(circular, {{0, {0, 1}}, {2, {2, 3}}}));
  EXPECT_TRUE(single_change_expansion_defect(Design({9, 3, 2, Kind::linear, 2}), {}));
}

TEST(SingleChangeExpansion, RefusesWhatDoesNotFit) {
  EXPECT_REFUSAL((void)expand_single_change(linear_four(), {0, 4}), BadInput,
                 "one element cannot be added: there is no position 4");
  EXPECT_REFUSAL((void)expand_single_change(linear_four(), {0, 0, 2}), BadInput,
                 "one element cannot be added: there is no position 0 twice");
  EXPECT_REFUSAL((void)expand_single_change(linear_four(), {0, 1}), BadInput,
                 "one element cannot be added: element 3 is in no chosen subset");
  EXPECT_REFUSAL((void)expand_single_change(linear_four(), ExpansionSet{}), BadInput,
                 "one element cannot be added: element 0 is in no chosen subset");
  EXPECT_REFUSAL(
      (void)expand_single_change(Design({9, 3, 2, Kind::linear, 2}), ExpansionSet{}),
      ImpossibleParameters,
      "the v + 1 expansion needs a single-change design of strength 2, not a linear DCCD(9,3)");
  const Design design = linear_four();
  EXPECT_REFUSAL(
      (void)expand_single_change(std::make_unique<DesignSource>(design), ExpansionSet{{0, {0, 1}}}),
      BadInput, "one element cannot be added: element 2 is in no chosen subset");
  const auto short_source = expand_single_change(std::make_unique<DesignSource>(design),
                                                 ExpansionSet{{0, {0, 1}}, {9, {2, 3}}});
  EXPECT_THROW((void)blocks_of(*short_source), BadInput);
}

TEST(SingleChangeExpansion, BuildsOnALiteralDesign) {
  const Design design = design_of("quadruples-single-change", parameters(9, 4, Kind::circular));
  const Recipe literal{"literal", design.parameters(), {}, {}, design.blocks()};
  const Recipe recipe{entry, parameters(10, 4, Kind::circular), {}, {literal}, {}};
  EXPECT_TRUE(verify(*standard().build(recipe)).tight());
  // Every unchanged subset of this one contains 0.
  const Recipe fan{
      "literal", parameters(4, 3, Kind::circular), {}, {}, {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}}};
  expect_refused({entry, parameters(5, 3, Kind::circular), {}, {fan}, {}}, "no expansion set");
}

TEST(SingleChangeExpansion, RefusesSpoiltRecipes) {
  expect_spoilt_recipes_refused(offer_of(entry, parameters(9, 3, Kind::circular))->recipe);
  expect_spoilt_recipes_refused(offer_of(entry, parameters(13, 4, Kind::linear))->recipe);
}

TEST(SingleChangeExpansion, ExplainsItself) {
  EXPECT_EQ(construction(entry).explain(offer_of(entry, parameters(9, 3, Kind::circular))->recipe),
            "At each of the 4 positions of an expansion set of the circular SCCD(8,3), insert its "
            "unchanged subset with the new element 8.");
}

}  // namespace
}  // namespace changeover::single_change_expansion_test
