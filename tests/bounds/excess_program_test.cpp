#include "bounds/excess_program.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <utility>

namespace changeover::excess_program_test {
namespace {

using Sums = std::set<std::pair<std::int64_t, std::int64_t>>;  // Σ i_x, Σ e_x

// Every sum that the elements can have, one element after the other.
bool by_brute_force(const ExcessProgram& p) {
  Sums sums{{0, 0}};
  for (std::int64_t x = 0; x < p.n; ++x) {
    Sums more;
    for (const auto& [i_sum, e_sum] : sums) {
      for (std::int64_t i = 1; i_sum + i <= p.i_sum; ++i) {
        for (std::int64_t stays = 0; 2 * i + stays <= p.r_most; ++stays) {
          const std::int64_t e = i * (p.k - 1) + p.m * stays - (p.n - 1);
          const bool can_stay = p.k > p.m || stays == 0;
          if (can_stay && e >= 0 && 2 * e <= p.twice_excess && e_sum + e <= p.twice_excess) {
            more.emplace(i_sum + i, e_sum + e);
          }
        }
      }
    }
    sums = std::move(more);
  }
  for (const auto& [i_sum, e_sum] : sums) {
    // With an excess of m or more the sum may be less: what is left is not asked for.
    if (i_sum == p.i_sum && (e_sum == p.twice_excess || p.twice_excess >= 2 * p.m)) {
      return true;
    }
  }
  return false;
}

TEST(ExcessProgram, IsTheBruteForceAnswer) {
  std::size_t yes = 0;
  std::size_t no = 0;
  for (std::int64_t n = 3; n <= 7; ++n) {
    for (std::int64_t k = 2; k < n; ++k) {
      for (std::int64_t m = 1; m <= k; ++m) {
        for (std::int64_t i_sum = n - 1; i_sum <= 2 * n + 3; ++i_sum) {
          for (std::int64_t twice = -2; twice <= 2 * m + 4; twice += 2) {
            for (const std::int64_t r_most : {std::int64_t{4}, std::int64_t{6}, n + 2}) {
              const ExcessProgram p{
                  .n = n, .k = k, .m = m, .i_sum = i_sum, .twice_excess = twice, .r_most = r_most};
              const bool brute = by_brute_force(p);
              EXPECT_EQ(p.feasible(), brute)
                  << n << ' ' << k << ' ' << m << ' ' << i_sum << ' ' << twice << ' ' << r_most;
              (brute ? yes : no) += 1;
            }
          }
        }
      }
    }
  }
  EXPECT_GT(yes, 500U);
  EXPECT_GT(no, 500U);
}

// More elements, where the sums of many are put together by halves.
TEST(ExcessProgram, IsTheBruteForceAnswerForMoreElements) {
  std::size_t yes = 0;
  std::size_t no = 0;
  for (const std::int64_t n : {17, 21}) {
    for (const auto& [k, m] : {std::pair{6, 4}, {8, 5}, {7, 6}, {5, 5}}) {
      for (std::int64_t i_sum = 2 * n; i_sum <= 6 * n; i_sum += 5) {
        for (std::int64_t twice = 0; twice <= 4 * n; twice = 2 * twice + 2) {
          const ExcessProgram p{
              .n = n, .k = k, .m = m, .i_sum = i_sum, .twice_excess = twice, .r_most = 14};
          const bool brute = by_brute_force(p);
          EXPECT_EQ(p.feasible(), brute)
              << n << ' ' << k << ' ' << m << ' ' << i_sum << ' ' << twice;
          (brute ? yes : no) += 1;
        }
      }
    }
  }
  EXPECT_GT(yes, 20U);
  EXPECT_GT(no, 20U);
}

}  // namespace
}  // namespace changeover::excess_program_test
