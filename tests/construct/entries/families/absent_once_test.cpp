#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"

namespace changeover::absent_once_test {
namespace {

using namespace test;

TEST(AbsentOnce, IsMinimumOverItsWholeRegion) {
  std::size_t served = 0;
  for (std::uint32_t t = 3; t <= 4; ++t) {
    for (std::uint64_t m = 1; m <= 4; ++m) {
      for (std::uint64_t v = t; v <= 24; ++v) {
        for (std::uint64_t k = std::max<std::uint64_t>(t, m); k <= v; ++k) {
          for (const Kind kind : {Kind::circular, Kind::linear}) {
            const Parameters p{v, k, m, kind, t};
            const std::uint64_t reach = (v - k + m - 1) / m;
            const auto offer = offer_of("absent-once", p);
            ASSERT_EQ(offer.has_value(), v >= k + m && v >= m * (t * reach + 1)) << name(p);
            if (offer) {
              ++served;
              EXPECT_EQ(offer->b, t * reach + 1);
              EXPECT_EQ(offer->b, lower_bound(p).blocks) << name(p);
              expect_as_promised(*offer);
            }
          }
        }
      }
    }
  }
  EXPECT_GT(served, 400U);
}

TEST(AbsentOnce, IsValidForLargeParameters) {
  for (const Parameters& p :
       {Parameters{60, 47, 1, Kind::circular, 3}, Parameters{75, 58, 3, Kind::circular, 3},
        Parameters{45, 36, 2, Kind::linear, 4}}) {
    const auto offer = offer_of("absent-once", p);
    ASSERT_TRUE(offer) << name(p);
    EXPECT_TRUE(verify(*standard().build(offer->recipe)).valid()) << name(p);
  }
}

TEST(AbsentOnce, LeavesPairsToOthersAndRefusesWhatItDoesNotServe) {
  EXPECT_FALSE(offer_of("absent-once", {9, 5, 1, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("absent-once", {6, 4, 1, Kind::linear, 3}));  // has 7 blocks all the same
  EXPECT_FALSE(offer_of("absent-once", {7, 6, 2, Kind::linear, 3}));  // only one is absent
  EXPECT_FALSE(offer_of("absent-once", {8, 6, 1, Kind::linear, 5}));
  const Recipe recipe = offer_of("absent-once", {7, 5, 1, Kind::circular, 3})->recipe;
  const auto refused = [&](const std::string& how, const auto& change) {
    Recipe spoilt = recipe;
    change(spoilt);
    expect_refused(spoilt, how);
  };
  refused("t = 2", [](Recipe& r) { r.parameters.strength = 2; });
  refused("t = 4", [](Recipe& r) { r.parameters.strength = 4; });
  refused("v - 1", [](Recipe& r) { --r.parameters.v, --r.parameters.k; });
  refused("m = 0", [](Recipe& r) { r.parameters.change = 0; });
  refused("argument", [](Recipe& r) { r.arguments["p"] = 2; });
  refused("input", [](Recipe& r) { r.inputs.push_back(r); });
  refused("block", [](Recipe& r) { r.blocks.push_back({0, 1}); });
}

}  // namespace
}  // namespace changeover::absent_once_test
