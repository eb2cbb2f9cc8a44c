// Two levels of memory: against plain sets, and wrong orders refused.
#include "changeover/loadorder/load_order.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/workers.hpp"
#include "loadorder_support.hpp"
#include "message_of.hpp"

namespace changeover::test::two_levels_test {
namespace {

/// The definition in sets. Empty, or what is wrong.
std::string fault_of(const std::vector<Step>& all, std::uint64_t items, std::uint64_t room,
                     std::uint64_t fast_room) {
  std::set<Element> memory;
  std::set<Element> fast;
  std::set<std::pair<Element, Element>> met;
  for (const Step& step : all) {
    for (const Element x : step.fast_evict) {
      if (fast.erase(x) != 1) {
        return fmt::format("step {}: {} is not on the accelerator", step.number, x);
      }
    }
    for (const Element x : step.evict) {
      if (memory.erase(x) != 1 || fast.count(x) != 0) {
        return fmt::format("step {} evicts {}", step.number, x);
      }
    }
    for (const Element x : step.load) {
      if (x >= items || !memory.insert(x).second) {
        return fmt::format("step {} loads {}", step.number, x);
      }
    }
    for (const Element x : step.fast_load) {
      if (memory.count(x) == 0 || !fast.insert(x).second) {
        return fmt::format("step {} transfers {}", step.number, x);
      }
    }
    if (memory.size() > room || fast.size() > fast_room) {
      return fmt::format("step {} holds {} and {}", step.number, memory.size(), fast.size());
    }
    std::set<std::pair<Element, Element>> computed;
    for (const Element x : fast) {
      for (const Element y : fast) {
        if (x < y && met.emplace(x, y).second) {
          computed.emplace(x, y);
        }
      }
    }
    if (computed !=
        std::set<std::pair<Element, Element>>(step.compute.begin(), step.compute.end())) {
      return fmt::format("step {} computes other pairs than those that meet first", step.number);
    }
  }
  return met.size() == items * (items - 1) / 2 ? "" : "pairs are missing";
}

TEST(TwoLevels, OrdersMeetTheDefinitionAndTheBounds) {
  for (const std::uint64_t items : {1U, 2U, 5U, 11U, 24U}) {
    for (const std::uint64_t room : {2U, 3U, 5U, 8U, 15U, 50U}) {
      for (const std::uint64_t fast_room : {2U, 3U, 4U, 8U, 15U}) {
        if (fast_room > room) {
          continue;
        }
        const std::string what = fmt::format("{} {} {}", items, room, fast_room);
        const LoadOrder order = plan_two_levels(items, room, fast_room);
        const LoadOrderFacts& facts = order.facts();
        const auto all = work_of(order.stream(), order.rules(ComputeRules{}));
        EXPECT_EQ(fault_of(all, items, room, fast_room), "") << what;
        std::uint64_t loads = 0;
        std::uint64_t transfers = 0;
        for (const Step& step : all) {
          loads += step.load.size();
          transfers += step.fast_load.size();
        }
        EXPECT_EQ(loads, facts.loads) << what;
        EXPECT_EQ(transfers, facts.transfers) << what;
        EXPECT_EQ(all.size(), facts.steps) << what;
        EXPECT_GE(loads, facts.bound.loads) << what;
        EXPECT_GE(transfers, facts.transfer_bound.loads) << what;
      }
    }
  }
}

TEST(TwoLevels, EverythingInMemoryIsLoadedOnceAndTransferredAsForOneLevel) {
  const LoadOrderFacts facts = plan_two_levels(40, 40, 6).facts();
  EXPECT_EQ(facts.loads, 40U);
  EXPECT_EQ(facts.transfers, plan_load_order(40, 6).facts().loads);
}

TEST(TwoLevels, BothLevelsAreCloseToTheirBoundsIfTheyAreFarApart) {
  const LoadOrderFacts facts = plan_two_levels(300, 60, 7).facts();
  EXPECT_LE(facts.loads * 10, facts.bound.loads * 14);
  EXPECT_LE(facts.transfers * 10, facts.transfer_bound.loads * 13);
}

TEST(TwoLevels, GoWithStoresBothWaysAndItemsAlone) {
  for (const auto& [items, room, fast_room] :
       {std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>{16, 8, 3},
        {24, 15, 4},
        {9, 4, 4}}) {
    const LoadOrder order = plan_two_levels(items, room, fast_room);
    ScheduleRules rules = order.rules(ComputeRules{});
    rules.compute = ComputeRules{.ordered = true, .self = true, .shuffle = 2};
    rules.store = true;
    const std::vector<Step> steps = work_of(order.stream(), rules);
    const ScheduleVerdict verdict = verdict_of(steps, rules);
    EXPECT_TRUE(verdict.valid()) << verdict.fault;
    EXPECT_EQ(verdict.computed, items * items);
    EXPECT_EQ(verdict.transfers, order.facts().transfers);
    EXPECT_GE(verdict.stores, store_lower_bound(order.facts().bound, {}, items, true).loads);
    auto lost = steps;
    lost.back().store.pop_back();
    EXPECT_NE(verdict_of(lost, rules).fault.find("loses"), std::string::npos);
    auto held = steps;
    held.back().fast_evict.clear();
    EXPECT_NE(verdict_of(held, rules).fault.find("on the accelerator"), std::string::npos);
  }
}

TEST(TwoLevels, OfSeveralWorkersComputeEachPairOnceAtOneOfThem) {
  for (const std::uint64_t workers : {1U, 2U, 3U, 50U}) {
    for (const auto& [items, room, fast_room] :
         {std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>{24, 15, 4},
          {30, 8, 3},
          {5, 5, 2}}) {
      const WorkerSplit split = split_two_levels(items, room, fast_room, workers);
      ScheduleRules rules = split.order().rules(ComputeRules{});
      const std::vector<Step> steps = work_of(split.stream(), rules);
      const ScheduleVerdict verdict = verdict_of(steps, rules);
      EXPECT_TRUE(verdict.valid()) << verdict.fault;
      EXPECT_EQ(verdict.computed, items * (items - 1) / 2);
      EXPECT_EQ(verdict.loads, split.facts().loads);
      EXPECT_EQ(verdict.makespan(), split.facts().makespan);
      EXPECT_GE(verdict.makespan(), split.facts().makespan_bound.loads);
      EXPECT_EQ(verdict.transfers, split.facts().transfers);
      EXPECT_GE(verdict.transfers, split.order().facts().transfers);
      // Who computes a pair that another has computed is seen, and so is who starts with a full
      // accelerator.
      auto repeated = steps;
      repeated.back().compute.push_back(repeated.back().compute.front());
      EXPECT_EQ(verdict_of(repeated, rules).repeated, 1U);
      rules.fast_room = fast_room - 1;
      EXPECT_NE(verdict_of(steps, rules).fault.find("accelerator is full"), std::string::npos);
    }
  }
}

TEST(TwoLevels, ChecksRefuseWhatIsWrong) {
  const LoadOrder order = plan_two_levels(16, 8, 3);
  const auto right = work_of(order.stream(), order.rules(ComputeRules{}));
  const auto verdict_of = [&](const std::vector<Step>& all, std::uint64_t room = 8,
                              std::uint64_t fast_room = 3) {
    ScheduleRules rules = order.rules(ComputeRules{});
    rules.room = room;
    rules.fast_room = fast_room;
    return test::verdict_of(all, rules);
  };
  ASSERT_TRUE(verdict_of(right).valid());
  EXPECT_EQ(verdict_of(right).computed, 120U);
  EXPECT_NE(verdict_of(right, 7).fault.find("memory is full"), std::string::npos);
  EXPECT_NE(verdict_of(right, 8, 2).fault.find("the accelerator is full"), std::string::npos);
  EXPECT_FALSE(verdict_of({}).valid());
  const auto refused = [&](const std::string& says, const auto& change) {
    auto wrong = right;
    change(wrong);
    const ScheduleVerdict verdict = verdict_of(wrong);
    EXPECT_FALSE(verdict.valid()) << says;
    EXPECT_NE(verdict.fault.find(says), std::string::npos) << says << ": " << verdict.fault;
  };
  refused("is numbered", [](auto& all) { all[1].number = 9; });
  refused("transfers 15", [](auto& all) { all[0].fast_load[0] = 15; });
  refused("loads 16", [](auto& all) { all[0].load[0] = 16; });
  refused("takes 0 from the accelerator", [](auto& all) { all[0].fast_evict.push_back(0); });
  refused("evicts", [](auto& all) {
    all[1].evict.push_back(all[1].fast_load[0]);
    all[1].evict.push_back(all[1].evict[0]);
  });
  refused("not both on the accelerator",
          [](auto& all) { std::swap(all[0].compute, all[1].compute); });
  refused("", [](auto& all) { all[1].compute.pop_back(); });
  refused("", [](auto& all) { all[1].compute.push_back(all[1].compute[0]); });
}

TEST(TwoLevels, MeetOnTheAcceleratorOrAreRefused) {
  // What is not asked for is not listed: 2·10⁹ pairs would take longer than all else.
  const LoadOrder order = plan_two_levels(40, 15, 4);
  std::vector<Step> steps = all_steps(*order.stream());
  for (const Step& step : steps) {
    EXPECT_TRUE(step.compute.empty()) << step.number;
  }
  EXPECT_TRUE(test::verdict_of(steps, order.rules()).valid());
  steps.back().fast_load.pop_back();
  EXPECT_GT(test::verdict_of(steps, order.rules()).missing, 0U);
  EXPECT_EQ(order.facts().computed, 780U);
}

TEST(TwoLevels, ManyItemsAreReadWithoutTheirPairs) {
  const LoadOrderFacts facts = plan_two_levels(9000, 4000, 300).facts();
  EXPECT_EQ(facts.computed, 0U);
  EXPECT_NE(facts.certificate.find("all 40495500 pairs met on the accelerator"), std::string::npos)
      << facts.certificate;
  const SplitFacts split = split_two_levels(9000, 4000, 300, 3).facts();
  EXPECT_EQ(split.certificate, facts.certificate);
  EXPECT_GT(split.transfers, facts.transfers);
}

TEST(TwoLevels, RefusesWhatCannotBe) {
  EXPECT_REFUSAL(static_cast<void>(plan_two_levels(16, 4, 5)), BadInput,
                 "the accelerator has room for");
  EXPECT_THROW(static_cast<void>(plan_two_levels(16, 4, 1)), BadInput);
  EXPECT_REFUSAL(static_cast<void>(plan_two_levels(0, 4, 2)), BadInput,
                 "a load order of 0 items: give at least 1 item");
  EXPECT_THROW(static_cast<void>(plan_two_levels(70'000, 40, 4)), ImpossibleParameters);
  EXPECT_REFUSAL(
      ScheduleCheck({.items = 7, .room = 4, .fast_room = 0}), BadInput,
      "a load order of 7 items with room for 4 and for 0 on the accelerator: give at least 1 of each");
  EXPECT_REFUSAL(ScheduleCheck({.items = 7, .room = 0, .fast_room = 4}), BadInput,
                 ": give at least 1 of each");
}

}  // namespace
}  // namespace changeover::test::two_levels_test
