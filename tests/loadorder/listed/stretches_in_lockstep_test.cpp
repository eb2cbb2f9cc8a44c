// Stretches of an order for workers that never hold one item twice, against plain sets.
#include "loadorder/listed/stretches_in_lockstep.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "../pairs/pairs_support.hpp"
#include "loadorder/listed/quick_moves.hpp"

namespace changeover::test::stretches_in_lockstep_test {
namespace {

// The first thing that is wrong, or "".
std::string fault_of(const LockstepEvents& events, std::uint64_t room, std::set<ItemPair> wanted) {
  std::uint32_t steps = 0;
  for (const auto& each : events) {
    for (const LockstepEvent& event : each) {
      steps = std::max(steps, event.step + 1);
    }
  }
  std::vector<std::set<Element>> memory(events.size());
  std::vector<std::size_t> at(events.size(), 0);
  for (std::uint32_t step = 0; step < steps; ++step) {
    for (const bool comes : {false, true}) {
      for (std::size_t w = 0; w < events.size(); ++w) {
        for (; at[w] < events[w].size() && events[w][at[w]].step == step &&
               events[w][at[w]].comes == comes;
             ++at[w]) {
          const Element x = events[w][at[w]].item;
          if (!comes && memory[w].erase(x) != 1) {
            return "an item goes that is not there";
          }
          for (const std::set<Element>& each : memory) {
            if (comes && each.contains(x)) {
              return "an item is held twice";
            }
          }
          if (comes) {
            for (const Element y : memory[w]) {
              wanted.erase({std::min(x, y), std::max(x, y)});
            }
            memory[w].insert(x);
          }
          if (memory[w].size() > room) {
            return "too much is held";
          }
        }
      }
    }
  }
  for (std::size_t w = 0; w < events.size(); ++w) {
    if (at[w] != events[w].size()) {
      return "events are not in order";
    }
  }
  return wanted.empty() ? "" : "pairs are missing";
}

TEST(StretchesInLockstep, EveryPairMeetsAndNoItemIsHeldTwice) {
  std::mt19937_64 random(1);
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    const std::uint64_t items = 4 + seed % 25;
    const auto pairs = random_pairs(items, 1 + random() % (items * (items - 1) / 2), seed);
    const std::uint64_t room = 2 + random() % 8;
    const PairGraph graph(items, pairs);
    for (const std::vector<LoadMove>& order : several_orders(graph, room)) {
      const StretchesInLockstep stretches(graph, order);
      ASSERT_GE(stretches.jobs(), 1U);
      ASSERT_LE(stretches.jobs(), order.size());
      std::set<std::size_t> begins{0};
      for (std::uint64_t i = random() % 9; i > 0; --i) {
        begins.insert(random() % stretches.jobs());
      }
      for (const std::size_t patience : {1U, 2U, 5U, 100U}) {
        const auto events = stretches.play({begins.begin(), begins.end()}, patience, 100'000);
        ASSERT_TRUE(events.has_value()) << seed;
        EXPECT_EQ(events->size(), begins.size());
        EXPECT_EQ(fault_of(*events, room, {pairs.begin(), pairs.end()}), "")
            << seed << ' ' << begins.size() << ' ' << patience;
      }
    }
  }
}

TEST(StretchesInLockstep, OneWorkerLoadsNoMoreThanTheOrder) {
  const auto pairs = close_points(60, 250, 4);
  const PairGraph graph(60, pairs);
  const std::vector<LoadMove> order = quick_moves(graph, 8);
  const auto events = StretchesInLockstep(graph, order).play({0}, 1, 100'000);
  ASSERT_TRUE(events.has_value());
  const auto loads = std::ranges::count(events->front(), true, &LockstepEvent::comes);
  EXPECT_LE(static_cast<std::size_t>(loads), order.size());
  const auto steps = static_cast<std::uint64_t>(loads);  // one load in each
  EXPECT_TRUE(StretchesInLockstep(graph, order).play({0}, 1, steps).has_value());
  EXPECT_FALSE(StretchesInLockstep(graph, order).play({0}, 1, steps - 1).has_value());
}

TEST(StretchesInLockstep, ItemsThatBothWorkersNeedAllTheTimeAreTakenInTurn) {
  // Two hubs, each of whose pairs with every other item is a separate job.
  std::vector<ItemPair> pairs;
  for (Element y = 2; y < 20; ++y) {
    pairs.emplace_back(0, y);
    pairs.emplace_back(1, y);
  }
  const PairGraph graph(20, pairs);
  const StretchesInLockstep stretches(graph, quick_moves(graph, 3));
  for (const std::size_t patience : {1U, 4U, 1000U}) {
    const auto events = stretches.play({0, stretches.jobs() / 2}, patience, 10'000);
    ASSERT_TRUE(events.has_value());
    EXPECT_EQ(fault_of(*events, 3, {pairs.begin(), pairs.end()}), "");
  }
}

}  // namespace
}  // namespace changeover::test::stretches_in_lockstep_test
