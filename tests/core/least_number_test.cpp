#include "core/least_number.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace changeover::least_number_test {
namespace {

TEST(LeastNumber, IsTheFirstThatIsEnough) {
  for (std::uint64_t low = 0; low < 6; ++low) {
    for (std::uint64_t high = low; high < 20; ++high) {
      for (std::uint64_t first = 0; first < 25; ++first) {
        const std::uint64_t expected = std::min(std::max(first, low), high);
        EXPECT_EQ(least_number(low, high, [&](std::uint64_t n) { return n >= first; }), expected)
            << low << " " << high << " " << first;
      }
    }
  }
}

TEST(LeastNumber, OfNoRangeIsItsBegin) {
  EXPECT_EQ(least_number(7, 3, [](std::uint64_t) { return true; }), 7U);
}

TEST(LeastNumber, AsksForNoNumberOutsideAndFewInside) {
  int asked = 0;
  constexpr std::uint64_t high = std::uint64_t{1} << 63U;
  EXPECT_EQ(least_number(5, high,
                         [&](std::uint64_t n) {
                           ++asked;
                           EXPECT_GE(n, 5U);
                           EXPECT_LT(n, high);
                           return n >= 1'000'000'007;
                         }),
            1'000'000'007U);
  EXPECT_LE(asked, 64);
}

}  // namespace
}  // namespace changeover::least_number_test
