// Exact covers and packings by dancing links.
//
// Given rows, each a set of columns, an exact cover is a set of rows that meets every primary
// column once and every secondary column at most once; a packing meets every column at most once.
// An expansion set is an exact cover of the v elements by unchanged subsets; a 1-factorization is
// one of the edges of K_n by its 1-factors.
//
//     ExactCover matchings(4);                          // the vertices of K_4 …
//     for (std::uint32_t b = 1; b < 4; ++b) {
//       for (std::uint32_t a = 0; a < b; ++a) {
//         matchings.add_row({a, b});                    // … covered by its edges 01 02 12 03 13 23
//       }
//     }
//     assert(matchings.count_solutions().value == 3);
//     assert(matchings.first_solution() == (std::vector<std::size_t>{0, 5}));
//     SearchLimits limits{.nodes = 1'000'000, .stop = {}};
//     FirstSolution first = matchings.first_solution(limits);
//     if (!first.rows && first.outcome == SearchOutcome::complete) { /* proved: there is none */ }
//
// Searching changes nothing in the object: several threads may search the same one. Everything is
// deterministic: the same rows give the same solutions in the same order with the same node count.
// No search recurses, so a cover by 65,535 rows needs no deep stack.
//
// Not done here: colours of secondary columns, columns to be covered several times, memoisation;
// the bound of largest_packing() is a plain count, not a linear program.
// References: dancing links, the choice of the smallest column, secondary columns [Knuth2000];
// maximal packings as maximal cliques [BronKerbosch1973], their pivot [TomitaTanakaTakahashi2006].
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <vector>

#include "changeover/construct/expansion.hpp"

namespace changeover {

/// Why a search ended: it had seen everything; it reached SearchLimits::nodes (or a count left 64
/// bits); the caller ended it, by `stop` or by what `visit` returned.
enum class SearchOutcome : std::uint8_t { complete, limit, stopped };

/// What a search that lists things did.
struct SearchReport {
  std::uint64_t found = 0;  ///< things handed to `visit`
  std::uint64_t nodes = 0;  ///< branches tried
  SearchOutcome outcome = SearchOutcome::complete;

  bool operator==(const SearchReport&) const = default;
};

/// The answer of ExactCover::first_solution(). No rows and `complete` together: there is none.
struct FirstSolution {
  std::optional<std::vector<std::size_t>> rows;  ///< ascending
  std::uint64_t nodes = 0;
  SearchOutcome outcome = SearchOutcome::complete;  ///< `complete` also if a solution was found

  bool operator==(const FirstSolution&) const = default;
};

/// The answer of ExactCover::count_solutions(); a lower bound unless the outcome is `complete`.
struct SolutionCount {
  std::uint64_t value = 0;
  bool saturated = false;  ///< the number exceeds 2⁶⁴ − 1, which `value` then is, outcome `limit`
  std::uint64_t nodes = 0;
  SearchOutcome outcome = SearchOutcome::complete;

  bool operator==(const SolutionCount&) const = default;
};

/// The answer of ExactCover::largest_packing().
struct LargestPacking {
  std::vector<std::size_t> rows;  ///< pairwise disjoint, ascending
  std::uint64_t covered = 0;      ///< primary columns that they cover
  std::uint64_t upper_bound = 0;  ///< no packing covers more
  bool optimal = false;           ///< covered == upper_bound: proved, even if a limit struck
  std::uint64_t nodes = 0;
  SearchOutcome outcome = SearchOutcome::complete;

  bool operator==(const LargestPacking&) const = default;
};

/// A list of rows over primary columns 0, …, p−1 and secondary columns p, …, p+s−1. Rows are known
/// by the order in which they were added, from 0; equal rows are different rows.
class ExactCover {
 public:
  /// Takes row numbers; false ends the search. The span is valid only during the call.
  using Visit = std::function<bool(std::span<const std::size_t>)>;

  /// @throws ImpossibleParameters if there are 2³² − 2 columns or more.
  explicit ExactCover(std::uint32_t primary_count, std::uint32_t secondary_count = 0);

  /// Adds a row and returns its number.
  /// @param columns distinct, in any order, at least one of them primary: a row of secondary
  ///   columns only could be joined to a solution or not, at will.
  /// @throws BadInput if that is not so, ImpossibleParameters if entries, rows and columns together
  ///   come near 2³².
  std::size_t add_row(std::span<const std::uint32_t> columns);
  std::size_t add_row(std::initializer_list<std::uint32_t> columns) {
    return add_row(std::span<const std::uint32_t>(columns.begin(), columns.size()));
  }

  [[nodiscard]] std::uint32_t primary_count() const { return primary_count_; }
  [[nodiscard]] std::uint32_t column_count() const { return column_count_; }
  [[nodiscard]] std::size_t row_count() const { return row_begin_.size() - 1; }

  /// The columns of a row, ascending. Valid until the next add_row().
  [[nodiscard]] std::span<const std::uint32_t> row(std::size_t index) const;

  /// Hands every exact cover to `visit`, once, its rows in the order in which they were chosen.
  /// Without primary columns there is one, the empty one. A node is a row tried in the column that
  /// has the fewest rows left (the first such column).
  /// @return the number handed over; the overload with limits says also why it ended.
  std::uint64_t for_each_solution(const Visit& visit) const {
    return for_each_solution(visit, SearchLimits{}).found;
  }
  SearchReport for_each_solution(const Visit& visit, const SearchLimits& limits) const;

  /// One exact cover, its rows ascending; nullopt if there is none.
  [[nodiscard]] std::optional<std::vector<std::size_t>> first_solution() const {
    return first_solution(SearchLimits{}).rows;
  }
  [[nodiscard]] FirstSolution first_solution(const SearchLimits& limits) const;

  /// The number of exact covers; with multiplicities, the sum over the exact covers of the products
  /// of their rows' multiplicities, as if each row had been added that many times.
  /// @param multiplicities one a row, or none at all.
  /// @throws BadInput if their number is wrong.
  /// @note Counts by visiting: the time is that of for_each_solution().
  [[nodiscard]] SolutionCount count_solutions(std::span<const std::uint64_t> multiplicities = {},
                                              const SearchLimits& limits = {}) const;

  /// A packing that covers the most primary columns, by branch and bound: a node takes a row in the
  /// smallest column, or leaves that column uncovered. The bound counts the columns that can still
  /// be covered, rounded down to a multiple of the greatest common divisor of the rows' sizes. If a
  /// limit strikes, the best packing so far.
  [[nodiscard]] LargestPacking largest_packing(const SearchLimits& limits = {}) const;

  /// Hands every packing to which no row can be added to `visit`, once, its rows in the order in
  /// which they were chosen. Without rows there is one, the empty one.
  /// @note Takes row_count()² bits, and row_count() bits more a branching level.
  SearchReport for_each_maximal_packing(const Visit& visit, const SearchLimits& limits = {}) const;

 private:
  std::uint32_t primary_count_;
  std::uint32_t column_count_;
  std::vector<std::uint32_t> entries_;
  std::vector<std::size_t> row_begin_{0};
};

}  // namespace changeover
