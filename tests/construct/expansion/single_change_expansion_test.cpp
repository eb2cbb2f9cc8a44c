#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/expansion.hpp"
#include "construction_checks.hpp"
#include "oracle_minima.hpp"

namespace changeover::single_change_expansion_test {
namespace {

using namespace test;

constexpr const char* entry = "single-change-expansion";

Parameters parameters(std::uint64_t v, std::uint64_t k, Kind kind) { return {v, k, 1, kind, 2}; }

Design design_of(const char* maker, const Parameters& p) {
  return standard().build_design(offer_of(maker, p)->recipe);
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

TEST(SingleChangeExpansion, InsertsTheNewElementBesideEachSubset) {
  const Design four(parameters(4, 3, Kind::linear),
                    std::vector<Block>{{0, 1, 2}, {0, 2, 3}, {1, 2, 3}});
  const Design larger = expand_by(four, {.subsets = {{0, {0, 1}}, {2, {2, 3}}}}, 1);
  EXPECT_EQ(larger.parameters(), parameters(5, 3, Kind::linear));
  EXPECT_EQ(larger.blocks(),
            (std::vector<Block>{{0, 1, 4}, {0, 1, 2}, {0, 2, 3}, {2, 3, 4}, {1, 2, 3}}));
  EXPECT_TRUE(naive_verdict(larger).valid);
}

// ⌈v/(k−1)⌉ intervals cover Z_v: economical designs for v + 1 out of tight ones.
TEST(SingleChangeExpansion, IsEconomicalForSubsetsThatOverlap) {
  for (std::uint64_t k = 3; k <= 12; ++k) {
    const Design design = design_of("mcsorley-circular", parameters(2 * k - 1, k, Kind::circular));
    const auto found = unchanged_subsets(design);
    const UnchangedCover cover{
        .subsets = {found[0], found[static_cast<std::size_t>(k - 1)], found.back()}};
    const Design larger = expand_by(design, cover, 1);
    const Verdict verdict = verify(larger);
    EXPECT_TRUE(verdict.economical()) << k;
    EXPECT_EQ(verdict.b, 2 * k + 2);
    EXPECT_EQ(verdict.excess, 3 * (k - 1) - (2 * k - 1));
    const auto source = expand_by(standard().build(*design.recipe), cover, 1);
    EXPECT_EQ(blocks_of(*source), larger.blocks());
    ASSERT_TRUE(source->rewind());
    EXPECT_EQ(blocks_of(*source), larger.blocks());
  }
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
