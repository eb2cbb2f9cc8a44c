#include "construct/tools/leave/leave_factors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace changeover::leave_factors_test {
namespace {

using Pair = LeaveFactors::Pair;

Pair sorted(Pair pair) {
  std::ranges::sort(pair);
  return pair;
}

std::set<Pair> edges(std::uint64_t w, std::vector<std::uint64_t> differences, bool half) {
  std::set<Pair> all;
  if (half) {
    differences.push_back(w / 2);
  }
  for (const std::uint64_t d : differences) {
    for (std::uint64_t x = 0; x < w; ++x) {
      all.insert(sorted({static_cast<Element>(x), static_cast<Element>((x + d) % w)}));
    }
  }
  return all;
}

// The pairs of all classes. In each class two neighbours are disjoint and no element lacks.
std::multiset<Pair> checked_pairs(std::uint64_t w, const LeaveFactors& factors) {
  std::multiset<Pair> all;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    std::set<Element> seen;
    Pair before{static_cast<Element>(w), static_cast<Element>(w)};
    for (std::uint64_t j = 0; j < factors.count(i); ++j) {
      const Pair pair = sorted(factors.pair(i, j));
      EXPECT_LT(pair[0], pair[1]);
      EXPECT_LT(pair[1], w);
      EXPECT_TRUE(std::ranges::find_first_of(pair, before) == pair.end()) << w << ' ' << i << j;
      before = pair;
      seen.insert(pair.begin(), pair.end());
      all.insert(pair);
    }
    EXPECT_EQ(seen.size(), w);
  }
  return all;
}

void expect_classes(std::uint64_t w, const std::vector<std::uint64_t>& differences, bool half) {
  const auto factors = LeaveFactors::of(w, differences, half);
  if (!factors) {
    return;
  }
  ASSERT_EQ(factors->size(), 2 * differences.size() + (half ? 1 : 0));
  const std::multiset<Pair> all = checked_pairs(w, *factors);
  const std::set<Pair> wanted = edges(w, differences, half);
  if (half) {  // 1-factors, which are a partition
    EXPECT_TRUE(std::ranges::equal(all, wanted));
    return;
  }
  for (const Pair& pair : wanted) {
    EXPECT_EQ(all.count(pair), 1U) << pair[0] << ' ' << pair[1];
  }
  if (w % 2 == 0) {
    return;
  }
  EXPECT_EQ(factors->pair(0, 0), (Pair{0, 1}));
  if (differences.size() >= 2) {
    EXPECT_EQ(factors->pair(factors->size() - 1, factors->count(factors->size() - 1) - 1),
              (Pair{0, 1}));
  }
}

// All sets of at most two differences, and some of three: cycles of each length, of even and of odd
// order.
TEST(LeaveFactors, AreOfAllLeavesWithFewDifferences) {
  std::uint64_t served = 0;
  for (std::uint64_t w = 10; w <= 48; ++w) {
    for (const bool half : {false, true}) {
      if (half && w % 2 == 1) {
        continue;
      }
      // 0, …, g−1 must not be neighbours if they are paired.
      const std::uint64_t least = half ? 1 : w / 4 + 1;
      for (std::uint64_t a = least; 2 * a < w; ++a) {
        expect_classes(w, {a}, half);
        for (std::uint64_t b = a + 1; 2 * b < w; ++b) {
          served += LeaveFactors::of(w, {a, b}, half) ? 1U : 0U;
          expect_classes(w, {a, b}, half);
          if (2 * b + 2 < w && (a + b) % 3 == 0) {
            expect_classes(w, {a, b, b + 1}, half);
          }
        }
      }
    }
  }
  EXPECT_GT(served, 2500U);
}

TEST(LeaveFactors, SayWhereThereIsNoRoom) {
  EXPECT_FALSE(LeaveFactors::of(15, {5}, false));   // cycles of three, and w is odd
  EXPECT_TRUE(LeaveFactors::of(24, {8}, true));     // prisms of triangles
  EXPECT_FALSE(LeaveFactors::of(6, {2, 2}, true));  // no element is left for the second
}

}  // namespace
}  // namespace changeover::leave_factors_test
