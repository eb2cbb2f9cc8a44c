// Workers that never hold one item twice, for items of different sizes: the definition in plain
// code, bounds, epochs, and what is wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/workers.hpp"
#include "message_of.hpp"
#include "sizes/sizes_support.hpp"

namespace changeover::test::sized_disjoint_test {
namespace {

using ::testing::HasSubstr;

LoadOrder order_of(const std::shared_ptr<const ItemSizes>& sizes, const WantedPairs& wanted,
                   std::uint64_t workers) {
  return plan_disjoint_levels(sizes, wanted, workers, hardly_searched());
}

struct Played {
  std::string fault;
  std::uint64_t bytes = 0;
  std::uint64_t span = 0;
  std::set<ItemPair> met;
};

// In each step all workers evict, then all load.
Played play_lockstep(const LoadOrder& order, std::uint64_t workers, const ItemSizes& sizes) {
  Played played;
  std::vector<std::set<Element>> held(static_cast<std::size_t>(workers));
  const auto steps = order.stream();
  std::vector<Step> round;
  for (Step step; steps->next(step);) {
    round.push_back(step);
    if (round.size() < workers) {
      continue;
    }
    std::uint64_t slowest = 0;
    for (const Step& each : round) {
      for (const Element x : each.evict) {
        if (held[each.worker].erase(x) != 1) {
          played.fault = "evicts what is not there";
        }
      }
    }
    for (const Step& each : round) {
      std::uint64_t loaded = 0;
      for (const Element x : each.load) {
        for (const std::set<Element>& other : held) {
          if (other.count(x) != 0) {
            played.fault = "loads what a worker has";
          }
        }
        loaded += sizes.bytes[x];
        for (const Element y : held[each.worker]) {
          played.met.emplace(std::min(x, y), std::max(x, y));
        }
        held[each.worker].insert(x);
      }
      std::uint64_t all = 0;
      for (const Element x : held[each.worker]) {
        all += sizes.bytes[x];
      }
      if (all > sizes.memory) {
        played.fault = "too much memory";
      }
      played.bytes += loaded;
      slowest = std::max(slowest, loaded);
    }
    played.span += slowest;
    round.clear();
  }
  return round.empty() ? played : Played{.fault = "half a step", .met = {}};
}

TEST(SizedDisjoint, EveryPairMeetsAndNoItemIsHeldTwice) {
  std::mt19937 random(1);
  for (int round = 0; round < 16; ++round) {
    const auto sizes = random_sizes(random, 2 + random() % 24, round % 3 == 0 ? 3 : 40, 120);
    const std::uint64_t items = sizes->bytes.size();
    const std::uint64_t workers = 1 + random() % 5;
    for (const WantedPairs& wanted :
         {WantedPairs(items), WantedPairs::between(items / 2, items - items / 2),
          WantedPairs::beyond(1 + random() % (items - 1), items),
          listed(items, random_pairs(items, 1 + random() % items, random()))}) {
      const LoadOrder order = plan_disjoint_order(sizes, wanted, workers);
      const LoadOrderFacts& facts = order.facts();
      const Played played = play_lockstep(order, workers, *sizes);
      EXPECT_EQ(played.fault, "");
      EXPECT_TRUE(have_all_met(played.met, items, wanted));
      EXPECT_EQ(played.bytes, facts.bytes);
      EXPECT_EQ(played.span, facts.span_bytes);
      EXPECT_LE(facts.most_bytes, sizes->memory);
      EXPECT_GE(facts.bytes, facts.byte_bound.loads);
      EXPECT_GE(facts.span_bytes, facts.makespan_byte_bound.loads);
      const LoadOrder again = repeat_order(plan_disjoint_order(sizes, wanted, workers), 3);
      EXPECT_EQ(play_lockstep(again, workers, *sizes).fault, "");
      EXPECT_GE(again.facts().span_bytes, again.facts().makespan_byte_bound.loads);
      EXPECT_GE(again.facts().makespan_byte_bound.loads, facts.makespan_byte_bound.loads);
    }
  }
}

TEST(SizedDisjoint, WithEqualSizesNoMoreIsLoadedThanWithoutSizes) {
  for (const auto& [items, room, workers] :
       {std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>{24, 4, 3},
        {32, 8, 2},
        {40, 5, 4}}) {
    const auto sizes = sizes_of(std::vector<std::uint64_t>(items, 10), 10 * room);
    EXPECT_LE(plan_disjoint_order(sizes, items, workers).facts().span_bytes,
              10 * plan_disjoint_order(items, room, workers).facts().span);
  }
}

TEST(SizedDisjoint, OneItemOfMoreThanHalfOfMemory) {
  const auto sizes = sizes_of({60, 30, 20, 10, 10, 40, 5}, 100);
  const LoadOrder order = plan_disjoint_order(sizes, 7, 3);
  const Played played = play_lockstep(order, 3, *sizes);
  EXPECT_EQ(played.fault, "");
  EXPECT_EQ(played.met.size(), 21U);
}

// So many workers would wait for the largest item for ever.
TEST(SizedDisjoint, SurplusWorkersAreIdle) {
  const std::vector<std::uint64_t> bytes{5, 5, 5, 5, 97, 5, 5, 610, 5, 3, 9, 1};
  auto sizes = std::make_shared<ItemSizes>(*sizes_of(bytes, 783));
  sizes->fast_memory = 766;
  for (const std::uint64_t workers : {2U, 4U, 8U, 12U, 20U}) {
    const LoadOrder order = plan_disjoint_order(sizes, 12, workers);
    const Played played = play_lockstep(order, workers, *sizes);
    EXPECT_EQ(played.fault, "") << workers;
    EXPECT_EQ(played.met.size(), 66U) << workers;
    EXPECT_LE(order.facts().span_bytes, 989U) << workers;  // one of them alone is as good
    const LoadOrder levels = plan_disjoint_levels(sizes, 12, workers);
    EXPECT_EQ(play_lockstep(levels, workers, *sizes).met.size(), 66U) << workers;
  }
}

TEST(SizedDisjoint, TheCheckFindsTooManyBytesAndItemsHeldTwice) {
  const auto sizes = sizes_of({6, 5, 4, 3}, 11);
  const ScheduleRules rules{.items = 4, .room = 3, .lockstep = 2, .sizes = sizes};
  const auto fault_of = [&](const std::vector<Step>& steps) {
    ScheduleCheck check(rules);
    for (const Step& step : steps) {
      check.read(step);
    }
    return check.finish().fault;
  };
  EXPECT_THAT(fault_of({{.number = 1, .load = {0, 1, 2}, .worker = 0}, {.number = 1, .worker = 1}}),
              HasSubstr("loads 2 of 4 bytes where 0 are free"));
  EXPECT_THAT(fault_of({{.number = 1, .load = {0, 1}, .worker = 0},
                        {.number = 1, .load = {1}, .worker = 1}}),
              HasSubstr("in memory of worker 0"));
}

TEST(SizedDisjoint, ManyItemsWithOneOfMoreThanHalfOfMemoryAreRefused) {
  std::vector<std::uint64_t> bytes(2'500, 1);
  bytes[7] = 60;
  EXPECT_THAT(message_of<BadInput>(
                  [&] { static_cast<void>(plan_disjoint_order(sizes_of(bytes, 100), 2'500, 2)); }),
              HasSubstr("larger than half of memory"));
}

// Two levels: also what is on each accelerator.
TEST(SizedDisjoint, AtTwoLevelsEveryPairMeetsOnAnAccelerator) {
  std::mt19937 random(6);
  for (int round = 0; round < 10; ++round) {
    const auto fast = random_sizes(random, 2 + random() % 18, round % 3 == 0 ? 3 : 40, 60);
    const auto sizes = std::make_shared<const ItemSizes>(
        ItemSizes{fast->bytes, fast->memory + random() % 200, fast->memory});
    const std::uint64_t items = sizes->bytes.size();
    const std::uint64_t workers = 1 + random() % 4;
    for (const WantedPairs& wanted :
         {WantedPairs(items), WantedPairs::between(items / 2, items - items / 2),
          listed(items, random_pairs(items, 1 + random() % items, random()))}) {
      const LoadOrder order = order_of(sizes, wanted, workers);
      const LoadOrderFacts& facts = order.facts();
      const Played played = play_lockstep(order, workers, *sizes);
      EXPECT_EQ(played.fault, "");
      EXPECT_EQ(played.bytes, facts.bytes);
      EXPECT_EQ(played.span, facts.span_bytes);
      EXPECT_GE(facts.bytes, facts.byte_bound.loads);
      EXPECT_GE(facts.span_bytes, facts.makespan_byte_bound.loads);
      EXPECT_GE(facts.transfer_bytes, facts.transfer_byte_bound.loads);
      std::vector<std::set<Element>> memory(workers);
      std::vector<std::set<Element>> there(workers);
      std::set<ItemPair> met;
      std::uint64_t transferred = 0;
      const std::vector<Step> steps = all_steps(*order.stream());
      for (const Step& step : steps) {
        for (const Element x : step.fast_evict) {
          EXPECT_EQ(there[step.worker].erase(x), 1U);
        }
        for (const Element x : step.evict) {
          EXPECT_EQ(memory[step.worker].erase(x), 1U);
          EXPECT_FALSE(there[step.worker].contains(x));
        }
        memory[step.worker].insert(step.load.begin(), step.load.end());
        std::uint64_t bytes = 0;
        for (const Element x : step.fast_load) {
          EXPECT_TRUE(memory[step.worker].contains(x));
          EXPECT_TRUE(there[step.worker].insert(x).second);
          transferred += sizes->bytes[x];
          for (const Element y : there[step.worker]) {
            met.emplace(std::min(x, y), std::max(x, y));
          }
        }
        for (const Element x : there[step.worker]) {
          bytes += sizes->bytes[x];
        }
        EXPECT_LE(bytes, sizes->fast_memory);
      }
      EXPECT_TRUE(have_all_met(met, items, wanted));
      EXPECT_EQ(transferred, facts.transfer_bytes);
      // Each pair once, in three epochs, with stores; a step that transfers nothing is found.
      const LoadOrder again = repeat_order(order_of(sizes, wanted, workers), 3);
      ScheduleRules rules = again.rules(ComputeRules{});
      rules.store = true;
      std::vector<Step> all = work_of(again.stream(), rules);
      EXPECT_TRUE(verdict_of(all, rules).valid()) << verdict_of(all, rules).fault;
      EXPECT_EQ(verdict_of(all, rules).computed, 3 * wanted.among(items).count());
      const auto step = std::ranges::find_if(
          all, [](const Step& each) { return !each.fast_load.empty() && !each.compute.empty(); });
      if (step != all.end()) {
        step->fast_load.clear();
        EXPECT_FALSE(verdict_of(all, rules).valid());
      }
    }
  }
}

}  // namespace
}  // namespace changeover::test::sized_disjoint_test
