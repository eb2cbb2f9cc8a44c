#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"

namespace changeover::relayed_windows_test {
namespace {

using namespace test;

Parameters circular(std::uint64_t v, std::uint64_t k) { return {v, k, 1, Kind::circular, 2}; }

TEST(RelayedWindows, AreMinimumOverTheirWholeRegion) {
  for (std::uint64_t k = 2; k <= 40; ++k) {
    for (std::uint64_t v = k + 1; v <= 4 * k; ++v) {
      const auto offer = offer_of("relayed-windows", circular(v, k));
      ASSERT_EQ(offer.has_value(), v > 2 * k && v + 3 <= 3 * k) << v << ' ' << k;
      if (offer) {
        EXPECT_EQ(offer->b, 3 * v - 4 * k + 1);
        EXPECT_EQ(offer->b, lower_bound(circular(v, k)).blocks);
        if (k <= 14) {
          expect_as_promised(*offer);
        } else {
          EXPECT_TRUE(verify(*standard().build(offer->recipe)).valid()) << v << ' ' << k;
        }
      }
    }
  }
}

TEST(RelayedWindows, AreValidForLargeBlocks) {
  for (const std::uint64_t v : {std::uint64_t{601}, std::uint64_t{750}, std::uint64_t{897}}) {
    const auto offer = offer_of("relayed-windows", circular(v, 300));
    ASSERT_TRUE(offer);
    EXPECT_TRUE(verify(*standard().build(offer->recipe)).valid()) << v;
  }
}

// Elements stay once or twice, so many of each.
TEST(RelayedWindows, HaveRunnersAndCarriers) {
  for (std::uint64_t k = 5; k <= 20; ++k) {
    for (std::uint64_t v = 2 * k + 1; v + 3 <= 3 * k; ++v) {
      const Verdict verdict =
          verify(*standard().build(offer_of("relayed-windows", circular(v, k))->recipe));
      const std::uint64_t w = v - 2 * k + 1;
      std::uint64_t once = 0;
      std::uint64_t twice = 0;
      for (const ElementCount& count : verdict.elements) {
        once += count.introductions == 1 ? 1 : 0;
        twice += count.introductions == 2 ? 1 : 0;
      }
      EXPECT_EQ(once, 2 * k - w);
      EXPECT_EQ(twice, 2 * w - 1);
    }
  }
}

TEST(RelayedWindows, RefuseSpoiltRecipes) {
  for (const auto& [v, k] : {std::pair<std::uint64_t, std::uint64_t>{9, 4}, {13, 6}, {24, 9}}) {
    const Recipe recipe = offer_of("relayed-windows", circular(v, k))->recipe;
    const auto spoil = [&](const std::string& how, const auto& change) {
      Recipe spoilt = recipe;
      change(spoilt);
      expect_refused(spoilt, how);
    };
    spoil("linear", [](Recipe& r) { r.parameters.kind = Kind::linear; });
    spoil("m = 2", [](Recipe& r) { r.parameters.change = 2; });
    spoil("t = 3", [](Recipe& r) { r.parameters.strength = 3; });
    spoil("v = 2k", [&](Recipe& r) { r.parameters.v = 2 * r.parameters.k; });
    spoil("v = 3k-2", [&](Recipe& r) { r.parameters.v = 3 * r.parameters.k - 2; });
    spoil("argument", [](Recipe& r) { r.arguments["w"] = 2; });
    spoil("input", [](Recipe& r) { r.inputs.push_back(r); });
    spoil("block", [](Recipe& r) { r.blocks.push_back({0, 1}); });
  }
}

}  // namespace
}  // namespace changeover::relayed_windows_test
