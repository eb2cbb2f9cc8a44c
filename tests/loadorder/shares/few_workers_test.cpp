#include "loadorder/shares/few_workers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include "changeover/loadorder/workers.hpp"

namespace changeover::test::few_workers_test {
namespace {

// By trying all: items get sets of workers, any two with a worker in common, and the worker with
// most items has as few as can be.
std::uint64_t fewest_by_trying(unsigned items, unsigned workers) {
  std::uint64_t best = items;
  std::vector<unsigned> sets;
  std::vector<unsigned> loads(workers, 0);
  const std::function<void(unsigned)> extend = [&](unsigned least) {
    if (*std::max_element(loads.begin(), loads.end()) >= best) {
      return;
    }
    if (sets.size() == items) {
      best = *std::max_element(loads.begin(), loads.end());
      return;
    }
    // Items are alike: their sets do not decrease.
    for (unsigned set = least; set < 1U << workers; ++set) {
      if (std::all_of(sets.begin(), sets.end(),
                      [&](unsigned other) { return (set & other) != 0; })) {
        for (unsigned w = 0; w < workers; ++w) {
          loads[w] += set >> w & 1;
        }
        sets.push_back(set);
        extend(set);
        sets.pop_back();
        for (unsigned w = 0; w < workers; ++w) {
          loads[w] -= set >> w & 1;
        }
      }
    }
  };
  extend(1);
  return best;
}

TEST(FewWorkers, NoSharingHasFewerItemsThanTheBound) {
  for (unsigned workers = 1; workers <= 7; ++workers) {
    for (unsigned items = 1; items <= (workers <= 4 ? 8U : workers <= 5 ? 7U : 5U); ++items) {
      const std::uint64_t least = least_at_one_worker(items, workers).loads;
      EXPECT_LE(least, fewest_by_trying(items, workers)) << items << " " << workers;
    }
  }
}

// The fractional covers of Theorem 17 are as good as can be.
TEST(FewWorkers, IsAttainedByUpToFive) {
  EXPECT_EQ(least_at_one_worker(6, 3).loads, fewest_by_trying(6, 3));
  EXPECT_EQ(least_at_one_worker(5, 4).loads, fewest_by_trying(5, 4));
  EXPECT_EQ(least_at_one_worker(5, 4).loads, 3U);
  // Nine items for five workers, five each: too many to try.
  EXPECT_EQ(least_at_one_worker(9, 5).loads, 5U);
}

// Theorem 17, for few workers: families of sets of at most five points that pairwise intersect and
// to which no set can be added are those of more than half of the weight, for one of a few weights.
TEST(FewWorkers, FamiliesOfPairwiseIntersectingSetsAreThoseOfMoreThanHalfOfTheWeight) {
  const std::vector<std::vector<unsigned>> weights{{1},
                                                   {1, 1, 1},
                                                   {2, 1, 1, 1},
                                                   {1, 1, 1, 1, 1},
                                                   {2, 2, 1, 1, 1},
                                                   {3, 1, 1, 1, 1},
                                                   {3, 2, 2, 1, 1}};
  for (const auto& [points, families] :
       std::vector<std::pair<unsigned, unsigned>>{{1, 1}, {2, 2}, {3, 4}, {4, 12}, {5, 81}}) {
    const unsigned all = (1U << points) - 1;
    unsigned count = 0;
    std::vector<unsigned> family;
    const auto weighs_more_than_half = [&](const std::vector<unsigned>& weight) {
      const unsigned total = std::accumulate(weight.begin(), weight.end(), 0U);
      return std::all_of(family.begin(), family.end(), [&](unsigned set) {
        unsigned sum = 0;
        for (unsigned point = 0; point < weight.size(); ++point) {
          sum += set >> point & 1 ? weight[point] : 0;
        }
        return 2 * sum > total;
      });
    };
    const auto is_weighed = [&] {
      for (const std::vector<unsigned>& some : weights) {
        if (some.size() > points) {
          continue;
        }
        std::vector<unsigned> weight(points, 0);
        std::copy(some.begin(), some.end(), weight.begin());
        std::sort(weight.begin(), weight.end());
        do {
          if (weighs_more_than_half(weight)) {
            return true;
          }
        } while (std::next_permutation(weight.begin(), weight.end()));
      }
      return false;
    };
    // One of each set and its complement.
    const std::function<void(unsigned)> choose = [&](unsigned set) {
      if (set > all / 2) {
        ++count;
        EXPECT_TRUE(is_weighed()) << points;
        return;
      }
      for (const unsigned one : {set, all - set}) {
        if (one != 0 && std::all_of(family.begin(), family.end(),
                                    [&](unsigned other) { return (one & other) != 0; })) {
          family.push_back(one);
          choose(set + 1);
          family.pop_back();
        }
      }
    };
    choose(0);
    EXPECT_EQ(count, families) << points;
  }
}

TEST(FewWorkers, IsAttainedByPlanes) {
  for (const std::uint64_t q : {2U, 3U, 4U, 5U, 7U, 8U, 9U}) {
    const std::uint64_t n = q * q + q + 1;
    EXPECT_EQ(least_at_one_worker(n, n).loads, q + 1) << q;
    EXPECT_EQ(least_at_one_worker(100 * n, n).loads, 100 * (q + 1)) << q;
    EXPECT_EQ(least_at_one_worker(100 * q * q, q * q + q).loads, 100 * q) << q;
  }
}

// Where squares are, counting pairs alone gives 1/sqrt(W).
TEST(FewWorkers, IsMoreThanPairsAloneAsk) {
  for (std::uint64_t workers = 2; workers <= 300; ++workers) {
    const std::uint64_t items = 100'000;
    const std::uint64_t least = least_at_one_worker(items, workers).loads;
    EXPECT_GE(least * least * workers, items * items) << workers;
    EXPECT_GE(makespan_lower_bound(items, items, workers).loads, least);
  }
  EXPECT_EQ(least_at_one_worker(1024, 16).loads, 277U);
  EXPECT_GT(least_at_one_worker(100'000, 16).loads, 27'000U);
}

TEST(FewWorkers, MoreWorkersNeedNoMoreAndMoreItemsNoFewer) {
  for (std::uint64_t items = 2; items < 200; items += 13) {
    for (std::uint64_t workers = 2; workers < 80; ++workers) {
      const std::uint64_t least = least_at_one_worker(items, workers).loads;
      EXPECT_LE(least, least_at_one_worker(items + 1, workers).loads);
      EXPECT_LE(least, items);
    }
  }
}

}  // namespace
}  // namespace changeover::test::few_workers_test
