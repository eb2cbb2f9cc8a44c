// Several epochs: every pair in each of them, what is in memory staying from one to the next; the
// bound against searches through all that can be done; what must be refused.
#include <gtest/gtest.h>

#include <deque>
#include <map>
#include <random>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/workers.hpp"
#include "core/checked.hpp"
#include "message_of.hpp"
#include "pairs/pairs_support.hpp"

namespace changeover::test::epochs_test {
namespace {

/// The definition in plain code: steps go through epochs, and in each of them all pairs meet.
struct Epochs {
  std::uint64_t epochs = 0;
  std::uint64_t loads = 0;
  std::vector<std::uint64_t> loads_of;
  std::vector<std::set<ItemPair>> met;
  std::string fault;
};

Epochs play(StepSource& steps, std::uint64_t room) {
  Epochs all;
  std::set<Element> memory;
  std::uint64_t number = 0;
  for (Step step; steps.next(step);) {
    if (step.number != ++number) {
      all.fault = "number";
    }
    if (step.epoch != all.epochs) {
      if (step.epoch != all.epochs + 1) {
        all.fault = "epoch";
      }
      all.epochs = step.epoch;
      all.loads_of.push_back(0);
      all.met.emplace_back();
    }
    for (const Element x : step.evict) {
      if (memory.erase(x) != 1) {
        all.fault = "evict";
      }
    }
    for (const Element x : step.load) {
      if (!memory.insert(x).second) {
        all.fault = "load";
      }
      ++all.loads;
      ++all.loads_of.back();
    }
    if (memory.size() > room) {
      all.fault = "room";
    }
    for (const Element x : memory) {
      for (const Element y : memory) {
        if (x < y) {
          all.met.back().emplace(x, y);
        }
      }
    }
  }
  return all;
}

TEST(Epochs, EveryPairMeetsInEachEpochAndWhatIsThereStays) {
  for (const auto& [items, room] : std::vector<std::pair<std::uint64_t, std::uint64_t>>{
           {1, 2}, {3, 4}, {6, 2}, {8, 4}, {13, 5}, {16, 8}, {37, 9}, {64, 16}, {150, 7}}) {
    for (const std::uint64_t epochs : {1U, 2U, 3U, 6U}) {
      const LoadOrder once = plan_load_order(items, room);
      const LoadOrder order = repeat_order(plan_load_order(items, room), epochs);
      const LoadOrderFacts& facts = order.facts();
      const auto steps = order.stream();
      const Epochs all = play(*steps, room);
      EXPECT_EQ(all.fault, "") << items << ' ' << room;
      EXPECT_EQ(all.epochs, epochs);
      EXPECT_EQ(all.loads, facts.loads);
      EXPECT_EQ(facts.steps, epochs * once.facts().steps);
      EXPECT_GE(facts.loads, facts.bound.loads);
      for (std::uint64_t e = 0; e < epochs; ++e) {
        EXPECT_EQ(all.met[e].size(), items * (items - 1) / 2);
        EXPECT_EQ(all.loads_of[e], once.facts().loads - (e == 0 ? 0 : std::min(items, room)));
      }
      if (epochs > 1) {
        EXPECT_EQ(all.loads_of, facts.epoch_loads);
        EXPECT_TRUE(facts.every_step_read);
      }
    }
  }
}

TEST(Epochs, AfterTheFirstHaveTheLoadsOfTheRoomLess) {
  const auto loads = [](std::uint64_t items, std::uint64_t room) {
    return repeat_order(plan_load_order(items, room), 4).facts().epoch_loads;
  };
  using Loads = std::vector<std::uint64_t>;
  EXPECT_EQ(loads(8, 4), (Loads{12, 8, 8, 8}));
  EXPECT_EQ(loads(16, 8), (Loads{24, 16, 16, 16}));
  EXPECT_EQ(loads(32, 16), (Loads{48, 32, 32, 32}));
  EXPECT_EQ(loads(64, 16), (Loads{149, 133, 133, 133}));
}

/// The fewest loads there can be: through all memories, sets of pairs that have met, and epochs.
std::uint64_t fewest_loads(unsigned items, unsigned room, std::uint32_t wanted, unsigned epochs) {
  const auto pairs_in = [&](unsigned memory) {
    std::uint32_t pairs = 0;
    unsigned bit = 0;
    for (unsigned y = 1; y < items; ++y) {
      for (unsigned x = 0; x < y; ++x, ++bit) {
        pairs |= static_cast<std::uint32_t>((memory >> x & memory >> y & 1U) << bit);
      }
    }
    return pairs & wanted;
  };
  struct Place {
    unsigned memory = 0;
    std::uint32_t met = 0;
    unsigned epoch = 0;
    auto operator<=>(const Place&) const = default;
  };
  std::map<Place, std::uint64_t> best{{{0, 0, 1}, 0}};
  std::deque<std::pair<Place, std::uint64_t>> next{{{0, 0, 1}, 0}};
  while (!next.empty()) {
    const auto [place, loads] = next.front();
    next.pop_front();
    if (loads > best.at(place)) {
      continue;
    }
    if (place.met == wanted && place.epoch == epochs) {
      return loads;
    }
    const auto go = [&](Place to, std::uint64_t cost) {
      while (to.met == wanted && to.epoch < epochs) {
        to = {to.memory, pairs_in(to.memory), to.epoch + 1};
      }
      const auto [found, is_new] = best.emplace(to, loads + cost);
      if (is_new || loads + cost < found->second) {
        found->second = loads + cost;
        cost == 0 ? next.emplace_front(to, loads) : next.emplace_back(to, loads + cost);
      }
    };
    for (unsigned x = 0; x < items; ++x) {
      const unsigned other = place.memory ^ (1U << x);
      if ((place.memory >> x & 1U) != 0) {
        go({other, place.met, place.epoch}, 0);
      } else if (static_cast<unsigned>(__builtin_popcount(place.memory)) < room) {
        go({other, place.met | pairs_in(other), place.epoch}, 1);
      }
    }
  }
  return ~std::uint64_t{0};
}

TEST(Epochs, NoOrderOfFewItemsIsBelowTheBoundAndOursAreTheBest) {
  for (unsigned items = 3; items <= 5; ++items) {
    for (unsigned room = 2; room <= items; ++room) {
      for (unsigned epochs = 2; epochs <= 3; ++epochs) {
        const std::uint32_t all = (1U << items * (items - 1) / 2) - 1;
        const std::uint64_t fewest = fewest_loads(items, room, all, epochs);
        const LoadOrder order = repeat_order(plan_load_order(items, room), epochs);
        EXPECT_LE(order.facts().bound.loads, fewest) << items << ' ' << room << ' ' << epochs;
        EXPECT_EQ(order.facts().loads, fewest) << items << ' ' << room << ' ' << epochs;
      }
    }
  }
}

TEST(Epochs, NoOrderOfAListIsBelowTheBound) {
  std::mt19937 random(5);
  for (int round = 0; round < 40; ++round) {
    constexpr unsigned items = 5;
    std::vector<ItemPair> pairs;
    std::uint32_t wanted = 0;
    unsigned bit = 0;
    for (Element y = 1; y < items; ++y) {
      for (Element x = 0; x < y; ++x, ++bit) {
        if (random() % 3 != 0) {
          pairs.emplace_back(x, y);
          wanted |= 1U << bit;
        }
      }
    }
    if (pairs.empty()) {
      continue;
    }
    for (unsigned room = 2; room <= 4; ++room) {
      const LoadOrder order = repeat_order(plan_load_order(listed(items, pairs), room), 2);
      const std::uint64_t fewest = fewest_loads(items, room, wanted, 2);
      EXPECT_LE(order.facts().bound.loads, fewest) << room;
      EXPECT_GE(order.facts().loads, fewest) << room;
    }
  }
}

/// All schedules that can be said of epochs, with what they compute.
void expect_valid(const LoadOrder& order, ComputeRules compute, bool store) {
  ScheduleRules rules = order.rules(compute);
  rules.store = store;
  StepWork work(order.stream(), rules);
  const auto steps = all_steps(work);
  const ScheduleVerdict verdict = verdict_of(steps, rules);
  EXPECT_TRUE(verdict.valid()) << verdict.fault << verdict.missing << ' ' << verdict.repeated;
  const std::uint64_t pairs = order.facts().wanted.are_all() ? binomial(order.facts().items, 2)
                                                             : order.facts().wanted.count();
  std::uint64_t alone = 0;
  for (Element x = 0; x < order.facts().items; ++x) {
    alone += compute.self && order.facts().wanted.needs(x) ? 1U : 0U;
  }
  EXPECT_EQ(verdict.computed, order.facts().epochs * (pairs * (compute.ordered ? 2 : 1) + alone));
}

TEST(Epochs, WorkIsDoneOnceInEachOfThemInEveryKindOfSchedule) {
  std::vector<LoadOrder> orders;
  orders.push_back(repeat_order(plan_load_order(24, 6), 3));
  orders.push_back(repeat_order(plan_load_order(WantedPairs::between(7, 9), 4), 4));
  orders.push_back(repeat_order(plan_load_order(WantedPairs::beyond(9, 14), 4), 4));
  orders.push_back(repeat_order(plan_load_order(listed(20, random_pairs(20, 50, 1)), 5), 3));
  orders.push_back(repeat_order(plan_disjoint_order(24, 4, 3), 3));
  orders.push_back(repeat_order(plan_two_levels(24, 8, 4), 3));
  for (const bool spread : {false, true}) {
    for (const bool both : {false, true}) {
      ComputeRules compute{.ordered = both, .self = both};
      if (spread) {
        compute.spread = 7;
        compute.shuffle = 8;
      }
      for (const bool store : {false, true}) {
        for (const LoadOrder& order : orders) {
          expect_valid(order, compute, store);
        }
      }
    }
  }
}

TEST(Epochs, SharesGoBackAndForthWithTheSamePairs) {
  for (const std::uint64_t workers : {1U, 2U, 5U, 7U}) {
    for (const std::uint64_t epochs : {2U, 3U}) {
      const WorkerSplit split = repeat_shares(split_load_order(60, 20, workers), epochs);
      const SplitFacts& facts = split.facts();
      ComputeRules compute;
      for (const bool spread : {false, true}) {
        if (spread) {
          compute.spread = 3;
        }
        const ScheduleRules rules = split.rules(compute);
        StepWork work(split.stream(), rules, split.owners());
        const ScheduleVerdict verdict = verdict_of(all_steps(work), rules);
        EXPECT_TRUE(verdict.valid()) << verdict.fault;
        EXPECT_EQ(verdict.computed, epochs * 1770);
        EXPECT_EQ(verdict.loads, facts.loads);
        EXPECT_EQ(verdict.makespan(), facts.makespan);
        EXPECT_GE(facts.makespan, facts.makespan_bound.loads);
        EXPECT_EQ(verdict.epoch_loads, facts.epoch_loads);
        for (std::size_t w = 0; w < verdict.worker_pairs.size(); ++w) {
          EXPECT_EQ(verdict.worker_pairs[w], facts.workers[w].pairs) << w;
        }
      }
    }
  }
  const WorkerSplit few = repeat_shares(split_load_order(8, 8, 4), 5);  // all fit: loaded once
  EXPECT_EQ(few.facts().epoch_loads[1], 0U);
}

TEST(Epochs, SpreadPairsAreEvenAndDependOnTheSeed) {
  const LoadOrder order = repeat_order(plan_load_order(64, 16), 2);
  const auto steps_with = [&](std::uint64_t seed) {
    return work_of(order.stream(), order.rules(ComputeRules{.spread = seed}));
  };
  const auto steps = steps_with(1);
  EXPECT_EQ(steps, steps_with(1));
  EXPECT_NE(steps, steps_with(2));
  const ScheduleVerdict verdict = verdict_of(steps, order.rules(ComputeRules{.spread = 1}));
  EXPECT_TRUE(verdict.valid());
  EXPECT_LE(verdict.most_in_a_step,
            18U);  // the mean is 15.04, and the first step has 120 otherwise
  EXPECT_NE(steps[0].compute, steps[2 * 134 - 1].compute);  // the same memory in the other epoch
}

TEST(Epochs, WhatIsWrongIsFound) {
  const LoadOrder order = repeat_order(plan_load_order(16, 5), 3);
  const ScheduleRules rules = order.rules();
  const auto right = all_steps(*order.stream());
  ASSERT_TRUE(verdict_of(right, rules).valid());
  const auto fault = [&](const std::vector<Step>& steps) { return verdict_of(steps, rules).fault; };
  const std::size_t epoch = right.size() / 3;

  // An epoch that ends early misses pairs, and the next begins where nothing is.
  for (std::size_t i = 0; i < right.size(); ++i) {
    std::vector<Step> steps = right;
    steps.erase(steps.begin() + static_cast<std::ptrdiff_t>(i));
    for (std::size_t j = i; j < steps.size(); ++j) {
      --steps[j].number;
    }
    EXPECT_FALSE(verdict_of(steps, rules).valid()) << i;
  }
  // Pairs of one epoch do not count for another.
  std::vector<Step> steps = right;
  for (std::size_t i = epoch - 3; i < epoch; ++i) {
    steps[i].epoch = 2;
  }
  EXPECT_GT(verdict_of(steps, rules).missing, 0U);
  // Epochs come one after another, all of them.
  steps = right;
  steps[epoch + 1].epoch = 1;
  EXPECT_NE(fault(steps), "");
  steps = right;
  for (std::size_t i = epoch; i < steps.size(); ++i) {
    ++steps[i].epoch;
  }
  EXPECT_NE(fault(steps), "");
  steps.assign(right.begin(), right.begin() + static_cast<std::ptrdiff_t>(2 * epoch));
  EXPECT_EQ(verdict_of(steps, rules).missing, 120U);
  // What an epoch leaves is there.
  steps = right;
  steps[epoch].load = {right[epoch - 1].load.front()};
  EXPECT_NE(fault(steps), "");
  // Steps of another worker are none of this one's epochs.
  steps = right;
  steps[epoch].worker = 1;
  EXPECT_NE(fault(steps), "");
  // A pair twice in an epoch, or in another one.
  const ScheduleRules computing = order.rules(ComputeRules{});
  auto work = work_of(order.stream(), computing);
  ASSERT_TRUE(verdict_of(work, computing).valid());
  std::swap(work[1].compute, work[epoch + 1].compute);
  EXPECT_FALSE(verdict_of(work, computing).valid());
}

TEST(Epochs, AreAtLeastOne) {
  EXPECT_THROW(static_cast<void>(repeat_order(plan_load_order(8, 4), 0)), BadInput);
  EXPECT_THROW(static_cast<void>(repeat_order(plan_load_order(8, 4), most_epochs + 1)), BadInput);
  EXPECT_THROW(static_cast<void>(repeat_order(repeat_order(plan_load_order(8, 4), 2), 2)),
               BadInput);
  EXPECT_THROW(static_cast<void>(repeat_shares(split_load_order(8, 4, 2), 0)), BadInput);
  EXPECT_REFUSAL(ScheduleCheck({.items = 3, .room = 2, .epochs = 0}), BadInput,
                 "0 epochs of a load order: give 1 to 1000000");
}

}  // namespace
}  // namespace changeover::test::epochs_test
