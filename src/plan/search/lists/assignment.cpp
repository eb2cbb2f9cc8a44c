#include "plan/search/lists/assignment.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace changeover {

std::int64_t cheapest_assignment(std::size_t rows, std::size_t columns,
                                 std::span<const std::int64_t> costs) {
  if (rows == 0) {
    return 0;
  }
  if (rows == 1) {
    return *std::min_element(costs.begin(), costs.begin() + static_cast<std::ptrdiff_t>(columns));
  }
  if (rows == 2 && columns == 2) {
    return std::min(costs[0] + costs[3], costs[1] + costs[2]);
  }
  constexpr std::int64_t far = std::numeric_limits<std::int64_t>::max();
  // Rows and columns count from 1: column 0 holds the row that is being assigned.
  std::vector<std::int64_t> of_row(rows + 1, 0);
  std::vector<std::int64_t> of_column(columns + 1, 0);
  std::vector<std::size_t> row_in(columns + 1, 0);
  std::vector<std::size_t> before(columns + 1, 0);
  std::vector<std::int64_t> distance;
  std::vector<bool> reached;
  for (std::size_t row = 1; row <= rows; ++row) {
    row_in[0] = row;
    std::size_t column = 0;
    distance.assign(columns + 1, far);
    reached.assign(columns + 1, false);
    while (row_in[column] != 0) {
      reached[column] = true;
      const std::size_t from = row_in[column];
      std::int64_t least = far;
      std::size_t next = 0;
      for (std::size_t j = 1; j <= columns; ++j) {
        if (reached[j]) {
          continue;
        }
        const std::int64_t length =
            costs[(from - 1) * columns + j - 1] - of_row[from] - of_column[j];
        if (length < distance[j]) {
          distance[j] = length;
          before[j] = column;
        }
        if (distance[j] < least) {
          least = distance[j];
          next = j;
        }
      }
      for (std::size_t j = 0; j <= columns; ++j) {
        if (reached[j]) {
          of_row[row_in[j]] += least;
          of_column[j] -= least;
        } else {
          distance[j] -= least;
        }
      }
      column = next;
    }
    while (column != 0) {
      row_in[column] = row_in[before[column]];
      column = before[column];
    }
  }
  return -of_column[0];
}

}  // namespace changeover
