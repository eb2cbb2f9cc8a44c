#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"
#include "oracle_minima.hpp"

namespace changeover::small_v_test {
namespace {

using namespace test;

constexpr std::uint64_t largest_k = 40;

std::uint64_t end_to_end(const Parameters& p) {
  return 2 * ((p.v - p.k + p.change - 1) / p.change) + 1;
}

// The parameters that are served, as documented.
bool served(const Parameters& p) {
  const std::uint64_t m = p.change;
  if (p.v < p.k + m || p.v > 2 * p.k) {
    return false;
  }
  if (p.v + m <= 2 * p.k) {
    return true;
  }
  const std::uint64_t s = 2 * p.k - p.v;
  const std::uint64_t reach = (p.v - p.k + m - 1) / m;
  const std::uint64_t r = reach * m - (p.v - p.k);
  if (p.kind == Kind::linear && reach >= 3) {
    return true;
  }
  if (r == 0 || reach == 1) {
    return false;
  }
  if (reach >= 3) {
    return s + r >= m;
  }
  return s + r >= m && (p.kind == Kind::linear ? 2 * s >= m : s >= r);
}

void expect_minimum(const Parameters& p) {
  const auto offer = offer_of("small-v", p);
  ASSERT_EQ(offer.has_value(), served(p)) << name(p);
  if (offer) {
    EXPECT_EQ(offer->b, end_to_end(p)) << name(p);
    EXPECT_EQ(offer->b, lower_bound(p).blocks) << name(p);
    expect_as_promised(*offer);
  }
}

void expect_minima(std::uint64_t m) {
  for (std::uint64_t k = m; k <= largest_k; ++k) {
    for (std::uint64_t v = k; v <= 2 * k + 2; ++v) {
      expect_minimum({v, k, m, Kind::circular, 2});
      expect_minimum({v, k, m, Kind::linear, 2});
    }
  }
}

TEST(SmallV, IsMinimumForSingleChange) { expect_minima(1); }
TEST(SmallV, IsMinimumForDoubleChange) { expect_minima(2); }
TEST(SmallV, IsMinimumForTripleChange) { expect_minima(3); }
TEST(SmallV, IsMinimumForFourChanges) { expect_minima(4); }
TEST(SmallV, IsMinimumForFiveChanges) { expect_minima(5); }

TEST(SmallV, IsMinimumForManyChanges) {
  for (std::uint64_t m = 6; m <= 13; ++m) {
    for (std::uint64_t k = m; k <= 4 * m; k += 1 + k / 20) {
      for (std::uint64_t v = k + m; v <= 2 * k; ++v) {
        expect_minimum({v, k, m, Kind::circular, 2});
        expect_minimum({v, k, m, Kind::linear, 2});
      }
    }
  }
}

TEST(SmallV, IsMinimumForLargeBlocks) {
  for (const std::uint64_t m : {1U, 2U, 3U, 7U}) {
    for (const std::uint64_t s : {0U, 1U, 2U, 3U, 7U}) {
      for (const std::uint64_t k : {201U, 202U, 203U}) {
        expect_minimum({2 * k - s, k, m, Kind::circular, 2});
        expect_minimum({2 * k - s, k, m, Kind::linear, 2});
      }
    }
  }
}

TEST(SmallV, ServesDoubleChangeUpToTwiceTheBlockSizeButForFourLinearCases) {
  std::set<std::pair<std::uint64_t, std::uint64_t>> unserved;
  for (std::uint64_t k = 3; k <= 200; ++k) {
    for (const std::uint64_t v : {2 * k - 1, 2 * k}) {
      if (!offer_of("small-v", {v, k, 2, Kind::linear, 2})) {
        unserved.emplace(v, k);
      }
    }
    EXPECT_EQ(offer_of("small-v", {2 * k - 1, k, 2, Kind::circular, 2}).has_value(),
              k % 2 == 0 && k > 2);
  }
  EXPECT_EQ(unserved, (decltype(unserved){{5, 3}, {6, 3}, {8, 4}, {9, 5}}));
}

TEST(SmallV, ServesSingleChangeUpToTwiceTheBlockSize) {
  for (std::uint64_t k = 3; k <= 200; ++k) {
    EXPECT_TRUE(offer_of("small-v", {2 * k, k, 1, Kind::linear, 2}));
    EXPECT_FALSE(offer_of("small-v", {2 * k, k, 1, Kind::circular, 2}));
    EXPECT_TRUE(offer_of("small-v", {2 * k - 1, k, 1, Kind::circular, 2}));
  }
  EXPECT_FALSE(offer_of("small-v", {4, 2, 1, Kind::linear, 2}));
}

// Where the known minimum is the end-to-end bound and v ≤ 2k, it is served, and only there.
TEST(SmallV, AgreesWithTheKnownMinima) {
  int met = 0;
  for (const OracleMinimum& row : oracle_minima()) {
    const Parameters& p = row.parameters;
    if (p.v > 2 * p.k || p.v < p.k + p.change) {
      continue;
    }
    const auto offer = offer_of("small-v", p);
    ASSERT_EQ(offer.has_value(), row.b == end_to_end(p)) << name(p);
    EXPECT_TRUE(offer || p.v > 2 * p.k - p.change) << name(p);
    if (offer) {
      ++met;
      EXPECT_EQ(offer->b, row.b);
      EXPECT_EQ(verify(standard().build_design(offer->recipe)).b, row.b);
    }
  }
  EXPECT_GE(met, 25);
}

TEST(SmallV, ServesNothingElse) {
  EXPECT_FALSE(offer_of("small-v", {7, 7, 2, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("small-v", {8, 7, 2, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("small-v", {8, 5, 2, Kind::circular, 3}));
  EXPECT_FALSE(offer_of("small-v", {9, 7, 0, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("small-v", {2, 1, 1, Kind::linear, 2}));
  EXPECT_FALSE(offer_of("small-v", {7, 9, 2, Kind::circular, 2}));
}

TEST(SmallV, NeedsItsConstructionsInTheRegistry) {
  const Registry some({&construction("small-v"), &construction("fix")});
  EXPECT_FALSE(construction("small-v").offer({10, 8, 2, Kind::circular, 2}, some));
  EXPECT_TRUE(construction("small-v").offer({12, 6, 1, Kind::linear, 2}, some));
  EXPECT_FALSE(construction("small-v").offer({12, 6, 2, Kind::linear, 2}, some));
}

TEST(SmallV, ServesTheLargestParametersWithoutWrapping) {
  constexpr std::uint64_t huge = 0xffff'ffff;
  for (const std::uint64_t m : {1U, 2U, 3U, 65'536U}) {
    for (const std::uint64_t k : {huge / 2 + 1, huge / 2 + 2, huge - 70'000, huge - 65'536}) {
      for (const Kind kind : {Kind::linear, Kind::circular}) {
        const Parameters p{huge, k, m, kind, 2};
        const auto offer = offer_of("small-v", p);
        ASSERT_EQ(offer.has_value(), served(p));
        if (offer) {
          EXPECT_EQ(offer->b, end_to_end(p));
          EXPECT_GE(offer->b, lower_bound(p).blocks);
          EXPECT_FALSE(construction("small-v").explain(offer->recipe).empty());
        }
      }
    }
  }
}

std::vector<std::string> chain(const Parameters& p) {
  std::vector<std::string> names;
  const Recipe recipe = offer_of("small-v", p)->recipe;
  for (const Recipe* at = &recipe;; at = &at->inputs.front()) {
    names.push_back(at->construction);
    if (at->inputs.empty()) {
      return names;
    }
  }
}

TEST(SmallV, ComposesKnownConstructions) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(chain({9, 7, 2, Kind::circular, 2}),
            (Names{"small-v", "fix", "doubling", "mcsorley-circular"}));
  EXPECT_EQ(chain({11, 8, 2, Kind::circular, 2}), (Names{"small-v", "fix", "short-long-runs"}));
  EXPECT_EQ(chain({8, 6, 1, Kind::circular, 2}), (Names{"small-v", "fix", "mcsorley-circular"}));
  EXPECT_EQ(chain({15, 9, 3, Kind::circular, 2}),
            (Names{"small-v", "blow-up", "mcsorley-circular"}));
  EXPECT_EQ(chain({16, 10, 3, Kind::linear, 2}),
            (Names{"small-v", "cut", "fix", "blow-up", "mcsorley-circular"}));
  EXPECT_EQ(chain({14, 9, 3, Kind::circular, 2}), (Names{"small-v", "fix", "small-v"}));
  EXPECT_EQ(chain({12, 6, 2, Kind::linear, 2}), (Names{"small-v", "blow-up", "small-v"}));
  EXPECT_EQ(chain({13, 7, 2, Kind::linear, 2}), (Names{"small-v", "fix", "blow-up", "small-v"}));
  EXPECT_EQ(chain({10, 5, 2, Kind::linear, 2}), (Names{"small-v"}));
}

TEST(SmallV, ExplainsItself) {
  const auto explanation = [](const Parameters& p) {
    return construction("small-v").explain(offer_of("small-v", p)->recipe);
  };
  EXPECT_EQ(explanation({9, 7, 2, Kind::circular, 2}),
            "No design has fewer blocks: some element is absent from the first block, some other "
            "from the last block, and they meet in one more.");
  EXPECT_EQ(
      explanation({12, 9, 2, Kind::linear, 2}),
      "No design has fewer blocks: some element is absent from the first 2 blocks, some other "
      "from the last 2 blocks, and they meet in one more.");
  EXPECT_EQ(
      explanation({12, 6, 1, Kind::linear, 2}),
      "Keep 5 elements up to block 7 while 6 others pass one by one, then let them go one by one "
      "while those come back; from block 3 to 7 put one more in place of one of the 5, and keep "
      "it up to block 12.");
  EXPECT_EQ(explanation({7, 4, 2, Kind::circular, 2}),
            "The 5 blocks {0,1,3,4}, {0,2,3,5}, {0,2,4,6}, {1,2,5,6}, {3,4,5,6}.");
  EXPECT_EQ(
      explanation({26, 14, 5, Kind::circular, 2}),
      "Write side by side, 7 blocks each: a circular SCCD(7,4) with 2 copies of every element "
      "and a circular SCCD(4,2) with 3 copies of every element.");
  EXPECT_EQ(
      explanation({10, 5, 2, Kind::linear, 2}),
      "Write side by side, 7 blocks each: a linear SCCD(6,3) with 1 copy of every element and a "
      "linear SCCD(4,2) with 1 copy of every element.");
}

TEST(SmallV, RefusesSpoiltRecipes) {
  for (const Parameters& p :
       {Parameters{9, 7, 2, Kind::circular, 2}, Parameters{30, 17, 3, Kind::circular, 2},
        Parameters{7, 4, 2, Kind::circular, 2}}) {
    expect_spoilt_recipes_refused(offer_of("small-v", p)->recipe);
  }
  expect_spoilt_recipes_refused(offer_of("small-v", {20, 10, 1, Kind::linear, 2})->recipe);
}

}  // namespace
}  // namespace changeover::small_v_test
