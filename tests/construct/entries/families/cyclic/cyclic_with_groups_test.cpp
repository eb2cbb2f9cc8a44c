// Cyclic designs with groups: an infinite family of constant waste.
#include <gtest/gtest.h>

#include "bounds/counting_bound.hpp"
#include "construction_checks.hpp"

namespace changeover::cyclic_with_groups_test {
namespace {

using namespace test;

Parameters circular(std::uint64_t v, std::uint64_t k) { return {v, k, 2, Kind::circular, 2}; }

TEST(CyclicWithGroups, ServesOneClassForEachBlockSize) {
  std::vector<std::uint64_t> served;
  for (std::uint64_t v = 1; v <= 700; ++v) {
    for (const std::uint64_t k : {3U, 4U, 5U, 6U}) {
      if (const auto offer = offer_of("cyclic-with-groups", circular(v, k))) {
        served.push_back(1000 * k + v);
        expect_as_promised(*offer);
      }
    }
  }
  EXPECT_EQ(served, (std::vector<std::uint64_t>{4083, 4183, 5255, 4283, 4383, 4483, 6509, 5549,
                                                4583, 4683}));
}

TEST(CyclicWithGroups, HasAWasteThatDoesNotGrow) {
  for (std::uint64_t k = 4; k <= 12; ++k) {
    const std::uint64_t n = k - 2;
    const std::uint64_t h = k % 2 == 0 ? n + 1 : n;
    std::size_t found = 0;
    for (std::uint64_t v = k; v <= 200'000; ++v) {
      if (const auto offer = offer_of("cyclic-with-groups", circular(v, k))) {
        ++found;
        EXPECT_EQ(offer->b * (2 * k - 3) - v * (v - 1) / 2, n * h * (h - 1)) << v << ' ' << k;
      }
    }
    EXPECT_GT(found, 3U) << k;
  }
}

TEST(CyclicWithGroups, IsAStreamThatCanBeReadAgain) {
  const auto offer = offer_of("cyclic-with-groups", circular(83, 4));
  ASSERT_TRUE(offer);
  EXPECT_EQ(offer->b, counting_bound(circular(83, 4)) + 2);
  const auto source = standard().build(offer->recipe);
  const std::vector<Block> blocks = blocks_of(*source);
  EXPECT_EQ(blocks.size(), offer->b);
  ASSERT_TRUE(source->rewind());
  EXPECT_EQ(blocks_of(*source), blocks);
  Block block(4);
  for (const std::size_t until : {0U, 100U, 300U, 600U, 683U}) {
    ASSERT_TRUE(source->rewind());
    for (std::size_t i = 0; i < until; ++i) {
      ASSERT_TRUE(source->next(block));
    }
    ASSERT_TRUE(source->rewind());
    EXPECT_EQ(blocks_of(*source), blocks) << until;
  }
  expect_spoilt_recipes_refused(offer->recipe);
}

}  // namespace
}  // namespace changeover::cyclic_with_groups_test
