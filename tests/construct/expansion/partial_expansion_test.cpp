#include "changeover/construct/expansion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <utility>

#include "changeover/bounds/lower_bound.hpp"
#include "message_of.hpp"
#include "partial_expansion_designs.hpp"

namespace changeover::partial_expansion_test {
namespace {

using namespace test;

TEST(PartialExpansion, IsADesignForEveryNumberOfNewElements) {
  std::size_t made = 0;
  for (const Design& design : some_designs()) {
    const Verdict before = verify(design);
    ASSERT_TRUE(before.valid());
    for (std::uint64_t w = 1; w <= 13; ++w) {
      SCOPED_TRACE(title(design, w));
      if (!fits(design, w)) {
        EXPECT_THROW((void)find_cover(design, for_w(w)), ImpossibleParameters);
        continue;
      }
      const auto cover = find_cover(design, for_w(w));
      if (!cover) {
        continue;
      }
      ++made;
      EXPECT_EQ(cover_defect(design, *cover, w), std::nullopt);
      const bool left_out = leaves_one_out(*cover, design.v());
      const Design larger = expand_by(design, *cover, w);
      const Verdict after = verify(larger);
      EXPECT_TRUE(after.valid());
      EXPECT_EQ(after.parameters.v, design.v() + w);
      EXPECT_EQ(after.parameters.kind, design.parameters().kind);
      EXPECT_EQ(after.b,
                before.b + blocks_added(design.parameters(), cover->subsets.size(), w, left_out));
      // Nothing but what is inserted adds to what is covered.
      const std::uint64_t each = newly_covered_at_most(design.parameters());
      EXPECT_EQ(after.covered, before.covered + (after.b - before.b) * each);
      EXPECT_EQ(after.excess,
                before.excess + (after.b - before.b) * each - (w * design.v() + w * (w - 1) / 2));
      if (larger.v() <= 20 && larger.block_count() <= 80) {
        EXPECT_TRUE(naive_verdict(larger).valid);
      }
    }
  }
  EXPECT_GT(made, 200U);
}

TEST(PartialExpansion, KeepsTheOldBlocksInTheirOrder) {
  const Design design = built("cyclic-paper", 11, 4);
  for (std::uint64_t w = 1; w <= 9; ++w) {
    const Design larger = expand_by(design, *find_cover(design, for_w(w)), w);
    std::size_t next = 0;
    for (const Block& block : larger.blocks()) {
      const auto old = design.block(std::min<std::size_t>(next, 10));
      next += next < 11 && std::equal(block.begin(), block.end(), old.begin()) ? 1U : 0U;
    }
    EXPECT_EQ(next, 11U);
  }
}

TEST(PartialExpansion, HasTheBlocksAndTheExcessOfTheFormula) {
  for (const Design& design : some_designs()) {
    const Parameters& p = design.parameters();
    if (p.change != 2) {
      continue;
    }
    const std::uint64_t old_excess = verify(design).excess;
    const auto cover = find_cover(design, for_w(2));
    if (!cover) {
      continue;
    }
    const std::uint64_t positions = cover->subsets.size();
    for (std::uint64_t w = 2; w <= positions + 1; w += 2) {
      const Verdict after = verify(expand_by(design, *cover, w));
      EXPECT_EQ(after.b, design.block_count() + positions * w / 2);
      EXPECT_EQ(after.excess,
                old_excess + (positions * (p.k - 2) - p.v) * w + (positions - w + 1) * w / 2);
    }
  }
}

TEST(PartialExpansion, IsTheirTheoremForAPartitionOfOddSizeAndEconomicalForAnEvenOne) {
  const Design fifteen = built("cyclic-paper", 15, 5);
  const auto thirds = find_cover(fifteen, for_w(6));
  ASSERT_TRUE(thirds);
  EXPECT_EQ(thirds->subsets.size(), 5U);
  EXPECT_TRUE(thirds->minimum);
  EXPECT_EQ(expand_by(fifteen, *thirds, 6).blocks(),
            expand(fifteen, thirds->subsets, one_factorization(6)).blocks());
  EXPECT_TRUE(verify(expand_by(fifteen, *thirds, 6)).tight());
  const Verdict nineteen = verify(expand_by(fifteen, *thirds, 4));
  EXPECT_EQ(nineteen.b, 25U);
  EXPECT_TRUE(nineteen.economical());
}

TEST(PartialExpansion, RunsTheExampleOfTheHeader) {
  const Design design = built("cyclic-paper", 15, 5);
  std::optional<UnchangedCover> cover = find_cover(design, {.new_elements = 4});
  Design larger = expand_by(design, *cover, 4);
  EXPECT_EQ(larger.block_count(), 25U);
  EXPECT_TRUE(verify(larger).economical());
}

TEST(PartialExpansion, ReachesEconomicalDesignsFromTheCyclicOneOnNineteenElements) {
  const Design design = built("cyclic-paper", 19, 6);
  for (const auto& [w, b] : {std::pair{2, 24}, std::pair{4, 29}, std::pair{6, 34}}) {
    const auto size = static_cast<std::uint64_t>(w);
    const auto cover = find_cover(design, for_w(size));
    ASSERT_TRUE(cover);
    EXPECT_EQ(cover->subsets.size(), 5U);
    const Verdict verdict = verify(expand_by(design, *cover, size));
    EXPECT_EQ(verdict.b, static_cast<std::uint64_t>(b));
    EXPECT_TRUE(verdict.economical());
  }
}

TEST(PartialExpansion, WorksWithBothKindsOfFactors) {
  const Design design = built("cyclic-paper", 21, 4);
  for (const std::uint64_t w : {7U, 8U, 9U, 10U, 12U}) {
    for (const FactorizationKind kind : {FactorizationKind::circle, FactorizationKind::doubled}) {
      EXPECT_TRUE(verify(expand_by(design, *find_cover(design, for_w(w)), w, kind)).valid());
    }
  }
}

TEST(PartialExpansion, TakesAnyNumberOfChangesUpToThatOfNewElements) {
  // Three copies of every element of a circular SCCD: m = 3.
  const Design single = built("mcsorley-circular", 7, 4, 1);
  Design triple(Parameters{21, 12, 3, Kind::circular, 2});
  for (const Block& block : single.blocks()) {
    Block copies;
    for (const Element x : block) {
      copies.insert(copies.end(), {3 * x, 3 * x + 1, 3 * x + 2});
    }
    triple.append(copies);
  }
  ASSERT_TRUE(verify(triple).tight());
  for (std::uint64_t w = 1; w <= 3; ++w) {
    const auto cover = find_cover(triple, for_w(w));
    ASSERT_TRUE(cover);
    const Verdict verdict = verify(expand_by(triple, *cover, w));
    EXPECT_TRUE(verdict.valid());
    EXPECT_EQ(verdict.b, 7 + cover->subsets.size());
    EXPECT_LE(cover->subsets.size(), 3U);
  }
  EXPECT_REFUSAL((void)find_cover(triple, for_w(4)), ImpossibleParameters,
                 "m = 3 takes at most 3 new elements, not 4");
}

TEST(PartialExpansion, AddsPositionsAndSweepsWhenThereAreManyNewElements) {
  for (const auto& [v, k, m] : {std::tuple{15, 5, 2}, std::tuple{11, 4, 2}, std::tuple{7, 3, 2},
                                std::tuple{19, 6, 2}, std::tuple{9, 5, 1}, std::tuple{13, 7, 1},
                                std::tuple{3, 2, 1}, std::tuple{5, 3, 1}, std::tuple{7, 4, 1}}) {
    const Design design =
        built(m == 1 ? "mcsorley-circular" : "cyclic-paper", static_cast<std::uint64_t>(v),
              static_cast<std::uint64_t>(k), static_cast<std::uint64_t>(m));
    for (std::uint64_t w = 1; w <= 45; ++w) {
      const auto cover = find_cover(design, for_w(w));
      if (!cover) {
        EXPECT_TRUE(k == 3 && w > 7) << title(design, w);
        continue;
      }
      const Verdict verdict = verify(expand_by(design, *cover, w));
      EXPECT_TRUE(verdict.valid()) << title(design, w);
      EXPECT_EQ(verdict.b,
                design.block_count() + blocks_added(design.parameters(), cover->subsets.size(), w,
                                                    leaves_one_out(*cover, design.v())));
    }
  }
}

TEST(PartialExpansion, SweepsAfterEveryPosition) {
  const Design single = built("mcsorley-circular", 7, 4, 1);
  const Design dual = built("cyclic-paper", 15, 5);
  for (const Design* design : {&single, &dual}) {
    for (const std::uint64_t w : {6U, 8U, 11U}) {
      auto cover = *find_cover(*design, for_w(2));
      for (std::size_t i = 0; i < cover.subsets.size(); ++i) {
        if (leaves_one_out(cover, design->v())) {
          continue;  // only one place will do
        }
        cover.sweep = i;
        EXPECT_TRUE(verify(expand_by(*design, cover, w)).valid()) << i;
      }
    }
  }
}

TEST(PartialExpansion, NamesTheNewElements) {
  Design design = built("doubling", 6, 4);
  design.set_labels({"1", "2", "3", "4", "5", "6"});
  EXPECT_EQ(expand_by(design, *find_cover(design), 2).label(7), "8");
}

TEST(PartialExpansion, OfAStreamIsTheSameAndCanBeReadAgain) {
  for (const Design& design : some_designs()) {
    for (std::uint64_t w = 1; w <= 7; ++w) {
      const auto cover = fits(design, w) ? find_cover(design, for_w(w)) : std::nullopt;
      if (!cover) {
        continue;
      }
      const Design larger = expand_by(design, *cover, w);
      const auto source = expand_by(std::make_unique<DesignSource>(design), *cover, w);
      EXPECT_EQ(source->parameters(), larger.parameters());
      EXPECT_EQ(source->block_count(), larger.block_count());
      expect_blocks_however_often(*source, larger.blocks());
    }
  }
}

TEST(PartialExpansion, RefusesWhatDoesNotFit) {
  const Parameters p{11, 4, 2, Kind::circular, 2};
  EXPECT_REFUSAL((void)blocks_added(p, 6, 0), ImpossibleParameters,
                 "partial expansion needs w >= 1 new elements");
  EXPECT_REFUSAL((void)blocks_added({11, 4, 2, Kind::circular, 3}, 6, 2), ImpossibleParameters,
                 "partial expansion is for strength 2, not for circular DCCD(11,4), t = 3");
  EXPECT_THROW((void)blocks_added({11, 4, 4, Kind::circular, 2}, 6, 2), ImpossibleParameters);
  EXPECT_REFUSAL((void)blocks_added({11, 4, 3, Kind::circular, 2}, 6, 4), ImpossibleParameters,
                 "m = 3 takes at most 3 new elements, not 4");
  EXPECT_THROW((void)blocks_added({6, 4, 2, Kind::circular, 2}, 3, 1), ImpossibleParameters);
  EXPECT_REFUSAL((void)blocks_added(p, 6, 0xffff'ffff), ImpossibleParameters,
                 "v + w = 11 + 4294967295 is too large");
  EXPECT_EQ(blocks_added(p, 6, 4), 12U);
  EXPECT_EQ(blocks_added(p, 6, 5), 18U);
  EXPECT_EQ(least_positions({7, 3, 2, Kind::circular, 2}, 6), 5U);
  EXPECT_EQ(least_positions({7, 3, 2, Kind::circular, 2}, 5), 5U);
  EXPECT_EQ(least_positions(p, 6), 1U);
}

TEST(BestNewElements, FindsTheEconomicalNumbers) {
  const Design design = built("cyclic-paper", 15, 5);
  const auto best = best_new_elements(design, 1, 12);
  ASSERT_TRUE(best);
  EXPECT_EQ(best->b, best->lower_bound);
  EXPECT_EQ(best->b, expand_by(design, best->cover, best->w).block_count());
  const auto even = best_new_elements(design, 6, 6);
  ASSERT_TRUE(even);
  EXPECT_EQ(even->b, 30U);
  EXPECT_REFUSAL((void)best_new_elements(design, 0, 3), BadInput,
                 "the range 0..3 of new elements is empty or begins with 0");
  EXPECT_REFUSAL((void)best_new_elements(design, 4, 3), BadInput,
                 "the range 4..3 of new elements is empty or begins with 0");
}

TEST(BestNewElements, AgreesWithTryingAllOfThem) {
  for (const Design& design : some_designs()) {
    if (design.v() > 12) {
      continue;
    }
    const auto best = best_new_elements(design, 1, 8);
    for (std::uint64_t w = 1; w <= 8; ++w) {
      const auto cover = fits(design, w) ? find_cover(design, for_w(w)) : std::nullopt;
      if (!cover) {
        continue;
      }
      ASSERT_TRUE(best);
      Parameters p = design.parameters();
      p.v += w;
      EXPECT_LE(best->b * lower_bound(p).blocks,
                expand_by(design, *cover, w).block_count() * best->lower_bound)
          << title(design, w);
    }
    if (best) {
      EXPECT_EQ(best->b, expand_by(design, best->cover, best->w).block_count());
      EXPECT_TRUE(verify(expand_by(design, best->cover, best->w)).valid());
    }
  }
}

RC_GTEST_PROP(PartialExpansion, IsVerifiedForEveryCyclicDesignAndEveryNumber, ()) {
  const auto k = *rc::gen::inRange<std::uint64_t>(3, 10);
  const auto c = *rc::gen::inRange<std::uint64_t>(1, 5);
  const auto w = *rc::gen::inRange<std::uint64_t>(1, 40);
  const Design design = built("cyclic-paper", c * (4 * k - 6) + 1, k);
  const Design linear = cut_at(design, *rc::gen::inRange<std::size_t>(0, design.block_count()));
  CoverOptions options = for_w(w);
  options.limits.nodes = 500;
  for (const Design* either : {&design, &linear}) {
    const auto cover = find_cover(*either, options);
    if (!cover) {
      RC_ASSERT(k == 3U);
      continue;
    }
    RC_ASSERT(verify(expand_by(*either, *cover, w)).valid());
  }
}

}  // namespace
}  // namespace changeover::partial_expansion_test
