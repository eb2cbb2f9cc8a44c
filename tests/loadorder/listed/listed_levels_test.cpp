// Two levels of memory for some pairs only: against plain sets and the fewest loads that there can
// be, and wrong orders refused.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "../pairs/pairs_support.hpp"
#include "changeover/core/error.hpp"
#include "changeover/loadorder/workers.hpp"
#include "loadorder/listed/level_search.hpp"
#include "loadorder/listed/listed_levels.hpp"
#include "loadorder/order/levels/level_cost.hpp"

namespace changeover::test::listed_levels_test {
namespace {

/// One worker's memory and accelerator, played in sets.
struct Player {
  explicit Player(std::set<ItemPair> pairs) : wanted(std::move(pairs)) {}

  void take(const Step& step, std::uint64_t room, std::uint64_t fast_room) {
    const auto fail = [&](const std::string& what) {
      fault = fault.empty() ? fmt::format("step {}: {}", step.number, what) : fault;
    };
    for (const Element x : step.fast_evict) {
      fast.erase(x) == 1 ? void() : fail("not on the accelerator");
    }
    for (const Element x : step.evict) {
      memory.erase(x) == 1 && !fast.contains(x) ? void() : fail("evicted");
      idle.contains(x) ? fail(fmt::format("{} was loaded for nothing", x)) : void();
    }
    for (const Element x : step.load) {
      memory.insert(x).second ? void() : fail("loaded");
      idle.insert(x);
      ++loads;
    }
    for (const Element x : step.fast_load) {
      memory.contains(x) && fast.insert(x).second ? void() : fail("transferred");
      ++transfers;
    }
    if (memory.size() > room || fast.size() > fast_room) {
      fail("too much is held");
    }
    for (const auto& [x, y] : step.compute) {
      fast.contains(x) && fast.contains(y) && wanted.contains({x, y}) ? void() : fail("computed");
      computed.insert({x, y}).second ? void() : fail("computed again");
      idle.erase(x);
      idle.erase(y);
    }
  }

  void next_worker() {
    fault += idle.empty() ? "" : fmt::format("{} was loaded for nothing", *idle.begin());
    memory.clear();
    fast.clear();
  }

  std::set<ItemPair> wanted;
  std::set<Element> memory, fast, idle;
  std::set<ItemPair> computed;
  std::uint64_t loads = 0, transfers = 0;
  std::string fault;
};

TEST(ListedLevels, MeetTheDefinitionAndTheFewestLoads) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const std::uint64_t items = 4 + seed % 4;
    const auto pairs = random_pairs(items, 3 + seed % (items * (items - 1) / 2 - 3), seed);
    const WantedPairs wanted = listed(items, pairs);
    for (std::uint64_t room = 2; room <= 5; ++room) {
      for (std::uint64_t fast_room = 2; fast_room <= room; ++fast_room) {
        const std::string what = fmt::format("{} {} {}", seed, room, fast_room);
        const LoadOrder order = plan_two_levels(wanted, room, fast_room, hardly_searched());
        Player player({pairs.begin(), pairs.end()});
        for (const Step& step : work_of(order.stream(), order.rules(ComputeRules{}))) {
          player.take(step, room, fast_room);
        }
        player.next_worker();
        EXPECT_EQ(player.fault, "") << what;
        EXPECT_EQ(player.computed, player.wanted) << what;
        const LoadOrderFacts& facts = order.facts();
        EXPECT_EQ(player.loads, facts.loads) << what;
        EXPECT_EQ(player.transfers, facts.transfers) << what;
        if (pairs.size() <= 9) {
          EXPECT_GE(facts.loads, fewest_loads(items, pairs, room)) << what;
          EXPECT_LE(facts.bound.loads, fewest_loads(items, pairs, room)) << what;
          EXPECT_GE(facts.transfers, fewest_loads(items, pairs, fast_room)) << what;
          EXPECT_LE(facts.transfer_bound.loads, fewest_loads(items, pairs, fast_room)) << what;
        }
      }
    }
  }
}

