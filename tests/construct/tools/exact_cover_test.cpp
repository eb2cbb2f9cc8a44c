#include "construct/tools/exact_cover.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "changeover/core/error.hpp"
#include "message_of.hpp"

namespace changeover::exact_cover_test {
namespace {

using Rows = std::vector<std::size_t>;
using Cell = std::pair<int, int>;

constexpr std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();

const auto ignore = [](std::span<const std::size_t>) { return true; };

Rows sorted(std::span<const std::size_t> rows) {
  Rows copy(rows.begin(), rows.end());
  std::sort(copy.begin(), copy.end());
  return copy;
}

ExactCover matchings(std::uint32_t order) {
  ExactCover cover(order);
  for (std::uint32_t b = 1; b < order; ++b) {
    for (std::uint32_t a = 0; a < b; ++a) {
      cover.add_row({a, b});
    }
  }
  return cover;
}

/// All subsets of the rows, tried one by one.
class Oracle {
 public:
  explicit Oracle(const ExactCover& cover) : cover_(cover) {
    for (std::size_t subset = 0; subset < std::size_t{1} << cover.row_count(); ++subset) {
      if (is_packing(subset)) {
        packings_.push_back(subset);
      }
    }
  }

  [[nodiscard]] std::set<Rows> covers() const {
    std::set<Rows> result;
    for (const std::size_t subset : packings_) {
      if (gain(subset) == cover_.primary_count()) {
        result.insert(rows(subset));
      }
    }
    return result;
  }

  [[nodiscard]] std::uint64_t most_covered() const {
    std::uint64_t most = 0;
    for (const std::size_t subset : packings_) {
      most = std::max(most, gain(subset));
    }
    return most;
  }

  [[nodiscard]] std::set<Rows> maximal_packings() const {
    std::set<Rows> result;
    for (const std::size_t subset : packings_) {
      bool maximal = true;
      for (std::size_t r = 0; r < cover_.row_count(); ++r) {
        maximal = maximal && ((subset >> r & 1) == 1 || !is_packing(subset | std::size_t{1} << r));
      }
      if (maximal) {
        result.insert(rows(subset));
      }
    }
    return result;
  }

  [[nodiscard]] bool is_packing(std::size_t subset) const {
    std::set<std::uint32_t> met;
    for (const std::size_t r : rows(subset)) {
      for (const std::uint32_t column : cover_.row(r)) {
        if (!met.insert(column).second) {
          return false;
        }
      }
    }
    return true;
  }

  [[nodiscard]] std::uint64_t gain(std::size_t subset) const {
    std::uint64_t count = 0;
    for (const std::size_t r : rows(subset)) {
      for (const std::uint32_t column : cover_.row(r)) {
        count += column < cover_.primary_count() ? 1U : 0U;
      }
    }
    return count;
  }

  static Rows rows(std::size_t subset) {
    Rows result;
    for (std::size_t r = 0; subset >> r != 0; ++r) {
      if ((subset >> r & 1) == 1) {
        result.push_back(r);
      }
    }
    return result;
  }

  static std::size_t subset_of(const Rows& rows) {
    std::size_t subset = 0;
    for (const std::size_t r : rows) {
      subset |= std::size_t{1} << r;
    }
    return subset;
  }

 private:
  const ExactCover& cover_;
  std::vector<std::size_t> packings_;
};

ExactCover arbitrary_cover() {
  const auto below = [](std::uint32_t first, std::uint32_t end) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(first, end));
  };
  const std::uint32_t primary = below(1, 8);
  const std::uint32_t secondary = below(0, 4);
  const std::uint32_t row_count = below(0, 13);
  ExactCover cover(primary, secondary);
  for (std::uint32_t r = 0; r < row_count; ++r) {
    std::set<std::uint32_t> row{below(0, primary)};
    for (std::uint32_t more = below(0, 4); more > 0; --more) {
      row.insert(below(0, primary + secondary));
    }
    cover.add_row(std::vector<std::uint32_t>(row.begin(), row.end()));
  }
  return cover;
}

std::vector<Rows> solutions(const ExactCover& cover) {
  std::vector<Rows> list;
  cover.for_each_solution([&list](std::span<const std::size_t> rows) {
    list.push_back(sorted(rows));
    return true;
  });
  return list;
}

std::vector<Rows> maximal_packings(const ExactCover& cover) {
  std::vector<Rows> list;
  cover.for_each_maximal_packing([&list](std::span<const std::size_t> rows) {
    list.push_back(sorted(rows));
    return true;
  });
  return list;
}

