// Workers that never hold one item twice: against plain sets, against all orders of small
// parameters, and wrong ones refused.
#include "changeover/loadorder/workers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <map>

#include "changeover/core/error.hpp"
#include "loadorder/order/lockstep/eras.hpp"
#include "loadorder/order/lockstep/grown.hpp"
#include "loadorder_support.hpp"
#include "message_of.hpp"

namespace changeover::test::disjoint_test {
namespace {

using Steps = std::vector<std::vector<Step>>;  // by worker

Steps steps_of(const LoadOrder& order) {
  Steps all;
  for (std::uint64_t w = 0; w < order.facts().lockstep; ++w) {
    all.emplace_back();
    const auto steps = order.stream(w);
    for (Step step; steps->next(step);) {
      all.back().push_back(step);
    }
  }
  return all;
}

/// The definition: sets, nothing else. "" if all pairs meet and no item is held twice.
std::string fault_of(const Steps& all, std::uint64_t items, std::uint64_t room) {
  std::set<std::pair<Element, Element>> met;
  std::vector<std::set<Element>> memory(all.size());
  for (std::size_t s = 0; s < all[0].size(); ++s) {
    for (std::size_t w = 0; w < all.size(); ++w) {
      if (all[w].size() != all[0].size() || all[w][s].number != s + 1) {
        return "numbers";
      }
      for (const Element x : all[w][s].evict) {
        if (memory[w].erase(x) != 1) {
          return fmt::format("worker {} evicts {} in step {}", w, x, s + 1);
        }
      }
      for (const Element x : all[w][s].load) {
        if (x >= items || !memory[w].insert(x).second) {
          return fmt::format("worker {} loads {} in step {}", w, x, s + 1);
        }
      }
      if (memory[w].size() > room) {
        return fmt::format("worker {} holds {}", w, memory[w].size());
      }
    }
    std::set<Element> held;
    for (const auto& each : memory) {
      for (const Element x : each) {
        if (!held.insert(x).second) {
          return fmt::format("{} is held twice in step {}", x, s + 1);
        }
        for (const Element y : each) {
          if (x < y) {
            met.emplace(x, y);
          }
        }
      }
    }
  }
  return met.size() == items * (items - 1) / 2 ? "" : "pairs are missing";
}

TEST(Disjoint, OrdersOfAllKindsMeetTheDefinition) {
  for (const std::uint64_t workers : {1U, 2U, 3U, 5U}) {
    for (const std::uint64_t room : {2U, 3U, 4U, 7U}) {
      for (const std::uint64_t more : {0U, 1U, 7U, 16U}) {
        const std::uint64_t items = workers * room + more;
        const LoadOrder order = plan_disjoint_order(items, room, workers);
        const LoadOrderFacts& facts = order.facts();
        const std::string what = fmt::format("{} {} {}", items, room, workers);
        const Steps all = steps_of(order);
        EXPECT_EQ(fault_of(all, items, room), "") << what;
        EXPECT_GE(facts.loads, facts.bound.loads) << what;
        EXPECT_GE(facts.makespan(), facts.makespan_bound.loads) << what;
        EXPECT_GE(facts.span, facts.makespan()) << what;
        std::uint64_t loads = 0;
        std::uint64_t span = 0;
        for (std::size_t s = 0; s < all[0].size(); ++s) {
          std::size_t slowest = 0;
          for (const auto& worker : all) {
            loads += worker[s].load.size();
            slowest = std::max(slowest, worker[s].load.size());
          }
          span += slowest;
        }
        EXPECT_EQ(loads, facts.loads) << what;
        EXPECT_EQ(span, facts.span) << what;
        EXPECT_EQ(all[0].size(), facts.steps) << what;
      }
    }
  }
}

TEST(Disjoint, ErasMeetTheDefinitionForAllNumbersOfGroups) {
  for (const std::uint64_t workers : {2U, 3U, 4U, 5U, 7U, 9U}) {
    for (const std::uint64_t items : {workers * 3, workers * 3 + 1, workers * 7 + 5}) {
      for (std::uint64_t groups = workers; groups <= items; ++groups) {
        const EraShape shape{items, workers, groups};
        Steps all(static_cast<std::size_t>(workers));
        std::uint64_t loads = 0;
        for (std::size_t w = 0; w < all.size(); ++w) {
          const auto steps = era_steps(shape, w);
          for (Step step; steps->next(step);) {
            loads += step.load.size();
            all[w].push_back(step);
          }
        }
        const std::uint64_t largest = (items + groups - 1) / groups;
        EXPECT_EQ(fault_of(all, items, largest + 1), "")
            << items << " " << workers << " " << groups;
        EXPECT_EQ(cost_of_eras(shape).loads, loads);
        EXPECT_EQ(cost_of_eras(shape).steps, all[0].size());
      }
    }
  }
}

TEST(Disjoint, EveryRuleGrowsOrdersToTheirEndAndCutsGoOn) {
  Random random(5);
  for (std::size_t rule = 0; rule < growth_rules; ++rule) {
    for (const auto& [items, room, workers] :
         {std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>{12, 3, 4},
          {13, 3, 4},
          {20, 5, 2}}) {
      const auto whole = grow_order(items, room, workers, {}, 0, growth_rule(rule), 10'000, random);
      ASSERT_TRUE(whole) << rule << " " << items;
      const std::size_t keep = whole->steps.size() / 2;
      const auto again =
          grow_order(items, room, workers, *whole, keep, growth_rule(rule), 10'000, random);
      ASSERT_TRUE(again);
      for (std::size_t s = 0; s < keep; ++s) {
        ASSERT_EQ(again->steps[s].size(), whole->steps[s].size());
        for (std::size_t i = 0; i < again->steps[s].size(); ++i) {
          EXPECT_EQ(again->steps[s][i].in, whole->steps[s][i].in);
        }
      }
      EXPECT_FALSE(grow_order(items, room, workers, {}, 0, growth_rule(rule), 2, random));
    }
  }
}

// The fewest loads of all workers together: a search through everything that two workers can hold
// and have done.
std::uint64_t fewest_loads(unsigned items, unsigned room) {
  using State =
      std::pair<std::pair<unsigned, unsigned>, std::uint32_t>;  // memories, pairs that met
  const auto rank = [](unsigned x, unsigned y) {
    return std::max(x, y) * (std::max(x, y) - 1) / 2 + std::min(x, y);
  };
  const std::uint32_t all = (1U << (items * (items - 1) / 2)) - 1;
  std::map<State, std::uint64_t> loads;
  std::deque<State> queue{{{0, 0}, 0}};
  loads[queue.front()] = 0;
  while (!queue.empty()) {
    const State state = queue.front();
    queue.pop_front();
    const std::uint64_t so_far = loads[state];
    if (state.second == all) {
      return so_far;
    }
    const auto reach = [&](const State& next, std::uint64_t cost) {
      const auto [found, is_new] = loads.emplace(next, so_far + cost);
      if (is_new || so_far + cost < found->second) {
        found->second = so_far + cost;
        cost == 0 ? queue.push_front(next) : queue.push_back(next);
      }
    };
    for (int w = 0; w < 2; ++w) {
      const unsigned mine = w == 0 ? state.first.first : state.first.second;
      const unsigned theirs = w == 0 ? state.first.second : state.first.first;
      const auto with = [&](unsigned memory) {
        return w == 0 ? std::pair(memory, theirs) : std::pair(theirs, memory);
      };
      for (unsigned x = 0; x < items; ++x) {
        if ((mine >> x & 1U) != 0) {
          reach({with(mine & ~(1U << x)), state.second}, 0);
        } else if ((theirs >> x & 1U) == 0 &&
                   static_cast<unsigned>(__builtin_popcount(mine)) < room) {
          std::uint32_t met = state.second;
          for (unsigned y = 0; y < items; ++y) {
            met |= (mine >> y & 1U) != 0 ? 1U << rank(x, y) : 0U;
          }
          reach({with(mine | 1U << x), met}, 1);
        }
      }
    }
  }
  return 0;
}

TEST(Disjoint, NoOrderBeatsTheBoundAndSmallOnesAreTheBest) {
  for (const auto& [items, room] : {std::pair(4U, 2U), {5U, 2U}}) {
    const std::uint64_t fewest = fewest_loads(items, room);
    const LoadOrderFacts facts = plan_disjoint_order(items, room, 2).facts();
    EXPECT_GE(fewest, facts.bound.loads) << items << " " << room;
    EXPECT_GE(facts.loads, fewest) << items << " " << room;
    EXPECT_LE(facts.loads, fewest + 2) << items << " " << room;
  }
}

TEST(Disjoint, CutsOfAnOrderForOneWorkerShareItems) {
  // What --workers alone gives: the check must see it.
  const WorkerSplit split = split_load_order(32, 8, 2);
  ScheduleCheck check({.items = 32, .room = 8, .lockstep = 2});
  const auto first = split.stream(0);
  const auto second = split.stream(1);
  for (Step one, other; first->next(one) && second->next(other);) {
    check.read(one);
    check.read(other);
  }
  EXPECT_NE(check.finish().fault.find("is in memory of worker"), std::string::npos)
      << check.finish().fault;
}

ScheduleRules rules_with(std::uint64_t room, const ComputeRules& compute = {}) {
  return {.items = 12, .room = room, .lockstep = 2, .compute = compute};
}

TEST(Disjoint, ChecksRefuseWhatIsWrong) {
  const LoadOrder order = plan_disjoint_order(12, 4, 2);
  const std::vector<Step> right = work_of(order.stream(), order.rules(ComputeRules{}));  // by turns
  ASSERT_TRUE(verdict_of(right, rules_with(4)).valid());
  EXPECT_EQ(verdict_of(right, rules_with(4)).computed, 66U);
  EXPECT_EQ(verdict_of(right, rules_with(4)).worker_loads, order.facts().worker_loads);
  EXPECT_NE(verdict_of(right, rules_with(3)).fault.find("memory is full"), std::string::npos);
  const auto refused = [&](const std::string& says, const auto& change) {
    auto wrong = right;
    change(wrong);
    const ScheduleVerdict verdict = verdict_of(wrong, rules_with(4));
    EXPECT_FALSE(verdict.valid()) << says;
    EXPECT_NE(verdict.fault.find(says), std::string::npos) << says << ": " << verdict.fault;
  };
  refused("is numbered", [](auto& all) { all[2].number = 7; });
  refused("which is not in memory", [](auto& all) { all[1].evict.push_back(0); });
  refused("is in memory of worker 0", [](auto& all) { all[1].load[0] = all[0].load[0]; });
  refused("which is not an item", [](auto& all) { all[1].load[0] = 12; });
  refused("not both in memory", [](auto& all) { std::swap(all[0].compute, all[1].compute); });
  refused("which is not wanted", [](auto& all) { all[0].compute[0] = {0, 0}; });
  refused("comes where worker 1 is next", [](auto& all) { all.erase(all.begin() + 5); });
  refused("is of 1 worker, not of 2", [](auto& all) { all.pop_back(); });
  refused("", [](auto& all) { all[0].compute.pop_back(); });
  refused("", [](auto& all) { all[0].compute.push_back(all[0].compute[0]); });
  auto repeated = right;
  repeated[0].compute.push_back(repeated[0].compute[0]);
  EXPECT_EQ(verdict_of(repeated, rules_with(4)).repeated, 1U);
  EXPECT_FALSE(verdict_of({}, rules_with(4)).valid());
}

TEST(Disjoint, PairsMeetAtOneWorkerOrAreRefused) {
  const LoadOrder order = plan_disjoint_order(12, 4, 2);
  std::vector<Step> steps = all_steps(*order.stream());
  EXPECT_TRUE(verdict_of(steps, order.rules()).valid());
  // The last loads of both workers bring new pairs.
  EXPECT_GT(verdict_of({steps.begin(), steps.end() - 2}, order.rules()).missing, 0U);
  // Items of two workers do not meet.
  const ScheduleRules rules{.items = 4, .room = 2, .lockstep = 2};
  const std::vector<Step> apart{{.number = 1, .load = {0, 1}},
                                {.number = 1, .load = {2, 3}, .worker = 1}};
  EXPECT_EQ(verdict_of(apart, rules).missing, 4U);
  // Of many items no pair is listed unless it is asked for.
  const LoadOrderFacts facts = plan_disjoint_order(9000, 500, 6).facts();
  EXPECT_NE(facts.certificate.find("all 40495500 pairs met"), std::string::npos)
      << facts.certificate;
}

TEST(Disjoint, WorkHasBothWaysAndItemsAloneIfAskedTo) {
  const LoadOrder order = plan_disjoint_order(12, 4, 2);
  const ComputeRules both{.ordered = true, .self = true, .shuffle = 3};
  const auto all = work_of(order.stream(), order.rules(both));
  const ScheduleVerdict verdict = verdict_of(all, rules_with(4, both));
  EXPECT_TRUE(verdict.valid()) << verdict.fault;
  EXPECT_EQ(verdict.computed, 144U);
  EXPECT_EQ(
      verdict_of(work_of(order.stream(), order.rules(ComputeRules{})), rules_with(4, both)).missing,
      78U);
}

TEST(Disjoint, ComesCloseToTheBound) {
  // What was found; a change that loses much of it is seen.
  EXPECT_LE(plan_disjoint_order(16, 4, 2).facts().span, 27U);
  EXPECT_LE(plan_disjoint_order(64, 8, 2).facts().span, 180U);
  EXPECT_LE(plan_disjoint_order(64, 8, 2).facts().loads, 360U);
  EXPECT_LE(plan_disjoint_order(64, 16, 4).facts().span, 64U);
  EXPECT_EQ(plan_disjoint_order(64, 2, 32).facts().span, 64U);  // a tournament: the bound
}

// Workers that together have room for more than all items.
TEST(Disjoint, CrowdedWorkersShareFewItems) {
  for (const auto& [items, room, workers] :
       std::vector<std::array<std::uint64_t, 3>>{{1, 2, 2},
                                                 {2, 2, 3},
                                                 {3, 4, 2},
                                                 {5, 5, 2},
                                                 {10, 4, 4},
                                                 {10, 30, 20},
                                                 {15, 8, 2},
                                                 {40, 12, 7},
                                                 {400, 90, 6}}) {
    const LoadOrder order = plan_disjoint_order(items, room, workers);
    const LoadOrderFacts& facts = order.facts();
    const std::string what = fmt::format("{} {} {}", items, room, workers);
    EXPECT_EQ(fault_of(steps_of(order), items, room), "") << what;
    EXPECT_GE(facts.loads, facts.bound.loads) << what;
    EXPECT_GE(facts.makespan(), facts.makespan_bound.loads) << what;
    // No item is done, which is the same job.
    const LoadOrder same = plan_disjoint_order(WantedPairs::beyond(0, items), room, workers);
    EXPECT_EQ(fault_of(steps_of(same), items, room), "") << what;
    if (items > 2) {
      const auto levels = plan_disjoint_levels(WantedPairs::beyond(0, items), room, 2, workers);
      EXPECT_EQ(levels.facts().lockstep, workers);
    }
  }
}

// Workers that would only take items from each other are idle.
TEST(Disjoint, MoreWorkersAreReadyNoLater) {
  for (const auto& [items, room, workers] :
       std::vector<std::array<std::uint64_t, 3>>{{5, 5, 5},
                                                 {6, 4, 2},
                                                 {7, 4, 3},
                                                 {10, 9, 9},
                                                 {10, 4, 10},
                                                 {12, 5, 4},
                                                 {24, 2, 24},
                                                 {40, 12, 7},
                                                 {310, 310, 2},
                                                 {310, 4, 156},
                                                 {400, 300, 5}}) {
    const LoadOrder order = plan_disjoint_order(items, room, workers);
    const LoadOrderFacts& facts = order.facts();
    const std::string what = fmt::format("{} {} {}", items, room, workers);
    EXPECT_EQ(fault_of(steps_of(order), items, room), "") << what;
    std::vector<std::uint64_t> fewer{workers / 2};
    if (room >= items) {
      fewer.push_back(1);
    }
    if (items < 2 * room) {
      fewer.push_back(std::min<std::uint64_t>(workers, 2));
    }
    for (const std::uint64_t some : fewer) {
      const LoadOrderFacts its = plan_disjoint_order(items, room, some).facts();
      EXPECT_LE(facts.span, its.span) << what << ", " << some << " workers";
      EXPECT_LE(facts.makespan(), its.makespan()) << what << ", " << some << " workers";
    }
    const auto idle = static_cast<std::uint64_t>(std::ranges::count(facts.worker_loads, 0U));
    EXPECT_EQ(facts.explanation.find("nothing to do") != std::string::npos, idle > 0)
        << what << ": " << facts.explanation;
  }
}

TEST(Disjoint, RefusesTooManyWorkersAndTooManyItems) {
  EXPECT_REFUSAL(static_cast<void>(plan_disjoint_order(15, 4, 0)), BadInput,
                 "0 workers: give 1 to 65536");
  EXPECT_REFUSAL(static_cast<void>(plan_disjoint_order(15, 4, 70'000)), BadInput,
                 "70000 workers: give 1 to 65536");
  EXPECT_THROW(static_cast<void>(plan_disjoint_order(70'000, 4, 2)), ImpossibleParameters);
  EXPECT_REFUSAL(static_cast<void>(plan_disjoint_order(12, 4, 2).stream(2)), BadInput,
                 "there is no worker 2: the order is for 2; count from 0");
  EXPECT_REFUSAL(static_cast<void>(split_order(plan_disjoint_order(12, 4, 2), 12, 4, 2)), BadInput,
                 "an order for 2 workers in lockstep cannot be cut for other workers");
  EXPECT_REFUSAL(
      ScheduleCheck({.items = 70'000, .room = 4, .lockstep = 2, .compute = ComputeRules{}}),
      MissingResource, "items have too many pairs to track; give at most");
}

}  // namespace
}  // namespace changeover::test::disjoint_test
