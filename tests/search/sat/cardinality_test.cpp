#include "search/sat/cardinality.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "search/sat/sat_solver.hpp"

namespace changeover::cardinality_test {
namespace {

std::vector<Literal> some_literals(Cnf& cnf, std::size_t size) {
  std::vector<Literal> literals;
  for (std::size_t i = 0; i < size; ++i) {
    literals.push_back(i % 3 == 1 ? -cnf.new_variable() : cnf.new_variable());
  }
  return literals;
}

/// The literals of which those hold whose bit is set.
std::vector<Literal> chosen(const std::vector<Literal>& literals, unsigned bits) {
  std::vector<Literal> assumptions;
  for (std::size_t i = 0; i < literals.size(); ++i) {
    assumptions.push_back(((bits >> i) & 1U) != 0 ? literals[i] : -literals[i]);
  }
  return assumptions;
}

TEST(Cardinality, IsExactlyAsLargeAsItWasForetold) {
  for (std::size_t size = 0; size <= 20; ++size) {
    for (std::size_t number = 0; number <= size + 2; ++number) {
      const auto grown = [&](const auto& add) {
        Cnf cnf;
        const auto literals = some_literals(cnf, size);
        const CnfSize before = cnf.size();
        add(cnf, literals);
        const CnfSize after = cnf.size();
        return CnfSize{after.variables - before.variables, after.clauses - before.clauses,
                       after.literals - before.literals};
      };
      EXPECT_EQ(grown([&](Cnf& cnf, const auto& x) { (void)unary_count(cnf, x, number); }),
                unary_count_size(size, number));
      EXPECT_EQ(grown([&](Cnf& cnf, const auto& x) { require_exactly(cnf, x, number); }),
                exactly_size(size, number));
      EXPECT_EQ(grown([&](Cnf& cnf, const auto& x) { require_at_most(cnf, x, number); }),
                at_most_size(size, number));
    }
  }
}

bool possible(const Cnf& cnf, std::vector<Literal> assumptions) {
  RunControl control({});
  return solve_sat(cnf, assumptions, {}, control).outcome == Outcome::found;
}

TEST(UnaryCount, SaysHowManyHoldInBothDirections) {
  for (std::size_t size = 1; size <= 5; ++size) {
    for (std::size_t limit = 0; limit <= size + 1; ++limit) {
      Cnf cnf;
      const auto literals = some_literals(cnf, size);
      const auto at_least = unary_count(cnf, literals, limit);
      ASSERT_EQ(at_least.size(), std::min(size, limit));
      for (unsigned bits = 0; bits < (1U << size); ++bits) {
        const auto number = static_cast<std::size_t>(std::popcount(bits));
        for (std::size_t j = 0; j < at_least.size(); ++j) {
          auto assumptions = chosen(literals, bits);
          assumptions.push_back(number > j ? at_least[j] : -at_least[j]);
          EXPECT_TRUE(possible(cnf, assumptions));
          assumptions.back() = -assumptions.back();
          EXPECT_FALSE(possible(cnf, assumptions));
        }
      }
    }
  }
}

TEST(Cardinality, AllowsExactlyTheRightNumbers) {
  for (std::size_t size = 0; size <= 5; ++size) {
    for (std::size_t number = 0; number <= size + 1; ++number) {
      Cnf exactly;
      const auto some = some_literals(exactly, size);
      require_exactly(exactly, some, number);
      Cnf at_most;
      const auto others = some_literals(at_most, size);
      require_at_most(at_most, others, number);
      for (unsigned bits = 0; bits < (1U << size); ++bits) {
        const auto count = static_cast<std::size_t>(std::popcount(bits));
        EXPECT_EQ(possible(exactly, chosen(some, bits)), count == number);
        EXPECT_EQ(possible(at_most, chosen(others, bits)), count <= number);
      }
    }
  }
}

}  // namespace
}  // namespace changeover::cardinality_test
