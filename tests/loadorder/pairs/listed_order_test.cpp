// Orders for listed pairs against everything there is, on small lists, and against orders that are
// known.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <atomic>
#include <numeric>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/all_pairs.hpp"
#include "changeover/loadorder/workers.hpp"
#include "changeover/run/control.hpp"
#include "loadorder/pairs/closing.hpp"
#include "loadorder/pairs/pair_bounds.hpp"
#include "message_of.hpp"
#include "pairs_support.hpp"

namespace changeover::test::listed_order_test {
namespace {

TEST(ListedOrder, IsBetweenTheBoundAndTheFewestAndMostlyTheFewest) {
  std::uint64_t lists = 0;
  std::uint64_t fewest = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const std::uint64_t items = 4 + seed % 3;
    const std::uint64_t room = 2 + seed % 2;
    const auto pairs = random_pairs(items, 3 + seed % 4, seed);
    const LoadOrder order = plan_load_order(listed(items, pairs), room);
    EXPECT_EQ(defect(order), "") << seed;
    const std::uint64_t least = fewest_loads(items, pairs, room);
    EXPECT_LE(order.facts().bound.loads, least) << seed;
    EXPECT_GE(order.facts().loads, least) << seed;
    ++lists;
    fewest += order.facts().loads == least ? std::uint64_t{1} : 0;
  }
  EXPECT_GE(10 * fewest, 9 * lists) << fewest << " of " << lists;
}

RC_GTEST_PROP(ListedOrder, IsAnOrderForEveryList, ()) {
  const auto items = *rc::gen::inRange<std::uint64_t>(2, 40);
  const auto room = *rc::gen::inRange<std::uint64_t>(2, 8);
  const auto most = items * (items - 1) / 2;
  const auto count = *rc::gen::inRange<std::uint64_t>(1, std::min<std::uint64_t>(most, 60) + 1);
  const auto seed = *rc::gen::inRange<std::uint64_t>(1, 1'000'000);
  const auto pairs = random_pairs(items, static_cast<std::size_t>(count), seed);
  RC_ASSERT(defect(plan_load_order(listed(items, pairs), room, hardly_searched())) ==
            std::string());
}

TEST(ListedOrder, LoadsAPathAndATreeOnceEach) {
  std::vector<ItemPair> path;
  for (Element x = 0; x + 1 < 50; ++x) {
    path.emplace_back(x * 7 % 50, (x + 1) * 7 % 50);
  }
  const LoadOrder order = plan_load_order(listed(50, path), 2);
  EXPECT_EQ(order.facts().loads, 50U);
  EXPECT_EQ(order.facts().bound.loads, 50U);
  EXPECT_EQ(defect(order), "");
  std::vector<ItemPair> star;
  for (Element x = 1; x < 2000; ++x) {
    star.emplace_back(0, x);
  }
  EXPECT_EQ(plan_load_order(listed(2000, star), 2).facts().loads, 2000U);
}

TEST(ListedOrder, OfClosePointsLoadsFewItemsTwice) {
  // A fixed amount of work, so these are the same everywhere.
  const LoadOrder order = plan_load_order(listed(120, close_points(120, 563, 1)), 10);
  EXPECT_EQ(defect(order), "");
  EXPECT_EQ(order.facts().bound.loads, 120U);
  EXPECT_LT(order.facts().loads, 134U);
}

TEST(ListedOrder, OfAllPairsIsNoWorseThanThatForAllPairs) {
  std::vector<ItemPair> all;
  for (Element y = 0; y < 20; ++y) {
    for (Element x = 0; x < y; ++x) {
      all.emplace_back(x, y);
    }
  }
  const LoadOrder order = plan_load_order(listed(20, all), 5);
  EXPECT_EQ(defect(order), "");
  const LoadOrder known = plan_load_order(20, 5);
  EXPECT_LE(order.facts().loads, known.facts().loads);
  EXPECT_EQ(order.facts().bound.loads, known.facts().bound.loads);
}

TEST(ListedOrder, LoadsWhatOccursAndNothingElse) {
  const std::vector<ItemPair> pairs{{1, 2}, {2, 1}, {4, 4}, {7, 7}, {1, 5}};
  for (const std::uint64_t room : {2U, 9U}) {
    const LoadOrder order = plan_load_order(listed(9, pairs), room);
    const auto steps = order.stream();
    const Simulation played = simulate(*steps, 9, room);
    EXPECT_EQ(played.fault, "");
    EXPECT_EQ(order.facts().loads, 5U);
    EXPECT_EQ(order.facts().wanted.count(), 2U);
  }
}

TEST(ListedOrder, CheckSeesEachPairAndEachLonelyItemThatIsMissed) {
  const WantedPairs wanted = listed(5, {{0, 1}, {1, 2}, {3, 3}});
  const auto verdict_of = [&](const std::vector<Step>& steps) {
    return test::verdict_of(steps, {.items = 5, .room = 2, .wanted = wanted});
  };
  const std::vector<Step> right{{1, {}, {0, 1}}, {2, {0}, {2}}, {3, {1}, {3}}};
  EXPECT_TRUE(verdict_of(right).valid());
  EXPECT_EQ(verdict_of({right[0], right[1]}).example, "{3,3}");
  EXPECT_EQ(verdict_of({right[0], {2, {1}, {2}}, {3, {2}, {3}}}).example, "{1,2}");
  EXPECT_EQ(verdict_of({right[0], {2, {}, {2}}}).fault, "step 2 loads 2 when memory is full");
  EXPECT_EQ(verdict_of({right[0], {2, {4}, {2}}}).fault, "step 2 evicts 4, which is not in memory");
  EXPECT_REFUSAL(ScheduleCheck({.items = 6, .room = 2, .wanted = wanted}), BadInput,
                 "pairs of 5 items are wanted of 6");
}

TEST(ListedOrder, IsTheSameForTheSameSeed) {
  const WantedPairs wanted = listed(40, close_points(40, 150, 3));
  const auto loads = [&](std::uint64_t seed) {
    LoadOrderOptions options;
    options.seed = seed;
    const LoadOrder order = plan_load_order(wanted, 6, options);
    std::vector<Element> list;
    const auto steps = order.stream();
    for (Step step; steps->next(step);) {
      list.insert(list.end(), step.load.begin(), step.load.end());
    }
    return list;
  };
  EXPECT_EQ(loads(5), loads(5));
}

TEST(ListedOrder, SearchesUntilItIsStoppedAndIsVerifiedAfterwards) {
  const WantedPairs wanted = listed(60, close_points(60, 300, 4));
  LoadOrderOptions options;
  options.effort = 1e-2;
  options.search_pairs = [](const std::function<void()>& search) {
    RunControl control({.time = std::chrono::milliseconds(100)});
    const RunScope scope(control);
    search();
  };
  const LoadOrder order = plan_load_order(wanted, 8, options);
  EXPECT_EQ(defect(order), "");
}

TEST(ListedOrder, IsPrefetchedAndSplitAndRun) {
  const auto pairs = close_points(30, 90, 5);
  const WantedPairs wanted = listed(30, pairs);
  const PrefetchPlan plan = plan_prefetch(wanted, 6);
  ScheduleRules rules{
      .items = 30, .room = 6, .wanted = wanted, .compute = ComputeRules{}, .overlap = true};
  const std::vector<Step> steps = work_of(plan.order.stream(), rules);
  const ScheduleVerdict verdict = verdict_of(steps, rules);
  EXPECT_TRUE(verdict.valid()) << verdict.fault;
  EXPECT_EQ(verdict.computed, 90U);
  // A pair that is not wanted is a fault, one that is left out is missing.
  rules.wanted = listed(30, {pairs.begin() + 1, pairs.end()});
  EXPECT_NE(verdict_of(steps, rules).fault.find("which is not wanted"), std::string::npos);

  for (const std::uint64_t workers : {1U, 3U, 200U}) {
    const WorkerSplit split = split_load_order(wanted, 6, workers);
    EXPECT_GE(split.facts().makespan, split.facts().makespan_bound.loads);
    std::set<ItemPair> met;
    for (std::uint64_t w = 0; w < workers; ++w) {
      const auto stream = split.stream(w);
      const Simulation played = simulate(*stream, 30, 6);
      EXPECT_EQ(played.fault, "");
      EXPECT_EQ(played.loads, split.facts().workers[w].loads);
      met.insert(played.met.begin(), played.met.end());
    }
    for (const ItemPair& pair : pairs) {
      EXPECT_EQ(met.count(pair), 1U);
    }
  }

  CallbackItems items(30, 8, [](Element, std::span<std::byte>) { return std::size_t{8}; });
  std::vector<std::atomic<int>> calls(30 * 30);
  const AllPairsReport report = all_pairs(items, plan.order, [&](const PairWork& pair) {
    ++calls[pair.first.item * std::size_t{30} + pair.second.item];
  });
  EXPECT_TRUE(report.finished);
  for (Element y = 0; y < 30; ++y) {
    for (Element x = 0; x < y; ++x) {
      EXPECT_EQ(calls[x * std::size_t{30} + y], wanted.contains(x, y) ? 1 : 0);
    }
  }
}

TEST(ListedOrder, CanHaveMoreItemsThanAllPairsCan) {
  std::vector<ItemPair> ring;
  constexpr Element items = 200'000;
  for (Element x = 0; x < items; ++x) {
    ring.emplace_back(x, (x + 1) % items);
  }
  const LoadOrder order = plan_load_order(listed(items, ring), 3);
  EXPECT_EQ(order.facts().loads, items);
  EXPECT_TRUE(order.facts().every_step_read);
}

TEST(PairBounds, CountPairsOneLoadAfterAnother) {
  for (std::uint64_t room = 2; room < 7; ++room) {
    std::uint64_t pairs = 0;
    for (std::uint64_t loads = 1; loads < 40; ++loads) {
      pairs += std::min(loads, room) - 1;
      EXPECT_EQ(most_pairs(loads, room), pairs);
      EXPECT_EQ(most_pairs(least_loads(pairs, room), room) >= pairs, true);
      EXPECT_LE(least_loads(pairs, room), loads);
    }
  }
}

// Each look at an order costs work, also where all that a look sees is closed: otherwise a search
// of so much work would have no end. Counted, not timed.
TEST(ListedOrder, ASearchLooksNoMoreOftenThanItsWorkAllows) {
  using Pairs = std::vector<ItemPair>;
  constexpr Element n = 600;
  Pairs hubs_first, hubs_last, star, grid, path, cliques, likes;
  for (Element i = 0; i < n; ++i) {
    for (Element h = 0; h < 5; ++h) {
      hubs_first.emplace_back(h, 5 + i);
      hubs_last.emplace_back(i, n + h);
    }
    star.emplace_back(0, i + 1);
    path.emplace_back(i, i + 1);
    for (Element j = i + 1; j < n && j / 6 == i / 6; ++j) {
      cliques.emplace_back(i, j);
    }
    if (i % 24 != 23) {
      grid.emplace_back(i, i + 1);
    }
    if (i + 24 < n) {
      grid.emplace_back(i, i + 24);
    }
    likes.emplace_back(i % 3 == 0 ? i / 2 : i % 7, i + 7);
  }
  for (const Pairs& pairs : {hubs_first, hubs_last, star, grid, path, cliques, likes}) {
    Element items = 0;
    for (const auto& [x, y] : pairs) {
      items = std::max(items, y + 1);
    }
    const PairGraph graph(items, pairs);
    for (const std::uint64_t room : {2U, 4U, 30U}) {
      for (const bool backwards : {false, true}) {
        std::vector<Element> order(items);
        std::iota(order.begin(), order.end(), 0U);
        if (backwards) {
          std::ranges::reverse(order);
        }
        Closing closing(graph, room, order);
        Random random(1);
        constexpr std::uint64_t work = 3'000'000;
        std::uint64_t looks = 0;
        closing.improve(
            work, random, [&] { return ++looks > work; }, [] {});
        EXPECT_LE(looks, work / 4) << pairs.size() << " pairs, room " << room;
      }
    }
  }
}

}  // namespace
}  // namespace changeover::test::listed_order_test