TEST(ListedLevels, WorkersComputeEachPairOnceAndLoadNothingInVain) {
  for (const bool balance : {true, false}) {
    for (const std::uint64_t workers : {1U, 2U, 5U, 40U}) {
      for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const std::uint64_t items = 10 + 7 * seed;
        const auto pairs = random_pairs(items, items + 11 * seed, seed);
        const std::uint64_t room = 5 + seed;
        const std::uint64_t fast_room = 2 + seed % 4;
        LoadOrderOptions options = hardly_searched();
        options.balance = balance;
        const WorkerSplit split =
            split_two_levels(listed(items, pairs), room, fast_room, workers, options);
        const SplitFacts& facts = split.facts();
        Player player({pairs.begin(), pairs.end()});
        for (std::uint64_t w = 0; w < workers; ++w) {
          const std::uint64_t before = player.loads;
          const std::size_t computed = player.computed.size();
          StepWork work(split.stream(w), split.rules(ComputeRules{}), split.owners());
          for (const Step& step : all_steps(work)) {
            player.take(step, room, fast_room);
          }
          player.next_worker();
          EXPECT_EQ(player.loads - before, facts.workers[w].loads);
          EXPECT_EQ(player.computed.size() - computed, facts.workers[w].pairs);
        }
        const std::string what = fmt::format("{} {}", workers, seed);
        EXPECT_EQ(player.fault, "") << what;
        EXPECT_EQ(player.computed, player.wanted) << what;
        EXPECT_EQ(player.transfers, facts.transfers) << what;
        EXPECT_GE(facts.makespan, facts.makespan_bound.loads) << what;
        EXPECT_GE(facts.loads, split.order().facts().bound.loads) << what;
        EXPECT_GE(facts.transfers, split.order().facts().transfer_bound.loads) << what;
        // All workers one after another are an order, too.
        EXPECT_TRUE(check_schedule(*split.order().stream(), split.order().rules()).valid()) << what;
      }
    }
  }
}

