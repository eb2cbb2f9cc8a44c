#include "plan/search/benches/without_clock.hpp"

#include <gtest/gtest.h>

namespace changeover::without_clock_test {
namespace {

using Seconds = std::chrono::duration<double>;

TEST(WithoutClock, GetsATenthToHalfOfTheTime) {
  EXPECT_EQ(share_without_clock(100, std::nullopt), 0.5);  // no limit
  EXPECT_EQ(share_without_clock(100, Seconds(0)), 0.5);
  EXPECT_EQ(share_without_clock(0, Seconds(10)), 0.1);
  EXPECT_EQ(share_without_clock(1'000'000, Seconds(10)), 0.5);
  // 0.4 ms a place between.
  EXPECT_DOUBLE_EQ(share_without_clock(500, Seconds(1)), 0.2);
  EXPECT_DOUBLE_EQ(share_without_clock(5000, Seconds(10)), 0.2);
  for (std::uint64_t places = 0; places < 2000; places += 50) {
    EXPECT_LE(share_without_clock(places, Seconds(1)),
              share_without_clock(places + 50, Seconds(1)));
    EXPECT_GE(share_without_clock(places, Seconds(1)), share_without_clock(places, Seconds(2)));
  }
}

}  // namespace
}  // namespace changeover::without_clock_test
