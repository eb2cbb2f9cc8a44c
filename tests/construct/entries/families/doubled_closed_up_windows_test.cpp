// Closed-up windows with two copies of every element but four.
#include <gtest/gtest.h>

#include <set>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"

namespace changeover::doubled_closed_up_windows_test {
namespace {

using namespace test;

Parameters linear(std::uint64_t v, std::uint64_t k) { return {v, k, 2, Kind::linear, 2}; }

TEST(DoubledClosedUpWindows, AreMinimumInTheirWholeRange) {
  std::size_t built = 0;
  for (std::uint64_t k = 3; k <= 45; ++k) {
    for (std::uint64_t v = k + 2; v <= 4 * k + 4; ++v) {
      const auto offer = offer_of("doubled-closed-up-windows", linear(v, k));
      const bool served = k % 2 == 1 && v % 2 == 0 && k >= 11 && 3 * k <= v + 1 && v + 12 <= 4 * k;
      ASSERT_EQ(offer.has_value(), served) << v << ' ' << k;
      if (offer) {
        ++built;
        expect_as_promised(*offer);
        EXPECT_EQ(offer->b, lower_bound(linear(v, k)).blocks);
      }
    }
  }
  EXPECT_EQ(built, 171U);
  expect_spoilt_recipes_refused(offer_of("doubled-closed-up-windows", linear(66, 21))->recipe);
}

// The proof of Theorem 6: every block of the single-change design, with two copies of all but the
// four single elements, is inside of a block here.
TEST(DoubledClosedUpWindows, HoldTheBlocksThatTheyAreMadeOf) {
  for (std::uint64_t big = 5; big <= 14; ++big) {
    for (std::uint64_t r = 3; r + 2 <= big; ++r) {
      const std::uint64_t k = 2 * big + 1;
      const auto doubled = offer_of("doubled-closed-up-windows", linear(8 * big - 2 - 2 * r, k));
      ASSERT_TRUE(doubled);
      const auto single =
          offer_of("closed-up-windows", {4 * big + 1 - r, big + 1, 1, Kind::linear, 2});
      ASSERT_TRUE(single);
      std::vector<std::set<Element>> blocks;
      for (const Block& block : blocks_of(*standard().build(doubled->recipe))) {
        blocks.emplace_back(block.begin(), block.end());
      }
      for (const Block& block : blocks_of(*standard().build(single->recipe))) {
        std::set<Element> copies;
        for (const Element x : block) {  // x is the element x + r
          const auto before = static_cast<Element>((x + big - 1) / big);
          copies.insert(2 * x - before);
          if (x % big != 0) {
            copies.insert(2 * x - before + 1);
          }
        }
        EXPECT_TRUE(std::any_of(blocks.begin(), blocks.end(),
                                [&](const auto& larger) {
                                  return std::includes(larger.begin(), larger.end(), copies.begin(),
                                                       copies.end());
                                }))
            << big << ' ' << r;
      }
    }
  }
}

}  // namespace
}  // namespace changeover::doubled_closed_up_windows_test
