// docs/minima.csv holds what exact search settled, docs/minima.md shows it: both say what the
// program says today.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/best_known.hpp"
#include "changeover/io/input.hpp"
#include "changeover/search/exact.hpp"
#include "run_program.hpp"

namespace changeover::minima_file_test {
namespace {

const std::string docs = CHANGEOVER_TEST_DATA "/../../docs/";

TEST(MinimaFile, SaysWhatTheBoundsAndTheBestKnownDesignsSay) {
  const std::vector<MinimaRow> rows = read_minima(*open_input(docs + "minima.csv"));
  ASSERT_GE(rows.size(), 446U);
  std::size_t settled = 0;
  for (const MinimaRow& row : rows) {
    const Parameters& p = row.parameters;
    SCOPED_TRACE(name(p) + ", strength " + std::to_string(p.strength) +
                 "; `changeover minima --data docs/minima.csv -o docs/minima.md` writes both "
                 "again");
    EXPECT_EQ(row.lower, lower_bound(p).blocks);
    const auto best = best_known(Registry::standard(), p);
    EXPECT_EQ(row.upper.has_value(), best.has_value());
    if (row.upper && best) {
      EXPECT_EQ(*row.upper, best->b);
    }
    settled += row.settled() ? 1U : 0U;
  }
  EXPECT_GE(settled, 415U);
}

TEST(MinimaFile, IsWhatThePageShows) {
  const std::vector<MinimaRow> rows = read_minima(*open_input(docs + "minima.csv"));
  EXPECT_EQ(test::slurp(docs + "minima.md"), minima_markdown(rows))
      << "`changeover minima --data docs/minima.csv -o docs/minima.md` writes both again";
}

// A design with a fixed element, blown up or cut open is one with other parameters, so what is
// excluded there is excluded here; no bound that proofs gave says more than those here know.
TEST(MinimaFile, ExcludesNothingThatIsNotExcludedWhereRulesLeadThere) {
  std::size_t compared = 0;
  for (const MinimaRow& row : read_minima(*open_input(docs + "minima.csv"))) {
    const Parameters& p = row.parameters;
    std::vector<Parameters> from;
    if (p.k > p.strength && p.k > p.change && p.k > 2) {
      from.push_back({p.v - 1, p.k - 1, p.change, p.kind, p.strength});
    }
    if (p.kind == Kind::linear) {
      from.push_back({p.v, p.k, p.change, Kind::circular, p.strength});
    }
    for (std::uint64_t s = 2; s <= p.change; ++s) {
      if (p.v % s == 0 && p.k % s == 0 && p.change % s == 0 && p.k / s >= p.strength) {
        from.push_back({p.v / s, p.k / s, p.change / s, p.kind, p.strength});
      }
    }
    for (const Parameters& input : from) {
      if (!impossibility(input) && row.lower > lower_bound(input).blocks) {
        ADD_FAILURE() << name(input) << " has " << row.lower << " blocks at least, as " << name(p)
                      << " has";
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 500U);
}

}  // namespace
}  // namespace changeover::minima_file_test
