// Two sets, and items that are new, against everything there is.
#include "loadorder/pairs/held_order.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/load_check.hpp"
#include "changeover/loadorder/prefetch.hpp"
#include "changeover/loadorder/workers.hpp"
#include "pairs_support.hpp"

namespace changeover::test {
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
  LoadCheckOptions options;
  options.all_pairs = false;
  options.wanted = order.facts().wanted;
  const WantedPairs small = WantedPairs::between(70'000, 100);
  const LoadOrder read = plan_load_order(small, 50);
  options.wanted = small;
  const auto steps = read.stream();
  const LoadVerdict verdict = check_loads(*steps, 70'100, 50, options);
  EXPECT_TRUE(verdict.valid()) << verdict.fault << verdict.uncovered_example;
  EXPECT_EQ(verdict.loads, read.facts().loads);
}

TEST(HeldOrder, IsPrefetchedAndSplit) {
  for (const WantedPairs& wanted : {WantedPairs::between(9, 14), WantedPairs::beyond(12, 20)}) {
    const PrefetchPlan plan = plan_prefetch(wanted, 5);
    PrefetchSchedule schedule(plan.order.stream(), wanted.items(), 5, wanted);
    PrefetchCheck check(wanted.items(), 5, wanted);
    for (PrefetchStep step; schedule.next(step);) {
      check.read(step);
    }
    const PrefetchVerdict verdict = check.finish();
    EXPECT_TRUE(verdict.valid()) << verdict.fault;
    EXPECT_EQ(verdict.computed, wanted.count());
    const WorkerSplit split = split_load_order(wanted, 5, 3);
    EXPECT_GE(split.facts().makespan, split.facts().makespan_bound.loads);
  }
}

TEST(WantedPairs, KnowWhatTheyAre) {
  const WantedPairs two = WantedPairs::between(3, 4);
  EXPECT_EQ(pairs_of(two).size(), two.count());
  const WantedPairs fresh = WantedPairs::beyond(5, 9);
  EXPECT_EQ(pairs_of(fresh).size(), fresh.count());
  EXPECT_NE(two.hash(), WantedPairs::between(4, 3).hash());
  EXPECT_TRUE(WantedPairs().are_all());
  EXPECT_THROW(WantedPairs::between(0, 4), BadInput);
  EXPECT_THROW(WantedPairs::beyond(4, 4), BadInput);
  EXPECT_THROW(plan_load_order(two, 1), BadInput);
  EXPECT_THROW(plan_load_order(WantedPairs(), 4), BadInput);
}

}  // namespace
}  // namespace changeover::test