RC_GTEST_PROP(ExactCover, solutions_are_those_of_the_oracle_each_once, ()) {
  const ExactCover cover = arbitrary_cover();
  const auto list = solutions(cover);
  RC_CLASSIFY(!list.empty());
  const std::set<Rows> set(list.begin(), list.end());
  RC_ASSERT(set.size() == list.size());
  RC_ASSERT(set == Oracle(cover).covers());
  RC_ASSERT(cover.count_solutions().value == list.size());
  RC_ASSERT(cover.first_solution().has_value() == !list.empty());
  if (!list.empty()) {
    RC_ASSERT(*cover.first_solution() == list.front());
  }
}

RC_GTEST_PROP(ExactCover, multiplicities_weigh_solutions_by_the_products, ()) {
  const ExactCover cover = arbitrary_cover();
  std::vector<std::uint64_t> weights;
  for (std::size_t r = 0; r < cover.row_count(); ++r) {
    weights.push_back(*rc::gen::inRange<std::uint64_t>(0, 4));
  }
  std::uint64_t expected = 0;
  for (const Rows& rows : Oracle(cover).covers()) {
    std::uint64_t product = 1;
    for (const std::size_t r : rows) {
      product *= weights[r];
    }
    expected += product;
  }
  const SolutionCount count = cover.count_solutions(weights);
  RC_ASSERT(count.value == expected);
  RC_ASSERT(!count.saturated);
  RC_ASSERT(count.outcome == SearchOutcome::complete);
}

RC_GTEST_PROP(ExactCover, a_node_limit_is_obeyed_and_loses_only_the_rest, ()) {
  const ExactCover cover = arbitrary_cover();
  const auto all = solutions(cover);
  const SearchReport whole = cover.for_each_solution(ignore, SearchLimits{});
  RC_ASSERT(whole.outcome == SearchOutcome::complete);
  RC_ASSERT(whole.found == all.size());
  const auto nodes = *rc::gen::inRange<std::uint64_t>(0, whole.nodes + 2);
  std::vector<Rows> some;
  const SearchReport part = cover.for_each_solution(
      [&some](std::span<const std::size_t> rows) {
        some.push_back(sorted(rows));
        return true;
      },
      SearchLimits{.nodes = nodes, .stop = {}});
  RC_ASSERT(part.nodes == std::min(nodes, whole.nodes));
  RC_ASSERT((part.outcome == SearchOutcome::complete) == (nodes >= whole.nodes));
  RC_ASSERT(std::equal(some.begin(), some.end(), all.begin(),
                       all.begin() + static_cast<std::ptrdiff_t>(some.size())));
}

RC_GTEST_PROP(LargestPacking, covers_as_much_as_the_best_of_the_oracle, ()) {
  const ExactCover cover = arbitrary_cover();
  const Oracle oracle(cover);
  const LargestPacking best = cover.largest_packing();
  RC_ASSERT(oracle.is_packing(Oracle::subset_of(best.rows)));
  RC_ASSERT(oracle.gain(Oracle::subset_of(best.rows)) == best.covered);
  RC_ASSERT(best.covered == oracle.most_covered());
  RC_ASSERT(best.upper_bound == best.covered);
  RC_ASSERT(best.optimal);
  RC_ASSERT(std::is_sorted(best.rows.begin(), best.rows.end()));
}

RC_GTEST_PROP(LargestPacking, within_a_limit_claims_nothing_that_is_false, ()) {
  const ExactCover cover = arbitrary_cover();
  const Oracle oracle(cover);
  const auto nodes = *rc::gen::inRange<std::uint64_t>(0, 6);
  const LargestPacking best = cover.largest_packing({.nodes = nodes, .stop = {}});
  RC_ASSERT(best.nodes <= nodes);
  RC_ASSERT(oracle.is_packing(Oracle::subset_of(best.rows)));
  RC_ASSERT(oracle.gain(Oracle::subset_of(best.rows)) == best.covered);
  RC_ASSERT(best.covered <= oracle.most_covered());
  RC_ASSERT(best.upper_bound >= oracle.most_covered());
  RC_ASSERT(best.optimal == (best.covered == best.upper_bound));
  RC_ASSERT(best.optimal || best.outcome == SearchOutcome::limit);
}

