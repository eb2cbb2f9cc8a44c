#include "construct/tools/leave/held_lists.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <ranges>
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

void expect_held_list(std::uint64_t k, std::uint64_t change, std::uint64_t t) {
  SCOPED_TRACE(std::to_string(k) + " " + std::to_string(change) + " " + std::to_string(t));
  const std::uint64_t n = k - change;
  const HeldList list(k, change, t);
  const std::vector<Block> blocks = blocks_of(list, k);
  std::set<std::pair<Element, Element>> pairs;
  const auto add_pairs = [&](const Block& block) {
    for (std::size_t j = 0; j < block.size(); ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        if (block[j] < n * t) {
          pairs.emplace(block[i], block[j]);
        }
      }
    }
  };
  for (const Block& block : blocks) {
    EXPECT_LT(block.back(), n * t + (change == 2 ? 0 : 2));
    add_pairs(block);
  }
  std::uint64_t seams = 0;
  for (std::size_t i = 1; i < blocks.size(); ++i) {
    seams += list.is_seam(i) ? 1U : 0U;
    const bool passes = std::ranges::any_of(std::views::iota(std::uint64_t{0}, t),
                                            [&](auto group) { return list.position(group) == i; });
    EXPECT_TRUE(passes || list.is_seam(i) || common(blocks[i - 1], blocks[i]) == n) << i;
  }
  std::uint64_t passing = 0;  // groups that are kept at their position
  for (std::uint64_t group = 0; group < t; ++group) {
    Block kept(static_cast<std::size_t>(n));
    std::iota(kept.begin(), kept.end(), static_cast<Element>(group * n));
    add_pairs(kept);  // They are together while the group is held.
    const std::uint64_t at = list.position(group);
    ASSERT_LE(at, blocks.size());
    EXPECT_TRUE(group == 0 || list.position(group - 1) < at + (change == 2 ? 0 : 1));
    passing += (at == 0 || common(kept, blocks[at - 1]) == n) &&
                       (at == blocks.size() || common(kept, blocks[at]) == n)
                   ? 1U
                   : 0U;
  }
  EXPECT_EQ(pairs.size(), n * t * (n * t - 1) / 2);
  EXPECT_GE(passing + seams + 1, t);
}

TEST(HeldLists, KeepEachGroupAndCoverAllPairs) {
  for (std::uint64_t change = 2; change <= 3; ++change) {
    for (std::uint64_t k = 4; k <= 12; ++k) {
      for (std::uint64_t t = 1; t <= 12; ++t) {
        expect_held_list(k, change, t);
      }
    }
  }
}

// These have no seams: every group is kept between two blocks or at an end.
TEST(HeldLists, ThatWereFoundAreDesigns) {
  for (const auto& [change, k, t] : std::vector<std::array<std::uint64_t, 3>>{{2, 4, 9},
                                                                              {2, 5, 6},
                                                                              {2, 6, 8},
                                                                              {3, 5, 3},
                                                                              {3, 5, 7},
                                                                              {3, 6, 6},
                                                                              {3, 7, 4},
                                                                              {3, 9, 3}}) {
    const HeldList list(k, change, t);
    for (std::uint64_t i = 1; i < list.size(); ++i) {
      EXPECT_FALSE(list.is_seam(i));
    }
    expect_held_list(k, change, t);
  }
}

}  // namespace
}  // namespace changeover::held_lists_test
