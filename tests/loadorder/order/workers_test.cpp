#include "changeover/loadorder/workers.hpp"

#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "loadorder_support.hpp"

namespace changeover::test {
namespace {

TEST(Workers, TogetherBringEveryPairTogetherWithinTheirRoom) {
  for (const std::uint64_t room : {2U, 3U, 5U, 8U, 12U}) {
    for (std::uint64_t items = 1; items <= 30; items += items < 8 ? 1 : 5) {
      for (const std::uint64_t workers : {1U, 2U, 3U, 7U, 40U}) {
        const WorkerSplit split = split_load_order(items, room, workers);
        const SplitFacts& facts = split.facts();
        ASSERT_EQ(facts.workers.size(), workers);
        Simulation all;
        all.items = items;
        std::uint64_t loads = 0;
        std::uint64_t makespan = 0;
        for (std::uint64_t w = 0; w < workers; ++w) {
          const auto steps = split.stream(w);
          const Simulation one = simulate(*steps, items, room);
          EXPECT_EQ(one.fault, "") << items << " " << room << " " << workers;
          EXPECT_EQ(one.loads, facts.workers[w].loads);
          EXPECT_EQ(one.steps, facts.workers[w].steps);
          all.met.insert(one.met.begin(), one.met.end());
          loads += one.loads;
          makespan = std::max(makespan, one.loads);
        }
        EXPECT_EQ(all.missing(), 0U) << items << " " << room << " " << workers;
        EXPECT_EQ(loads, facts.loads);
        EXPECT_EQ(makespan, facts.makespan);
        EXPECT_EQ(facts.certificate,
                  "every step read, all " + std::to_string(items * (items - 1) / 2) + " pairs met");
        EXPECT_EQ(facts.explanation.starts_with("Of " + std::to_string(facts.groups) + " groups"),
                  facts.groups < items);
        EXPECT_GE(makespan, facts.makespan_bound.loads) << items << " " << room << " " << workers;
      }
    }
  }
}

TEST(Workers, OneOfThemIsTheWholeOrder) {
  const WorkerSplit split = split_load_order(20, 5, 1);
  EXPECT_EQ(split.facts().makespan, plan_load_order(20, 5).facts().loads);
  EXPECT_EQ(split.facts().makespan_bound.loads, load_lower_bound(20, 5).loads);
}

TEST(Workers, StretchesAreWithinOneRoomOfTheBound) {
  const WorkerSplit split = split_load_order(1000, 100, 8);
  EXPECT_LE(split.facts().makespan, split.facts().makespan_bound.loads + 100);
}

TEST(Workers, ManyOfThemWorkOnGroupsOfItems) {
  // Everything would fit at once; three workers with two of three groups each need fewer loads.
  const WorkerSplit split = split_load_order(30, 30, 3);
  EXPECT_EQ(split.facts().groups, 3U);
  EXPECT_EQ(split.facts().makespan, 20U);
}

TEST(Workers, RefuseNoneAndTooMany) {
  EXPECT_THROW(static_cast<void>(split_load_order(9, 4, 0)), BadInput);
  EXPECT_THROW(static_cast<void>(split_load_order(9, 4, 1'000'000)), BadInput);
  EXPECT_THROW(static_cast<void>(split_load_order(9, 4, 2).stream(2)), BadInput);
}

}  // namespace
}  // namespace changeover::test
