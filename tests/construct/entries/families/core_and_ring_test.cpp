#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"

namespace changeover::core_and_ring_test {
namespace {

using namespace test;

TEST(CoreAndRing, IsMinimumWithEveryBlockNew) {
  for (std::uint64_t k = 4; k <= 30; ++k) {
    for (const Kind kind : {Kind::circular, Kind::linear}) {
      const Parameters p{2 * k + 1, k, k, kind, 2};
      const auto offer = offer_of("core-and-ring", p);
      ASSERT_TRUE(offer) << name(p);
      EXPECT_EQ(offer->b, 2 * k + (kind == Kind::circular ? 4 : 3)) << name(p);
      EXPECT_EQ(offer->b, lower_bound(p).blocks) << name(p);
      expect_as_promised(*offer);
    }
  }
}

TEST(CoreAndRing, SaysHowItIsMade) {
  const Recipe recipe = offer_of("core-and-ring", {9, 4, 4, Kind::linear, 2})->recipe;
  EXPECT_EQ(construction("core-and-ring").explain(recipe),
            "The core is {6, …, 8}, the ring 0, …, 5. The blocks are, in turn, the core with x and "
            "the ring without x and the element after x, for x = 0, …, 5; the last block is of the "
            "core. Two elements of the ring meet where it lacks two others; that takes k >= 4.");
}

TEST(CoreAndRing, ServesNothingElse) {
  EXPECT_FALSE(offer_of("core-and-ring", {7, 3, 3, Kind::linear, 2}));
  EXPECT_FALSE(offer_of("core-and-ring", {9, 4, 3, Kind::linear, 2}));
  EXPECT_FALSE(offer_of("core-and-ring", {10, 4, 4, Kind::linear, 2}));
  const Recipe recipe = offer_of("core-and-ring", {9, 4, 4, Kind::circular, 2})->recipe;
  const auto refused = [&](const std::string& how, const auto& change) {
    Recipe spoilt = recipe;
    change(spoilt);
    expect_refused(spoilt, how);
  };
  refused("k = 3", [](Recipe& r) { r.parameters.k = r.parameters.change = 3; });
  refused("block", [](Recipe& r) { r.blocks.push_back({0, 1, 2, 3}); });
}

}  // namespace
}  // namespace changeover::core_and_ring_test
