#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "bounds/degree_program.hpp"
#include "bounds/excess_program.hpp"
#include "changeover/bounds/lower_bound.hpp"
#include "core/checked.hpp"
#include "oracle_minima.hpp"

namespace changeover::degree_program_test {
namespace {

// The program by brute force: every way to choose i_1 ≤ i_2 ≤ … with the right sum, for designs of p
// in which no element is in every block.
struct Numbers {
  std::uint64_t r_sum = 0, r_most = 0, cut = 0;
  Parameters p;

  [[nodiscard]] bool good(const std::vector<std::uint64_t>& i) const {
    std::uint64_t least = 0;
    std::uint64_t most = 0;
    for (const std::uint64_t x : i) {
      std::uint64_t r = x;
      while (x * (p.k - 1) + p.change * (r - x) < p.v - 1) {
        ++r;
      }
      if (r + x > r_most) {
        return false;
      }
      least += r;
      most += r_most - x;
    }
    for (std::uint64_t s = 1; s <= p.v; ++s) {
      std::uint64_t sum = 0;
      for (const std::uint64_t x : i) {
        sum += x < s + 1 ? s + 1 - x : 0;
      }
      if (sum > (s * s - s + 1) * p.k + cut) {
        return false;
      }
    }
    return least <= r_sum && r_sum <= most;
  }

