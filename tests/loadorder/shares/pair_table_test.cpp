#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <numeric>
#include <set>

#include "../loadorder_support.hpp"
#include "changeover/core/error.hpp"
#include "changeover/loadorder/workers.hpp"
#include "changeover/run/control.hpp"
#include "loadorder/shares/owners/pouring.hpp"
#include "loadorder/shares/step_lists.hpp"
#include "message_of.hpp"
#include "run/random.hpp"

namespace changeover::test::pair_table_test {
namespace {

std::vector<ItemPair> random_pairs(Element items, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::set<ItemPair> pairs;
  while (pairs.size() < count) {
    const Element x = random.below(items);
    const Element y = random.below(items);
    if (x != y) {
      pairs.emplace(std::min(x, y), std::max(x, y));
    }
  }
  return {pairs.begin(), pairs.end()};
}

// By playing: each wanted pair is computed once, by a worker that has both; what workers load,
// compute and pay is as said; and no stay in memory is without a pair.
void expect_fair(const WorkerSplit& split, const std::set<ItemPair>& wanted,
                 const std::function<double(Element, Element)>& cost = {}) {
  const SplitFacts& facts = split.facts();
  std::set<ItemPair> computed;
  for (std::uint64_t w = 0; w < facts.workers.size(); ++w) {
    const WorkerFacts& worker = facts.workers[static_cast<std::size_t>(w)];
    std::uint64_t loads = 0;
    std::uint64_t pairs = 0;
    double paid = 0;
    std::set<Element> memory;
    std::set<Element> idle;  // there, and without a pair as yet
    StepWork work(split.stream(w), split.rules(ComputeRules{}), split.owners());
    std::uint64_t number = 0;
    for (Step step; work.next(step);) {
      EXPECT_EQ(step.number, ++number);
      for (const Element x : step.evict) {
        EXPECT_EQ(memory.erase(x), 1U);
        EXPECT_EQ(idle.count(x), 0U) << "worker " << w << " loads " << x << " for nothing";
      }
      for (const Element x : step.load) {
        EXPECT_TRUE(memory.insert(x).second);
        idle.insert(x);
        ++loads;
      }
      EXPECT_LE(memory.size(), facts.room);
      for (const ItemPair& pair : step.compute) {
        EXPECT_TRUE(memory.contains(pair.first) && memory.contains(pair.second));
        EXPECT_TRUE(wanted.contains(pair));
        EXPECT_TRUE(computed.insert(pair).second);
        idle.erase(pair.first);
        idle.erase(pair.second);
        ++pairs;
        paid += cost ? cost(pair.first, pair.second) : 0;
      }
    }
    EXPECT_TRUE(idle.empty()) << "worker " << w;
    EXPECT_EQ(loads, worker.loads) << w;
    EXPECT_EQ(number, worker.steps) << w;
    EXPECT_EQ(pairs, worker.pairs) << w;
    EXPECT_NEAR(paid, worker.cost, 1e-6);
  }
  EXPECT_EQ(computed, wanted);
  EXPECT_EQ(facts.all_pairs, wanted.size());
  EXPECT_TRUE(facts.pairs_are_known);
}

TEST(FairShares, OfListsComputeEachPairOnceAndLoadNothingInVain) {
  for (const std::uint64_t workers : {2U, 3U, 8U, 20U}) {
    for (const Element items : {20U, 40U}) {
      const std::vector<ItemPair> pairs = random_pairs(items, items + 20, workers);
      const auto graph = std::make_shared<const PairGraph>(items, pairs);
      const WorkerSplit split = split_load_order(WantedPairs::listed(graph), 6, workers);
      expect_fair(split, {pairs.begin(), pairs.end()});
      EXPECT_GE(split.facts().makespan, split.facts().makespan_bound.loads);
    }
  }
}

TEST(FairShares, OfAllPairsAndOfTwoSetsDoToo) {
  for (const std::uint64_t workers : {2U, 4U, 7U}) {
    std::set<ItemPair> all;
    std::set<ItemPair> between;
    std::set<ItemPair> beyond;
    for (Element y = 0; y < 40; ++y) {
      for (Element x = 0; x < y; ++x) {
        all.emplace(x, y);
        if (x < 15 && y >= 15) {
          between.emplace(x, y);
        }
        if (y >= 30) {
          beyond.emplace(x, y);
        }
      }
    }
    expect_fair(split_load_order(40, 6, workers), all);
    expect_fair(split_load_order(WantedPairs::between(15, 25), 6, workers), between);
    expect_fair(split_load_order(WantedPairs::beyond(30, 40), 6, workers), beyond);
  }
}

TEST(FairShares, SpreadCostsInsteadOfNumbers) {
  const std::vector<ItemPair> pairs = random_pairs(20, 60, 7);
  LoadOrderOptions options;
  options.pair_cost = [](Element x, Element y) { return (x * 7 + y) % 5 == 0 ? 20.0 : 0.5; };
  const WorkerSplit split = split_load_order(
      WantedPairs::listed(std::make_shared<const PairGraph>(20, pairs)), 8, 3, options);
  expect_fair(split, {pairs.begin(), pairs.end()}, options.pair_cost);
  EXPECT_TRUE(split.facts().has_costs);
  EXPECT_NEAR(split.facts().all_costs,
              std::accumulate(pairs.begin(), pairs.end(), 0.0,
                              [&](double sum, const ItemPair& pair) {
                                return sum + options.pair_cost(pair.first, pair.second);
                              }),
              1e-6);
  options.pair_cost = [](Element, Element) { return -1.0; };
  EXPECT_REFUSAL(static_cast<void>(split_load_order(20, 5, 3, options)), BadInput,
                 "the pair of 1 and 6 costs -1: give 0 or more");
  EXPECT_THROW(static_cast<void>(split_load_order(6000, 50, 3, options)), BadInput);
}

// What is asked for: pairs of the busiest worker by the mean, where the first that has a pair
// computed it 1.77 times the mean.
TEST(FairShares, AreEven) {
  const auto evenness = [](std::uint64_t items, std::uint64_t room, std::uint64_t workers) {
    const WorkerSplit split = split_load_order(items, room, workers);
    const SplitFacts& facts = split.facts();
    return static_cast<double>(facts.most_pairs) * static_cast<double>(workers) /
           static_cast<double>(facts.all_pairs);
  };
  EXPECT_LE(evenness(1024, 1024, 16), 1.05);
  EXPECT_LE(evenness(1024, 64, 16), 1.05);
  EXPECT_LE(evenness(1024, 256, 6), 1.05);
  EXPECT_LE(evenness(1024, 1024, 15), 1.05);
  EXPECT_LE(evenness(512, 40, 11), 1.05);
  EXPECT_LE(evenness(20'000, 100, 7), 1.05);
}

// The first worker that has a pair computes it, and loads nothing for pairs that others have had.
TEST(FairShares, TheFirstHolderComputesAndLoadsNothingInVain) {
  LoadOrderOptions options;
  options.balance = false;
  for (const std::uint64_t workers : {2U, 3U, 9U}) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const auto items = static_cast<Element>(12 + 4 * (seed % 8));
      const std::vector<ItemPair> pairs = random_pairs(items, items + 5 * seed, seed);
      const std::set<ItemPair> wanted(pairs.begin(), pairs.end());
      options.effort = 1e-3;
      options.search_pairs = [](const std::function<void()>& search) {
        RunControl control({.time = std::chrono::milliseconds(2)});
        const RunScope scope(control);
        search();
      };
      const WorkerSplit split =
          split_load_order(WantedPairs::listed(std::make_shared<const PairGraph>(items, pairs)),
                           3 + seed % 5, workers, options);
      expect_fair(split, wanted);
      std::set<ItemPair> met;
      for (std::uint64_t w = 0; w < workers; ++w) {
        std::set<ItemPair> here;
        std::set<Element> memory;
        std::uint64_t computed = 0;
        StepWork work(split.stream(w), split.rules(ComputeRules{}), split.owners());
        for (Step step; work.next(step);) {
          computed += step.compute.size();
          for (const Element x : step.evict) {
            memory.erase(x);
          }
          for (const Element x : step.load) {
            for (const Element y : memory) {
              if (const ItemPair pair(std::min(x, y), std::max(x, y)); wanted.contains(pair)) {
                here.insert(pair);
              }
            }
            memory.insert(x);
          }
        }
        const std::size_t before = met.size();
        met.insert(here.begin(), here.end());
        EXPECT_EQ(computed, met.size() - before) << seed << ": worker " << w;
      }
    }
    std::set<ItemPair> all;
    for (Element y = 0; y < 40; ++y) {
      for (Element x = 0; x < y; ++x) {
        all.emplace(x, y);
      }
    }
    expect_fair(split_load_order(40, 10, workers, options), all);
  }
}

TEST(Pouring, FillsToTheSameHeight) {
  Pouring pouring;
  pouring.begin = {0, 2, 3};
  pouring.worker = {0, 1, 0};
  pouring.amount = {6, 2};
  pouring.pour(2);
  EXPECT_NEAR(pouring.portion[0], 2, 1e-4);
  EXPECT_NEAR(pouring.portion[1], 4, 1e-4);
  EXPECT_NEAR(pouring.portion[2], 2, 1e-9);
  EXPECT_NEAR(pouring.load[0], 4, 1e-4);
}

// A row of workers in which each shares with the next: what the first has goes down all of it.
TEST(Pouring, PassesOnAlongARow) {
  constexpr std::uint32_t workers = 30;
  Pouring pouring;
  pouring.begin = {0};
  for (std::uint32_t w = 0; w + 1 < workers; ++w) {
    pouring.worker.insert(pouring.worker.end(), {w, w + 1});
    pouring.begin.push_back(pouring.worker.size());
    pouring.amount.push_back(100);
  }
  pouring.worker.push_back(0);
  pouring.begin.push_back(pouring.worker.size());
  pouring.amount.push_back(100);
  pouring.pour(workers);
  EXPECT_NEAR(*std::max_element(pouring.load.begin(), pouring.load.end()), 100, 0.1);
}

// The definition of keeping lazily: the same items are there when they are needed, in the same
// room, with no more loads.
TEST(Lazily, NothingIsLoadedThatCouldHaveStayed) {
  const std::vector<Move> moves{{{}, {0, 1}}, {{0}, {2}}, {{1, 2}, {3}}, {{3}, {0, 1}}};
  const std::vector<Move> few = lazily(moves, 2);
  std::uint64_t loads = 0;
  for (const Move& move : few) {
    loads += move.load.size();
  }
  EXPECT_EQ(loads, 5U);  // 0 1 | 2 | 3 | 0: 1 stays when there is a place for it
  const std::vector<Move> all = lazily(moves, 4);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_TRUE(all[1].evict.empty());
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    std::vector<Move> plan;
    std::set<Element> memory;
    const std::uint64_t room = 1 + random.below(6);
    for (int i = 0; i < 20; ++i) {
      Move& move = plan.emplace_back();
      for (Element x = 0; x < 8; ++x) {
        if (memory.contains(x) && random.one_in_two()) {
          memory.erase(x);
          move.evict.push_back(x);
        }
      }
      for (Element x = 0; x < 8; ++x) {
        if (!memory.contains(x) && memory.size() < room && random.below(3) == 0 &&
            std::find(move.evict.begin(), move.evict.end(), x) == move.evict.end()) {
          memory.insert(x);
          move.load.push_back(x);
        }
      }
    }
    const std::vector<Move> lazy = lazily(plan, room);
    // Both are played; a step of the plan that loads nothing more has none of the other.
    std::set<Element> there;
    std::set<Element> must;
    std::size_t at = 0;
    std::uint64_t before = 0;
    std::uint64_t after = 0;
    for (const Move& move : plan) {
      for (const Element x : move.evict) {
        must.erase(x);
      }
      must.insert(move.load.begin(), move.load.end());
      before += move.load.size();
      if (!std::includes(there.begin(), there.end(), must.begin(), must.end())) {
        ASSERT_LT(at, lazy.size());
        for (const Element x : lazy[at].evict) {
          EXPECT_EQ(there.erase(x), 1U);
        }
        for (const Element x : lazy[at].load) {
          EXPECT_TRUE(there.insert(x).second);
        }
        after += lazy[at++].load.size();
      }
      EXPECT_TRUE(std::includes(there.begin(), there.end(), must.begin(), must.end()));
      EXPECT_LE(there.size(), room);
    }
    EXPECT_EQ(at, lazy.size());
    EXPECT_LE(after, before);
  }
}

}  // namespace
}  // namespace changeover::test::pair_table_test
