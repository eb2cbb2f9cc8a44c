#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"

namespace changeover::held_triangles_test {
namespace {

using namespace test;

constexpr Kind kinds[] = {Kind::linear, Kind::circular};

Parameters parameters(std::uint64_t v, std::uint64_t k, Kind kind) { return {v, k, 3, kind, 2}; }

TEST(HeldTriangles, AreDesigns) {
  std::uint64_t served = 0;
  for (const Kind kind : kinds) {
    for (std::uint64_t k = 4; k <= 12; ++k) {
      for (std::uint64_t v = k + 1; v <= 170; ++v) {
        if (const auto offer = offer_of("held-triangles", parameters(v, k, kind))) {
          expect_as_promised(*offer);
          ++served;
        }
      }
    }
  }
  EXPECT_GT(served, 180U);
}

// One class and no pair twice: all waste is at the ways between the two lists, whose blocks at an
// end have one element in common.
TEST(HeldTriangles, WithOneClassWasteOnlyOnTheWays) {
  for (const Kind kind : kinds) {
    for (std::uint64_t k = 4; k <= 16; ++k) {
      for (std::uint64_t c = 4; c <= 11; ++c) {
        const Parameters p = parameters(6 * c * (k - 2) + k, k, kind);
        const auto offer = offer_of("held-triangles", p);
        ASSERT_TRUE(offer) << name(p);
        const std::uint64_t w = p.v - (k - 3);
        const std::uint64_t way = (k + 1) / 3 - 1;
        EXPECT_EQ(offer->b, c * w + w / 3 + (kind == Kind::linear ? way : 2 * way)) << name(p);
      }
    }
  }
}

// 1-rotational Steiner systems S(2, 4, 12c+4), in an order.
TEST(HeldTriangles, OfFourElementsAreTight) {
  for (const Kind kind : kinds) {
    for (const std::uint64_t c : {1U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 10U, 11U, 12U, 13U}) {
      const Parameters p = parameters(12 * c + 4, 4, kind);
      const auto offer = offer_of("held-triangles", p);
      ASSERT_TRUE(offer) << name(p);
      EXPECT_EQ(offer->b, p.v * (p.v - 1) / 12);
      EXPECT_EQ(offer->b, lower_bound(p).blocks) << name(p);
      expect_as_promised(*offer);
    }
  }
}

TEST(HeldTriangles, ServeLargeBlocks) {
  for (const Kind kind : kinds) {
    const Parameters p = parameters(6 * 4 * 62 + 4 * 63 + 1, 64, kind);  // c = t = 4
    const auto offer = offer_of("held-triangles", p);
    ASSERT_TRUE(offer);
    expect_as_promised(*offer);
  }
}

TEST(HeldTriangles, ServeNothingElse) {
  for (const Kind kind : kinds) {
    EXPECT_FALSE(offer_of("held-triangles", parameters(76, 5, kind)));
    EXPECT_FALSE(offer_of("held-triangles", parameters(77, 3, kind)));
    EXPECT_FALSE(offer_of("held-triangles", parameters(6 * 4 * 63 + 65, 65, kind)));
    EXPECT_FALSE(offer_of("held-triangles", {77, 5, 2, kind, 2}));
    EXPECT_FALSE(offer_of("held-triangles", {77, 5, 3, kind, 3}));
    const auto offer = offer_of("held-triangles", parameters(77, 5, kind));
    ASSERT_TRUE(offer);
    expect_spoilt_recipes_refused(offer->recipe, {.any_v = true, .any_kind = true});
  }
}

TEST(HeldTriangles, ExplainThemselves) {
  const auto text = [](const Parameters& p) {
    return construction("held-triangles").explain(offer_of("held-triangles", p)->recipe);
  };
  EXPECT_THAT(text(parameters(77, 5, Kind::linear)),
              ::testing::EndsWith("over Z_75. This leaves the pairs with the difference 25. They "
                                  "are those of 25 triangles that hold every element of Z_75. "
                                  "These pass beside 2 new elements that are held."));
  EXPECT_THAT(
      text(parameters(103, 10, Kind::circular)),
      ::testing::HasSubstr("over Z_96. Pairs with the difference 48 come twice. One of their "
                           "differences repeats another. This leaves the pairs with the "
                           "difference 32. "));
}

}  // namespace
}  // namespace changeover::held_triangles_test