  [[nodiscard]] bool exist(std::vector<std::uint64_t>& i, std::uint64_t sum) const {
    if (i.size() == p.v) {
      return sum == 0 && good(i);
    }
    for (std::uint64_t x = i.empty() ? 1 : i.back(); x * (p.v - i.size()) <= sum; ++x) {
      i.push_back(x);
      const bool found = exist(i, sum - x);
      i.pop_back();
      if (found) {
        return true;
      }
    }
    return false;
  }
};

// The degrees of the pairs that are newly covered too often (excess_program_test.cpp).
bool excess_exists(const Parameters& p, std::uint64_t b) {
  const auto pairs = [](std::uint64_t n) { return static_cast<std::int64_t>(n * (n - 1)); };
  const bool linear = p.kind == Kind::linear;
  const std::int64_t each = pairs(p.k) - pairs(p.k - p.change);
  const auto blocks = static_cast<std::int64_t>(b);
  return ExcessProgram{
      .n = static_cast<std::int64_t>(p.v),
      .k = static_cast<std::int64_t>(p.k),
      .m = static_cast<std::int64_t>(p.change),
      .i_sum = static_cast<std::int64_t>(p.change * b + (linear ? p.k - p.change : 0)),
      .twice_excess = each * blocks + (linear ? pairs(p.k) - each : 0) - pairs(p.v),
      .r_most = blocks + (linear ? 1 : 0)}
      .feasible();
}

bool counts_exist(const Parameters& p, std::uint64_t b) {
  std::vector<std::uint64_t> i;
  if (p.kind == Kind::linear) {
    return excess_exists(p, b) &&
           Numbers{.r_sum = p.k * b, .r_most = b + 1, .p = p}.exist(i, p.k + p.change * (b - 1));
  }
  for (std::uint64_t f = 0; f + p.change <= p.k; ++f) {
    Parameters rest = p;
    rest.v -= f;
    rest.k -= f;
    const Numbers numbers{.r_sum = rest.k * b, .r_most = b, .cut = rest.k - p.change, .p = rest};
    if (excess_exists(rest, b) && numbers.exist(i, p.change * b)) {
      return true;
    }
  }
  return false;
}

TEST(DegreeProgram, IsTheBruteForceAnswerWhereverItRaisesTheBound) {
  for (std::uint64_t m = 1; m <= 3; ++m) {
    for (std::uint64_t k = m; k <= 5; ++k) {
      for (std::uint64_t v = k + m; v <= 9; ++v) {
        for (const Kind kind : {Kind::linear, Kind::circular}) {
          const Parameters p{.v = v, .k = k, .change = m, .kind = kind};
          if (k < 2 || impossibility(p)) {
            continue;
          }
          std::uint64_t others = 0;
          std::uint64_t program = 0;
          for (const Bound& bound : lower_bounds(p)) {
            if (bound.name == "checked proofs") {
              continue;
            }
            (bound.name == "degree program" ? program : others) =
                std::max(bound.name == "degree program" ? program : others, bound.blocks);
          }
          std::uint64_t b = others;
          while (!counts_exist(p, b)) {
            ++b;
          }
          EXPECT_EQ(std::max(program, others), b) << name(p);
        }
      }
    }
  }
}

// Asked by itself, from any number of blocks on, where other bounds would hide what it says.
TEST(DegreeProgram, IsTheBruteForceAnswerFromAnyNumberOn) {
  for (std::uint64_t m = 1; m <= 3; ++m) {
    for (std::uint64_t k = std::max<std::uint64_t>(m, 2); k <= 7; ++k) {
      for (std::uint64_t v = k + m; v <= 8; ++v) {
        for (const Kind kind : {Kind::linear, Kind::circular}) {
          const Parameters p{.v = v, .k = k, .change = m, .kind = kind};
          if (impossibility(p)) {
            continue;
          }
          std::uint64_t least = 1;
          while (!counts_exist(p, least)) {
            ++least;
          }
          EXPECT_EQ(degree_program(p, 1), least) << name(p);
          for (std::uint64_t from = least + 1; from <= least + 3; ++from) {
            std::uint64_t b = from;
            while (!counts_exist(p, b)) {
              ++b;
            }
            EXPECT_EQ(degree_program(p, from), b) << name(p) << " from " << from;
          }
        }
      }
    }
  }
}

// Where some elements in every block allow fewer blocks than the program without them: by counting
// one stay too many or too few for them, the answer would be another.
TEST(DegreeProgram, IsTheBruteForceAnswerWhereFixedElementsDecide) {
  const std::vector<std::pair<std::uint64_t, std::uint64_t>> all{
      {15, 6}, {16, 6}, {16, 7}, {19, 8}, {20, 8}};
  for (const auto& [v, k] : all) {
    const Parameters p{.v = v, .k = k, .change = 1, .kind = Kind::circular};
    std::uint64_t least = 1;
    while (!counts_exist(p, least)) {
      ++least;
    }
    EXPECT_EQ(degree_program(p, 1), least) << name(p);
  }
}

TEST(DegreeProgram, IsTriedForPairsFewChangesAndNotTooManyElements) {
  EXPECT_EQ(degree_program({.v = 2000, .k = 1500, .change = 3}, 5000), 5000U);
  EXPECT_FALSE(degree_program({.v = 2001, .k = 1500, .change = 3}, 5000));
  EXPECT_EQ(degree_program({.v = 90, .k = 40, .change = 30}, 1000), 1000U);
  EXPECT_FALSE(degree_program({.v = 90, .k = 40, .change = 31}, 1000));
  EXPECT_FALSE(degree_program({.v = 30, .k = 9, .strength = 3}, 1000));
  EXPECT_FALSE(degree_program({.v = 9, .k = 9}, 1000));
}

TEST(DegreeProgram, TriesTenThousandNumbersOfBlocks) {
  // Blocks of two: every pair is a separate block.
  const Parameters p{.v = 144, .k = 2, .change = 1};
  const std::uint64_t least = 144 * 143 / 2;
  EXPECT_EQ(degree_program(p, least - 10'000), least);
  EXPECT_FALSE(degree_program(p, least - 10'001));
}

TEST(DegreeProgram, GivesTheCoveringBoundOfFortAndHedlundForTriples) {
  for (std::uint64_t v = 6; v <= 100; ++v) {
    const std::uint64_t covering = ceil_div(v * ceil_div(v - 1, 2), 3);
    EXPECT_GE(lower_bound({.v = v, .k = 3, .kind = Kind::circular}).blocks, covering) << v;
    EXPECT_GE(lower_bound({.v = v, .k = 3, .kind = Kind::linear}).blocks, covering) << v;
  }
}

}  // namespace
}  // namespace changeover::degree_program_test
