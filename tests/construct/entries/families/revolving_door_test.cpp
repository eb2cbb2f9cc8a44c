#include <gtest/gtest.h>

#include <set>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"

namespace changeover::revolving_door_test {
namespace {

using namespace test;

TEST(RevolvingDoor, HasEveryBlockOnceAndIsMinimum) {
  for (std::uint32_t t = 3; t <= 4; ++t) {
    for (std::uint64_t v = t + 1; v <= 14; ++v) {
      for (const Kind kind : {Kind::circular, Kind::linear}) {
        const Parameters p{v, t, 1, kind, t};
        const auto offer = offer_of("revolving-door", p);
        ASSERT_TRUE(offer) << name(p);
        expect_as_promised(*offer);
        EXPECT_EQ(offer->b, lower_bound(p).blocks) << name(p);
        EXPECT_EQ(best_known(standard(), p)->b, offer->b) << name(p);
        const Design design = standard().build_design(offer->recipe);
        std::set<Block> blocks;
        for (const auto& block : design.blocks()) {
          blocks.emplace(block.begin(), block.end());
        }
        EXPECT_EQ(blocks.size(), offer->b) << name(p);
      }
    }
  }
}

TEST(RevolvingDoor, IsAStream) {
  const Parameters p{120, 4, 1, Kind::circular, 4};
  const auto source = standard().build(offer_of("revolving-door", p)->recipe);
  EXPECT_EQ(source->block_count(), 8'214'570U);
  EXPECT_TRUE(
      verify(*standard().build(offer_of("revolving-door", {40, 4, 1, Kind::circular, 4})->recipe))
          .valid());
}

TEST(RevolvingDoor, SaysHowItIsMade) {
  const Recipe recipe = offer_of("revolving-door", {7, 3, 1, Kind::circular, 3})->recipe;
  EXPECT_EQ(
      construction("revolving-door").explain(recipe),
      "All 3-subsets of 7 elements. Those with largest element 2 come first, then 3 and so on "
      "to 6; for each, the 2-subsets of the smaller elements in the same kind of order, "
      "backwards. Every 3 elements must be a block, so no design has fewer.");
}

TEST(RevolvingDoor, RefusesWhatItDoesNotServe) {
  EXPECT_FALSE(offer_of("revolving-door", {7, 2, 1, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("revolving-door", {7, 4, 1, Kind::circular, 3}));
  EXPECT_FALSE(offer_of("revolving-door", {7, 3, 2, Kind::circular, 3}));
  EXPECT_FALSE(offer_of("revolving-door", {3, 3, 1, Kind::linear, 3}));
  EXPECT_FALSE(offer_of("revolving-door", {65537, 3, 1, Kind::linear, 3}));
  EXPECT_TRUE(offer_of("revolving-door", {65536, 3, 1, Kind::linear, 3}));
  const Recipe recipe = offer_of("revolving-door", {7, 3, 1, Kind::circular, 3})->recipe;
  const auto refused = [&](const std::string& how, const auto& change) {
    Recipe spoilt = recipe;
    change(spoilt);
    expect_refused(spoilt, how);
  };
  refused("t = 4", [](Recipe& r) { r.parameters.strength = 4; });
  refused("m = 2", [](Recipe& r) { r.parameters.change = 2; });
  refused("argument", [](Recipe& r) { r.arguments["p"] = 2; });
  refused("block", [](Recipe& r) { r.blocks.push_back({0, 1, 2}); });
}

}  // namespace
}  // namespace changeover::revolving_door_test