RC_GTEST_PROP(MaximalPackings, are_those_of_the_oracle_each_once, ()) {
  const ExactCover cover = arbitrary_cover();
  const auto list = maximal_packings(cover);
  const std::set<Rows> set(list.begin(), list.end());
  RC_ASSERT(set.size() == list.size());
  RC_ASSERT(set == Oracle(cover).maximal_packings());
}

TEST(ExactCover, the_example_in_the_header_holds) {
  ExactCover k4(4);
  for (std::uint32_t b = 1; b < 4; ++b) {
    for (std::uint32_t a = 0; a < b; ++a) {
      k4.add_row({a, b});
    }
  }
  EXPECT_EQ(k4.count_solutions().value, 3U);
  EXPECT_EQ(k4.first_solution(), (std::vector<std::size_t>{0, 5}));
  SearchLimits limits{.nodes = 1'000'000, .stop = {}};
  FirstSolution first = k4.first_solution(limits);
  EXPECT_TRUE(first.rows && first.outcome == SearchOutcome::complete);
}

TEST(ExactCover, one_factors_of_complete_graphs_are_double_factorials) {
  EXPECT_EQ(matchings(8).count_solutions().value, 105U);
  EXPECT_EQ(matchings(14).count_solutions().value, 135'135U);
  EXPECT_EQ(matchings(7).count_solutions().value, 0U);
}

TEST(ExactCover, one_factorizations_of_K6_and_K8_number_6_and_6240) {
  const std::array<std::pair<std::uint32_t, std::uint64_t>, 3> known{{{4, 1}, {6, 6}, {8, 6240}}};
  for (const auto& [order, expected] : known) {
    const ExactCover edges = matchings(order);
    ExactCover factorizations(static_cast<std::uint32_t>(edges.row_count()));
    edges.for_each_solution([&factorizations](std::span<const std::size_t> factor) {
      factorizations.add_row(std::vector<std::uint32_t>(factor.begin(), factor.end()));
      return true;
    });
    EXPECT_EQ(factorizations.count_solutions().value, expected);
  }
}

TEST(ExactCover, partitions_of_a_set_are_counted_by_the_bell_numbers) {
  const std::array<std::uint64_t, 9> bell{1, 1, 2, 5, 15, 52, 203, 877, 4140};
  for (std::uint32_t n = 0; n < bell.size(); ++n) {
    ExactCover cover(n);
    for (std::uint32_t subset = 1; subset < 1U << n; ++subset) {
      std::vector<std::uint32_t> row;
      for (std::uint32_t i = 0; i < n; ++i) {
        if ((subset >> i & 1) == 1) {
          row.push_back(i);
        }
      }
      cover.add_row(row);
    }
    EXPECT_EQ(cover.count_solutions().value, bell[n]) << n;
  }
}

TEST(ExactCover, steiner_triple_systems_on_7_and_9_points_number_30_and_840) {
  const std::array<std::pair<std::uint32_t, std::uint64_t>, 4> known{
      {{5, 0}, {7, 30}, {8, 0}, {9, 840}}};
  for (const auto& [v, expected] : known) {
    const auto pair = [](std::uint32_t a, std::uint32_t b) { return b * (b - 1) / 2 + a; };
    ExactCover cover(v * (v - 1) / 2);
    for (std::uint32_t c = 2; c < v; ++c) {
      for (std::uint32_t b = 1; b < c; ++b) {
        for (std::uint32_t a = 0; a < b; ++a) {
          cover.add_row({pair(a, b), pair(a, c), pair(b, c)});
        }
      }
    }
    EXPECT_EQ(cover.count_solutions().value, expected) << v;
  }
}

TEST(ExactCover, queens_place_in_diagonals_that_are_secondary) {
  const std::array<std::uint64_t, 9> known{1, 1, 0, 0, 2, 10, 4, 40, 92};
  for (std::uint32_t n = 1; n < known.size(); ++n) {
    ExactCover cover(2 * n, 2 * (2 * n - 1));
    for (std::uint32_t x = 0; x < n; ++x) {
      for (std::uint32_t y = 0; y < n; ++y) {
        cover.add_row({x, n + y, 2 * n + x + y, 4 * n - 1 + x + n - 1 - y});
      }
    }
    EXPECT_EQ(cover.count_solutions().value, known[n]) << n;
  }
}

TEST(ExactCover, dominoes_tile_the_6_by_6_board_in_6728_ways) {
  ExactCover cover(36);
  for (std::uint32_t cell = 0; cell < 36; ++cell) {
    if (cell % 6 != 5) {
      cover.add_row({cell, cell + 1});
    }
    if (cell < 30) {
      cover.add_row({cell, cell + 6});
    }
  }
  EXPECT_EQ(cover.count_solutions().value, 6728U);
}

/// A piece turned and flipped in all ways, its least cell at the origin, each once.
std::set<std::vector<Cell>> orientations(std::vector<Cell> cells) {
  std::set<std::vector<Cell>> found;
  for (int turn = 0; turn < 8; ++turn) {
    for (Cell& cell : cells) {
      cell = turn == 4 ? Cell{cell.first, -cell.second} : Cell{-cell.second, cell.first};
    }
    std::vector<Cell> placed = cells;
    std::sort(placed.begin(), placed.end());
    const Cell least = placed.front();
    for (Cell& cell : placed) {
      cell = {cell.first - least.first, cell.second - least.second};
    }
    found.insert(placed);
  }
  return found;
}

std::vector<Cell> marked(const std::vector<std::string>& picture, char mark) {
  std::vector<Cell> cells;
  for (std::size_t y = 0; y < picture.size(); ++y) {
    for (std::size_t x = 0; x < picture[y].size(); ++x) {
      if (picture[y][x] == mark) {
        cells.emplace_back(static_cast<int>(x), static_cast<int>(y));
      }
    }
  }
  return cells;
}

/// Tilings of the dots of a board by the twelve pentominoes, each used once.
ExactCover pentominoes(const std::vector<std::string>& board) {
  const std::vector<std::vector<std::string>> pieces = {
      {".XX", "XX.", ".X."},    {"XXXXX"},
      {"X.", "X.", "X.", "XX"}, {".X", "XX", "X.", "X."},
      {"XX", "XX", "X."},       {"XXX", ".X.", ".X."},
      {"X.X", "XXX"},           {"X..", "X..", "XXX"},
      {"X..", "XX.", ".XX"},    {".X.", "XXX", ".X."},
      {".X", "XX", ".X", ".X"}, {"XX.", ".X.", ".XX"}};
  std::map<Cell, std::uint32_t> column;
  for (const Cell& cell : marked(board, '.')) {
    column.emplace(cell, static_cast<std::uint32_t>(pieces.size() + column.size()));
  }
  ExactCover cover(static_cast<std::uint32_t>(pieces.size() + column.size()));
  for (std::uint32_t piece = 0; piece < pieces.size(); ++piece) {
    for (const std::vector<Cell>& placed : orientations(marked(pieces[piece], 'X'))) {
      for (const auto& [origin, unused] : column) {
        std::vector<std::uint32_t> row{piece};
        for (const Cell& cell : placed) {
          const auto at = column.find({origin.first + cell.first, origin.second + cell.second});
          if (at != column.end()) {
            row.push_back(at->second);
          }
        }
        if (row.size() == 6) {
          cover.add_row(row);
        }
      }
    }
  }
  return cover;
}

TEST(ExactCover, pentominoes_fill_3_by_20_in_2_ways_up_to_symmetry) {
  EXPECT_EQ(pentominoes(std::vector<std::string>(3, std::string(20, '.'))).count_solutions().value,
            2U * 4U);
}

TEST(ExactCover, pentominoes_fill_8_by_8_without_its_centre_in_65_ways_up_to_symmetry) {
  std::vector<std::string> board(8, std::string(8, '.'));
  board[3] = board[4] = "...##...";
  const ExactCover cover = pentominoes(board);
  EXPECT_EQ(cover.row_count(), 1568U);  // as in [Knuth2000]
  EXPECT_EQ(cover.count_solutions().value, 65U * 8U);
}

TEST(ExactCover, without_primary_columns_there_is_the_empty_cover) {
  for (const ExactCover& cover : {ExactCover(0), ExactCover(0, 3)}) {
    EXPECT_EQ(solutions(cover), std::vector<Rows>{Rows{}});
    EXPECT_EQ(cover.for_each_solution(ignore, SearchLimits{.nodes = 0, .stop = {}}),
              (SearchReport{1, 0, SearchOutcome::complete}));
    EXPECT_EQ(cover.count_solutions().value, 1U);
    EXPECT_EQ(maximal_packings(cover), std::vector<Rows>{Rows{}});
    EXPECT_TRUE(cover.largest_packing().optimal);
  }
}

TEST(ExactCover, without_rows_nothing_is_covered) {
  const ExactCover cover(3, 1);
  EXPECT_EQ(cover.first_solution(SearchLimits{}),
            (FirstSolution{std::nullopt, 0, SearchOutcome::complete}));
  EXPECT_EQ(cover.count_solutions(), SolutionCount{});
  EXPECT_EQ(cover.largest_packing(), (LargestPacking{{}, 0, 0, true, 0, SearchOutcome::complete}));
  EXPECT_EQ(maximal_packings(cover), std::vector<Rows>{Rows{}});
}

TEST(ExactCover, equal_rows_are_different_rows) {
  ExactCover cover(2);
  for (int copy = 0; copy < 3; ++copy) {
    cover.add_row({1, 0});
  }
  EXPECT_EQ(solutions(cover), (std::vector<Rows>{{0}, {1}, {2}}));
  EXPECT_EQ(maximal_packings(cover), (std::vector<Rows>{{0}, {1}, {2}}));
  const auto row = cover.row(2);
  EXPECT_EQ(std::vector<std::uint32_t>(row.begin(), row.end()), (std::vector<std::uint32_t>{0, 1}));
}

TEST(ExactCover, refuses_rows_that_make_no_sense_and_stays_as_it_was) {
  ExactCover cover(3, 2);
  EXPECT_EQ(cover.add_row({4, 0}), 0U);
  EXPECT_REFUSAL(cover.add_row({0, 1, 0}), BadInput, "row 1 has column 0 twice");
  EXPECT_REFUSAL(cover.add_row({0, 4, 4}), BadInput, "row 1 has column 4 twice");
  EXPECT_REFUSAL(cover.add_row({0, 5}), BadInput, "row 1 has column 5, but there are only 5");
  for (const auto& none : std::vector<std::vector<std::uint32_t>>{{5}, {3, 4}, {}}) {
    EXPECT_REFUSAL(cover.add_row(none), BadInput,
                   " has no primary column (they are numbered below ");
  }
  EXPECT_EQ(cover.row_count(), 1U);
  EXPECT_EQ(cover.add_row({1, 2, 3}), 1U);
  EXPECT_EQ(solutions(cover), (std::vector<Rows>{{0, 1}}));
  EXPECT_THROW((void)cover.row(2), std::out_of_range);
}

TEST(ExactCover, as_many_rows_as_columns_do_not_overflow_the_stack) {
  constexpr std::uint32_t n = 65'535;
  ExactCover singles(n);
  ExactCover chain(n);  // overlapping triples: only every third one fits
  for (std::uint32_t c = 0; c < n; ++c) {
    singles.add_row({c});
    if (c + 2 < n) {
      chain.add_row({c, c + 1, c + 2});
    }
  }
  EXPECT_EQ(singles.first_solution()->size(), n);
  EXPECT_EQ(singles.largest_packing().covered, n);
  EXPECT_EQ(chain.count_solutions().value, 1U);
  EXPECT_TRUE(chain.largest_packing().optimal);
}

TEST(ExactCover, a_visitor_or_predicate_ends_the_search_with_stopped) {
  const ExactCover cover = matchings(8);
  std::uint64_t seen = 0;
  EXPECT_EQ(cover.for_each_solution([&seen](auto) { return ++seen < 10; }), 10U);
  EXPECT_EQ(cover.for_each_solution([](auto) { return false; }, SearchLimits{}).outcome,
            SearchOutcome::stopped);
  const SearchLimits at_once{.nodes = {}, .stop = [] { return true; }};
  EXPECT_EQ(cover.for_each_solution(ignore, at_once), (SearchReport{0, 0, SearchOutcome::stopped}));
  EXPECT_EQ(cover.first_solution(at_once),
            (FirstSolution{std::nullopt, 0, SearchOutcome::stopped}));
  EXPECT_EQ(cover.count_solutions({}, at_once).outcome, SearchOutcome::stopped);
  EXPECT_EQ(cover.for_each_maximal_packing(ignore, at_once).outcome, SearchOutcome::stopped);
  EXPECT_EQ(cover.for_each_maximal_packing([](auto) { return false; }),
            (SearchReport{1, 4, SearchOutcome::stopped}));
  const LargestPacking none = cover.largest_packing(at_once);
  EXPECT_EQ(none, (LargestPacking{{}, 0, 8, false, 0, SearchOutcome::stopped}));

  int asked = 0;
  const SearchLimits later{.nodes = {}, .stop = [&asked] { return ++asked == 3; }};
  EXPECT_EQ(matchings(14).for_each_solution(ignore, later).nodes, 512U);
}

TEST(ExactCover, a_search_that_needs_exactly_the_limit_is_complete) {
  const ExactCover cover = matchings(8);
  const std::uint64_t needed = cover.count_solutions().nodes;
  const auto within = [&cover](std::uint64_t nodes) {
    return cover.count_solutions({}, {.nodes = nodes, .stop = {}});
  };
  EXPECT_EQ(within(needed).outcome, SearchOutcome::complete);
  EXPECT_EQ(within(needed - 1).outcome, SearchOutcome::limit);
  EXPECT_EQ(within(needed - 1).nodes, needed - 1);
}

TEST(ExactCover, searching_twice_gives_the_same_in_the_same_order) {
  const ExactCover cover = matchings(8);
  EXPECT_EQ(solutions(cover), solutions(cover));
  EXPECT_EQ(cover.count_solutions(), cover.count_solutions());
  EXPECT_EQ(cover.largest_packing(), cover.largest_packing());
  EXPECT_EQ(maximal_packings(cover), maximal_packings(cover));
}

TEST(CountSolutions, saturates_at_64_bits_and_says_so) {
  const auto power = [](std::uint32_t columns, std::uint64_t multiplicity) {
    ExactCover cover(columns);
    for (std::uint32_t c = 0; c < columns; ++c) {
      cover.add_row({c});
    }
    return cover.count_solutions(std::vector<std::uint64_t>(columns, multiplicity));
  };
  EXPECT_EQ(power(63, 2),
            (SolutionCount{std::uint64_t{1} << 63, false, 63, SearchOutcome::complete}));
  EXPECT_EQ(power(64, 2), (SolutionCount{largest, true, 64, SearchOutcome::limit}));
  EXPECT_EQ(power(1, largest), (SolutionCount{largest, false, 1, SearchOutcome::complete}));

  ExactCover sum(1);
  sum.add_row({0});
  sum.add_row({0});
  EXPECT_EQ(sum.count_solutions(std::vector<std::uint64_t>{largest, 0}).saturated, false);
  EXPECT_EQ(sum.count_solutions(std::vector<std::uint64_t>{largest - 1, 1}).value, largest);
  EXPECT_EQ(sum.count_solutions(std::vector<std::uint64_t>{largest - 1, 1}).saturated, false);
  EXPECT_EQ(sum.count_solutions(std::vector<std::uint64_t>{largest, 1}).saturated, true);
}

TEST(CountSolutions, leaves_out_rows_of_multiplicity_0_before_anything_overflows) {
  const std::vector<std::uint64_t> weights{largest, 0, 0, 0, 0, 0};
  EXPECT_EQ(matchings(4).count_solutions(weights), SolutionCount{});
}

TEST(LargestPacking, of_triples_with_pairs_covered_at_most_once_on_8_points_has_8_triples) {
  const auto pair = [](std::uint32_t a, std::uint32_t b) { return b * (b - 1) / 2 + a; };
  ExactCover cover(28);
  for (std::uint32_t c = 2; c < 8; ++c) {
    for (std::uint32_t b = 1; b < c; ++b) {
      for (std::uint32_t a = 0; a < b; ++a) {
        cover.add_row({pair(a, b), pair(a, c), pair(b, c)});
      }
    }
  }
  const LargestPacking best = cover.largest_packing();
  EXPECT_EQ(best.rows.size(), 8U);
  EXPECT_EQ(best.covered, 24U);
  EXPECT_TRUE(best.optimal);
}

TEST(LargestPacking, knows_at_once_that_edges_cannot_match_an_odd_number_of_vertices) {
  const LargestPacking best = matchings(9).largest_packing();
  EXPECT_EQ(best.covered, 8U);
  EXPECT_EQ(best.nodes, 4U);  // the bound is a multiple of 2
}

TEST(MaximalPackings, of_edges_are_the_maximal_matchings) {
  // K_n, n odd: leave one vertex and match the others.
  EXPECT_EQ(matchings(7).for_each_maximal_packing(ignore).found, 7U * 15U);
  EXPECT_EQ(matchings(8).for_each_maximal_packing(ignore).found, 105U);
}

TEST(MaximalPackings, forced_choices_take_no_levels) {
  constexpr std::uint32_t n = 4000;
  ExactCover cover(n);
  for (std::uint32_t c = 0; c < n; ++c) {
    cover.add_row({c});
  }
  EXPECT_EQ(cover.for_each_maximal_packing(ignore), (SearchReport{1, n, SearchOutcome::complete}));
}

}  // namespace
}  // namespace changeover::exact_cover_test
