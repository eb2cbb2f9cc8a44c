// One function answers for a cell: alone, in a range, in another range, after other questions.
#include "construct/known_designs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "changeover/catalog/catalog.hpp"
#include "changeover/construct/registry.hpp"
#include "run_program.hpp"

namespace changeover::known_designs_test {
namespace {

using test::TemporaryFolder;

const Registry& registry() { return Registry::standard(); }

std::vector<Parameters> random_cells(std::size_t count, std::uint64_t largest_v) {
  std::mt19937 random(26);
  std::vector<Parameters> cells;
  while (cells.size() < count) {
    Parameters p;
    p.change = 1 + random() % 8;
    p.k = std::max<std::uint64_t>(p.change, 2) + random() % 30;
    p.v = p.k + 1 + random() % (largest_v - p.k);
    p.kind = random() % 2 == 0 ? Kind::linear : Kind::circular;
    if (!impossibility(p)) {
      cells.push_back(p);
    }
  }
  return cells;
}

// A range around a cell.
CellRange range_around(const Parameters& p, std::mt19937& random) {
  return {.v_from = p.v - random() % 2,
          .v_to = p.v + random() % 2,
          .k_from = std::max<std::uint64_t>(2, p.k - random() % 2),
          .k_to = p.k,
          .change = p.change};
}

void expect_one_answer(const std::vector<Parameters>& cells) {
  std::mt19937 random(27);
  KnownDesigns all(registry());
  for (const Parameters& p : cells) {
    SCOPED_TRACE(name(p));
    const auto alone = best_known(registry(), p);
    const auto expect_same = [&](const std::optional<Offer>& other) {
      ASSERT_EQ(other.has_value(), alone.has_value());
      if (alone) {
        EXPECT_EQ(other->b, alone->b);
        EXPECT_EQ(other->recipe, alone->recipe);
      }
    };
    expect_same(all.best(p));
    expect_same(best_known_table(registry(), range_around(p, random)).at(p).best);
    const auto offered = registry().best(p);
    EXPECT_TRUE(!offered || alone->b <= offered->b);
    EXPECT_TRUE(!alone || alone->b >= lower_bound(p).blocks);
  }
}

TEST(KnownDesigns, AnswerTheSameWhateverElseIsAsked) { expect_one_answer(random_cells(40, 120)); }

TEST(KnownDesigns, AnswerTheSameForAThousandCellsSlow) {
  expect_one_answer(random_cells(1000, 300));
}

// Ranges once found what single questions did not, and the other way round.
TEST(KnownDesigns, AreNoWorseThanWhatRangesAndSingleCellsFound) {
  struct Row {
    Parameters p;
    std::uint64_t b;
  };
  for (const auto& [p, b] : std::vector<Row>{{{24, 7, 5, Kind::circular}, 33},
                                             {{198, 9, 2, Kind::linear}, 1315},
                                             {{208, 8, 8, Kind::circular}, 978},
                                             {{75, 26, 8, Kind::circular}, 19},
                                             {{171, 7, 6, Kind::linear}, 1240}}) {
    const auto best = best_known(registry(), p);
    ASSERT_TRUE(best) << name(p);
    EXPECT_LE(best->b, b) << name(p);
  }
}

// Nothing but the catalog is asked there, however large the range: the rules had their turn when it
// was made.
TEST(KnownDesigns, AreLookedUpWhereTheCatalogComesWithThem) {
  for (const Parameters& p :
       {Parameters{99, 12, 3, Kind::linear}, Parameters{40, 6, 2, Kind::circular},
        Parameters{160, 40, 1, Kind::linear}}) {
    ASSERT_TRUE(is_stored_cell(p));
    const auto offered = registry().best(p);
    const auto best = best_known(registry(), p);
    ASSERT_TRUE(offered && best);
    EXPECT_EQ(best->recipe, offered->recipe) << name(p);
    // And planned again it is no better: otherwise docs/tools/plan_catalog.sh has news.
    const auto anew = KnownDesigns(registry(), Stored::anew).best(p);
    ASSERT_TRUE(anew);
    EXPECT_EQ(anew->b, best->b) << name(p);
  }
}

// A catalog that comes with nothing stands for one that comes with all, and what that knows for
// news of the user's.
TEST(KnownDesigns, FollowWhatTheUserFoundInCellsThatTheCatalogComesWith) {
  const Registry without(registry_entries());
  std::size_t followed = 0;
  for (std::uint64_t k = 6; k <= 10; ++k) {
    for (std::uint64_t v = 3 * k; v <= 60; v += 5) {
      const Parameters p{.v = v, .k = k, .change = 2, .kind = Kind::circular};
      const auto entry = standard_catalog().best(p);
      const auto offered = without.best(p);
      ASSERT_TRUE(entry && offered && is_stored_cell(p));
      if (entry->b >= offered->b || entry->recipe.construction == "found") {
        continue;
      }
      const TemporaryFolder folder;
      Catalog catalog({.shipped = {}, .user = folder.file("mine.db")});
      const Registry with_none(registry_entries(), &catalog);
      const auto before = best_known(with_none, p);
      ASSERT_TRUE(before);
      EXPECT_EQ(before->b, offered->b) << name(p);  // as if it came planned
      catalog.add(*entry);
      Parameters fixed = p;
      ++fixed.v;
      ++fixed.k;
      Parameters linear = p;
      linear.kind = Kind::linear;
      const BestKnownTable plan = best_known_table(
          with_none, {.v_from = v, .v_to = v + 1, .k_from = k, .k_to = k + 1, .change = 2});
      for (const Parameters& q : {p, fixed, linear}) {
        const auto best = best_known(with_none, q);
        ASSERT_TRUE(best) << name(q);
        EXPECT_LE(best->b, entry->b) << name(q);
        EXPECT_EQ(plan.at(q).best->recipe, best->recipe) << name(q);
      }
      ++followed;
    }
  }
  EXPECT_GT(followed, 3U);
}

}  // namespace
}  // namespace changeover::known_designs_test
