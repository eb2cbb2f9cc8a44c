#include "changeover/bounds/lower_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bounds/counting_bound.hpp"
#include "bounds/stays.hpp"
#include "changeover/core/error.hpp"
#include "core/checked.hpp"
#include "oracle_minima.hpp"

namespace changeover {
namespace {

std::uint64_t bound_named(const Parameters& p, const std::string& name) {
  for (const Bound& bound : lower_bounds(p)) {
    if (bound.name == name) {
      return bound.blocks;
    }
  }
  return 0;
}

TEST(LowerBound, NeverExceedsAKnownMinimum) {
  std::size_t reached = 0;
  const auto minima = test::oracle_minima();
  for (const auto& [p, b] : minima) {
    for (const Bound& bound : lower_bounds(p)) {
      EXPECT_LE(bound.blocks, b) << name(p) << ": " << bound.name << ": " << bound.reason;
    }
    reached += lower_bound(p).blocks == b ? 1U : 0U;
  }
  // Where formulas do not reach a minimum, the table of searched ones does.
  EXPECT_EQ(reached, minima.size());
}

TEST(LowerBound, IsThePapersCountingBound) {
  for (std::uint64_t k = 3; k <= 12; ++k) {
    for (std::uint64_t v = 2 * k - 1; v <= 60; ++v) {
      const std::uint64_t pairs = v * (v - 1) / 2;
      const std::uint64_t first = k * (k - 1) / 2;
      EXPECT_EQ(counting_bound({.v = v, .k = k, .kind = Kind::circular}),
                ceil_div(pairs, 2 * k - 3));
      EXPECT_EQ(counting_bound({.v = v, .k = k}), ceil_div(pairs - first, 2 * k - 3) + 1);
      EXPECT_EQ(bound_named({.v = v, .k = k}, "counting"), ceil_div(pairs - first, 2 * k - 3) + 1);
      EXPECT_EQ(bound_named({.v = v, .k = k, .kind = Kind::circular}, "counting"),
                ceil_div(pairs, 2 * k - 3));
      EXPECT_EQ(bound_named({.v = v, .k = k, .change = 1}, "counting"),
                ceil_div(pairs - first, k - 1) + 1);
    }
  }
}

TEST(LowerBound, AllowsForElementsThatAreInEveryBlock) {
  // {2..7}, {0,1,4..7}, {0,1,2,3,6,7} is a circular DCCD(8,6): no bound may say 4.
  EXPECT_EQ(lower_bound({.v = 8, .k = 6, .kind = Kind::circular}).blocks, 3U);
  for (std::uint64_t k = 3; k <= 30; ++k) {
    EXPECT_EQ(lower_bound({.v = k + 1, .k = k, .change = 1, .kind = Kind::circular}).blocks, 3U);
  }
}

TEST(LowerBound, ProvesByParityThatNoTightDesignExistsForOddK) {
  for (std::uint64_t k = 5; k <= 41; k += 2) {
    const Parameters p{.v = 2 * k - 2, .k = k, .kind = Kind::circular};
    EXPECT_EQ(bound_named(p, "counting"), k - 1);
    EXPECT_EQ(bound_named(p, "degree"), k);
  }
}

TEST(LowerBound, ReachesFromEndToEnd) {
  for (std::uint64_t m = 1; m <= 4; ++m) {
    for (std::uint64_t k = m + 1; k <= 12; ++k) {
      for (std::uint64_t v = k + m; v <= 2 * k; ++v) {
        for (std::uint32_t t = 2; t <= std::min<std::uint64_t>(k, 4); ++t) {
          EXPECT_EQ(bound_named({.v = v, .k = k, .change = m, .strength = t}, "end to end"),
                    t * ceil_div(v - k, m) + 1);
        }
      }
    }
  }
}

TEST(LowerBound, GivesEachBoundWithAReasonLargestFirst) {
  const auto bounds = lower_bounds({.v = 20, .k = 5, .kind = Kind::circular});
  EXPECT_TRUE(std::is_sorted(bounds.begin(), bounds.end(),
                             [](const Bound& a, const Bound& b) { return a.blocks > b.blocks; }));
  for (const Bound& bound : bounds) {
    EXPECT_FALSE(bound.reason.empty());
    EXPECT_EQ(bound.reason.find('\n'), std::string::npos);
    EXPECT_NE(bound.reason.find(std::to_string(bound.blocks)), std::string::npos) << bound.reason;
  }
}

TEST(LowerBound, SaysHowWhatSearchExcludedCanBeCheckedAnew) {
  const Bound bound = lower_bound({.v = 12, .k = 4});
  EXPECT_EQ(bound.blocks, 14U);
  EXPECT_EQ(bound.name, "checked proofs");
  EXPECT_NE(bound.reason.find("changeover search 12 4 --change 2 --linear --exact --proof DIR"),
            std::string::npos);
}

TEST(LowerBound, OfStaysIsTheLargestOverEveryS) {
  for (std::uint64_t strength = 2; strength <= 4; ++strength) {
    for (std::uint64_t k = strength; k <= 12; ++k) {
      for (std::uint64_t v = k; v <= 150; ++v) {
        std::uint64_t best = 0;
        for (std::uint64_t s = 1; s <= v; ++s) {
          const std::uint64_t n = s < strength ? s : s * s - s + 1;
          best = std::max(best, (s + 1) * v - std::min((s + 1) * v, n * k));
        }
        const Introductions least = least_introductions(v, k, strength);
        EXPECT_EQ(least.count, best) << v << ' ' << k << ' ' << strength;
        EXPECT_EQ(least.count, (least.s + 1) * v - most_meetings(least.s, strength) * k);
      }
    }
  }
  EXPECT_THROW((void)least_introductions(std::uint64_t{1} << 40, 1), ImpossibleParameters);
}

TEST(LowerBound, OfStaysProvesWhatOnlySearchHadShown) {
  // b ≥ 3v − 4k + 1 and, as a circular design is also a linear one, its consequences.
  EXPECT_EQ(bound_named({.v = 25, .k = 10, .change = 1}, "stays"), 36U);
  EXPECT_EQ(bound_named({.v = 9, .k = 4, .change = 1}, "stays"), 12U);
  EXPECT_EQ(bound_named({.v = 15, .k = 7}, "stays"), 10U);
  // Strength t: b ≥ ⌈t(v−k)/m⌉ + 1.
  EXPECT_EQ(bound_named({.v = 14, .k = 8, .change = 2, .strength = 3}, "stays"), 10U);
}

// Each row of the table is needed: it says more than what is proved on paper.
TEST(LowerBound, NamesSearchOnlyWhereNothingElseReachesAsFar) {
  std::size_t rows = 0;
  for (std::uint64_t m = 1; m <= 3; ++m) {
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      for (std::uint64_t k = std::max<std::uint64_t>(2, m); k <= 8; ++k) {
        for (std::uint64_t v = k + m; v <= 20; ++v) {
          std::uint64_t searched = 0;
          std::uint64_t proved = 0;
          for (const Bound& b : lower_bounds({.v = v, .k = k, .change = m, .kind = kind})) {
            (b.name == "checked proofs" ? searched : proved) =
                std::max(b.name == "checked proofs" ? searched : proved, b.blocks);
          }
          rows += searched > 0 ? 1U : 0U;
          EXPECT_TRUE(searched == 0 || searched > proved) << v << ' ' << k << ' ' << m;
        }
      }
    }
  }
  EXPECT_GE(rows, 35U);
}

TEST(LowerBound, CountsTriples) {
  // Linear, t = 3: ⌈(C(v,3) − C(k,3)) / (C(k,3) − C(k−m,3))⌉ + 1.
  EXPECT_EQ(lower_bound({.v = 8, .k = 4, .change = 1, .strength = 3}).blocks,
            ceil_div(56 - 4, 4 - 1) + 1);
}

TEST(LowerBound, RefusesWhatCannotBeCountedAndReturnsSoonForHugeBlocks) {
  EXPECT_THROW((void)lower_bound({.v = 4'000'000'000, .k = 4, .strength = 4}),
               ImpossibleParameters);
  EXPECT_THROW((void)lower_bound({.v = 3, .k = 4}), ImpossibleParameters);
  EXPECT_EQ(lower_bound({.v = 4'000'000'000, .k = 3'999'999'000, .kind = Kind::circular}).blocks,
            1001U);
  EXPECT_EQ(lower_bound({.v = 7, .k = 7}).blocks, 1U);
}

}  // namespace
}  // namespace changeover
