// The check rejects what is wrong by one load, one eviction, one item.
#include "changeover/loadorder/schedule.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "all_pairs/load_orders.hpp"
#include "changeover/core/error.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "loadorder_support.hpp"

namespace changeover::test::schedule_check_test {
namespace {

std::vector<Step> steps_of(const LoadOrder& order) { return all_steps(*order.stream()); }

ScheduleVerdict verdict_of(const std::vector<Step>& steps, std::uint64_t items, std::uint64_t room,
                           const CheckOptions& options = {}) {
  return test::verdict_of(steps, {.items = items, .room = room}, options);
}

TEST(ScheduleCheck, AcceptsWhatIsRightAndCountsIt) {
  const LoadOrder order = plan_load_order(20, 5);
  const ScheduleVerdict verdict = verdict_of(steps_of(order), 20, 5);
  EXPECT_TRUE(verdict.valid());
  EXPECT_EQ(verdict.loads, order.facts().loads);
  EXPECT_EQ(verdict.steps, order.facts().steps);
  EXPECT_EQ(verdict.most_in_memory, 5U);
  EXPECT_EQ(verdict.watched_items, 20U);
}

TEST(ScheduleCheck, RejectsEachSingleMutationOfATightOrder) {
  // 21 blocks of a tight SCCD(12,4): nothing can be spared.
  const std::vector<Step> good = steps_of(plan_load_order(12, 4));
  ASSERT_TRUE(verdict_of(good, 12, 4).valid());
  for (std::size_t i = 0; i < good.size(); ++i) {
    auto dropped = good;
    dropped.erase(dropped.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(verdict_of(dropped, 12, 4).valid()) << i;
    for (std::size_t j = i; j < dropped.size(); ++j) {
      dropped[j].number = j + 1;
    }
    EXPECT_FALSE(verdict_of(dropped, 12, 4).valid()) << i;
    auto kept = good;
    if (!kept[i].evict.empty()) {
      kept[i].evict.clear();
      EXPECT_FALSE(verdict_of(kept, 12, 4).valid()) << i;
    }
    auto other = good;
    other[i].load.back() = 12;
    EXPECT_NE(verdict_of(other, 12, 4).fault.find("not an item"), std::string::npos);
    other[i].load.back() = good[i].load.front() == 0 ? 1 : 0;
    EXPECT_FALSE(verdict_of(other, 12, 4).valid()) << i;
  }
  auto absent = good;
  absent[1].evict.front() = absent[1].load.front();
  EXPECT_NE(verdict_of(absent, 12, 4).fault.find("not in memory"), std::string::npos);
  auto twice = good;
  twice[1].load.push_back(twice[0].load.back());
  twice[1].evict.clear();
  EXPECT_NE(verdict_of(twice, 13, 6).fault.find("which is in memory"), std::string::npos);
  EXPECT_NE(verdict_of(good, 12, 3).fault.find("full"), std::string::npos);
  EXPECT_EQ(verdict_of(good, 13, 4).missing, 12U);
  EXPECT_FALSE(verdict_of({}, 1, 2).valid());
}

TEST(ScheduleCheck, FollowsAFewItemsWhenNotAllPairsAreAskedFor) {
  CheckOptions few;
  few.all_pairs = false;
  few.watched = 12;
  std::vector<Step> steps = steps_of(plan_load_order(12, 4));
  EXPECT_TRUE(verdict_of(steps, 12, 4, few).valid());
  steps.pop_back();
  EXPECT_FALSE(verdict_of(steps, 12, 4, few).valid());
  few.watched = 3;
  EXPECT_EQ(verdict_of(steps, 12, 4, few).watched_items, 3U);
  EXPECT_THROW(ScheduleCheck({.items = 70'000, .room = 4}), MissingResource);
  EXPECT_THROW(ScheduleCheck({.items = 0, .room = 4}), BadInput);
}

TEST(ScheduleCheck, HasTheSameVerdictUnderOtherNames) {
  const std::vector<Step> good = steps_of(plan_load_order(12, 4));
  CheckOptions renamed;
  for (Element x = 0; x < 12; ++x) {
    renamed.kept_as.push_back((5 * x + 3) % 12);
  }
  EXPECT_TRUE(verdict_of(good, 12, 4, renamed).valid());
  for (std::size_t i = 1; i < good.size(); ++i) {
    auto dropped = good;
    dropped.resize(i);
    const ScheduleVerdict own = verdict_of(dropped, 12, 4);
    const ScheduleVerdict other = verdict_of(dropped, 12, 4, renamed);
    EXPECT_FALSE(other.valid()) << i;
    EXPECT_EQ(other.missing, own.missing) << i;
    EXPECT_EQ(other.loads, own.loads) << i;
  }
  // Names are translated back: 0 and 1 never meet.
  ScheduleCheck check({.items = 3, .room = 2}, {.kept_as = {2, 0, 1}});
  check.read({1, {}, {0, 2}});
  check.read({2, {0}, {1}});
  EXPECT_EQ(check.finish().example, "{0,1}");
  for (const auto& names : std::vector<std::vector<Element>>{{0, 1}, {0, 1, 1}, {0, 1, 3}}) {
    EXPECT_THROW(ScheduleCheck({.items = 3, .room = 2}, {.kept_as = names}), BadInput);
  }
}

TEST(ScheduleCheck, StartsOverWithAnEmptyMemoryForTheNextWorker) {
  ScheduleCheck check({.items = 3, .room = 2});
  check.read({1, {}, {0, 1}});
  check.read({.number = 1, .load = {1, 2}, .worker = 1});
  check.read({.number = 2, .evict = {1}, .load = {0}, .worker = 1});
  EXPECT_TRUE(check.finish().valid()) << check.finish().fault;
}

RC_GTEST_PROP(ScheduleCheck, AgreesWithTheSimulation, ()) {
  const auto items = *rc::gen::inRange<std::uint64_t>(2, 30);
  const auto room = *rc::gen::inRange<std::uint64_t>(2, 10);
  LoadOrderOptions options;
  options.constructions = false;
  std::vector<Step> steps = steps_of(plan_load_order(items, room, options));
  // Drop the loads of some steps at the end: legal, but pairs may be missing.
  const auto cut = *rc::gen::inRange<std::size_t>(0, 4);
  steps.resize(steps.size() - std::min(cut, steps.size() - 1));
  Simulation simulation;
  simulation.items = items;
  for (const Step& step : steps) {
    simulation.take(step, room);
  }
  const ScheduleVerdict verdict = verdict_of(steps, items, room);
  RC_ASSERT(verdict.fault.empty() == simulation.fault.empty());
  RC_ASSERT(verdict.missing == simulation.missing());
  RC_ASSERT(verdict.loads == simulation.loads);
}

TEST(Baselines, AreLoadOrdersWithTheNumbersOfBlocksThatAreKnown) {
  struct Known {
    std::uint64_t items, room, blocks;
  };
  for (const Known& known : {Known{8, 4, 10}, Known{12, 4, 24}, Known{15, 4, 38}, Known{20, 5, 52},
                             Known{26, 6, 71}, Known{32, 16, 34}, Known{64, 32, 66}}) {
    EXPECT_EQ(beta_order(known.items, known.room).facts().steps, known.blocks);
  }
  EXPECT_EQ(exhaustive_order(1000, 100).facts().loads, 35'834U);
  for (const std::uint64_t room : {2U, 3U, 7U}) {
    for (std::uint64_t items = 1; items <= 25; ++items) {
      for (LoadOrder& order : baseline_orders(items, room)) {
        const Simulation simulation = simulate(order, items, room);
        EXPECT_EQ(simulation.fault, "") << order.facts().method << items << " " << room;
        EXPECT_EQ(simulation.missing(), 0U) << order.facts().method << items << " " << room;
        EXPECT_EQ(simulation.loads, order.facts().loads);
        EXPECT_GE(simulation.loads, order.facts().bound.loads);
      }
    }
  }
}

}  // namespace
}  // namespace changeover::test::schedule_check_test
