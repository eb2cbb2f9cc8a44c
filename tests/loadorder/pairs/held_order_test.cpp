// Two sets, and items that are new, against everything there is.
#include "loadorder/pairs/held/held_order.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/workers.hpp"
#include "loadorder/pairs/held/held_blocks.hpp"
#include "loadorder/pairs/pair_bounds.hpp"
#include "message_of.hpp"
#include "pairs_support.hpp"

namespace changeover::test::held_order_test {
namespace {

TEST(HeldOrder, OfTwoSetsIsBetweenTheBoundAndTheFewest) {
  for (std::uint64_t a = 1; a <= 4; ++a) {
    for (std::uint64_t b = 1; a * b <= 12 && a + b <= 7; ++b) {
      for (std::uint64_t room = 2; room <= 4; ++room) {
        const WantedPairs wanted = WantedPairs::between(a, b);
        const LoadOrder order = plan_load_order(wanted, room);
        EXPECT_EQ(defect(order), "") << a << ' ' << b << ' ' << room;
        const std::uint64_t least = fewest_loads(a + b, pairs_of(wanted), room);
        EXPECT_LE(order.facts().bound.loads, least) << a << ' ' << b << ' ' << room;
        EXPECT_EQ(order.facts().loads, least) << a << ' ' << b << ' ' << room;
      }
    }
  }
}

TEST(HeldOrder, OfNewItemsIsBetweenTheBoundAndTheFewest) {
  for (std::uint64_t items = 2; items <= 6; ++items) {
    for (std::uint64_t done = 1; done < items; ++done) {
      for (std::uint64_t room = 2; room <= 4; ++room) {
        const WantedPairs wanted = WantedPairs::beyond(done, items);
        if (wanted.count() > 12) {
          continue;
        }
        const LoadOrder order = plan_load_order(wanted, room);
        EXPECT_EQ(defect(order), "") << items << ' ' << done << ' ' << room;
        const std::uint64_t least = fewest_loads(items, pairs_of(wanted), room);
        EXPECT_LE(order.facts().bound.loads, least) << items << ' ' << done << ' ' << room;
        EXPECT_LE(least, order.facts().loads) << items << ' ' << done << ' ' << room;
      }
    }
  }
}

RC_GTEST_PROP(HeldOrder, BringsTwoSetsTogether, ()) {
  const auto a = *rc::gen::inRange<std::uint64_t>(1, 40);
  const auto b = *rc::gen::inRange<std::uint64_t>(1, 40);
  const auto room = *rc::gen::inRange<std::uint64_t>(2, 20);
  RC_ASSERT(defect(plan_load_order(WantedPairs::between(a, b), room)) == std::string());
}

RC_GTEST_PROP(HeldOrder, BringsNewItemsToAllOthers, ()) {
  const auto items = *rc::gen::inRange<std::uint64_t>(2, 60);
  const auto done = *rc::gen::inRange<std::uint64_t>(0, items);
  const auto room = *rc::gen::inRange<std::uint64_t>(2, 20);
  RC_ASSERT(defect(plan_load_order(WantedPairs::beyond(done, items), room)) == std::string());
}

TEST(HeldOrder, CountsLoadsWithoutMakingThem) {
  // 3 of 12 stay while 12 others pass; the last to pass are the first of the next time.
  EXPECT_EQ(best_held_shape(WantedPairs::between(12, 12), 4).loads, 12U + 4 * 12 - 3);
  // 10 in groups of 4, 3 and 3: one of the 9 others stays at the first turn, and two at the second.
  EXPECT_EQ(best_held_shape(WantedPairs::between(9, 10), 5).loads, 10U + 3 * 9 - 1 - 2);
  // 25 groups of 4 of the larger set: one stays at each turn.
  EXPECT_EQ(best_held_shape(WantedPairs::between(9, 100), 5).loads, 100U + 25 * 9 - 24);
  // The new ones fit: everything is loaded once.
  EXPECT_EQ(best_held_shape(WantedPairs::beyond(1000, 1024), 64).loads, 1024U);
}

TEST(HeldOrder, OfMillionsOfItemsIsMadeAsItGoes) {
  const LoadOrder order = plan_load_order(WantedPairs::between(1'000'000, 2'000'000), 1000);
  EXPECT_FALSE(order.facts().every_step_read);
  CheckOptions options;
  options.all_pairs = false;
  const WantedPairs small = WantedPairs::between(70'000, 100);
  const LoadOrder read = plan_load_order(small, 50);
  const ScheduleVerdict verdict =
      check_schedule(*read.stream(), {.items = 70'100, .room = 50, .wanted = small}, options);
  EXPECT_TRUE(verdict.valid()) << verdict.fault << verdict.example;
  EXPECT_EQ(verdict.loads, read.facts().loads);
}

TEST(HeldOrder, IsPrefetchedAndSplit) {
  for (const WantedPairs& wanted : {WantedPairs::between(9, 14), WantedPairs::beyond(12, 20)}) {
    const PrefetchPlan plan = plan_prefetch(wanted, 5);
    const ScheduleRules rules{.items = wanted.items(),
                              .room = 5,
                              .wanted = wanted,
                              .compute = ComputeRules{},
                              .overlap = true};
    const ScheduleVerdict verdict = verdict_of(work_of(plan.order.stream(), rules), rules);
    EXPECT_TRUE(verdict.valid()) << verdict.fault;
    EXPECT_EQ(verdict.computed, wanted.count());
    const WorkerSplit split = split_load_order(wanted, 5, 3);
    EXPECT_GE(split.facts().makespan, split.facts().makespan_bound.loads);
  }
}

// What the workers bring together, each alone.
std::string defect_of_split(const WorkerSplit& split, const WantedPairs& wanted,
                            std::uint64_t room) {
  const SplitFacts& facts = split.facts();
  std::set<ItemPair> met;
  std::uint64_t loads = 0;
  std::uint64_t makespan = 0;
  for (std::uint64_t w = 0; w < facts.workers.size(); ++w) {
    const auto steps = split.stream(w);
    const Simulation played = simulate(*steps, wanted.items(), room);
    if (!played.fault.empty() || played.loads != facts.workers[w].loads) {
      return fmt::format("worker {}: {} loads, {}", w, played.loads, played.fault);
    }
    met.insert(played.met.begin(), played.met.end());
    loads += played.loads;
    makespan = std::max(makespan, played.loads);
  }
  for (const ItemPair& pair : pairs_of(wanted)) {
    if (met.count(pair) == 0) {
      return fmt::format("{{{},{}}} did not meet", pair.first, pair.second);
    }
  }
  return loads == facts.loads && makespan == facts.makespan &&
                 makespan >= facts.makespan_bound.loads
             ? ""
             : fmt::format("{} loads, makespan {}", loads, makespan);
}

RC_GTEST_PROP(HeldBlocks, BringTwoSetsTogetherForEveryNumberOfWorkers, ()) {
  const auto a = *rc::gen::inRange<std::uint64_t>(1, 30);
  const auto b = *rc::gen::inRange<std::uint64_t>(1, 30);
  const auto room = *rc::gen::inRange<std::uint64_t>(2, 40);
  const auto workers = *rc::gen::inRange<std::uint64_t>(1, 12);
  const WantedPairs wanted = WantedPairs::between(a, b);
  RC_ASSERT(defect_of_split(split_load_order(wanted, room, workers), wanted, room) ==
            std::string());
  // Blocks alone, whether they are better or not.
  const auto blocks = best_held_blocks(wanted, room, workers);
  RC_ASSERT(blocks && blocks->shapes.size() <= workers);
  const auto shared = std::make_shared<const HeldBlocks>(*blocks);
  const auto steps = block_steps(shared, wanted.items());
  const Simulation played = simulate(*steps, wanted.items(), room);
  RC_ASSERT(played.fault == std::string());
  for (const ItemPair& pair : pairs_of(wanted)) {
    RC_ASSERT(played.met.count(pair) == 1U);
  }
}

TEST(HeldBlocks, SplitWhatFitsIntoMemory) {
  // Four workers have 50 items with 50 others each; all 200 would fit.
  const WantedPairs wanted = WantedPairs::between(100, 100);
  const WorkerSplit split = split_load_order(wanted, 200, 4);
  EXPECT_EQ(split.facts().makespan, 100U);
  EXPECT_EQ(split.facts().loads, 400U);
  EXPECT_EQ(split.facts().makespan_bound.loads, 100U);
  EXPECT_EQ(defect_of_split(split, wanted, 200), "");
}

TEST(HeldBlocks, AreNotReadIfTheyAreTooMany) {
  const WantedPairs wanted = WantedPairs::between(100'000, 60'000);
  const WorkerSplit split = split_load_order(wanted, 2000, 4);
  CheckOptions options;
  options.all_pairs = false;
  const ScheduleVerdict verdict = check_schedule(
      *split.stream(), {.items = wanted.items(), .room = 2000, .wanted = wanted}, options);
  EXPECT_TRUE(verdict.valid()) << verdict.fault << verdict.example;
  EXPECT_EQ(verdict.loads, split.facts().loads);
}

TEST(PairBounds, OfTwoSetsCountPairsOneLoadAfterAnother) {
  for (std::uint64_t room = 2; room < 7; ++room) {
    for (std::uint64_t loads = 1; loads < 30; ++loads) {
      const std::uint64_t most = most_between(loads, room);
      EXPECT_LE(least_between(most, room), loads);
      EXPECT_GT(least_between(most + 1, room), loads);
    }
  }
}

TEST(WantedPairs, KnowWhatTheyAre) {
  const WantedPairs two = WantedPairs::between(3, 4);
  EXPECT_EQ(pairs_of(two).size(), two.count());
  const WantedPairs fresh = WantedPairs::beyond(5, 9);
  EXPECT_EQ(pairs_of(fresh).size(), fresh.count());
  EXPECT_NE(two.hash(), WantedPairs::between(4, 3).hash());
  EXPECT_TRUE(WantedPairs().are_all());
  EXPECT_REFUSAL((void)WantedPairs::between(0, 4), BadInput,
                 "0 items with 4 others: give at least 1 of both");
  EXPECT_REFUSAL((void)WantedPairs::beyond(4, 4), BadInput,
                 "items are done, and nothing is left to load; give fewer that are done");
  EXPECT_THROW(plan_load_order(two, 1), BadInput);
  EXPECT_REFUSAL((void)plan_load_order(WantedPairs(), 4), BadInput,
                 "a load order of 0 items: give at least 1 item");
}

}  // namespace
}  // namespace changeover::test::held_order_test
