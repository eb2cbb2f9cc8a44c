#include "construct/tools/leave/held_lists.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace changeover::held_lists_test {
namespace {

std::vector<Block> blocks_of(const HeldList& list, std::uint64_t k) {
  std::vector<Block> blocks;
  for (std::uint64_t i = 0; i < list.size(); ++i) {
    Block& block = blocks.emplace_back(static_cast<std::size_t>(k));
    list.write(i, block);
    std::ranges::sort(block);
    EXPECT_EQ(std::ranges::adjacent_find(block), block.end());
  }
  return blocks;
}

std::size_t common(const Block& one, const Block& two) {
  return static_cast<std::size_t>(
      std::ranges::count_if(one, [&](Element x) { return std::ranges::binary_search(two, x); }));
}

TEST(HeldLists, KeepEachGroupAndCoverAllPairs) {
  for (std::uint64_t k = 4; k <= 9; ++k) {
    const std::uint64_t n = k - 2;
    for (std::uint64_t t = 1; t <= 12; ++t) {
      const HeldList list(k, t);
      const std::vector<Block> blocks = blocks_of(list, k);
      SCOPED_TRACE(std::to_string(k) + " " + std::to_string(t));
      std::set<std::pair<Element, Element>> pairs;
      for (const Block& block : blocks) {
        for (std::size_t j = 0; j < block.size(); ++j) {
          for (std::size_t i = 0; i < j; ++i) {
            pairs.emplace(block[i], block[j]);
          }
        }
      }
      std::uint64_t passing = 0;  // groups that are kept at their position
      for (std::uint64_t group = 0; group < t; ++group) {
        Block kept(static_cast<std::size_t>(n));
        std::iota(kept.begin(), kept.end(), static_cast<Element>(group * n));
        for (std::size_t j = 0; j < kept.size(); ++j) {
          for (std::size_t i = 0; i < j; ++i) {
            pairs.emplace(kept[i], kept[j]);  // They are together while the group is held.
          }
        }
        const std::uint64_t at = list.position(group);
        ASSERT_LE(at, blocks.size());
        EXPECT_TRUE(group == 0 || list.position(group - 1) < at);
        passing += (at == 0 || common(kept, blocks[at - 1]) == n) &&
                           (at == blocks.size() || common(kept, blocks[at]) == n)
                       ? 1U
                       : 0U;
      }
      EXPECT_EQ(pairs.size(), n * t * (n * t - 1) / 2);
      std::uint64_t gaps = 0;
      for (std::size_t i = 1; i < blocks.size(); ++i) {
        gaps += common(blocks[i - 1], blocks[i]) == n ? 0U : 1U;
      }
      EXPECT_LE(gaps, list.gaps());
      EXPECT_GE(passing + list.gaps() + 1, t);
      if (list.gaps() == 0) {
        EXPECT_EQ(passing, t);
      }
    }
  }
}

}  // namespace
}  // namespace changeover::held_lists_test
