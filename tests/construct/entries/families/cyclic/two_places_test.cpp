#include <gtest/gtest.h>

#include "construction_checks.hpp"

namespace changeover::two_places_test {
namespace {

using namespace test;

TEST(TwoPlaces, AreOneOverTheBoundOfStaysOverTheirWholeRegion) {
  expect_circular_family("two-places", 45, 2, [](std::uint64_t v, std::uint64_t k) {
    return k >= 4 && v + 2 >= 3 * k && 3 * v <= 10 * k - 5;
  });
}

TEST(TwoPlaces, AreValidForLargeBlocks) {
  expect_valid_circular("two-places", {898, 950, 998}, 300);
}

// 4k−2−v elements stay once, all others twice.
TEST(TwoPlaces, HaveElementsThatStayOnce) {
  for (std::uint64_t k = 4; k <= 20; ++k) {
    for (std::uint64_t v = 3 * k - 2; 3 * v <= 10 * k - 5; ++v) {
      const Verdict verdict =
          verify(*standard().build(offer_of("two-places", circular_single_change(v, k))->recipe));
      std::uint64_t once = 0;
      for (const ElementCount& count : verdict.elements) {
        once += count.introductions == 1 ? 1 : 0;
        EXPECT_LE(count.introductions, 2);
      }
      EXPECT_EQ(once, 4 * k - 2 - v);
    }
  }
}

TEST(TwoPlaces, RefuseSpoiltRecipes) {
  for (const auto& [v, k] : {std::pair<std::uint64_t, std::uint64_t>{10, 4}, {15, 5}, {25, 9}}) {
    const Recipe recipe = offer_of("two-places", circular_single_change(v, k))->recipe;
    const auto spoil = [&](const std::string& how, const auto& change) {
      Recipe spoilt = recipe;
      change(spoilt);
      expect_refused(spoilt, how);
    };
    spoil("linear", [](Recipe& r) { r.parameters.kind = Kind::linear; });
    spoil("m = 2", [](Recipe& r) { r.parameters.change = 2; });
    spoil("t = 3", [](Recipe& r) { r.parameters.strength = 3; });
    spoil("v = 3k-3", [&](Recipe& r) { r.parameters.v = 3 * r.parameters.k - 3; });
    spoil("v too large", [&](Recipe& r) { r.parameters.v = (10 * r.parameters.k - 2) / 3; });
    spoil("argument", [](Recipe& r) { r.arguments["w"] = 2; });
    spoil("input", [](Recipe& r) { r.inputs.push_back(r); });
    spoil("block", [](Recipe& r) { r.blocks.push_back({0, 1}); });
  }
}

}  // namespace
}  // namespace changeover::two_places_test
