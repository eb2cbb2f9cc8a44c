#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include "../../loadorder_support.hpp"
#include "changeover/loadorder/workers.hpp"
#include "loadorder/shares/groups/even_shares.hpp"
#include "loadorder/shares/groups/group_shares.hpp"
#include "loadorder/shares/groups/idle_workers.hpp"
#include "loadorder/shares/groups/known_shares.hpp"
#include "loadorder/shares/groups/larger_groups.hpp"
#include "loadorder/shares/groups/planes.hpp"

namespace changeover::test::changed_shares_test {
namespace {

// What is wrong with shares, by playing their steps.
std::string defect_of(const GroupShares& shares, std::uint64_t items, std::uint64_t room,
                      std::uint64_t makespan) {
  const ItemGroups groups{items, shares.groups};
  std::set<std::pair<Element, Element>> met;
  for (std::size_t w = 0; w < shares.workers.size(); ++w) {
    const auto steps = share_steps(shares.workers[w], groups, room, w);
    const Simulation played = simulate(*steps, items, room);
    if (!played.fault.empty()) {
      return played.fault;
    }
    if (played.loads > makespan) {
      return fmt::format("worker {} loads {}", w, played.loads);
    }
    met.insert(played.met.begin(), played.met.end());
  }
  return met.size() == items * (items - 1) / 2 ? "" : "pairs are missing";
}

// Loads of the busiest worker; 0 if a share does not fit.
std::uint64_t makespan_of(const GroupShares& shares, std::uint64_t items, std::uint64_t room) {
  std::uint64_t most = 0;
  for (const GroupShare& share : shares.workers) {
    const ShareCost cost = cost_of(share, {items, shares.groups}, room);
    if (cost.steps == 0) {
      return 0;
    }
    most = std::max(most, cost.loads);
  }
  return most;
}

TEST(LargerGroups, AreSpreadOverTheLinesOfAPlane) {
  const GroupShares lines = plane_shares(7, false);
  EXPECT_GT(makespan_of(lines, 256, 64), 37U);
  const GroupShares spread = with_larger_spread(lines, 256, 64);
  EXPECT_LE(makespan_of(spread, 256, 64), 37U);
  EXPECT_EQ(defect_of(spread, 256, 64, 37), "");
}

// Never more loads, never something that did fit and fits no more; sometimes better.
TEST(LargerGroups, MakeNoKnownSharesWorse) {
  int fewer = 0;
  int fit = 0;
  for (const std::uint64_t workers : {7U, 14U, 23U, 33U}) {
    for (const auto& [items, room] : {std::pair(64U, 16U), std::pair(100U, 13U)}) {
      each_group_shares(
          workers, items, [](const ShareShape& shape) { return shape.groups <= 40; },
          [&](const GroupShares& shares) {
            const GroupShares spread = with_larger_spread(shares, items, room);
            const std::uint64_t before = makespan_of(shares, items, room);
            const std::uint64_t after = makespan_of(spread, items, room);
            if (before > 0) {
              ASSERT_GT(after, 0U);
              ASSERT_LE(after, before);
              fewer += after < before ? 1 : 0;
            } else {
              fit += after > 0 ? 1 : 0;
            }
            if (after > 0) {
              ASSERT_EQ(defect_of(spread, items, room, after), "");
            }
          });
    }
  }
  EXPECT_GT(fewer, 0);
  EXPECT_GT(fit, 0);
}

TEST(LargerGroups, OfOneSizeAreLeftAlone) {
  const GroupShares shares = developed_shares("13 1 | 0 1 3 9 /");
  const GroupShares same = with_larger_spread(shares, 130, 40);
  EXPECT_EQ(same.workers, shares.workers);
}

// Base shares of 14 workers whose pairs are uneven, and nearly all needed.
TEST(EvenShares, HaveAllPairsAndNoMoreLoads) {
  int better = 0;
  for (const char* const line : share_table()) {
    GroupShares shares = developed_shares(line);
    const std::uint64_t workers = shares.workers.size();
    constexpr std::uint64_t items = 100;
    if (shares.groups > 24 || workers > 16 || shares.workers.front().streamed.empty()) {
      continue;
    }
    const double before = unevenness(shares, items, workers);
    if (before <= 1.03) {
      continue;
    }
    constexpr std::uint64_t room = 40;
    const std::uint64_t makespan = makespan_of(shares, items, room);
    if (makespan == 0) {
      continue;
    }
    const GroupShares even = with_even_pairs(shares, items, room, makespan);
    EXPECT_EQ(defect_of(even, items, room, makespan), "") << line;
    const double after = unevenness(even, items, workers);
    EXPECT_LE(after, before + 1e-9) << line;
    better += after < before - 0.01 ? 1 : 0;
  }
  EXPECT_GT(better, 3);
}

// Pairs that were uneven by up to an eighth, with a thirtieth more loads at most.
TEST(EvenShares, AreFoundWhereTheTableHasUnevenOnes) {
  for (const auto& [room, workers, most] :
       {std::tuple(45U, 14U, 88U), {32U, 22U, 74U}, {45U, 13U, 94U}, {45U, 57U, 38U}}) {
    const SplitFacts facts = split_load_order(256, room, workers).facts();
    EXPECT_LE(facts.makespan, most) << workers;
    EXPECT_LE(facts.most_pairs * workers * 100, facts.all_pairs * 105) << workers;
  }
}

}  // namespace
}  // namespace changeover::test::changed_shares_test
