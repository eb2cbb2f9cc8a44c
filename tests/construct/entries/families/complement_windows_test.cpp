#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"

namespace changeover::complement_windows_test {
namespace {

using namespace test;

// small-v has those of three blocks.
TEST(ComplementWindows, AreMinimumForEveryChangeNumberBelowK) {
  std::size_t built = 0;
  for (std::uint64_t k = 2; k <= 24; ++k) {
    for (std::uint64_t m = 1; m < k; ++m) {
      for (const Kind kind : {Kind::circular, Kind::linear}) {
        const Parameters p{k + m, k, m, kind, 2};
        const auto offer = offer_of(2 * m > k ? "complement-windows" : "small-v", p);
        ASSERT_TRUE(offer) << name(p);
        EXPECT_EQ(offer->b, 2 * ((m + k - m - 1) / (k - m)) + 1) << name(p);
        EXPECT_EQ(offer->b, lower_bound(p).blocks) << name(p);
        expect_as_promised(*offer);
        ++built;
      }
    }
  }
  EXPECT_EQ(built, 2U * 23 * 24 / 2);
  EXPECT_TRUE(
      verify(*standard().build(
                 offer_of("complement-windows", {399, 200, 199, Kind::circular, 2})->recipe))
          .valid());
}

TEST(ComplementWindows, SayHowTheyAreMade) {
  const Recipe recipe = offer_of("complement-windows", {9, 5, 4, Kind::linear, 2})->recipe;
  EXPECT_EQ(
      construction("complement-windows").explain(recipe),
      "Outside each block are 4 elements, and no element is outside two consecutive ones. "
      "Outside blocks 1, 3, 5, … are {0, …, 3}, then the same moved up by 1 a time, and {4, …, "
      "7} at the last, which has nothing in common with the first. So no element is outside all "
      "of these blocks, and every two elements meet.");
}

TEST(ComplementWindows, ServeNothingElse) {
  EXPECT_FALSE(offer_of("complement-windows", {10, 5, 5, Kind::linear, 2}));
  EXPECT_FALSE(offer_of("complement-windows", {10, 5, 4, Kind::linear, 2}));
  EXPECT_FALSE(offer_of("complement-windows", {9, 5, 4, Kind::linear, 3}));
  EXPECT_FALSE(offer_of("complement-windows", {6, 4, 2, Kind::linear, 2}));
  const Recipe recipe = offer_of("complement-windows", {9, 5, 4, Kind::linear, 2})->recipe;
  const auto refused = [&](const std::string& how, const auto& change) {
    Recipe spoilt = recipe;
    change(spoilt);
    expect_refused(spoilt, how);
  };
  refused("v = 10", [](Recipe& r) { r.parameters.v = 10; });
  refused("argument", [](Recipe& r) { r.arguments["p"] = 2; });
}

}  // namespace
}  // namespace changeover::complement_windows_test
