#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"

namespace changeover::partial_expansion_entry_test {
namespace {

using namespace test;

constexpr std::string_view own = "partial-expansion";

std::optional<Offer> circular(std::uint64_t v, std::uint64_t k, std::uint64_t m = 2) {
  return offer_of(own, {v, k, m, Kind::circular, 2});
}

struct Row {
  std::uint64_t v, k, b;
};

// Economical designs that the theorems of the paper do not give, all with an even number of new
// elements (an even number of positions or an overlap).
constexpr Row economical[] = {
    {19, 5, 25},  {23, 6, 29},  {25, 6, 34},  {17, 5, 20},  {21, 6, 24},   {25, 7, 28},
    {8, 4, 6},    {12, 6, 8},   {14, 6, 11},  {9, 5, 6},    {13, 7, 8},    {47, 7, 99},
    {53, 7, 126}, {29, 8, 32},  {55, 8, 115}, {63, 8, 151}, {33, 9, 36},   {63, 9, 131},
    {93, 9, 286}, {37, 10, 40}, {41, 11, 44}, {45, 12, 48}, {87, 12, 179}, {24, 12, 14},
};

// One block above the counting bound and yet minimum, by the degree bound.
constexpr Row minimum[] = {{8, 3, 11},  {14, 3, 33}, {20, 3, 67}, {16, 5, 19},
                           {24, 7, 27}, {32, 9, 35}, {40, 11, 43}};

TEST(PartialExpansionEntry, MakesEconomicalDesigns) {
  for (const Row& row : economical) {
    const auto offer = circular(row.v, row.k);
    ASSERT_TRUE(offer) << row.v << " " << row.k;
    EXPECT_EQ(offer->b, row.b) << row.v << " " << row.k;
    EXPECT_TRUE(offer->economical);
    EXPECT_FALSE(offer->tight);
    expect_as_promised(*offer);
  }
}

TEST(PartialExpansionEntry, MakesMinimumDesignsByAddingOneElement) {
  for (const Row& row : minimum) {
    const auto offer = circular(row.v, row.k);
    ASSERT_TRUE(offer) << row.v << " " << row.k;
    EXPECT_EQ(offer->b, row.b);
    EXPECT_EQ(offer->b, lower_bound(offer->recipe.parameters).blocks);
    expect_as_promised(*offer);
  }
}

TEST(PartialExpansionEntry, IsTightWhereTheirTheoremIs) {
  for (const auto& [v, k] :
       {std::pair{15, 3}, std::pair{21, 5}, std::pair{55, 7}, std::pair{77, 5}, std::pair{10, 4}}) {
    const auto offer = circular(static_cast<std::uint64_t>(v), static_cast<std::uint64_t>(k));
    ASSERT_TRUE(offer);
    EXPECT_TRUE(offer->tight);
    EXPECT_EQ(offer->b, offer_of("expansion", offer->recipe.parameters)->b);
    expect_as_promised(*offer);
  }
}

TEST(PartialExpansionEntry, KeepsItsPromiseForAllSmallParameters) {
  for (const std::uint64_t m : {1U, 2U}) {
    for (std::uint64_t k = m + 1; k <= 9; ++k) {
      for (std::uint64_t v = k + m; v <= 60; ++v) {
        if (const auto offer = circular(v, k, m)) {
          EXPECT_GE(offer->b, lower_bound(offer->recipe.parameters).blocks);
          expect_as_promised(*offer);
        } else {
          EXPECT_TRUE(m == 1 ? v <= 2 * k - 1 : v <= 4 * k - 5) << v << " " << k << " " << m;
        }
        EXPECT_FALSE(offer_of(own, {v, k, m, Kind::linear, 2}));
        EXPECT_FALSE(offer_of(own, {v, k, m, Kind::circular, 3}));
      }
    }
  }
}

// Verified, within `per_mille` of the bound.
void expect_good(const Offer& offer, std::uint64_t per_mille) {
  const Parameters& p = offer.recipe.parameters;
  SCOPED_TRACE(offer.recipe.construction + " " + name(p));
  const Verdict verdict = verify(*standard().build(offer.recipe));
  EXPECT_TRUE(verdict.valid());
  EXPECT_EQ(verdict.b, offer.b);
  EXPECT_EQ(verdict.economical(), offer.economical);
  EXPECT_LE(offer.b * 1000, lower_bound(p).blocks * (1000 + per_mille));
}

void expect_good_for_random_parameters(int how_many, std::uint64_t from, std::uint64_t to) {
  std::mt19937_64 random(20);
  for (int i = 0; i < how_many; ++i) {
    const std::uint64_t v = from + random() % (to - from + 1);
    const std::uint64_t m = 1 + random() % 2;
    const std::uint64_t k = m + 1 + random() % (12 - m);
    const Parameters p{v, k, m, Kind::circular, 2};
    const std::uint64_t per_mille = m == 1 ? (v < 1000 ? 9 : 1) : (v < 1000 ? 45 : 6);
    if (const auto offer = circular(v, k, m)) {
      expect_good(*offer, per_mille);
      const Recipe cut{"cut", {v, k, m, Kind::linear, 2}, {{"at", 0}}, {offer->recipe}, {}};
      const Verdict verdict = verify(*standard().build(cut));
      EXPECT_TRUE(verdict.valid());
      EXPECT_LE(verdict.b * 1000,
                lower_bound(cut.parameters).blocks * (1000 + per_mille) + 1000 * k);
    } else {
      EXPECT_TRUE(offer_of(m == 1 ? "cyclic-single-change" : "cyclic", p)) << name(p);
    }
  }
}

TEST(PartialExpansionEntry, IsCloseToTheBoundInBothKinds) {
  expect_good_for_random_parameters(30, 200, 700);
  expect_good_for_random_parameters(3, 1000, 1500);
}

TEST(PartialExpansionEntry, SlowIsCloseToTheBoundUpToThreeThousandElements) {
  expect_good_for_random_parameters(40, 1000, 3000);
}

TEST(PartialExpansionEntry, ServesTenThousandElementsAsAStream) {
  for (const std::uint64_t v : {10'001U, 10'002U}) {
    const auto offer = circular(v, 11);
    ASSERT_TRUE(offer);
    const auto source = standard().build(offer->recipe);
    EXPECT_EQ(source->block_count(), offer->b);
    Block before(11);
    Block block(11);
    ASSERT_TRUE(source->next(before));
    for (int i = 0; i < 50'000; ++i) {
      ASSERT_TRUE(source->next(block));
      ASSERT_EQ(difference(block, before).size(), 2U);
      before = block;
    }
    EXPECT_LE(offer->b * 1000, lower_bound(offer->recipe.parameters).blocks * 1001);
  }
}

TEST(PartialExpansionEntry, SlowVerifiesTenThousandElements) {
  expect_good(*circular(10'001, 11), 1);
  expect_good(*circular(10'002, 11), 1);
}

TEST(PartialExpansionEntry, OffersForLargeParametersWithoutBuilding) {
  for (const std::uint64_t k : {3U, 4U, 17U, 1000U, 100'000U}) {
    for (const std::uint64_t v : {1'000'000U, 1'000'001U, 16'777'216U, 16'777'217U}) {
      const auto offer = circular(v, k);
      if (offer) {
        EXPECT_LE(v, 16'777'216U);
        EXPECT_GE(offer->b, lower_bound(offer->recipe.parameters).blocks);
        EXPECT_LE(offer->b, lower_bound(offer->recipe.parameters).blocks * 5 / 4);
      }
    }
  }
}

TEST(PartialExpansionEntry, AddsOneMoreElementBesideTheOthers) {
  std::size_t seen = 0;
  for (std::uint64_t k = 4; k <= 12; ++k) {
    for (std::uint64_t v = 4 * k; v <= 140; v += 2) {
      const auto offer = circular(v, k);
      ASSERT_TRUE(offer);
      if (offer->recipe.inputs.front().construction == own) {
        ++seen;
        EXPECT_EQ(offer->recipe.arguments.at("w"), 1);
        EXPECT_TRUE(verify(*standard().build(offer->recipe)).valid()) << v << " " << k;
      }
    }
  }
  EXPECT_GT(seen, 20U);
}

TEST(PartialExpansionEntry, WorksOnOtherInputsBySearch) {
  // The linear DCCD(7,3,7) has an expansion set with both ends.
  const Recipe printed = offer_of("printed", {7, 3, 2, Kind::linear, 2})->recipe;
  for (const std::uint64_t w : {2U, 4U, 6U, 8U}) {
    const Recipe recipe{std::string(own),
                        {7 + w, 3, 2, Kind::linear, 2},
                        {{"w", static_cast<std::int64_t>(w)}},
                        {printed},
                        {}};
    const auto source = standard().build(recipe);
    const Verdict verdict = verify(*source);
    EXPECT_TRUE(verdict.valid());
    EXPECT_EQ(verdict.b, 7 + 7 * w / 2);
    EXPECT_EQ(verdict.tight(), w == 8);
  }
  Recipe none{std::string(own), {9, 3, 2, Kind::circular, 2}, {{"w", 2}}, {}, {}};
  none.inputs.push_back(offer_of("printed", {7, 3, 2, Kind::circular, 2})->recipe);
  expect_refused(none, "element 2 is never kept");
}

TEST(PartialExpansionEntry, RefusesSpoiltRecipes) {
  expect_spoilt_recipes_refused(circular(19, 5)->recipe);
  expect_spoilt_recipes_refused(circular(16, 5)->recipe);
  expect_spoilt_recipes_refused(circular(12, 4, 1)->recipe);
  Recipe few{std::string(own), {7, 4, 2, Kind::circular, 2}, {{"w", 1}}, {}, {}};
  few.inputs.push_back(offer_of("doubling", {6, 4, 2, Kind::circular, 2})->recipe);
  expect_refused(few, "no other element fits");
}

TEST(PartialExpansionEntry, ExplainsItself) {
  EXPECT_EQ(construction(own).explain(circular(19, 5)->recipe),
            "At each of the 5 positions of a cover of the circular DCCD(15,5) by unchanged "
            "subsets, insert the subset with the edges of one 1-factor of K_4 on the new elements "
            "15,…,18.");
  EXPECT_EQ(construction(own).explain(circular(16, 5)->recipe),
            "At each of the 4 positions of a cover of the circular DCCD(15,5) by unchanged "
            "subsets, insert the subset with the new element 15 and an old one from neither block "
            "there.");
  EXPECT_EQ(construction(own).explain(circular(10, 4, 1)->recipe),
            "At each of the 2 positions of a cover of the circular SCCD(7,4) by unchanged subsets, "
            "insert the subset with each of the new elements 7,…,9 in turn; at one of them, let "
            "all these meet one another.");
}

}  // namespace
}  // namespace changeover::partial_expansion_entry_test
