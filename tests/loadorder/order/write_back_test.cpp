// What is stored when items change: against plain counting, and wrong lists refused.
#include <gtest/gtest.h>

#include <map>

#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/workers.hpp"
#include "loadorder_support.hpp"

namespace changeover::test::write_back_test {
namespace {

std::vector<Step> steps_of(const LoadOrder& order) {
  const LoadOrderFacts& facts = order.facts();
  return work_of(order.stream(), {.items = facts.items,
                                  .room = facts.room,
                                  .wanted = facts.wanted,
                                  .compute = ComputeRules{},
                                  .store = true});
}

std::string fault_of(const std::vector<Step>& all, const LoadOrder& order) {
  const LoadOrderFacts& facts = order.facts();
  return verdict_of(all, {.items = facts.items,
                          .room = facts.room,
                          .wanted = facts.wanted,
                          .compute = ComputeRules{},
                          .store = true})
      .fault;
}

TEST(WriteBack, StoresEachStayThatComputesOnceAndNothingElse) {
  for (const auto& [items, room] :
       {std::pair<std::uint64_t, std::uint64_t>{1, 2}, {4, 9}, {9, 4}, {20, 5}, {30, 7}}) {
    const LoadOrder order = plan_load_order(items, room);
    const auto all = steps_of(order);
    EXPECT_EQ(fault_of(all, order), "");
    // By the definition: a stay is from a load to an eviction.
    std::map<Element, bool> held;  // whether it changed
    std::uint64_t expected = 0;
    std::uint64_t stores = 0;
    for (const Step& step : all) {
      for (const Element x : step.evict) {
        expected += held.at(x) ? 1U : 0U;
        EXPECT_EQ(std::count(step.store.begin(), step.store.end(), x), held.at(x) ? 1 : 0);
        held.erase(x);
      }
      for (const Element x : step.load) {
        held[x] = false;
      }
      for (const auto& [x, y] : step.compute) {
        held.at(x) = held.at(y) = true;
      }
      stores += step.store.size();
    }
    EXPECT_TRUE(held.empty());
    EXPECT_EQ(stores, expected);
    EXPECT_LE(stores, order.facts().loads);
    EXPECT_GE(stores, store_lower_bound(order.facts().bound, {}, items, false).loads);
  }
}

TEST(WriteBack, ItemsWithoutAPairAreNotStored) {
  const std::vector<ItemPair> pairs = {{0, 1}, {1, 2}, {4, 4}};
  const WantedPairs wanted = WantedPairs::listed(std::make_shared<const PairGraph>(5, pairs));
  const LoadOrder order = plan_load_order(wanted, 2);
  const auto all = steps_of(order);
  EXPECT_EQ(fault_of(all, order), "");
  std::uint64_t stores = 0;
  for (const Step& step : all) {
    EXPECT_EQ(std::count(step.store.begin(), step.store.end(), 4U), 0);
    stores += step.store.size();
  }
  auto in_vain = all;
  for (Step& step : in_vain) {
    step.store = step.evict;
  }
  EXPECT_NE(fault_of(in_vain, order).find("stores 4, which has not changed"), std::string::npos);
  EXPECT_EQ(order.facts().loads, 4U);
  EXPECT_EQ(stores, 3U);
  EXPECT_EQ(store_lower_bound(order.facts().bound, wanted, 5, false).loads, 3U);
  EXPECT_EQ(store_lower_bound(order.facts().bound, wanted, 5, true).loads, 4U);
}

TEST(WriteBack, ChecksRefuseWhatLosesAChangeOrStoresInVain) {
  const LoadOrder order = plan_load_order(12, 4);
  const auto right = steps_of(order);
  ASSERT_EQ(fault_of(right, order), "");
  const auto refused = [&](const std::string& says, const auto& change) {
    auto wrong = right;
    change(wrong);
    EXPECT_NE(fault_of(wrong, order).find(says), std::string::npos)
        << says << ": " << fault_of(wrong, order);
  };
  refused("loses what was changed", [](auto& all) { all[1].store.clear(); });
  refused("loses what was changed", [](auto& all) { all.back().store.pop_back(); });
  refused("which it does not evict then",
          [](auto& all) { all[1].store.push_back(all[1].store[0]); });
  refused("stores 11, which it does not evict then", [](auto& all) { all[0].store.push_back(11); });
  refused("which are not both in memory", [](auto& all) { all[0].load.pop_back(); });
  refused("when memory is full", [](auto& all) { all[0].load.push_back(0); });
  refused("still held at the end", [](auto& all) { all.pop_back(); });
}

TEST(WriteBack, OfDisjointWorkersLosesNoChange) {
  const LoadOrder order = plan_disjoint_order(18, 4, 3);
  ScheduleRules rules = order.rules(ComputeRules{});
  rules.store = true;
  const ScheduleVerdict verdict = verdict_of(work_of(order.stream(), rules), rules);
  EXPECT_TRUE(verdict.valid()) << verdict.fault;
  EXPECT_EQ(verdict.steps, order.facts().steps + 1);
  EXPECT_GE(verdict.stores, order.facts().bound.loads);
}

}  // namespace
}  // namespace changeover::test::write_back_test
