// Disjoint workers with two levels: the definition in sets, and wrong orders refused.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "../pairs/pairs_support.hpp"
#include "changeover/core/error.hpp"
#include "changeover/loadorder/workers.hpp"

namespace changeover::test::lockstep_levels_test {
namespace {

/// What all workers hold, played in sets: all leave, then all come.
struct Rounds {
  std::vector<std::set<Element>> memory, fast;
  std::set<ItemPair> computed;
  std::uint64_t loads = 0, transfers = 0;
  std::string fault;

  explicit Rounds(std::size_t workers) : memory(workers), fast(workers) {}

  void fail(const Step& step, const std::string& what) {
    fault =
        fault.empty() ? fmt::format("step {} of {}: {}", step.number, step.worker, what) : fault;
  }

  void play(const std::vector<Step>& all, std::uint64_t room, std::uint64_t fast_room) {
    const std::size_t workers = memory.size();
    for (std::size_t i = 0; i + workers <= all.size(); i += workers) {
      for (std::size_t w = 0; w < workers; ++w) {
        leave(all[i + w], w, i / workers + 1);
      }
      for (std::size_t w = 0; w < workers; ++w) {
        come(all[i + w], w, room, fast_room);
      }
    }
    fault += all.size() % workers == 0 ? "" : "a worker has more steps";
  }

  void leave(const Step& step, std::size_t w, std::size_t number) {
    step.worker == w&& step.number == number ? void() : fail(step, "numbers");
    for (const Element x : step.fast_evict) {
      fast[w].erase(x) == 1 ? void() : fail(step, "not on the accelerator");
    }
    for (const Element x : step.evict) {
      memory[w].erase(x) == 1 && !fast[w].contains(x) ? void() : fail(step, "evicted");
    }
  }

  void come(const Step& step, std::size_t w, std::uint64_t room, std::uint64_t fast_room) {
    for (const Element x : step.load) {
      for (const std::set<Element>& other : memory) {
        other.contains(x) ? fail(step, fmt::format("{} is held", x)) : void();
      }
      memory[w].insert(x);
      ++loads;
    }
    for (const Element x : step.fast_load) {
      memory[w].contains(x) && fast[w].insert(x).second ? void() : fail(step, "transferred");
      ++transfers;
    }
    memory[w].size() <= room&& fast[w].size() <= fast_room ? void() : fail(step, "too much");
    for (const auto& [x, y] : step.compute) {
      fast[w].contains(x) && fast[w].contains(y) && computed.insert({x, y}).second
          ? void()
          : fail(step, "computed");
    }
  }
};

std::set<ItemPair> pairs_in(const WantedPairs& wanted) {
  std::set<ItemPair> pairs;
  for (Element y = 0; y < wanted.items(); ++y) {
    for (Element x = 0; x < y; ++x) {
      if (wanted.contains(x, y)) {
        pairs.insert({x, y});
      }
    }
  }
  return pairs;
}

TEST(LockstepLevels, EachPairIsComputedOnceOnAnAcceleratorAndNoItemIsHeldTwice) {
  for (const auto& [wanted, room, fast_room] :
       {std::tuple{WantedPairs(30), 5U, 3U}, std::tuple{WantedPairs(48), 12U, 4U},
        std::tuple{WantedPairs(33), 8U, 8U}, std::tuple{WantedPairs(16), 4U, 2U},
        std::tuple{WantedPairs::between(9, 14), 6U, 3U},
        std::tuple{WantedPairs::beyond(12, 24), 6U, 4U},
        std::tuple{listed(25, random_pairs(25, 60, 4)), 6U, 3U},
        std::tuple{listed(40, close_points(40, 130, 3)), 9U, 9U}}) {
    for (const std::uint64_t workers : {1U, 2U, 4U}) {
      const LoadOrder order =
          plan_disjoint_levels(wanted, room, fast_room, workers, hardly_searched());
      const LoadOrderFacts& facts = order.facts();
      const std::string what = fmt::format("{} {} {}", wanted.describe(), room, workers);
      const std::vector<Step> all = work_of(order.stream(), order.rules(ComputeRules{}));
      Rounds rounds(workers);
      rounds.play(all, room, fast_room);
      EXPECT_EQ(rounds.fault, "") << what;
      EXPECT_EQ(rounds.computed, pairs_in(wanted)) << what;
      EXPECT_EQ(rounds.loads, facts.loads) << what;
      EXPECT_EQ(rounds.transfers, facts.transfers) << what;
      EXPECT_GE(facts.loads, facts.bound.loads) << what;
      EXPECT_GE(facts.transfers, facts.transfer_bound.loads) << what;
      EXPECT_GE(facts.span, facts.makespan_bound.loads) << what;
    }
  }
}

TEST(LockstepLevels, GoWithStoresAndEpochsAndWhatIsWrongIsFound) {
  for (const std::uint64_t epochs : {1U, 3U}) {
    const LoadOrder order = repeat_order(plan_disjoint_levels(40, 8, 4, 3), epochs);
    ScheduleRules rules = order.rules(ComputeRules{.ordered = true, .self = true, .spread = 3});
    rules.store = true;
    const std::vector<Step> all = work_of(order.stream(), rules);
    const ScheduleVerdict verdict = verdict_of(all, rules);
    EXPECT_TRUE(verdict.valid()) << verdict.fault << verdict.missing;
    EXPECT_EQ(verdict.computed, epochs * 1600);
    EXPECT_GE(verdict.transfers, order.facts().transfer_bound.loads);
    const auto refused = [&](const auto& change) {
      std::vector<Step> wrong = all;
      const auto step = std::ranges::find_if(wrong, [](const Step& each) {
        return each.number > 3 && !each.evict.empty() && !each.store.empty();
      });
      ASSERT_NE(step, wrong.end());
      change(*step);
      EXPECT_FALSE(verdict_of(wrong, rules).valid());
    };
    refused([](Step& step) { step.store.pop_back(); });
    refused([](Step& step) { step.evict.pop_back(); });
    refused([](Step& step) { step.load.push_back(step.evict.front()); });
    refused([](Step& step) { step.worker ^= 1U; });
    refused([](Step& step) { step.number += 1; });
    std::vector<Step> wrong = all;
    const auto step = std::ranges::find_if(
        wrong, [](const Step& each) { return !each.fast_load.empty() && !each.compute.empty(); });
    step->fast_load.clear();
    EXPECT_FALSE(verdict_of(wrong, rules).valid());
  }
}

TEST(LockstepLevels, MoreWorkersThanItemsFillAreIdle) {
  const LoadOrder order = plan_disjoint_levels(20, 6, 4, 11);
  Rounds rounds(11);
  rounds.play(work_of(order.stream(), order.rules(ComputeRules{})), 6, 4);
  EXPECT_EQ(rounds.fault, "");
  EXPECT_EQ(rounds.computed, pairs_in(20));
  EXPECT_GT(std::ranges::count(order.facts().worker_loads, 0U), 0);
}

TEST(LockstepLevels, TooManyItemsOrPairsAreRefused) {
  EXPECT_THROW(static_cast<void>(plan_disjoint_levels(20, 4, 5, 2)), BadInput);
  EXPECT_THROW(static_cast<void>(plan_disjoint_levels(70'000, 4, 3, 2)), ImpossibleParameters);
}

}  // namespace
}  // namespace changeover::test::lockstep_levels_test
