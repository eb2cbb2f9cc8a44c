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

using Half = CyclicLeave::Half;
constexpr Half halves[] = {Half::none, Half::left, Half::covered};

// Every residue of c modulo 4, the smallest ones too; every k, δ and kind that is served.
TEST(CyclicLeave, CoversEachDifferenceOnceButThoseLeft) {
  for (std::uint64_t k = 4; k <= 11; ++k) {
    for (std::uint64_t rounds = 1; rounds <= 41; ++rounds) {
      for (std::uint64_t left = 0; left <= 2 * k; ++left) {
        for (const Half half : halves) {
          const CyclicLeave::Shape shape{rounds, left, half};
          if (!CyclicLeave::serves(k, shape)) {
            EXPECT_GE(rounds % 4, 2U);
            EXPECT_TRUE(half == Half::left ? 2 * left + 2 < k - 2
                                           : half == Half::covered && left == 0);
            continue;
          }
          const CyclicLeave leave(k, shape);
          const std::uint64_t w = leave.elements();
          const std::uint64_t more = half == Half::none ? 1 : half == Half::left ? 2 : 0;
          ASSERT_EQ(w, 2 * (rounds * (2 * k - 3) + left) + more);
          std::vector<std::uint64_t> all = new_differences(leave, k);
          if (w % 2 == 0) {
            EXPECT_EQ(std::ranges::count(all, w / 2), half == Half::covered ? 1 : 0);
          }
          const std::vector<std::uint64_t> rest = leave.differences();
          ASSERT_EQ(rest.size(), left);
          ASSERT_TRUE(std::ranges::is_sorted(rest));
          all.insert(all.end(), rest.begin(), rest.end());
          std::ranges::sort(all);
          for (std::size_t i = 0; i < all.size(); ++i) {
            ASSERT_EQ(all[i], i + 1) << k << ' ' << rounds << ' ' << left;
          }
          const auto last = leave.points(rounds - 1);
          EXPECT_EQ(std::ranges::count(last, k - 2), 1);
        }
      }
    }
  }
}

TEST(CyclicLeave, IsAsItsSummarySays) {
  const CyclicLeave leave(4, {.rounds = 3, .left = 1, .half = Half::none});
  EXPECT_EQ(leave.elements(), 33U);
  EXPECT_EQ(leave.differences(), std::vector<std::uint64_t>{13});
  EXPECT_EQ(leave.points(2)[0], 2U);
}

TEST(CyclicLeave, ManyRoundsKeepTheirDistance) {
  for (std::uint64_t rounds = 100'000; rounds < 100'004; ++rounds) {
    const CyclicLeave leave(4, {.rounds = rounds, .left = 2, .half = Half::left});
    const std::vector<std::uint64_t> all = new_differences(leave, 4);
    EXPECT_EQ(std::set(all.begin(), all.end()).size(), all.size());
  }
}

}  // namespace
}  // namespace changeover::cyclic_leave_test
