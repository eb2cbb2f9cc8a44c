#include <gtest/gtest.h>

#include "construction_checks.hpp"

namespace changeover::relayed_windows_test {
namespace {

using namespace test;

TEST(RelayedWindows, AreMinimumOverTheirWholeRegion) {
  expect_circular_family("relayed-windows", 40, 1, [](std::uint64_t v, std::uint64_t k) {
    return v > 2 * k && v + 3 <= 3 * k;
  });
}

TEST(RelayedWindows, AreValidForLargeBlocks) {
  expect_valid_circular("relayed-windows", {601, 750, 897}, 300);
}

// Elements stay once or twice, so many of each.
TEST(RelayedWindows, HaveRunnersAndCarriers) {
  for (std::uint64_t k = 5; k <= 20; ++k) {
    for (std::uint64_t v = 2 * k + 1; v + 3 <= 3 * k; ++v) {
      const Verdict verdict = verify(
          *standard().build(offer_of("relayed-windows", circular_single_change(v, k))->recipe));
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
    const Recipe recipe = offer_of("relayed-windows", circular_single_change(v, k))->recipe;
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
