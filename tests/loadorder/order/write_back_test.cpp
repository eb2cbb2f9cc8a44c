// What is stored when items change: against plain counting, and wrong lists refused.
#include "changeover/loadorder/write_back.hpp"

#include <gtest/gtest.h>

#include <map>

#include "changeover/loadorder/disjoint.hpp"

namespace changeover::test {
namespace {

std::vector<StoredStep> steps_of(const LoadOrder& order) {
  const LoadOrderFacts& facts = order.facts();
  StepWork work(facts.items, facts.room, facts.wanted);
  work.start(order.stream());
  WriteBack back(facts.items);
  std::vector<StoredStep> all;
  StoredStep step;
  while (work.next(step.work)) {
    back.read(step);
    all.push_back(step);
  }
  back.finish(step);
  all.push_back(step);
  return all;
}

std::string fault_of(const std::vector<StoredStep>& all, std::uint64_t items) {
  StoreCheck check(items);
  for (const StoredStep& step : all) {
    check.read({&step, 1});
  }
  return check.finish();
}

TEST(WriteBack, StoresEachStayThatComputesOnceAndNothingElse) {
  for (const auto& [items, room] :
       {std::pair<std::uint64_t, std::uint64_t>{1, 2}, {4, 9}, {9, 4}, {20, 5}, {30, 7}}) {
    const LoadOrder order = plan_load_order(items, room);
    const auto all = steps_of(order);
    EXPECT_EQ(fault_of(all, items), "");
    // By the definition: a stay is from a load to an eviction.
    std::map<Element, bool> held;  // whether it changed
    std::uint64_t expected = 0;
    std::uint64_t stores = 0;
    for (const StoredStep& step : all) {
      for (const Element x : step.work.loads.evict) {
        expected += held.at(x) ? 1U : 0U;
        EXPECT_EQ(std::count(step.store.begin(), step.store.end(), x), held.at(x) ? 1 : 0);
        held.erase(x);
      }
      for (const Element x : step.work.loads.load) {
        held[x] = false;
      }
      for (const auto& [x, y] : step.work.pairs) {
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
  EXPECT_EQ(fault_of(all, 5), "");
  std::uint64_t stores = 0;
  for (const StoredStep& step : all) {
    EXPECT_EQ(std::count(step.store.begin(), step.store.end(), 4U), 0);
    stores += step.store.size();
  }
  EXPECT_EQ(order.facts().loads, 4U);
  EXPECT_EQ(stores, 3U);
  EXPECT_EQ(store_lower_bound(order.facts().bound, wanted, 5, false).loads, 3U);
  EXPECT_EQ(store_lower_bound(order.facts().bound, wanted, 5, true).loads, 4U);
}

TEST(WriteBack, ChecksRefuseWhatLosesAChangeOrStoresInVain) {
  const auto right = steps_of(plan_load_order(12, 4));
  ASSERT_EQ(fault_of(right, 12), "");
  const auto refused = [&](const std::string& says, const auto& change) {
    auto wrong = right;
    change(wrong);
    EXPECT_NE(fault_of(wrong, 12).find(says), std::string::npos)
        << says << ": " << fault_of(wrong, 12);
  };
  refused("loses what was changed", [](auto& all) { all[1].store.clear(); });
  refused("loses what was changed", [](auto& all) { all.back().store.pop_back(); });
  refused("has not changed", [](auto& all) { all[1].store.push_back(all[1].store[0]); });
  refused("stores 11, which is not held", [](auto& all) { all[0].store.push_back(11); });
  refused("which is not held", [](auto& all) { all[0].work.loads.load.pop_back(); });
  refused("which is held or no item", [](auto& all) { all[0].work.loads.load.push_back(0); });
  refused("still held at the end", [](auto& all) { all.pop_back(); });
}

TEST(WriteBack, OfDisjointWorkersLosesNoChange) {
  const DisjointOrder order = plan_disjoint_order(18, 4, 3);
  LockstepWork work(order);
  std::vector<WriteBack> backs(3, WriteBack(18));
  StoreCheck check(18);
  std::vector<StoredStep> stored(3);
  for (std::vector<WorkStep> steps; work.next(steps);) {
    for (std::size_t w = 0; w < 3; ++w) {
      stored[w].work = steps[w];
      backs[w].read(stored[w]);
    }
    check.read(stored);
  }
  for (std::size_t w = 0; w < 3; ++w) {
    backs[w].finish(stored[w]);
  }
  check.read(stored);
  EXPECT_EQ(check.finish(), "");
  EXPECT_GE(backs[0].stores() + backs[1].stores() + backs[2].stores(), order.facts().bound.loads);
}

}  // namespace
}  // namespace changeover::test
