#include "changeover/bounds/lower_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "bounds/counting_bound.hpp"
#include "bounds/stays.hpp"
#include "changeover/core/error.hpp"
#include "core/checked.hpp"
#include "oracle_minima.hpp"

namespace changeover::lower_bound_test {
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
  EXPECT_GE(rows, 30U);
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

std::string reason_named(const Parameters& p, const std::string& name) {
  for (const Bound& bound : lower_bounds(p)) {
    if (bound.name == name) {
      return bound.reason;
    }
  }
  return "";
}

/// The counting bound of a circular design for pairs over every number f of elements in every
/// block, with an excess of `each` or more at the v − f others and what it forces at the f.
std::uint64_t counted_over_every_f(const Parameters& p, std::uint64_t each) {
  const auto pairs = [](std::uint64_t n) { return n * (n - 1) / 2; };
  const auto most = [&](std::uint64_t k) { return pairs(k) - pairs(k - p.change); };
  std::uint64_t least = ~std::uint64_t{0};
  for (std::uint64_t f = 0; f + p.change <= p.k; ++f) {
    if (most(p.k - f) == 0) {
      continue;
    }
    const std::uint64_t rest = p.v - f;
    std::uint64_t at_fixed = 0;
    while (each > 0 && f > 0 && (rest + at_fixed) % p.change != 0) {
      ++at_fixed;
    }
    const std::uint64_t excess = (rest * each + f * at_fixed + 1) / 2;
    least =
        std::min(least, std::max({ceil_div(pairs(p.v) - (f < 2 ? 0 : pairs(f)) + excess, most(p.k)),
                                  ceil_div(pairs(rest), most(p.k - f)), ceil_div(rest, p.change),
                                  std::uint64_t{3}}));
  }
  return least;
}

TEST(LowerBound, CountsOverEveryNumberOfElementsThatAreInEveryBlock) {
  std::size_t forced = 0;
  for (std::uint64_t m = 1; m <= 6; ++m) {
    for (std::uint64_t k = std::max<std::uint64_t>(m, 2); k <= 24; ++k) {
      for (std::uint64_t v = k + m; v <= 34; ++v) {
        const Parameters p{.v = v, .k = k, .change = m, .kind = Kind::circular};
        if (impossibility(p)) {
          continue;
        }
        EXPECT_EQ(bound_named(p, "counting"), counted_over_every_f(p, 0)) << name(p);
        // e_x is the least number that makes v − 1 + e_x divisible by gcd(k−1, m).
        std::uint64_t each = 0;
        while ((v - 1 + each) % std::gcd(k - 1, m) != 0) {
          ++each;
        }
        EXPECT_EQ(bound_named(p, "degree"), each == 0 ? 0 : counted_over_every_f(p, each))
            << name(p);
        const std::uint64_t all = v * (v - 1) / 2 + (v * each + 1) / 2;
        const std::uint64_t first = k * (k - 1) / 2;
        const std::uint64_t most = first - (k - m) * (k - m - 1) / 2;
        EXPECT_EQ(bound_named({.v = v, .k = k, .change = m}, "degree"),
                  each == 0 ? 0 : ceil_div(all - first, k == m ? first : most) + 1)
            << name(p);
        forced += each > 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(forced, 400U);
}

TEST(LowerBound, SaysLittleWhereMoreThanAMillionNumbersWouldHaveToBeTried) {
  constexpr std::uint64_t million = std::uint64_t{1} << 20;
  const Parameters p{
      .v = 2 * million + 1004, .k = 2 * million + 4, .change = 1, .kind = Kind::circular};
  EXPECT_EQ(bound_named(p, "counting"), 3U);
  EXPECT_NE(reason_named(p, "counting").find("least at f = 0: b >= 3"), std::string::npos);
}

// Reasons as they are read: every number in them is the right one.
TEST(LowerBound, WritesEachReasonWithItsNumbers) {
  const auto circular = [](std::uint64_t v, std::uint64_t k, std::uint64_t m) {
    return Parameters{.v = v, .k = k, .change = m, .kind = Kind::circular};
  };
  EXPECT_EQ(
      reason_named(circular(20, 5, 2), "counting"),
      "each block newly covers at most 7 of C(20,2) = 190 pairs: b >= ceil(190 / 7) = 28 (a design with elements "
      "in every block needs no fewer)");
  EXPECT_EQ(
      reason_named(circular(8, 6, 2), "counting"),
      "ceil(C(8,2) / 9) = 4 counts pairs of elements that are in every block; over the number f of "
      "those, max(ceil((C(8,2) - C(f,2)) / 9), ceil(C(8-f,2) / p(6-f)), ceil((8-f) / 2), 3) is least at "
      "f = 2: b >= 3");
  EXPECT_EQ(
      reason_named(circular(10, 8, 1), "counting"),
      "ceil(C(10,2) / 7) = 7 counts pairs of elements that are in every block; over the number f of "
      "those, max(ceil((C(10,2) - C(f,2)) / 7), ceil(C(10-f,2) / p(8-f)), ceil((10-f) / 1), 3) is least "
      "at f = 5: b >= 5");
  EXPECT_EQ(
      reason_named({.v = 12, .k = 4}, "counting"),
      "the first block covers C(4,2) = 6 of C(12,2) = 66 pairs, each later one newly covers at most 5: "
      "b >= ceil((66 - 6) / 5) + 1 = 13");
  EXPECT_EQ(
      reason_named({.v = 14, .k = 7, .kind = Kind::circular, .strength = 3}, "counting"),
      "the first block covers C(7,3) = 35 of C(14,3) = 364 3-subsets, each later one newly covers at "
      "most 25: b >= ceil((364 - 35) / 25) + 1 = 15 (a circular design is also a linear one)");
  EXPECT_EQ(
      reason_named(circular(23, 9, 4), "degree"),
      "i_x(k-1) + m(r_x-i_x) = v-1 + e_x makes every e_x >= 2 (modulo gcd(k-1,m) = 4); counting pairs "
      "with this excess gives b >= 11");
  EXPECT_EQ(
      reason_named(circular(12, 9, 2), "degree"),
      "i_x(k-1) + m(r_x-i_x) = v-1 + e_x makes every e_x >= 1 (modulo gcd(k-1,m) = 2); counting pairs "
      "with this excess, least with 2 elements in every block, gives b >= 5");
  EXPECT_EQ(
      reason_named({.v = 20, .k = 9, .change = 4}, "degree"),
      "i_x(k-1) + m(r_x-i_x) = v-1 + e_x makes every e_x >= 1 (modulo gcd(k-1,m) = 4), so 200 pairs are "
      "covered with repetition: b >= ceil((200 - 36) / 26) + 1 = 8");
  EXPECT_EQ(
      reason_named({.v = 19, .k = 7, .change = 3}, "end to end"),
      "at most 3 elements enter a step, so some x is in none of the first ceil((19-7)/3) = 4 blocks and "
      "some y in none of the last 4: b >= 2*4 + 1 = 9");
  EXPECT_EQ(
      reason_named({.v = 9, .k = 4, .change = 1}, "end to end"),
      "at most 1 element enters a step, so some x is in none of the first ceil((9-4)/1) = 5 blocks and "
      "some y in none of the last 5: b >= 2*5 + 1 = 11");
  EXPECT_EQ(
      reason_named({.v = 14, .k = 7, .strength = 3}, "end to end"),
      "at most 2 elements enter a step, so ceil((14-7)/2) = 4 blocks in a row lack some element, and 3 "
      "runs of 4 lack 3 that never meet: b >= 3*4 + 1 = 13");
  const auto stays = [](const std::string& weights, const std::string& most,
                        const std::string& forced) {
    return weights + " <= " + most +
           " where n_j elements have j stays (docs/theorems.md, Theorem 5), so k + m(b-1) >= " +
           forced;
  };
  EXPECT_EQ(reason_named(circular(8, 6, 2), "stays"), stays("n1", "k = 6", "2v - k = 10: b >= 3"));
  EXPECT_EQ(reason_named({.v = 12, .k = 4}, "stays"),
            stays("2*n1 + n2", "3k = 12", "3v - 3k = 24: b >= 11"));
  EXPECT_EQ(reason_named({.v = 14, .k = 7, .strength = 3}, "stays"),
            stays("2*n1 + n2", "2k = 14", "3v - 2k = 28: b >= 12"));
  EXPECT_EQ(reason_named({.v = 20, .k = 3, .change = 1}, "stays"),
            stays("4*n1 + 3*n2 + 2*n3 + n4", "13k = 39", "5v - 13k = 61: b >= 59"));
  EXPECT_EQ(reason_named({.v = 30, .k = 3}, "stays"),
            stays("5*n1 + 4*n2 + ... + n5", "21k = 63", "6v - 21k = 117: b >= 58"));
  EXPECT_EQ(
      reason_named(circular(10, 3, 3), "degree program"),
      "with 16 blocks let x be introduced i_x >= 1 times, and e_x >= 0 be its new meetings beyond "
      "v-1; then e_x >= i_x(k-1)-(v-1), the difference is a multiple of m = 3, e_x is at most half of "
      "the sum of all, and x fits into the blocks, whatever is in every block. No whole numbers with "
      "the right sums and the stays of Theorem 5 do (docs/theorems.md, Theorem 35): b >= 17");
  EXPECT_EQ(
      reason_named({.v = 12, .k = 6, .change = 4}, "degree program"),
      "with 5 blocks let x be introduced i_x >= 1 times, and e_x >= 0 be its new meetings beyond "
      "v-1; then e_x >= i_x(k-1)-(v-1), the difference is a multiple of m = 4, e_x is at most half of "
      "the sum of all, and x fits into the blocks. No whole numbers with the right sums do "
      "(docs/theorems.md, Theorem 35): b >= 6");
  EXPECT_EQ(
      reason_named({.v = 9, .k = 5, .change = 4}, "complements"),
      "v = k+m, so the sets of m = 4 elements outside consecutive blocks are disjoint, and from "
      "each block to the next but one at most k-m = 1 of them change. Blocks 1, 3, 5, … or 2, "
      "4, 6, … must have no element outside in common, or two elements never meet "
      "(docs/theorems.md, Theorem 39): b >= 2*ceil(4 / 1) + 1 = 9");
  EXPECT_EQ(
      reason_named(circular(9, 4, 4), "one left out"),
      "each step leaves out one element, and only such an element goes from blocks 1, 3, 5, … "
      "to blocks 2, 4, 6, … or back; with fewer blocks two elements never meet "
      "(docs/theorems.md, Theorem 40): b >= 2k + 4 = 12");
  EXPECT_EQ(
      reason_named(circular(9, 4, 4), "returning elements"),
      "v < k + 2m, so from the third block on at least 2m+k-v = 3 of the 4 entering elements were in "
      "the block before the last one: 3 of the 6 pairs are not new "
      "(docs/theorems.md, Theorem 36), so 6 + 6 + 3(b-2) >= 36: b >= 10");
  EXPECT_EQ(
      reason_named({.v = 13, .k = 4, .change = 4}, "Steiner system"),
      "with C(13,2) / C(4,2) = 13 blocks every pair is in one block only: a projective plane, where "
      "any two blocks meet, but consecutive blocks must not (docs/theorems.md, Theorem 37): b >= 14");
  EXPECT_EQ(
      reason_named(circular(16, 4, 4), "Steiner system"),
      "with C(16,2) / C(4,2) = 20 blocks every pair is in one block only: an affine plane, where "
      "disjoint blocks are parallel, so the list would stay among 4 parallel ones "
      "(docs/theorems.md, Theorem 37): b >= 21");
  EXPECT_EQ(
      reason_named(circular(21, 6, 6), "Steiner system"),
      "with C(21,2) / C(6,2) = 14 blocks every pair is in one block only: a Steiner system with more "
      "than one block has at least v = 21 of them (Fisher's inequality) (docs/theorems.md, Theorem "
      "37): b >= 15");
  EXPECT_EQ(reason_named({.v = 9, .k = 5, .change = 1, .kind = Kind::circular, .strength = 3},
                         "checked proofs"),
            "fewer than 15 blocks are excluded by SAT with checked DRAT proofs, which this command "
            "writes: changeover search 9 5 --change 1 --circular --strength 3 --exact --proof DIR");
  EXPECT_EQ(reason_named({.v = 12, .k = 4}, "checked proofs"),
            "fewer than 14 blocks are excluded by SAT with checked DRAT proofs, which this command "
            "writes: changeover search 12 4 --change 2 --linear --exact --proof DIR");
  EXPECT_EQ(reason_named(circular(14, 5, 1), "all lists"),
            "with 23 blocks each element has one or two stays; a search through all such lists "
            "finds none (docs/theorems.md, Theorem 29): b >= 24");
  EXPECT_EQ(reason_named({.v = 7, .k = 7}, "trivial"), "one block holds all elements");
}

// Elements that are added to every block make a larger design of as many blocks; a circular design
// is also a linear one; one of strength t has every smaller strength.
TEST(LowerBound, IsNotBelowThatOfADesignThatItMakes) {
  const auto bound = [](Parameters p, std::uint64_t added) {
    p.v += added;
    p.k += added;
    return lower_bound(p).blocks;
  };
  for (std::uint32_t t = 2; t <= 3; ++t) {
    for (std::uint64_t m = 1; m <= 6; ++m) {
      for (std::uint64_t k = std::max<std::uint64_t>(m, t); k <= 12; ++k) {
        for (std::uint64_t v = k + m; v <= 26; ++v) {
          Parameters p{.v = v, .k = k, .change = m, .strength = t};
          if (k < 2 || impossibility(p)) {
            continue;
          }
          const std::uint64_t linear = lower_bound(p).blocks;
          p.kind = Kind::circular;
          const std::uint64_t circular = lower_bound(p).blocks;
          EXPECT_LE(linear, circular) << name(p);
          for (std::uint64_t f = 1; f <= 3; ++f) {
            EXPECT_LE(bound(p, f), circular) << name(p) << " and " << f;
            EXPECT_LE(bound(p.as(Kind::linear), f), linear) << name(p) << " and " << f;
          }
          p.strength = 2;
          EXPECT_LE(lower_bound(p).blocks, circular) << name(p);
        }
      }
    }
  }
}

TEST(LowerBound, OfLargeChangesIsWhatIsProved) {
  const auto both = [](std::uint64_t v, std::uint64_t k, std::uint64_t m) {
    const Parameters p{.v = v, .k = k, .change = m};
    return std::pair(lower_bound(p).blocks, lower_bound(p.as(Kind::circular)).blocks);
  };
  using Pair = std::pair<std::uint64_t, std::uint64_t>;
  EXPECT_EQ(both(12, 6, 4), Pair(6, 6));
  EXPECT_EQ(both(13, 6, 4), Pair(7, 7));
  EXPECT_EQ(both(18, 8, 4), Pair(8, 8));
  EXPECT_EQ(both(13, 4, 4), Pair(14, 14));
  EXPECT_EQ(both(16, 4, 4), Pair(21, 21));
  EXPECT_EQ(both(13, 7, 6), Pair(13, 13));
  EXPECT_EQ(both(9, 4, 4), Pair(11, 12));
  EXPECT_EQ(both(25, 5, 2).second, 44U);  // one pair too much has two odd degrees
}

TEST(LowerBound, SaysNothingMoreWhereOneBlockIsAll) {
  EXPECT_EQ(lower_bounds({.v = 7, .k = 7}).size(), 1U);
  EXPECT_EQ(counting_bound({.v = 7, .k = 7}), 1U);
  EXPECT_EQ(counting_bound({.v = 7, .k = 7, .kind = Kind::circular}), 1U);
  EXPECT_THROW((void)lower_bounds({.v = 3, .k = 4}), ImpossibleParameters);
}

TEST(LowerBound, OfPairsIsNotSaidOfTriples) {
  const auto bounds = lower_bounds({.v = 14, .k = 7, .kind = Kind::circular, .strength = 3});
  std::vector<std::string> names;
  for (const Bound& bound : bounds) {
    names.push_back(bound.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"counting", "end to end", "stays"}));
  EXPECT_EQ(least_introductions(25, 10), (Introductions{45, 2}));  // of pairs, if nothing is said
}

TEST(LowerBound, IsOfTheFirstKindAmongEqualOnes) {
  const auto bounds = lower_bounds({.v = 8, .k = 6, .kind = Kind::circular});
  ASSERT_EQ(bounds.size(), 3U);
  EXPECT_EQ(bounds[0].name, "counting");
  EXPECT_EQ(bounds[1].name, "end to end");
  EXPECT_EQ(bounds[2].name, "stays");
}

}  // namespace
}  // namespace changeover::lower_bound_test
