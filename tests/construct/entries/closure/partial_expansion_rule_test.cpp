// Partial expansion of any design at hand: the cover by unchanged subsets that a recipe names by
// positions.
#include <gtest/gtest.h>

#include "changeover/catalog/catalog.hpp"
#include "changeover/construct/best_known.hpp"
#include "changeover/construct/closure.hpp"
#include "changeover/construct/expansion.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/design.hpp"
#include "construction_checks.hpp"
#include "naive_verdict.hpp"

namespace changeover::partial_expansion_rule_test {
namespace {

using namespace test;

// The elements in some unchanged subset, or in an end block of a linear design.
std::size_t elements_that_stay(const Design& design) {
  std::vector<bool> stays(static_cast<std::size_t>(design.v()), false);
  const auto mark = [&](const auto& elements) {
    for (const Element x : elements) {
      stays[x] = true;
    }
  };
  for (const UnchangedSubset& subset : unchanged_subsets(design)) {
    mark(subset.elements);
  }
  return static_cast<std::size_t>(std::count(stays.begin(), stays.end(), true));
}

TEST(PartialExpansionRule, MakesADesignOfEveryFoundDesignWithACover) {
  std::size_t covered = 0;
  std::size_t made = 0;
  std::vector<CatalogEntry> entries;
  standard_catalog().each({.v_to = 22, .strength = 2, .best_only = false},
                          [&](const CatalogEntry& entry) {
                            if (entry.carries_blocks()) {
                              entries.push_back(entry);
                            }
                            return true;
                          });
  for (const CatalogEntry& found : entries) {
    const Parameters& p = found.parameters;
    SCOPED_TRACE(name(p));
    const Design design = standard().build_design(found.recipe);
    const auto cover = cover_positions(design);
    if (!cover) {
      EXPECT_TRUE(p.kind == Kind::linear || elements_that_stay(design) < p.v);
      continue;
    }
    ++covered;
    EXPECT_GE(cover->positions.size() * (p.k - p.change), p.v);
    for (const std::uint64_t w : {1U, 2U, 3U, 4U, 5U, 8U, 9U, 20U}) {
      if (!new_elements_fit(p, w)) {
        continue;
      }
      const auto b = partial_expansion_count(p, found.b, *cover, w);
      if (!b) {
        continue;
      }
      const Recipe recipe = partial_expansion_recipe(found.recipe, *cover, w);
      const Design larger = standard().build_design(recipe);
      ++made;
      EXPECT_EQ(larger.v(), p.v + w);
      EXPECT_EQ(larger.block_count(), *b) << w;
      EXPECT_TRUE(verify(larger).valid()) << w;
      if (larger.v() <= 14) {
        EXPECT_TRUE(naive_verdict(larger).valid) << w;
      }
      EXPECT_NE(construction("partial-expansion").explain(recipe).find("position"),
                std::string::npos);
    }
  }
  EXPECT_GT(covered, 60U);
  EXPECT_GT(made, 400U);
}

TEST(PartialExpansionRule, RefusesPositionsThatDoNotCover) {
  const auto offer = offer_of("found", {16, 4, 2, Kind::circular, 2});
  ASSERT_TRUE(offer);
  const auto cover = cover_positions(standard().build_design(offer->recipe));
  ASSERT_TRUE(cover);
  const Recipe good = partial_expansion_recipe(offer->recipe, *cover, 8);
  EXPECT_TRUE(verify(*standard().build(good)).valid());
  Recipe bad = good;
  bad.blocks.front().pop_back();
  expect_refused(bad, "an element is left over");
  bad = good;
  std::swap(bad.blocks.front()[0], bad.blocks.front()[1]);
  expect_refused(bad, "positions that do not increase");
  bad = good;
  bad.blocks.front().back() = 100'000;
  expect_refused(bad, "a position that is none");
  bad = good;
  bad.blocks.front().front() = 0;
  expect_refused(bad, "position 0 of a circular design");
  bad = good;
  bad.blocks.push_back(bad.blocks.front());
  expect_refused(bad, "two lists");
  bad = good;
  bad.blocks = {{}};
  expect_refused(bad, "an empty list");
}

TEST(PartialExpansionRule, FitsWhenBlocksAddedSaysSo) {
  for (std::uint64_t m = 1; m <= 4; ++m) {
    for (std::uint64_t k = m; k <= m + 3; ++k) {
      for (std::uint64_t v = k + 1; v <= k + 9; ++v) {
        for (std::uint64_t w = 0; w <= 6; ++w) {
          const Parameters p{v, k, m, Kind::circular, 2};
          bool fits = true;
          try {
            (void)blocks_added(p, 3, w);
          } catch (const ImpossibleParameters&) {
            fits = false;
          }
          EXPECT_EQ(new_elements_fit(p, w), fits) << name(p) << " w = " << w;
        }
      }
    }
  }
}

struct Cell {
  Parameters parameters;
  std::uint64_t b;
};

TEST(PartialExpansionRule, ServesBestKnown) {
  for (const auto& [p, b] :
       {Cell{{70, 4, 2, Kind::circular, 2}, 483}, Cell{{24, 4, 2, Kind::circular, 2}, 56},
        Cell{{22, 4, 2, Kind::circular, 2}, 47}}) {
    const auto best = best_known(standard(), p);
    ASSERT_TRUE(best) << name(p);
    EXPECT_LE(best->b, b) << name(p);
    const Design design = standard().build_design(best->recipe);
    EXPECT_EQ(design.block_count(), best->b);
    const Verdict verdict = verify(design);
    EXPECT_TRUE(verdict.valid()) << name(p);
    EXPECT_EQ(verdict.tight(), p.v == 70) << name(p);
  }
}

TEST(PartialExpansionRule, APlanOfOneCellKnowsWhatAPlanOfAllKnows) {
  for (std::uint64_t m = 1; m <= 3; ++m) {
    const BestKnownTable plan = best_known_table(
        standard(), {.v_from = 3, .v_to = 40, .k_from = 3, .k_to = 8, .change = m});
    std::size_t asked = 0;
    for (const KnownCell& cell : plan.cells()) {
      const Parameters& p = cell.parameters;
      if (cell.best && p.v <= 32 && p.k <= 7 && (p.v * 7 + p.k * 3 + m) % 5 == 0) {
        const auto best = best_known(standard(), p);
        ASSERT_TRUE(best) << name(p);
        EXPECT_EQ(best->b, cell.best->b) << name(p);
        ++asked;
      }
    }
    EXPECT_GT(asked, 40U);
  }
}

}  // namespace
}  // namespace changeover::partial_expansion_rule_test
