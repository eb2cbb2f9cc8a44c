// What steps compute: each pair once, in the first step that has it, in all the ways that can be asked for.
#include "changeover/loadorder/step_work.hpp"

#include <gtest/gtest.h>

#include <map>

#include "changeover/loadorder/workers.hpp"
#include "pairs/pairs_support.hpp"

namespace changeover::test {
namespace {

std::vector<WorkStep> steps_of(const LoadOrder& order, const StepWorkOptions& options) {
  const LoadOrderFacts& facts = order.facts();
  StepWork work(facts.items, facts.room, facts.wanted, options);
  work.start(order.stream());
  std::vector<WorkStep> steps;
  for (WorkStep step; work.next(step);) {
    steps.push_back(step);
  }
  return steps;
}

WorkVerdict verdict_of(const LoadOrder& order, const std::vector<WorkStep>& steps,
                       const StepWorkOptions& options) {
  WorkCheck check(order.facts().items, order.facts().wanted, options);
  for (const WorkStep& step : steps) {
    check.read(step);
  }
  return check.finish();
}

TEST(StepWork, HasEachPairInTheFirstStepThatHoldsIt) {
  for (const bool ordered : {false, true}) {
    for (const bool self : {false, true}) {
      for (const bool shuffled : {false, true}) {
        StepWorkOptions options{.ordered = ordered, .self = self};
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
          for (const WorkStep& step : steps) {
            for (const Element x : step.loads.evict) {
              memory.erase(x);
            }
            memory.insert(step.loads.load.begin(), step.loads.load.end());
            for (const ItemPair& pair : step.pairs) {
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
          const WorkVerdict verdict = verdict_of(order, steps, options);
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
    EXPECT_EQ(first[i].pairs, again[i].pairs);
    differ = differ || first[i].pairs != other[i].pairs;
    auto sorted = first[i].pairs;
    auto expected = plain[i].pairs;
    std::sort(sorted.begin(), sorted.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(sorted, expected);
  }
  EXPECT_TRUE(differ);
}

TEST(StepWork, CheckSeesWhatIsMissedRepeatedOrNotThere) {
  const LoadOrder order = plan_load_order(9, 4);
  const StepWorkOptions options{.ordered = true, .self = true};
  const auto right = steps_of(order, options);
  auto steps = right;
  steps[2].pairs.pop_back();
  EXPECT_EQ(verdict_of(order, steps, options).missing, 1U);
  steps = right;
  steps[2].pairs.push_back(steps[2].pairs.front());
  EXPECT_EQ(verdict_of(order, steps, options).repeated, 1U);
  steps = right;
  steps[0].pairs.push_back(right.back().pairs.back());
  EXPECT_NE(verdict_of(order, steps, options).fault.find("not in memory"), std::string::npos);
  steps = right;
  steps[1].loads.evict.push_back(steps[1].loads.load.front());
  EXPECT_NE(verdict_of(order, steps, options).fault.find("evicts"), std::string::npos);
  EXPECT_NE(verdict_of(order, right, {.ordered = true}).fault.find("not wanted"),
            std::string::npos);
  EXPECT_NE(verdict_of(order, right, {.self = true}).fault.find("not wanted"), std::string::npos);
}

TEST(StepWork, OfSeveralWorkersHasEachPairOnce) {
  const WorkerSplit split = split_load_order(20, 5, 3);
  const StepWorkOptions options{.self = true};
  StepWork work(20, 5, {}, options);
  WorkCheck check(20, {}, options);
  for (std::uint64_t w = 0; w < 3; ++w) {
    work.start(split.stream(w));
    check.start_over();
    for (WorkStep step; work.next(step);) {
      check.read(step);
    }
  }
  const WorkVerdict verdict = check.finish();
  EXPECT_TRUE(verdict.valid()) << verdict.fault << verdict.missing << ' ' << verdict.repeated;
  EXPECT_EQ(verdict.computed, 190U + 20U);
}

}  // namespace
}  // namespace changeover::test
