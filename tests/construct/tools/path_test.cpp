#include "construct/tools/path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <map>
#include <numeric>
#include <set>

#include "all_blocks.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "message_of.hpp"

namespace changeover::path_test {
namespace {

// Breadth-first search over all k-subsets.
std::map<Block, std::uint64_t> distances_by_search(std::uint32_t v, std::uint32_t k,
                                                   std::uint32_t m) {
  const std::vector<Block> all = test::all_blocks(v, k);
  std::map<Block, std::uint64_t> distance{{all.front(), 0}};
  std::deque<Block> queue{all.front()};
  while (!queue.empty()) {
    const Block here = queue.front();
    queue.pop_front();
    for (const Block& next : all) {
      if (distance.count(next) == 0 && difference(here, next).size() == m) {
        distance[next] = distance[here] + 1;
        queue.push_back(next);
      }
    }
  }
  return distance;
}

TEST(Path, IsAsShortAsASearchOverAllBlocksSaysAndChangesExactlyMElements) {
  for (std::uint32_t v = 2; v <= 8; ++v) {
    for (std::uint32_t k = 1; k < v; ++k) {
      for (std::uint32_t m = 1; m <= k; ++m) {
        const auto distance = distances_by_search(v, k, m);
        Block from(k);
        std::iota(from.begin(), from.end(), 0U);
        for (std::uint32_t d = 1; d <= std::min(k, v - k); ++d) {
          Block to(from.begin() + d, from.end());
          for (std::uint32_t i = 0; i < d; ++i) {
            to.push_back(k + i);
          }
          Block sorted = to;
          std::sort(sorted.begin(), sorted.end());
          const auto found = distance.find(sorted);
          const auto steps = connecting_steps(d, k, m, v);
          ASSERT_EQ(steps.has_value(), found != distance.end())
              << v << " " << k << " " << m << " " << d;
          if (!steps) {
            EXPECT_REFUSAL((void)connecting_blocks(from, to, m, v), ImpossibleParameters,
                           "no way from a block to another by changes of");
            continue;
          }
          ASSERT_EQ(*steps, found->second) << v << " " << k << " " << m << " " << d;
          std::vector<Block> way = connecting_blocks(from, to, m, v);
          ASSERT_EQ(way.size() + 1, *steps);
          way.insert(way.begin(), from);
          way.push_back(to);
          for (std::size_t i = 0; i + 1 < way.size(); ++i) {
            EXPECT_EQ(std::set<Element>(way[i].begin(), way[i].end()).size(), k);
            EXPECT_EQ(difference(way[i], way[i + 1]).size(), m);
          }
        }
      }
    }
  }
}

TEST(Path, FromABlockToItselfIsNone) {
  EXPECT_EQ(connecting_steps(0, 4, 2, 10), 0U);
  EXPECT_REFUSAL((void)connecting_blocks({0, 1}, {0, 1}, 1, 5), ImpossibleParameters,
                 "no way from a block to another by changes of 1 for v = 5, k = 2");
}

TEST(Path, AWayHandsOutTheSameBlocksOneByOne) {
  const auto distances = std::make_shared<const Distances>(12, 5, 40);
  Block from(12);
  std::iota(from.begin(), from.end(), 0U);
  Block to(12);
  std::iota(to.begin(), to.end(), 10U);
  const std::vector<Block> all = connecting_blocks(from, to, 5, 40);
  Way way(distances, from, to);
  EXPECT_EQ(way.left(), all.size());
  std::vector<Block> handed_out;
  for (Block block(12); way.next(block);) {
    handed_out.push_back(block);
  }
  EXPECT_EQ(handed_out, all);
}

TEST(Path, CountsStepsOfManyElementsAtOnce) {
  // m² moves at each of k distances would be 10¹³.
  EXPECT_EQ(connecting_steps(25'000, 30'000, 20'000, 65'535), 2U);
  EXPECT_EQ(connecting_steps(30'000, 30'000, 1, 65'535), 30'000U);
}

}  // namespace
}  // namespace changeover::path_test
