// The assignments of the search against trying all of them.
#include "plan/search/lists/assignment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <vector>

#include "run/random.hpp"

namespace changeover::assignment_test {
namespace {

std::int64_t by_trying(std::size_t rows, std::size_t columns,
                       const std::vector<std::int64_t>& costs) {
  std::vector<std::size_t> column(columns);
  std::iota(column.begin(), column.end(), std::size_t{0});
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  do {
    std::int64_t sum = 0;
    for (std::size_t row = 0; row < rows; ++row) {
      sum += costs[row * columns + column[row]];
    }
    least = std::min(least, sum);
  } while (std::next_permutation(column.begin(), column.end()));
  return least;
}

TEST(Assignment, IsTheCheapest) {
  Random random(7, 7);
  for (int turn = 0; turn < 400; ++turn) {
    const std::size_t columns = 1 + random.below(6);
    const std::size_t rows = random.below(static_cast<std::uint32_t>(columns) + 1);
    std::vector<std::int64_t> costs(rows * columns);
    for (std::int64_t& cost : costs) {
      cost = random.below(turn % 2 == 0 ? 5 : 1'000'000);
    }
    EXPECT_EQ(cheapest_assignment(rows, columns, costs), by_trying(rows, columns, costs))
        << rows << " by " << columns << ", turn " << turn;
  }
}

TEST(Assignment, OfTheExample) {
  EXPECT_EQ(cheapest_assignment(2, 3, std::array<std::int64_t, 6>{4, 1, 3, 2, 0, 5}), 3);
  EXPECT_EQ(cheapest_assignment(0, 3, {}), 0);
}

}  // namespace
}  // namespace changeover::assignment_test