TEST(ListedLevels, TwoSetsAndNewItemsAreListsToo) {
  for (const WantedPairs& wanted : {WantedPairs::between(9, 14), WantedPairs::beyond(15, 20)}) {
    const LoadOrder order = plan_two_levels(wanted, 9, 4);
    EXPECT_TRUE(check_schedule(*order.stream(), order.rules()).valid());
    EXPECT_EQ(order.facts().computed, wanted.count());
    EXPECT_TRUE(split_two_levels(wanted, 9, 4, 3).facts().pairs_are_known);
  }
  EXPECT_THROW(static_cast<void>(plan_two_levels(WantedPairs::between(65'000, 5000), 9, 4)),
               ImpossibleParameters);
  EXPECT_THROW(static_cast<void>(plan_two_levels(WantedPairs::between(5, 5), 4, 5)), BadInput);
  EXPECT_THROW(static_cast<void>(split_two_levels(WantedPairs::between(5, 5), 4, 5, 2)), BadInput);
}

// What all workers hold is played in sets; pairs are counted where they are computed.
TEST(ListedLevels, TwoSetsAndNewItemsForWorkers) {
  for (const auto& [wanted, room, fast_room] : {std::tuple{WantedPairs::between(1, 1), 2U, 2U},
                                                std::tuple{WantedPairs::between(1, 9), 4U, 3U},
                                                std::tuple{WantedPairs::between(7, 11), 5U, 2U},
                                                std::tuple{WantedPairs::between(20, 33), 12U, 4U},
                                                std::tuple{WantedPairs::between(30, 30), 16U, 8U},
                                                std::tuple{WantedPairs::between(12, 12), 30U, 5U},
                                                std::tuple{WantedPairs::beyond(1, 2), 2U, 2U},
                                                std::tuple{WantedPairs::beyond(29, 30), 6U, 3U},
                                                std::tuple{WantedPairs::beyond(11, 30), 9U, 4U},
                                                std::tuple{WantedPairs::beyond(3, 40), 14U, 5U}}) {
    std::set<ItemPair> pairs;
    for (Element y = 0; y < wanted.items(); ++y) {
      for (Element x = 0; x < y; ++x) {
        if (wanted.contains(x, y)) {
          pairs.insert({x, y});
        }
      }
    }
    for (const std::uint64_t workers : {1U, 3U, 4U, 40U}) {
      // What is found in all of the time is looked at for few items.
      const WorkerSplit split =
          split_two_levels(wanted, room, fast_room, workers,
                           wanted.items() <= 20 ? LoadOrderOptions{} : hardly_searched());
      const SplitFacts& facts = split.facts();
      const ScheduleRules rules = split.rules(ComputeRules{});
      Player player(pairs);
      std::vector<Step> all;
      for (std::uint64_t w = 0; w < workers; ++w) {
        const std::uint64_t before = player.loads;
        const std::size_t computed = player.computed.size();
        StepWork work(split.stream(w), rules, split.owners());
        for (const Step& step : all_steps(work)) {
          player.idle.clear();  // groups may bring items that a worker does not need
          player.take(step, room, fast_room);
          all.push_back(step);
        }
        player.idle.clear();
        player.next_worker();
        EXPECT_EQ(player.loads - before, facts.workers[w].loads);
        EXPECT_EQ(player.computed.size() - computed, facts.workers[w].pairs);
      }
      const std::string what = fmt::format("{} {} {}", wanted.describe(), room, workers);
      EXPECT_EQ(player.fault, "") << what;
      EXPECT_EQ(player.computed, pairs) << what;
      EXPECT_EQ(player.transfers, facts.transfers) << what;
      EXPECT_GE(facts.makespan, facts.makespan_bound.loads) << what;
      EXPECT_GE(facts.transfers, split.order().facts().transfer_bound.loads) << what;
      for (const std::size_t at : {std::size_t{0}, all.size() / 2, all.size() - 1}) {
        std::vector<Step> wrong = all;
        if (!wrong[at].fast_load.empty() && !wrong[at].compute.empty()) {
          wrong[at].fast_load.clear();
          EXPECT_FALSE(verdict_of(wrong, rules).valid()) << what;
        }
        wrong = all;
        if (!wrong[at].compute.empty()) {
          wrong[at].compute.pop_back();
          EXPECT_EQ(verdict_of(wrong, rules).missing, 1U) << what;
        }
      }
    }
  }
}

// Each of few workers has a part of both sets: not much more than at one level.
TEST(ListedLevels, TwoSetsOfWorkersAreNotFarFromOneLevel) {
  for (const std::uint64_t workers : {1U, 4U, 9U}) {
    const WantedPairs wanted = WantedPairs::between(100, 100);
    const SplitFacts one = split_load_order(wanted, 20, workers).facts();
    const SplitFacts two = split_two_levels(wanted, 20, 6, workers).facts();
    EXPECT_LE(two.makespan * 10, one.makespan * 16) << workers;
    EXPECT_LE(two.transfers, 2 * 2005U) << workers;
  }
}

TEST(ListedLevels, ItemsThatAreOnlyLoadedAreTransferredOnce) {
  const auto graph = std::make_shared<const PairGraph>(
      9, std::vector<ItemPair>{{0, 1}, {1, 2}, {2, 3}, {7, 7}, {8, 8}});
  const WantedPairs wanted = WantedPairs::listed(graph);
  for (const std::uint64_t workers : {1U, 3U}) {
    const WorkerSplit split = split_two_levels(wanted, 3, 2, workers);
    std::map<Element, int> alone;
    StepWork work(split.stream(), split.rules(ComputeRules{.self = true}), split.owners());
    for (Step step; work.next(step);) {
      for (const auto& [x, y] : step.compute) {
        alone[x] += x == y ? 1 : 0;
      }
    }
    EXPECT_EQ(alone, (std::map<Element, int>{{0, 1}, {1, 1}, {2, 1}, {3, 1}, {7, 1}, {8, 1}}));
  }
}

TEST(ListedLevels, GoWithStoresAndEpochs) {
  const auto pairs = close_points(40, 130, 3);
  for (const std::uint64_t epochs : {1U, 3U}) {
    LoadOrder once = plan_two_levels(listed(40, pairs), 12, 4, hardly_searched());
    const LoadBound bound = once.facts().bound;
    const WantedPairs wanted = once.facts().wanted;
    const LoadOrder order = repeat_order(std::move(once), epochs);
    ScheduleRules rules = order.rules(ComputeRules{.ordered = true, .self = true});
    rules.store = true;
    std::vector<Step> steps = work_of(order.stream(), rules);
    const ScheduleVerdict verdict = verdict_of(steps, rules);
    EXPECT_TRUE(verdict.valid()) << verdict.fault << verdict.missing;
    EXPECT_EQ(verdict.computed, epochs * (2 * pairs.size() + 40));
    EXPECT_GE(verdict.stores, store_lower_bound(bound, wanted, 40, true).loads);
    steps.back().store.pop_back();
    EXPECT_NE(verdict_of(steps, rules).fault.find("loses"), std::string::npos);
  }
  const WorkerSplit split = repeat_shares(split_two_levels(listed(40, pairs), 12, 4, 3), 2);
  StepWork work(split.stream(), split.rules(ComputeRules{}), split.owners());
  const ScheduleVerdict verdict = check_schedule(work, split.rules(ComputeRules{}));
  EXPECT_TRUE(verdict.valid()) << verdict.fault << verdict.missing;
  EXPECT_EQ(verdict.computed, 2 * pairs.size());
}

TEST(ListedLevels, ChecksRefuseWhatIsWrong) {
  const auto pairs = close_points(30, 90, 5);
  const LoadOrder order = plan_two_levels(listed(30, pairs), 10, 4);
  const std::vector<Step> right = all_steps(*order.stream());
  const auto refused = [&](const std::string& says, const auto& change) {
    std::vector<Step> wrong = right;
    change(wrong);
    const ScheduleVerdict verdict = verdict_of(wrong, order.rules());
    EXPECT_FALSE(verdict.valid()) << says;
    EXPECT_NE(verdict.fault.find(says), std::string::npos) << says << ": " << verdict.fault;
  };
  ASSERT_TRUE(verdict_of(right, order.rules()).valid());
  refused("", [](auto& all) { all.back().fast_load.pop_back(); });
  refused("loads 30", [](auto& all) { all[0].load[0] = 30; });
  refused("not in memory", [](auto& all) { all[0].load.pop_back(); });
  refused("takes", [](auto& all) { all[0].fast_evict.push_back(all[0].load[0]); });
  // A pair of the list that never meets is missed, whichever it is.
  for (const ItemPair& pair : pairs) {
    std::vector<Step> wrong = right;
    for (Step& step : wrong) {  // the larger item never comes
      for (auto* const list : {&step.evict, &step.load, &step.fast_evict, &step.fast_load}) {
        std::erase(*list, pair.second);
      }
    }
    EXPECT_GT(verdict_of(wrong, order.rules()).missing, 0U);
  }
}

TEST(ListedLevels, AreCloseToBothBounds) {
  const WantedPairs wanted = listed(400, close_points(400, 3000, 1));
  const LoadOrderFacts facts = plan_two_levels(wanted, 60, 10).facts();
  EXPECT_LE(facts.loads * 10, facts.bound.loads * 12) << facts.loads << " " << facts.bound.loads;
  EXPECT_LE(facts.transfers * 10, facts.transfer_bound.loads * 19)
      << facts.transfers << " " << facts.transfer_bound.loads;
}

TEST(ListedLevels, ASearchHasNoWorseOrderAndOneThatIsRight) {
  for (const auto& [wanted, room, fast_room] :
       {std::tuple{listed(40, close_points(40, 130, 3)), 10U, 4U},
        std::tuple{listed(25, random_pairs(25, 60, 4)), 8U, 3U},
        std::tuple{listed(12, random_pairs(12, 40, 2)), 5U, 5U},
        std::tuple{listed(9, {{0, 1}, {1, 2}, {5, 8}}), 2U, 2U}}) {
    const LoadOrder before = plan_two_levels(wanted, room, fast_room, hardly_searched());
    const LoadOrderFacts& facts = before.facts();
    const std::vector<Move> start = moves_of(*before.stream());
    int rounds = 300;
    const std::vector<Move> found =
        search_levels(*wanted.graph(), facts, start, 1, [&] { return --rounds < 0; });
    if (found.empty()) {
      continue;
    }
    EXPECT_LT(cost_of(found, facts), cost_of(start, facts));
    StepLists lists;
    lists.add(found);
    const ScheduleVerdict verdict = check_schedule(*lists.of(0), before.rules());
    EXPECT_TRUE(verdict.valid()) << verdict.fault << verdict.example;
    EXPECT_GE(verdict.loads, facts.bound.loads);
    EXPECT_GE(verdict.transfers, facts.transfer_bound.loads);
  }
  const auto list = listed(40, close_points(40, 130, 3));
  LoadOrderFacts rooms = plan_two_levels(list, 10, 4, hardly_searched()).facts();
  // From a poor start something is found, the same each time.
  const std::vector<Move> poor = moves_of(*plan_two_levels(40, 10, 4).stream());
  const auto search = [&] {
    int rounds = 100;
    return search_levels(*list.graph(), rooms, poor, 7, [&] { return --rounds < 0; });
  };
  EXPECT_FALSE(search().empty());
  EXPECT_EQ(cost_of(search(), rooms), cost_of(search(), rooms));
}

}  // namespace
}  // namespace changeover::test::listed_levels_test
