#include "search/exact/exact_encoding.hpp"

#include <gtest/gtest.h>

#include <map>
#include <utility>
#include <vector>

#include "changeover/core/error.hpp"
#include "exact_oracle.hpp"
#include "naive_verdict.hpp"
#include "search/sat/sat_solver.hpp"

namespace changeover::exact_encoding_test {
namespace {

std::optional<Design> solution(const Parameters& p, std::uint64_t b,
                               const EncodingOptions& options) {
  const DesignFormula formula = encode_design(p, b, options);
  RunControl control({});
  const SatResult result = solve_sat(formula.cnf(), {}, {}, control);
  EXPECT_NE(result.outcome, Outcome::unknown);
  if (result.outcome != Outcome::found) {
    return std::nullopt;
  }
  return formula.decode([&](Literal x) { return result.is_true(x); });
}

// Every (v, k, m, t, kind) with v at most this, every b, as far as the oracle gets.
void hold_against_oracle(std::uint64_t most_v, std::uint64_t most_b, std::uint64_t nodes,
                         const EncodingOptions& options, std::size_t at_least) {
  std::map<bool, std::size_t> decided;
  for (std::uint64_t v = 2; v <= most_v; ++v) {
    for (std::uint64_t k = 2; k <= v; ++k) {
      for (std::uint64_t m = 1; m <= k; ++m) {
        for (std::uint32_t t = 2; t <= std::min<std::uint64_t>(k, max_strength); ++t) {
          for (const Kind kind : {Kind::linear, Kind::circular}) {
            const Parameters p{.v = v, .k = k, .change = m, .kind = kind, .strength = t};
            test::ExistenceOracle oracle(p);
            for (std::uint64_t b = 1; b <= most_b; ++b) {
              const std::optional<bool> exists = oracle.exists(b, nodes);
              if (!exists) {
                break;  // it only gets harder
              }
              const std::optional<Design> design = solution(p, b, options);
              ASSERT_EQ(design.has_value(), *exists) << name(p) << " with " << b << " blocks";
              ++decided[*exists];
              if (design) {
                ASSERT_EQ(design->block_count(), b);
                ASSERT_TRUE(test::naive_verdict(*design).valid) << name(p) << ", b = " << b;
              }
            }
          }
        }
      }
    }
  }
  EXPECT_GE(decided[false], at_least);
  EXPECT_GE(decided[true], at_least);
}

TEST(ExactEncoding, HasASolutionExactlyWhereBruteForceFindsADesign) {
  hold_against_oracle(6, 9, 20'000, {}, 100);
}

TEST(ExactEncoding, IsRightWithoutSymmetryBreaking) {
  hold_against_oracle(5, 7, 20'000, {.order = false}, 50);
}

TEST(ExactEncoding, IsRightWithoutDegrees) {
  hold_against_oracle(5, 7, 20'000, {.degrees = false}, 50);
}

TEST(ExactEncoding, IsRightWithoutABudget) { hold_against_oracle(5, 7, 20'000, {.budget = 0}, 50); }

TEST(ExactEncoding, IsRightWithALargeBudget) {
  hold_against_oracle(5, 7, 20'000, {.budget = 100}, 50);
}

TEST(ExactEncoding, IsRightForMoreElementsSlow) { hold_against_oracle(8, 12, 2'000'000, {}, 500); }

// Elements in every block, whose pairs are never newly covered, let a circular design have fewer
// blocks.
TEST(ExactEncoding, AllowsForFixedElements) {
  for (std::uint64_t k = 3; k <= 8; ++k) {
    const Parameters p{.v = k + 1, .k = k, .change = 1, .kind = Kind::circular};
    const std::optional<Design> design = solution(p, 3, {});
    ASSERT_TRUE(design.has_value()) << k;
    EXPECT_TRUE(test::naive_verdict(*design).valid);
    EXPECT_FALSE(solution(p, 2, {}).has_value());
  }
  EXPECT_TRUE(solution({.v = 8, .k = 6, .kind = Kind::circular}, 3, {}).has_value());
  EXPECT_TRUE(solution({.v = 12, .k = 9, .change = 3, .kind = Kind::circular}, 3, {}).has_value());
}

TEST(ExactEncoding, IsTheSameEveryTime) {
  const Parameters p{.v = 9, .k = 4, .change = 1};
  const DesignFormula one = encode_design(p, 11);
  const DesignFormula two = encode_design(p, 11);
  EXPECT_TRUE(std::equal(one.cnf().literals().begin(), one.cnf().literals().end(),
                         two.cnf().literals().begin(), two.cnf().literals().end()));
}

TEST(ExactEncoding, RefusesImpossibleParametersAndTooLargeOnes) {
  EXPECT_THROW((void)encode_design({.v = 3, .k = 4}, 2), ImpossibleParameters);
  EXPECT_THROW((void)encode_design({.v = 60'000, .k = 4}, 60'000), MissingResource);
}

// Every (v, k, m, t, kind, b) up to here, with every kind of clauses.
TEST(ExactEncoding, IsExactlyAsLargeAsItWasForetold) {
  const std::vector<EncodingOptions> all{{},
                                         {.order = false, .budget = 0},
                                         {.degrees = false, .budget = 1},
                                         {.order = false, .degrees = false, .budget = 100}};
  std::size_t formulas = 0;
  for (std::uint64_t v = 2; v <= 8; ++v) {
    for (std::uint64_t k = 2; k <= v; ++k) {
      for (std::uint64_t m = 1; m <= k; ++m) {
        for (std::uint32_t t = 2; t <= std::min<std::uint64_t>(k, max_strength); ++t) {
          for (const Kind kind : {Kind::linear, Kind::circular}) {
            const Parameters p{.v = v, .k = k, .change = m, .kind = kind, .strength = t};
            for (std::uint64_t b = 1; b <= 10; ++b) {
              for (const EncodingOptions& options : all) {
                ASSERT_EQ(design_formula_size(p, b, options),
                          encode_design(p, b, options).cnf().size())
                    << name(p) << " with " << b << " blocks, budget " << options.budget;
                ++formulas;
              }
            }
          }
        }
      }
    }
  }
  EXPECT_GT(formulas, 10'000U);
}

TEST(ExactEncoding, IsForetoldForLargeParametersToo) {
  for (const auto& [p, b] : {std::pair{Parameters{.v = 30, .k = 5}, 70U},
                             std::pair{Parameters{.v = 25, .k = 20, .change = 3}, 9U},
                             std::pair{Parameters{.v = 40, .k = 3, .kind = Kind::circular}, 9U}}) {
    EXPECT_EQ(design_formula_size(p, b), encode_design(p, b).cnf().size()) << name(p);
  }
}

TEST(ExactEncoding, RefusesAnyAbsurdNumberOfBlocksAtOnce) {
  for (std::uint64_t b = 1 << 16; b != 0; b <<= 4) {
    for (const std::uint64_t v : {9U, 1000U, 65'535U}) {
      for (const std::uint32_t t : {2U, 4U}) {
        for (const std::uint64_t k : {v / 2, v - 1}) {
          const Parameters p{.v = v, .k = k, .change = 1, .strength = t};
          EXPECT_THROW((void)design_formula_size(p, b), MissingResource) << name(p) << ", " << b;
        }
      }
    }
  }
}

}  // namespace
}  // namespace changeover::exact_encoding_test
