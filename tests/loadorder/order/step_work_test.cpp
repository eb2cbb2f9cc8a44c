// What steps compute: each pair once, in the first step that has it, in all the ways that can be
// asked for.
#include "changeover/loadorder/load_order.hpp"

#include <gtest/gtest.h>

#include <map>

#include "changeover/loadorder/workers.hpp"
#include "pairs/pairs_support.hpp"

namespace changeover::test::step_work_test {
namespace {

ScheduleRules rules_of(const LoadOrder& order, const ComputeRules& compute) {
  const LoadOrderFacts& facts = order.facts();
  return {.items = facts.items, .room = facts.room, .wanted = facts.wanted, .compute = compute};
}

std::vector<Step> steps_of(const LoadOrder& order, const ComputeRules& compute) {
  return work_of(order.stream(), rules_of(order, compute));
}

ScheduleVerdict verdict_of(const LoadOrder& order, const std::vector<Step>& steps,
                           const ComputeRules& compute) {
  return test::verdict_of(steps, rules_of(order, compute));
}

TEST(StepWork, HasEachPairInTheFirstStepThatHoldsIt) {
  for (const bool ordered : {false, true}) {
    for (const bool self : {false, true}) {
      for (const bool shuffled : {false, true}) {
        ComputeRules options{.ordered = ordered, .self = self};
        if (shuffled) {
          options.shuffle = 7;
        }
        for (const LoadOrder& order :
             {plan_load_order(24, 6), plan_load_order(WantedPairs::between(7, 9), 4),
              plan_load_order(listed(20, random_pairs(20, 50, 1)), 5)}) {
          const LoadOrderFacts& facts = order.facts();
          const auto steps = steps_of(order, options);
          EXPECT_EQ(steps.size(), facts.steps);
          std::map<ItemPair, int> times;
          std::set<Element> memory;
          for (const Step& step : steps) {
            for (const Element x : step.evict) {
              memory.erase(x);
            }
            memory.insert(step.load.begin(), step.load.end());
            for (const ItemPair& pair : step.compute) {
              ++times[pair];
              EXPECT_TRUE(memory.count(pair.first) == 1 && memory.count(pair.second) == 1);
            }
            for (const Element x : memory) {
              for (const Element y : memory) {
                const bool wanted =
                    x == y ? self : (facts.wanted.contains(x, y) && (ordered || x < y));
                EXPECT_EQ(times.count({x, y}), wanted ? 1U : 0U);
              }
            }
          }
          for (const auto& [pair, count] : times) {
            EXPECT_EQ(count, 1);
          }
          const ScheduleVerdict verdict = verdict_of(order, steps, options);
          EXPECT_TRUE(verdict.valid()) << verdict.fault;
          EXPECT_EQ(verdict.computed, times.size());
        }
      }
    }
  }
}

TEST(StepWork, IsShuffledByTheSeedWithinItsStepOnly) {
  const LoadOrder order = plan_load_order(24, 6);
  const auto plain = steps_of(order, {});
  const auto first = steps_of(order, {.shuffle = 1});
  const auto again = steps_of(order, {.shuffle = 1});
  const auto other = steps_of(order, {.shuffle = 2});
  bool differ = false;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_EQ(first[i].compute, again[i].compute);
    differ = differ || first[i].compute != other[i].compute;
    auto sorted = first[i].compute;
    auto expected = plain[i].compute;
    std::sort(sorted.begin(), sorted.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(sorted, expected);
  }
  EXPECT_TRUE(differ);
}

TEST(StepWork, CheckSeesWhatIsMissedRepeatedOrNotThere) {
  const LoadOrder order = plan_load_order(9, 4);
  const ComputeRules options{.ordered = true, .self = true};
  const auto right = steps_of(order, options);
  auto steps = right;
  steps[2].compute.pop_back();
  EXPECT_EQ(verdict_of(order, steps, options).missing, 1U);
  steps = right;
  steps[2].compute.push_back(steps[2].compute.front());
  EXPECT_EQ(verdict_of(order, steps, options).repeated, 1U);
  steps = right;
  steps[0].compute.push_back(right.back().compute.back());
  EXPECT_NE(verdict_of(order, steps, options).fault.find("not both in memory"), std::string::npos);
  steps = right;
  steps[1].evict.push_back(steps[1].load.front());
  EXPECT_NE(verdict_of(order, steps, options).fault.find("evicts"), std::string::npos);
  EXPECT_NE(verdict_of(order, right, {.ordered = true}).fault.find("not wanted"),
            std::string::npos);
  EXPECT_NE(verdict_of(order, right, {.self = true}).fault.find("not wanted"), std::string::npos);
}

TEST(StepWork, OfSeveralWorkersHasEachPairOnce) {
  const WorkerSplit split = split_load_order(20, 5, 3);
  const ComputeRules options{.self = true};
  const ScheduleRules rules{.items = 20, .room = 5, .compute = options};
  const ScheduleVerdict verdict = test::verdict_of(work_of(split.stream(), rules), rules);
  EXPECT_TRUE(verdict.valid()) << verdict.fault << verdict.missing << ' ' << verdict.repeated;
  EXPECT_EQ(verdict.computed, 190U + 20U);
}

}  // namespace
}  // namespace changeover::test::step_work_test
