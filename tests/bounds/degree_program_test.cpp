#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "changeover/bounds/lower_bound.hpp"
#include "core/checked.hpp"
#include "oracle_minima.hpp"

namespace changeover {
namespace {

// The program by brute force: sums of (i, r) reachable with v elements, one after another.
bool counts_exist(const Parameters& p, std::uint64_t b) {
  const auto possible = [&](std::uint64_t f) {
    const bool linear = p.kind == Kind::linear;
    const std::uint64_t n = p.v - f;
    const std::uint64_t i_sum = linear ? p.k + p.change * (b - 1) : p.change * b;
    const std::uint64_t r_sum = (p.k - f) * b;
    std::vector<std::vector<bool>> reached(i_sum + 1, std::vector<bool>(r_sum + 1, false));
    reached[0][0] = true;
    for (std::uint64_t x = 0; x < n; ++x) {
      std::vector<std::vector<bool>> next(i_sum + 1, std::vector<bool>(r_sum + 1, false));
      for (std::uint64_t i = 1; i <= b; ++i) {
        for (std::uint64_t r = i; r <= b && r + i <= b + (linear ? 1 : 0); ++r) {
          if (i * (p.k - 1) + p.change * (r - i) < p.v - 1) {
            continue;
          }
          for (std::uint64_t a = i; a <= i_sum; ++a) {
            for (std::uint64_t c = r; c <= r_sum; ++c) {
              if (reached[a - i][c - r]) {
                next[a][c] = true;
              }
            }
          }
        }
      }
      reached = next;
    }
    return static_cast<bool>(reached[i_sum][r_sum]);
  };
  if (p.kind == Kind::linear) {
    return possible(0);
  }
  for (std::uint64_t f = 0; f + p.change <= p.k; ++f) {
    if ((f == 0 || p.change * b >= p.v - f) && possible(f)) {
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

TEST(DegreeProgram, GivesTheCoveringBoundOfFortAndHedlundForTriples) {
  for (std::uint64_t v = 6; v <= 100; ++v) {
    const std::uint64_t covering = ceil_div(v * ceil_div(v - 1, 2), 3);
    EXPECT_GE(lower_bound({.v = v, .k = 3, .kind = Kind::circular}).blocks, covering) << v;
    EXPECT_GE(lower_bound({.v = v, .k = 3, .kind = Kind::linear}).blocks, covering) << v;
  }
}

}  // namespace
}  // namespace changeover
