#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"

namespace changeover {
namespace {

using namespace test;

Parameters linear(std::uint64_t v, std::uint64_t k) { return {v, k, 1, Kind::linear, 2}; }

// Neighbouring parameters are served too, so only the rest of a recipe can be spoilt.
void expect_spoilt_refused(const Recipe& recipe) {
  const auto spoil = [&](const std::string& how, const auto& change) {
    Recipe spoilt = recipe;
    change(spoilt);
    expect_refused(spoilt, how);
  };
  spoil("circular", [](Recipe& r) { r.parameters.kind = Kind::circular; });
  spoil("m = 2", [](Recipe& r) { r.parameters.change = 2; });
  spoil("t = 3", [](Recipe& r) { r.parameters.strength = 3; });
  spoil("argument", [](Recipe& r) { r.arguments["w"] = 1; });
  spoil("input", [](Recipe& r) { r.inputs.push_back(r); });
  spoil("block", [](Recipe& r) { r.blocks.push_back({0, 1}); });
}

TEST(VisitedWindows, AreAsPromisedBetweenAllTightDesigns) {
  for (std::uint64_t k = 3; k <= 9; ++k) {
    for (std::uint64_t v = k + 1; v <= 8 * k; ++v) {
      const auto offer = offer_of("visited-windows", linear(v, k));
      ASSERT_EQ(offer.has_value(), v > 2 * k - 1 && (v - 1) % (2 * k - 2) != 0) << v << ' ' << k;
      if (offer) {
        expect_as_promised(*offer);
      }
    }
  }
}

TEST(VisitedWindows, AreMinimumUpToThreeTimesTheBlockSize) {
  for (std::uint64_t k = 4; k <= 40; ++k) {
    for (std::uint64_t v = 2 * k; v < 3 * k; ++v) {
      const auto offer = offer_of("visited-windows", linear(v, k));
      ASSERT_TRUE(offer);
      EXPECT_EQ(offer->b, 3 * v - 4 * k + 1);
      EXPECT_EQ(offer->b, lower_bound(linear(v, k)).blocks);
      EXPECT_TRUE(verify(*standard().build(offer->recipe)).valid()) << v << ' ' << k;
    }
  }
}

TEST(VisitedWindows, RefuseSpoiltRecipes) {
  for (const auto& [v, k] : {std::pair<std::uint64_t, std::uint64_t>{12, 5}, {14, 5}, {22, 5}}) {
    expect_spoilt_refused(offer_of("visited-windows", linear(v, k))->recipe);
  }
}

TEST(ClosedUpWindows, AreMinimumFromThreeToFourTimesTheBlockSize) {
  for (std::uint64_t k = 3; k <= 40; ++k) {
    for (std::uint64_t v = k + 1; v <= 5 * k; ++v) {
      const auto offer = offer_of("closed-up-windows", linear(v, k));
      ASSERT_EQ(offer.has_value(), k >= 5 && v >= 3 * k && v + 5 <= 4 * k) << v << ' ' << k;
      if (offer) {
        EXPECT_EQ(offer->b, 3 * v - 4 * k + 1);
        EXPECT_EQ(offer->b, lower_bound(linear(v, k)).blocks);
        if (k <= 12) {
          expect_as_promised(*offer);
        } else {
          EXPECT_TRUE(verify(*standard().build(offer->recipe)).valid()) << v << ' ' << k;
        }
      }
    }
  }
}

TEST(ClosedUpCyclic, IsAsPromisedOverAllOfItsGaps) {
  for (std::uint64_t k = 3; k <= 9; ++k) {
    for (std::uint64_t v = k + 1; v <= 6 * k; ++v) {
      const auto offer = offer_of("closed-up-cyclic", linear(v, k));
      ASSERT_EQ(offer.has_value(), v > 2 * k && (v - 1) % (2 * k - 2) != 0) << v << ' ' << k;
      if (offer) {
        expect_as_promised(*offer);
      }
    }
  }
  expect_spoilt_refused(offer_of("closed-up-cyclic", linear(30, 6))->recipe);
}

// The number of blocks rests on this count.
TEST(ClosedUpCyclic, HasThePromisedBlocksWhereverItIsServedSlow) {
  std::uint64_t served = 0;
  for (std::uint64_t k = 3; k <= 49; ++k) {
    for (std::uint64_t v = 2 * k; v <= 12 * k; ++v) {
      if (const auto offer = offer_of("closed-up-cyclic", linear(v, k))) {
        ASSERT_EQ(standard().build(offer->recipe)->block_count(), offer->b) << v << ' ' << k;
        ++served;
      }
    }
  }
  EXPECT_GT(served, 10'000U);
}

TEST(ClosedUpWindows, RefuseSpoiltRecipes) {
  expect_spoilt_refused(offer_of("closed-up-windows", linear(21, 7))->recipe);
}

}  // namespace
}  // namespace changeover
