// The check rejects what is wrong by one load, one eviction, one item.
#include "changeover/loadorder/schedule.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "all_pairs/load_orders.hpp"
#include "changeover/core/error.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "loadorder_support.hpp"
#include "message_of.hpp"

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
  EXPECT_REFUSAL(ScheduleCheck({.items = 70'000, .room = 4}), MissingResource,
                 "items have too many pairs to track; give at most");
  EXPECT_REFUSAL(ScheduleCheck({.items = 0, .room = 4}), BadInput,
                 "a load order of 0 items with room for 4: give at least 1 of each");
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
    EXPECT_REFUSAL(ScheduleCheck({.items = 3, .room = 2}, {.kept_as = names}), BadInput,
                   "the other names of the items are not a permutation of them");
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

TEST(Baselines, CometIsBetaOfGroups) {
  for (const auto& [items, room, group, loads] :
       std::vector<std::array<std::uint64_t, 4>>{{64, 16, 1, 166},
                                                 {64, 16, 2, 172},
                                                 {64, 16, 8, 232},
                                                 {1000, 100, 50, 9550},
                                                 {12, 6, 3, 21}}) {
    LoadOrder order = comet_order(items, room, group);
    EXPECT_EQ(order.facts().loads, loads);
    if (items < 100) {
      const Simulation simulation = simulate(order, items, room);
      EXPECT_EQ(simulation.fault, "");
      EXPECT_EQ(simulation.missing(), 0U);
      EXPECT_EQ(simulation.loads, loads);
    }
  }
  EXPECT_THROW(static_cast<void>(comet_order(64, 16, 3)), BadInput);
  EXPECT_THROW(static_cast<void>(comet_order(64, 16, 16)), BadInput);
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

/// A random schedule: of each worker in turn, in lockstep or one after another.
struct Wandering {
  ScheduleRules rules;
  std::vector<Step> steps;
  std::set<ItemPair> met;  // in one memory, or on one accelerator
};

Wandering wander(std::mt19937& random, const ScheduleRules& rules, std::uint64_t count) {
  const auto below = [&](std::size_t n) { return std::size_t{random() % n}; };
  Wandering all{rules, {}, {}};
  const bool fast = rules.fast_room.has_value();
  const std::size_t workers = static_cast<std::size_t>(rules.lockstep > 0 ? rules.lockstep : 3);
  std::vector<std::vector<Element>> memory(workers);
  std::vector<std::vector<Element>> accelerator(workers);
  std::set<Element> held;
  const auto leave = [&](std::vector<Element>& list, std::vector<Element>& said) {
    const std::size_t i = below(list.size());
    said.push_back(list[i]);
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
  };
  const auto meet = [&](Element x, const std::vector<Element>& others) {
    for (const Element y : others) {
      if (rules.wanted.contains(x, y)) {
        all.met.emplace(std::min(x, y), std::max(x, y));
      }
    }
  };
  const auto play = [&](std::size_t w, std::uint64_t number) {
    Step step{.number = number, .worker = w};
    while (!accelerator[w].empty() && below(3) == 0) {
      leave(accelerator[w], step.fast_evict);
    }
    // What is on the accelerator stays; the others go now and then, many at a time.
    const bool full = memory[w].size() == rules.room;
    for (std::size_t n = full ? 1 + below(below(40) == 0 ? rules.room : 3) : 0; n > 0; --n) {
      const std::size_t i = below(memory[w].size());
      const Element x = memory[w][i];
      if (std::count(accelerator[w].begin(), accelerator[w].end(), x) == 0) {
        step.evict.push_back(x);
        held.erase(x);
        memory[w].erase(memory[w].begin() + static_cast<std::ptrdiff_t>(i));
        if (memory[w].empty()) {
          break;
        }
      }
    }
    while (memory[w].size() < rules.room && held.size() < rules.items && below(50) != 0) {
      const auto x = static_cast<Element>(below(rules.items));
      if (held.insert(x).second) {
        step.load.push_back(x);
        if (!fast) {
          meet(x, memory[w]);
        }
        memory[w].push_back(x);
      }
    }
    for (std::size_t tries = fast ? below(9) : 0; tries > 0 && !memory[w].empty(); --tries) {
      const Element x = memory[w][below(memory[w].size())];
      if (accelerator[w].size() < *rules.fast_room &&
          std::count(accelerator[w].begin(), accelerator[w].end(), x) == 0) {
        step.fast_load.push_back(x);
        meet(x, accelerator[w]);
        accelerator[w].push_back(x);
      }
    }
    all.steps.push_back(std::move(step));
  };
  for (std::size_t w = 0; w < (rules.lockstep > 0 ? 1 : workers); ++w) {
    held.clear();
    for (std::uint64_t number = 1; number <= count; ++number) {
      for (std::size_t other = 0; other < rules.lockstep; ++other) {
        play(other, number);
      }
      if (rules.lockstep == 0) {
        play(w, number);
      }
    }
  }
  return all;
}

TEST(ScheduleCheck, MissesThePairsThatTheDefinitionMisses) {
  std::mt19937 random(26);
  std::uint64_t missing = 0;
  const std::vector<WantedPairs> kinds{
      {}, WantedPairs::between(70, 160), WantedPairs::beyond(100, 230)};
  for (const WantedPairs& wanted : kinds) {
    for (const std::uint64_t lockstep : {0U, 1U, 2U, 3U}) {
      for (const std::uint64_t room : {5U, 31U, 40U, 70U}) {
        for (const std::uint64_t fast_room : {0U, 4U, 33U}) {
          if (fast_room > room) {
            continue;
          }
          ScheduleRules rules{.items = 230, .room = room, .lockstep = lockstep, .wanted = wanted};
          if (fast_room > 0) {
            rules.fast_room = fast_room;
          }
          const Wandering all = wander(random, rules, 60 + random() % 2000);
          CheckOptions named;
          for (Element x = 0; x < 230; ++x) {
            named.kept_as.push_back((7 * x + 3) % 230);
          }
          const std::uint64_t expected =
              (wanted.are_all() ? 230U * 229 / 2 : wanted.count()) - all.met.size();
          const std::string what =
              fmt::format("{} {} {} {}", wanted.describe(), lockstep, room, fast_room);
          for (const CheckOptions& options : {CheckOptions{}, named}) {
            const ScheduleVerdict verdict = test::verdict_of(all.steps, rules, options);
            EXPECT_EQ(verdict.fault, "") << what;
            EXPECT_EQ(verdict.missing, expected) << what;
          }
          missing += expected;
          CheckOptions few;
          few.all_pairs = false;
          few.watched = 230;  // all of them: each missing pair from both sides
          EXPECT_EQ(test::verdict_of(all.steps, rules, few).missing, 2 * expected) << what;
        }
      }
    }
  }
  EXPECT_GT(missing, 0U);
}

}  // namespace
}  // namespace changeover::test::schedule_check_test
