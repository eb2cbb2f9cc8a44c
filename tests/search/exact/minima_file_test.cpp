// docs/minima.csv holds what exact search settled: bounds and constructions must agree with it.
#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/planner.hpp"
#include "changeover/io/input.hpp"
#include "changeover/search/minima_table.hpp"

namespace changeover {
namespace {

TEST(MinimaFile, AgreesWithTheBoundsAndWithTheBestKnownDesigns) {
  const std::vector<MinimaRow> rows =
      read_minima(*open_input(CHANGEOVER_TEST_DATA "/../../docs/minima.csv"));
  ASSERT_GE(rows.size(), 446U);
  std::size_t settled = 0;
  for (const MinimaRow& row : rows) {
    const Parameters& p = row.parameters;
    SCOPED_TRACE(name(p) + ", strength " + std::to_string(p.strength));
    ASSERT_TRUE(row.upper);
    EXPECT_LE(row.lower, *row.upper);
    const std::uint64_t bound = lower_bound(p).blocks;
    EXPECT_LE(bound, *row.upper);
    const auto best = best_known(Registry::standard(), p);
    EXPECT_TRUE(!best || best->b >= row.lower);
    if (p.strength == 2) {
      EXPECT_GE(bound, row.lower);
      ASSERT_TRUE(best);
      EXPECT_LE(best->b, *row.upper);
      if (row.settled()) {
        EXPECT_EQ(best->b, bound);
        ++settled;
      }
    }
  }
  EXPECT_GE(settled, 373U);
}

}  // namespace
}  // namespace changeover
