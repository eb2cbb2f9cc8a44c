#include "plan/search/bounds/least_sum.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "run/random.hpp"

namespace changeover::least_sum_test {
namespace {

struct Program {
  std::vector<double> costs;
  std::vector<LeastSum::Row> rows;
  std::vector<std::int64_t> least;
};

Program random_program(std::uint64_t seed) {
  Random random(seed);
  Program program;
  program.costs.resize(1 + random.below(12));
  for (double& cost : program.costs) {
    cost = random.below(10);
  }
  program.rows.resize(1 + random.below(15));
  for (LeastSum::Row& row : program.rows) {
    for (std::size_t j = 0; j < program.costs.size(); ++j) {
      const std::int64_t factor = std::int64_t{random.below(9)} - (seed % 3 == 0 ? 4 : 2);
      if (random.below(3) > 0) {
        row.push_back({j, factor});
      }
    }
    program.least.push_back(std::int64_t{random.below(20)} - 5);
  }
  return program;
}

// What the prices prove: nothing if some column is charged more than it costs.
std::optional<double> proved(const Program& program, const LeastSum& solved) {
  std::vector<double> charged(program.costs.size(), 0);
  double sum = 0;
  for (std::size_t i = 0; i < program.rows.size(); ++i) {
    if (solved.price(i) < 0) {
      return std::nullopt;
    }
    sum += solved.price(i) * static_cast<double>(program.least[i]);
    for (const LeastSum::Term& term : program.rows[i]) {
      charged[term.column] += solved.price(i) * static_cast<double>(term.factor);
    }
  }
  for (std::size_t j = 0; j < charged.size(); ++j) {
    if (charged[j] > program.costs[j] + 1e-4) {
      return std::nullopt;
    }
  }
  return sum;
}

// Stopped early, the table may hold a negative number for a column.
TEST(LeastSum, NoValueIsNegativeWhenTheWorkEnds) {
  LeastSum program({1, 2});
  program.add({{0, 20}, {1, 20}}, 100);
  program.add({{1, 1}}, 10);
  std::uint64_t work = 12;  // two pivots of 2 rows and 3 numbers
  ASSERT_EQ(program.solve(work), LeastSum::End::worked);
  EXPECT_EQ(program.value(0), 0.0);
  EXPECT_EQ(program.value(1), 10.0);
}

// Values that satisfy all rows and prices that prove their sum are each the best.
TEST(LeastSum, HasValuesAndPricesOfTheSameSumOrPricesThatProveThatThereAreNone) {
  std::uint64_t solved = 0;
  std::uint64_t impossible = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    const Program program = random_program(seed);
    LeastSum sum(program.costs);
    std::uint64_t work = 1'000'000;
    constexpr double enough = 1000;
    LeastSum::End end = LeastSum::End::solved;
    for (std::size_t i = 0; i < program.rows.size(); ++i) {
      sum.add(program.rows[i], program.least[i]);
      if (i % 4 == 3 && end == LeastSum::End::solved) {
        end = sum.solve(work);  // Rows may come at any time.
      }
    }
    if (end == LeastSum::End::impossible) {
      continue;
    }
    end = sum.solve(work, enough);
    const std::optional<double> least = proved(program, sum);
    ASSERT_TRUE(least.has_value()) << seed;
    if (end == LeastSum::End::impossible) {
      EXPECT_GE(*least, enough * 0.999) << seed;
      ++impossible;
      continue;
    }
    ASSERT_EQ(end, LeastSum::End::solved) << seed;
    double cost = 0;
    for (std::size_t j = 0; j < program.costs.size(); ++j) {
      EXPECT_GE(sum.value(j), -1e-6) << seed;
      cost += program.costs[j] * sum.value(j);
    }
    for (std::size_t i = 0; i < program.rows.size(); ++i) {
      double all = 0;
      for (const LeastSum::Term& term : program.rows[i]) {
        all += static_cast<double>(term.factor) * sum.value(term.column);
      }
      EXPECT_GE(all, static_cast<double>(program.least[i]) - 1e-5) << seed;
    }
    EXPECT_NEAR(cost, *least, 1e-4) << seed;
    ++solved;
  }
  EXPECT_GT(solved, 1000U);
  EXPECT_GT(impossible, 150U);
}

TEST(LeastSum, ProvesLessWhenItIsEndedEarly) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Program program = random_program(seed);
    double before = 0;
    for (std::uint64_t pivots = 0; pivots < 6; ++pivots) {
      LeastSum sum(program.costs);
      for (std::size_t i = 0; i < program.rows.size(); ++i) {
        sum.add(program.rows[i], program.least[i]);
      }
      std::uint64_t work = pivots * program.rows.size() * (program.costs.size() + 1);
      if (sum.solve(work) != LeastSum::End::worked) {
        break;
      }
      const std::optional<double> least = proved(program, sum);
      ASSERT_TRUE(least.has_value()) << seed;
      EXPECT_GE(*least, before - 1e-6) << seed;
      before = *least;
    }
  }
}

}  // namespace
}  // namespace changeover::least_sum_test
