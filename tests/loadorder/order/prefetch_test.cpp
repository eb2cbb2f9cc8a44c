#include "changeover/loadorder/workers.hpp"

#include <gtest/gtest.h>

#include "loadorder_support.hpp"

namespace changeover::test::prefetch_test {
namespace {

ScheduleRules rules_of(std::uint64_t items, std::uint64_t room) {
  return {.items = items, .room = room, .compute = ComputeRules{}, .overlap = true};
}

std::vector<Step> schedule_of(const LoadOrder& order, std::uint64_t room) {
  return work_of(order.stream(), rules_of(order.facts().items, room));
}

ScheduleVerdict verdict_of(const std::vector<Step>& steps, std::uint64_t items,
                           std::uint64_t room) {
  return test::verdict_of(steps, rules_of(items, room));
}

TEST(Prefetch, ComputesEachPairOnceWithWhatIsThereForAllSmallItemsAndRoom) {
  for (std::uint64_t room = 2; room <= 12; ++room) {
    for (std::uint64_t items = 1; items <= 40; items += 3) {
      LoadOrderOptions options;
      options.closure_rules = false;
      const LoadOrder order = plan_load_order(items, room, options);
      for (const std::uint64_t spare : {0U, 1U, 2U}) {
        const ScheduleVerdict verdict =
            verdict_of(schedule_of(order, room + spare), items, room + spare);
        EXPECT_TRUE(verdict.valid()) << verdict.fault << " " << items << " " << room;
        EXPECT_EQ(verdict.computed, items * (items - 1) / 2);
      }
    }
  }
}

TEST(Prefetch, OverlapsEverythingButTheFirstStepWithAPlaceToSpare) {
  const LoadOrder order = plan_load_order(40, 5);
  const std::vector<Step> steps = schedule_of(order, 6);
  for (std::size_t i = 1; i < steps.size(); ++i) {
    EXPECT_TRUE(steps[i].compute.empty());
    EXPECT_EQ(steps[i].late, steps[i].evict.size());
  }
}

TEST(Prefetch, WithoutOnlyPairsWithWhatGoesComeBeforeTheLoads) {
  const LoadOrder order = plan_load_order(12, 4);
  const std::vector<Step> steps = schedule_of(order, 4);
  for (std::size_t i = 1; i + 1 < steps.size(); ++i) {
    const std::vector<Element>& gone = steps[i + 1].evict;
    ASSERT_EQ(gone.size() - steps[i + 1].late, 1U);
    for (const ItemPair& pair : steps[i].compute) {
      EXPECT_TRUE(pair.first == gone[0] || pair.second == gone[0]);
    }
    for (const ItemPair& pair : steps[i].overlap) {
      EXPECT_TRUE(pair.first != gone[0] && pair.second != gone[0]);
    }
  }
}

TEST(Prefetch, PlanLeavesAPlaceWhereItemsPassOneByOne) {
  const PrefetchPlan plan = plan_prefetch(1000, 100);
  EXPECT_EQ(plan.spare, 1U);
  EXPECT_EQ(plan.order.facts().room, 99U);
  EXPECT_EQ(plan_prefetch(9, 2).spare, 0U);
  EXPECT_EQ(plan_prefetch(9, 20).spare, 0U);
}

// Every way in which work can be asked for, with workers one after another.
TEST(Prefetch, GoesWithWorkersStoresBothWaysAndItemsAlone) {
  for (const std::uint64_t workers : {1U, 2U, 3U, 7U}) {
    for (const std::uint64_t room : {2U, 3U, 6U, 20U}) {
      for (const std::uint64_t items : {1U, 5U, 19U, 24U}) {
        const PrefetchSplit plan = split_prefetch(items, room, workers);
        ScheduleRules rules = rules_of(items, room);
        rules.compute = ComputeRules{.ordered = true, .self = true, .shuffle = 5};
        rules.store = workers == 1;
        const std::vector<Step> steps = work_of(plan.order.stream(), rules);
        const ScheduleVerdict verdict = test::verdict_of(steps, rules);
        EXPECT_TRUE(verdict.valid()) << verdict.fault << " " << items << " " << room;
        EXPECT_EQ(verdict.computed, items * items);
        EXPECT_EQ(verdict.loads, plan.order.facts().loads);
        if (rules.store) {
          EXPECT_GE(verdict.stores, load_lower_bound(items, room).loads);
          auto lost = steps;
          lost.back().store.pop_back();
          EXPECT_NE(test::verdict_of(lost, rules).fault.find("loses"), std::string::npos);
        }
      }
    }
  }
}

TEST(Prefetch, CheckSeesWhatIsStoredBeforeItsPairsAreComputed) {
  ScheduleRules rules = rules_of(12, 6);
  rules.store = true;
  const LoadOrder order = plan_load_order(12, 5);  // with a place to spare all goes late
  const std::vector<Step> right = work_of(order.stream(), rules);
  ASSERT_TRUE(test::verdict_of(right, rules).valid());
  int seen = 0;
  for (std::size_t i = 1; i + 1 < right.size(); ++i) {
    auto early = right;
    early[i].late = 0;
    seen += test::verdict_of(early, rules).valid() ? 0 : 1;
  }
  EXPECT_GT(seen, 5);
  auto more = right;
  more[1].late = more[1].evict.size() + 1;
  EXPECT_NE(test::verdict_of(more, rules).fault.find("late"), std::string::npos);
}

TEST(Prefetch, CheckRejectsPairsThatWentOrHaveNotArrivedAndPairsTwice) {
  const LoadOrder order = plan_load_order(12, 4);
  const std::vector<Step> good = schedule_of(order, 4);
  ASSERT_TRUE(verdict_of(good, 12, 4).valid());
  int moved = 0;
  for (std::size_t i = 0; i < good.size(); ++i) {
    if (!good[i].compute.empty() && i + 1 < good.size() && i > 0) {
      auto late = good;  // the pair with what goes, computed after it went
      late[i].overlap.push_back(late[i].compute.back());
      late[i].compute.pop_back();
      EXPECT_FALSE(verdict_of(late, 12, 4).valid()) << i;
      ++moved;
    }
    auto lost = good;
    auto& pairs = lost[i].overlap.empty() ? lost[i].compute : lost[i].overlap;
    const ItemPair pair = pairs.back();
    pairs.pop_back();
    EXPECT_EQ(verdict_of(lost, 12, 4).missing, 1U);
    pairs.push_back(pair);
    pairs.push_back(pair);
    EXPECT_EQ(verdict_of(lost, 12, 4).repeated, 1U);
  }
  EXPECT_GT(moved, 10);
  EXPECT_FALSE(verdict_of(good, 12, 3).valid());
  auto early = good;  // computed while it is still on its way
  early[1].overlap.push_back(
      {std::min(good[2].load[0], good[1].load[0]), std::max(good[2].load[0], good[1].load[0])});
  EXPECT_NE(verdict_of(early, 12, 4).fault, "");
}

TEST(Prefetch, OfMoreItemsThanPairsCanBeKeptInMindComputesWhatArrivesAgainstAllThere) {
  const LoadOrder order = plan_load_order(1'000'000, 10);
  StepWork schedule(order.stream(), rules_of(1'000'000, 11));
  Step step;
  ASSERT_TRUE(schedule.next(step));
  EXPECT_EQ(step.compute.size() + step.overlap.size(), 45U);
  ASSERT_TRUE(schedule.next(step));
  EXPECT_EQ(step.compute.size(), 0U);
  EXPECT_EQ(step.overlap.size(), 9U);
}

}  // namespace
}  // namespace changeover::test::prefetch_test
