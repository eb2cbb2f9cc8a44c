// Linear programs for bounds: min Σ c_j·x_j where Σ a_ij·x_j ≥ b_i and x_j ≥ 0, c_j ≥ 0; rows are
// added between calls of solve().
//
//     LeastSum program({3, 2});          // 3x + 2y
//     program.add({{0, 1}, {1, 1}}, 5);  // x + y ≥ 5
//     program.add({{0, 2}}, 4);          // 2x ≥ 4
//     std::uint64_t work = 1'000'000;
//     program.solve(work);
//     program.value(0);                  // 2
//     program.price(1);                  // 0.5: a unit more of the second row costs so much
//
// The dual simplex method on a dense table [Lemke1954]. It uses rounded numbers, so its results are
// proposals. With any prices ≥ 0 of the rows, Σ price·b_i is a lower bound if Σ price·a_ij ≤ c_j
// for every column; a caller that needs a proof checks that in integers. After every pivot the
// prices satisfy this, up to rounding, so the method can be stopped at any time. Deterministic:
// floating point with + − × ÷ and comparisons only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace changeover {

class LeastSum {
 public:
  struct Term {
    std::size_t column = 0;
    std::int64_t factor = 0;
  };
  using Row = std::vector<Term>;

  /// One cost per column, none negative.
  explicit LeastSum(const std::vector<double>& costs);

  /// Adds the row Σ factor · value ≥ least. O(columns · terms).
  void add(const Row& row, std::int64_t least);

  enum class End { solved, impossible, worked };
  /// Computes the least sum for these rows, continuing from the last solve(). `impossible` if no
  /// values satisfy the rows: then there are prices for any sum above `enough`, and price() returns
  /// them. `worked` if `work` numbers were computed before the end; `work` becomes what is left.
  /// Stopped if the scope of this thread (run/control.hpp) requests it; the prices are then as
  /// valid as before.
  End solve(std::uint64_t& work, double enough = 0);

  /// A value in the last table; at least 0 even if solve() did not end.
  [[nodiscard]] double value(std::size_t column) const;
  [[nodiscard]] double price(std::size_t row) const;
  [[nodiscard]] std::size_t rows() const { return table_.size(); }

 private:
  // A variable of the table: a column of the program, or the slack of a row.
  static constexpr std::size_t no_place = static_cast<std::size_t>(-1);
  void pivot(std::size_t row, std::size_t place);
  void raise(std::size_t row, double enough);

  std::size_t columns_;
  std::vector<std::vector<double>> table_;  // by basic variable: its value where all others are 0,
                                            // and its increase per unit of each of them
  std::vector<double> reduced_;             // by place: cost per unit
  double sum_ = 0;                          // the sum where all of these are 0
  std::size_t raised_ = no_place;           // a basic variable that has a cost, too
  double raised_by_ = 0;
  std::vector<std::size_t> basic_;     // by row of the table: a variable
  std::vector<std::size_t> free_;      // by place: a variable
  std::vector<std::size_t> row_of_;    // by variable, or no_place
  std::vector<std::size_t> place_of_;  // by variable, or no_place
};

}  // namespace changeover
