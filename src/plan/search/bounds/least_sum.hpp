// Linear programs of bounds: min Σ c_j·x_j where Σ a_ij·x_j ≥ b_i and x_j ≥ 0, c_j ≥ 0, and rows
// come while it is solved.
//
//     LeastSum program({3, 2});          // 3x + 2y
//     program.add({{0, 1}, {1, 1}}, 5);  // x + y ≥ 5
//     program.add({{0, 2}}, 4);          // 2x ≥ 4
//     std::uint64_t work = 1'000'000;
//     program.solve(work);
//     program.value(0);                  // 2
//     program.price(1);                  // 0.5: a unit more of the second row costs so much
//
// The dual simplex method on a dense table [Lemke1954]. It computes with rounded numbers, so what
// it says is a proposal: with any prices ≥ 0 of the rows, Σ price·b_i is a lower bound if no
// column's Σ price·a_ij exceeds c_j, and who needs a proof checks that in whole numbers. After
// every pivot the prices are such, up to rounding, so it may be stopped at any time.
// Deterministic: floating point with + − × ÷ and comparisons only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace changeover {

class LeastSum {
 public:
  struct Term {
    std::size_t column = 0;
    std::int64_t factor = 0;
  };
  using Row = std::vector<Term>;

  /// One cost a column, none negative.
  explicit LeastSum(const std::vector<double>& costs);

  /// Σ factor · value ≥ least. O(columns · terms).
  void add(const Row& row, std::int64_t least);

  enum class End { solved, impossible, worked };
  /// The least sum for these rows, from where the last solve() ended. Impossible if no values
  /// satisfy the rows: a larger sum than `enough` then has prices, too, and these are they. Worked
  /// if so many numbers were computed before; `work` is what is left of them. Stopped if the scope
  /// of this thread (run/control.hpp) wants to stop; the prices are then as good as they were.
  End solve(std::uint64_t& work, double enough = 0);

  /// Of the last table; no less than 0 even if solve() has not ended.
  [[nodiscard]] double value(std::size_t column) const;
  [[nodiscard]] double price(std::size_t row) const;
  [[nodiscard]] std::size_t rows() const { return table_.size(); }

 private:
  // What stands in the table: a column of the program, or what a row has more than it must.
  static constexpr std::size_t no_place = static_cast<std::size_t>(-1);
  void pivot(std::size_t row, std::size_t place);
  void raise(std::size_t row, double enough);

  std::size_t columns_;
  std::vector<std::vector<double>> table_;  // by basic variable: its value where all others are 0,
                                            // and by how much each of them raises it
  std::vector<double> reduced_;             // by place: what a unit of it costs
  double sum_ = 0;                          // where all of these are 0
  std::size_t raised_ = no_place;           // a basic variable that costs something, too
  double raised_by_ = 0;
  std::vector<std::size_t> basic_;     // by row of the table: a variable
  std::vector<std::size_t> free_;      // by place: a variable
  std::vector<std::size_t> row_of_;    // by variable, or no_place
  std::vector<std::size_t> place_of_;  // by variable, or no_place
};

}  // namespace changeover
