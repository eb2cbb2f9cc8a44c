#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"

namespace changeover::visited_windows_test {
namespace {

using namespace test;

Parameters linear(std::uint64_t v, std::uint64_t k) { return {v, k, 1, Kind::linear, 2}; }
Parameters circular(std::uint64_t v, std::uint64_t k) { return {v, k, 1, Kind::circular, 2}; }

// Neighbouring parameters are served too, and often the other kind, so only the rest of a recipe
// can be spoilt.
void expect_spoilt_refused(const Recipe& recipe) {
  const auto spoil = [&](const std::string& how, const auto& change) {
    Recipe spoilt = recipe;
    change(spoilt);
    expect_refused(spoilt, how);
  };
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
      const auto ring = offer_of("visited-windows", circular(v, k));
      ASSERT_EQ(ring.has_value(), offer.has_value());
      if (ring) {
        expect_as_promised(*ring);
      }
    }
  }
}

TEST(VisitedWindows, AreOneOverTheBoundIfCircular) {
  for (std::uint64_t k = 4; k <= 40; ++k) {
    for (std::uint64_t v = 2 * k; v + 1 < 3 * k; ++v) {
      const auto offer = offer_of("visited-windows", circular(v, k));
      ASSERT_TRUE(offer);
      EXPECT_EQ(offer->b, 3 * v - 4 * k + 2);
      EXPECT_TRUE(verify(*standard().build(offer->recipe)).valid()) << v << ' ' << k;
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

// For k up to 30: the construction serves (v, k) if `fewer` is not 0, with so many blocks fewer.
template <typename Fewer>
void expect_fewer_than_visited(const char* name, Kind kind, const Fewer& fewer) {
  for (std::uint64_t k = 3; k <= 30; ++k) {
    for (std::uint64_t v = 3 * k; v <= 8 * k; ++v) {
      const Parameters p{v, k, 1, kind, 2};
      const auto offer = offer_of(name, p);
      const std::uint64_t by = fewer(v, k);
      ASSERT_EQ(offer.has_value(), by > 0) << v << ' ' << k;
      if (offer) {
        EXPECT_EQ(offer->b + by, offer_of("visited-windows", p)->b);
        if (k <= 11) {
          expect_as_promised(*offer);
        } else {
          EXPECT_TRUE(verify(*standard().build(offer->recipe)).valid()) << v << ' ' << k;
        }
      }
    }
  }
}

TEST(ChainedWindows, HaveOneOrTwoBlocksFewerThanVisitedOnes) {
  expect_fewer_than_visited("chained-windows", Kind::linear,
                            [](std::uint64_t v, std::uint64_t k) -> std::uint64_t {
                              if (k >= 6 && v + 1 >= 4 * k && v + 6 <= 5 * k) {
                                return k >= 7 && v >= 4 * k ? 2 : 1;
                              }
                              return k >= 5 && v + 3 >= 6 * k && v + 8 <= 7 * k ? 1 : 0;
                            });
  expect_spoilt_refused(offer_of("chained-windows", linear(36, 9))->recipe);
  expect_spoilt_refused(offer_of("chained-windows", linear(58, 10))->recipe);
}

TEST(ChainedWindows, HaveOneBlockFewerThanVisitedOnesIfCircular) {
  expect_fewer_than_visited("chained-windows", Kind::circular,
                            [](std::uint64_t v, std::uint64_t k) -> std::uint64_t {
                              return k >= 4 && v + 1 >= 4 * k && v + 5 <= 5 * k ? 1 : 0;
                            });
  expect_spoilt_refused(offer_of("chained-windows", circular(36, 9))->recipe);
}

// K from 5 to 8 is where the proof begins; beyond, K and w grow together or K alone.
TEST(ChainedThreeWindows, HaveTwoBlocksFewerThanVisitedOnes) {
  expect_fewer_than_visited("chained-three-windows", Kind::linear,
                            [](std::uint64_t v, std::uint64_t k) -> std::uint64_t {
                              return k >= 6 && v + 2 >= 6 * k && v + 8 <= 7 * k ? 2 : 0;
                            });
  expect_fewer_than_visited("chained-three-windows", Kind::circular,
                            [](std::uint64_t, std::uint64_t) { return std::uint64_t{0}; });
  expect_spoilt_refused(offer_of("chained-three-windows", linear(59, 10))->recipe);
}

TEST(ClosedUpWindows, RefuseSpoiltRecipes) {
  const Recipe recipe = offer_of("closed-up-windows", linear(21, 7))->recipe;
  expect_spoilt_refused(recipe);
  Recipe ring = recipe;
  ring.parameters.kind = Kind::circular;
  expect_refused(ring, "circular");
}

}  // namespace
}  // namespace changeover::visited_windows_test
