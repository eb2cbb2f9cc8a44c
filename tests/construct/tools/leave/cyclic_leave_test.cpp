#include "construct/tools/leave/cyclic_leave.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace changeover::cyclic_leave_test {
namespace {

std::vector<std::uint64_t> new_differences(const CyclicLeave& leave, std::uint64_t k) {
  const std::uint64_t w = leave.elements();
  const auto difference = [w](std::uint64_t x, std::uint64_t y) {
    const std::uint64_t d = (x + w - y) % w;
    return std::min(d, w - d);
  };
  std::vector<std::uint64_t> found;
  for (std::uint64_t i = 0; i < leave.base_blocks(); ++i) {
    const auto [x, y] = leave.points(i);
    found.push_back(difference(x, y));
    for (std::uint64_t a = 0; a < k - 2; ++a) {
      found.push_back(difference(x, a));
      found.push_back(difference(y, a));
    }
  }
  return found;
}

// Every residue of c modulo 4, the smallest ones too; every k, δ and parity that is served.
TEST(CyclicLeave, CoversEachDifferenceOnceButThoseLeft) {
  for (std::uint64_t k = 4; k <= 11; ++k) {
    for (std::uint64_t rounds = 1; rounds <= 41; ++rounds) {
      for (std::uint64_t left = 0; left <= 2 * k; ++left) {
        for (const bool even : {false, true}) {
          const CyclicLeave::Shape shape{rounds, left, even};
          if (!CyclicLeave::serves(k, shape)) {
            EXPECT_TRUE(even && rounds % 4 >= 2 && 2 * left + 2 < k - 2);
            continue;
          }
          const CyclicLeave leave(k, shape);
          ASSERT_EQ(leave.elements(), 2 * (rounds * (2 * k - 3) + left) + (even ? 2 : 1));
          std::vector<std::uint64_t> all = new_differences(leave, k);
          const std::vector<std::uint64_t> rest = leave.differences();
          ASSERT_EQ(rest.size(), left);
          ASSERT_TRUE(std::ranges::is_sorted(rest));
          all.insert(all.end(), rest.begin(), rest.end());
          std::ranges::sort(all);
          for (std::size_t i = 0; i < all.size(); ++i) {
            ASSERT_EQ(all[i], i + 1) << k << ' ' << rounds << ' ' << left << ' ' << even;
          }
          const auto last = leave.points(rounds - 1);
          EXPECT_EQ(std::ranges::count(last, k - 2), 1);
        }
      }
    }
  }
}

TEST(CyclicLeave, IsAsItsSummarySays) {
  const CyclicLeave leave(4, {.rounds = 3, .left = 1, .even = false});
  EXPECT_EQ(leave.elements(), 33U);
  EXPECT_EQ(leave.differences(), std::vector<std::uint64_t>{13});
  EXPECT_EQ(leave.points(2)[0], 2U);
}

TEST(CyclicLeave, ManyRoundsKeepTheirDistance) {
  for (std::uint64_t rounds = 100'000; rounds < 100'004; ++rounds) {
    const CyclicLeave leave(4, {.rounds = rounds, .left = 2, .even = true});
    const std::vector<std::uint64_t> all = new_differences(leave, 4);
    EXPECT_EQ(std::set(all.begin(), all.end()).size(), all.size());
  }
}

}  // namespace
}  // namespace changeover::cyclic_leave_test
