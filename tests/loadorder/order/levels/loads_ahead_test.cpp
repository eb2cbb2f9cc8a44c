// Loads of two levels that start early: the definition in sets, the fewest loads and the least
// waiting by trying everything, and wrong schedules refused.
#include "loadorder/order/levels/loads_ahead.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "../../pairs/pairs_support.hpp"
#include "../../sizes/sizes_support.hpp"
#include "changeover/loadorder/workers.hpp"

namespace changeover::test::loads_ahead_test {
namespace {

struct Played {
  std::string fault;
  std::uint64_t loads = 0;
  std::uint64_t ahead = 0;
  std::set<ItemPair> met;
};

// In sets; `size` is of an item, for both rooms.
Played play(const std::vector<Step>& steps, std::uint64_t room, std::uint64_t fast_room,
            const std::function<std::uint64_t(Element)>& size) {
  Played played;
  std::set<Element> memory;
  std::set<Element> fast;
  std::map<Element, std::size_t> came;  // loaded, and not transferred yet
  const auto all = [&](const std::set<Element>& items) {
    std::uint64_t sum = 0;
    for (const Element x : items) {
      sum += size(x);
    }
    return sum;
  };
  const auto claim = [&](bool is_true, const Step& step, const std::string& what) {
    played.fault = is_true || !played.fault.empty() ? played.fault
                                                    : fmt::format("step {} {}", step.number, what);
  };
  for (std::size_t t = 0; t < steps.size(); ++t) {
    const Step& step = steps[t];
    for (const Element x : step.fast_evict) {
      claim(fast.erase(x) == 1, step, "is not on the accelerator");
    }
    for (const Element x : step.evict) {
      claim(memory.erase(x) == 1 && !fast.contains(x), step, "evicts");
    }
    for (const Element x : step.load) {
      claim(memory.insert(x).second, step, "loads");
      came[x] = t;
      ++played.loads;
    }
    for (const Element x : step.fast_load) {
      claim(memory.contains(x) && fast.insert(x).second, step, "transfers");
      played.ahead += came.contains(x) && came[x] < t ? 1U : 0U;
      came.erase(x);
      for (const Element y : fast) {
        played.met.emplace(std::min(x, y), std::max(x, y));
      }
    }
    claim(all(memory) <= room && all(fast) <= fast_room, step, "holds too much");
  }
  return played;
}

std::uint64_t one(Element /*item*/) { return 1; }

std::vector<Step> ahead_of(const LoadOrder& order, std::uint64_t spare) {
  StepLists lists;
  lists.add(loads_ahead(*order.stream(), order.facts().items, order.facts().room, spare, nullptr));
  return all_steps(*lists.of(0));
}

TEST(LoadsAhead, TransfersStayAndLoadsComeNoLater) {
  for (const auto& [wanted, room, fast_room] :
       {std::tuple{WantedPairs(16), 8U, 3U}, std::tuple{WantedPairs(24), 15U, 4U},
        std::tuple{WantedPairs(9), 4U, 4U}, std::tuple{WantedPairs(5), 5U, 2U},
        std::tuple{WantedPairs::between(9, 14), 8U, 3U},
        std::tuple{listed(40, close_points(40, 130, 3)), 12U, 5U}}) {
    const LoadOrder order = plan_two_levels(wanted, room, fast_room, hardly_searched());
    const auto before = all_steps(*order.stream());
    for (const std::uint64_t spare : spares_to_try(order.rules())) {
      const std::string what = fmt::format("{} {} {}", wanted.describe(), room, spare);
      const auto after = ahead_of(order, spare);
      ASSERT_EQ(after.size(), before.size());
      std::uint64_t loaded_before = 0;
      std::uint64_t loaded_after = 0;
      for (std::size_t t = 0; t < after.size(); ++t) {
        EXPECT_EQ(after[t].fast_load, before[t].fast_load);
        EXPECT_EQ(after[t].fast_evict, before[t].fast_evict);
        loaded_before += before[t].load.size();
        loaded_after += after[t].load.size();
      }
      EXPECT_TRUE(spare > 0 || loaded_after <= loaded_before) << what;
      const Played played = play(after, room, fast_room, one);
      EXPECT_EQ(played.fault, "") << what;
      EXPECT_TRUE(have_all_met(played.met, wanted.items(), wanted)) << what;
    }
    const LoadOrder early = start_loads_early(LoadOrder(order.facts(), order.maker()));
    const Played played = play(all_steps(*early.stream()), room, fast_room, one);
    EXPECT_EQ(played.fault, "");
    EXPECT_EQ(played.loads, early.facts().loads);
    EXPECT_EQ(played.ahead, early.facts().ahead);
    EXPECT_EQ(early.facts().transfers, order.facts().transfers);
    EXPECT_GE(early.facts().loads, early.facts().bound.loads);
  }
}

// The fewest loads for given transfers, over everything that memory can do.
std::uint64_t fewest_loads_for(const std::vector<Step>& steps, std::uint64_t items,
                               std::uint64_t room) {
  std::map<unsigned, std::uint64_t> best{{0U, 0U}};
  std::set<Element> fast;
  for (const Step& step : steps) {
    for (const Element x : step.fast_evict) {
      fast.erase(x);
    }
    fast.insert(step.fast_load.begin(), step.fast_load.end());
    unsigned needed = 0;
    for (const Element x : fast) {
      needed |= 1U << x;
    }
    std::map<unsigned, std::uint64_t> next;
    for (const auto& [memory, loads] : best) {
      for (unsigned then = 0; then < 1U << items; ++then) {
        if ((then & needed) != needed ||
            static_cast<std::uint64_t>(__builtin_popcount(then)) > room) {
          continue;
        }
        const std::uint64_t all =
            loads + static_cast<std::uint64_t>(__builtin_popcount(then & ~memory));
        const auto found = next.try_emplace(then, all).first;
        found->second = std::min(found->second, all);
      }
    }
    best = std::move(next);
  }
  std::uint64_t least = ~std::uint64_t{0};
  for (const auto& [memory, loads] : best) {
    least = std::min(least, loads);
  }
  return least;
}

TEST(LoadsAhead, NoLoadIsSparedByWaiting) {
  // As a cache, memory has the fewest loads that these transfers allow; early ones are no more.
  for (const auto& [items, room, fast_room] :
       {std::tuple{6U, 4U, 2U}, std::tuple{7U, 4U, 3U}, std::tuple{7U, 5U, 2U}}) {
    const LoadOrder order = plan_two_levels(items, room, fast_room);
    const auto before = all_steps(*order.stream());
    const auto early = ahead_of(order, 0);
    const std::uint64_t least = fewest_loads_for(before, items, room);
    const Played played = play(early, room, fast_room, one);
    EXPECT_EQ(played.fault, "");
    EXPECT_GE(played.loads, least);
    EXPECT_LE(played.loads, order.facts().loads);
  }
}

TEST(LoadsAhead, NothingWaitsThatCouldStart) {
  // A load that is not made in a step in which there is room, or an item that is done, comes next
  // only because it is still in use.
  const LoadOrder order = start_loads_early(plan_two_levels(24, 12, 4));
  const auto steps = all_steps(*order.stream());
  EXPECT_GT(order.facts().ahead, order.facts().loads / 2);
  std::set<Element> memory;
  for (std::size_t t = 0; t < steps.size(); ++t) {
    for (const Element x : steps[t].evict) {
      memory.erase(x);
    }
    memory.insert(steps[t].load.begin(), steps[t].load.end());
    // The load after this step.
    Element next = 24;
    for (std::size_t then = t + 1; then < steps.size() && next == 24; ++then) {
      next = steps[then].load.empty() ? next : steps[then].load.front();
    }
    EXPECT_TRUE(next == 24 || memory.size() == 12 || memory.contains(next)) << t;
  }
}

TEST(LoadsAhead, GoWithSizesEpochsStoresAndWorkers) {
  std::mt19937 random(3);
  for (int round = 0; round < 8; ++round) {
    const auto fast = random_sizes(random, 4 + random() % 16, 30, 60);
    const auto sizes = std::make_shared<const ItemSizes>(
        ItemSizes{fast->bytes, fast->memory + 40 + random() % 200, fast->memory});
    const std::uint64_t items = sizes->bytes.size();
    const auto size = [&](Element x) { return sizes->bytes[x]; };
    for (const std::uint64_t epochs : {1U, 3U}) {
      const LoadOrder order = start_loads_early(
          repeat_order(plan_two_levels(sizes, WantedPairs(items), hardly_searched()), epochs));
      const Played played =
          play(all_steps(*order.stream()), sizes->memory, sizes->fast_memory, size);
      EXPECT_EQ(played.fault, "");
      EXPECT_EQ(played.ahead, order.facts().ahead);
      EXPECT_GE(order.facts().bytes, order.facts().byte_bound.loads);
      ScheduleRules rules = order.rules(ComputeRules{.ordered = true, .self = true});
      rules.store = true;
      StepWork work(order.stream(), rules);
      const ScheduleVerdict verdict = check_schedule(work, rules);
      EXPECT_TRUE(verdict.valid()) << verdict.fault;
      EXPECT_EQ(verdict.computed, epochs * items * items);
      const WorkerSplit split =
          start_loads_early(repeat_shares(split_two_levels(sizes, WantedPairs(items), 3), epochs));
      const ScheduleRules of_workers = split.rules(ComputeRules{});
      StepWork works(split.stream(), of_workers, split.owners());
      const ScheduleVerdict all = check_schedule(works, of_workers);
      EXPECT_TRUE(all.valid()) << all.fault;
      EXPECT_EQ(all.loads, split.facts().loads);
      EXPECT_EQ(all.makespan_bytes(), split.facts().makespan_bytes);
    }
  }
  for (const std::uint64_t workers : {1U, 3U}) {
    const WorkerSplit split = start_loads_early(split_two_levels(30, 12, 4, workers));
    const ScheduleRules rules = split.rules(ComputeRules{});
    StepWork work(split.stream(), rules, split.owners());
    const ScheduleVerdict verdict = check_schedule(work, rules);
    EXPECT_TRUE(verdict.valid()) << verdict.fault;
    EXPECT_EQ(verdict.computed, 435U);
    EXPECT_EQ(verdict.loads, split.facts().loads);
    EXPECT_EQ(verdict.makespan(), split.facts().makespan);
  }
}

TEST(LoadsAhead, WhatIsWrongIsFound) {
  const LoadOrder order = start_loads_early(plan_two_levels(24, 12, 4));
  const std::vector<Step> all = all_steps(*order.stream());
  const auto verdict_with = [&](const auto& change) {
    std::vector<Step> wrong = all;
    change(wrong);
    return verdict_of(wrong, order.rules());
  };
  EXPECT_TRUE(verdict_with([](std::vector<Step>&) {}).valid());
  const auto ahead = std::ranges::find_if(all, [](const Step& step) {
    return step.number > 1 && !step.load.empty() && !step.evict.empty();
  });
  ASSERT_NE(ahead, all.end());
  const auto at = static_cast<std::size_t>(ahead - all.begin());
  EXPECT_FALSE(verdict_with([&](auto& steps) { steps[at].evict.pop_back(); }).valid());
  EXPECT_FALSE(verdict_with([&](auto& steps) { steps[at].load.pop_back(); }).valid());
  // A load that comes in the step of its transfer is not ahead; one after it is no load.
  std::vector<Step> late = all;
  const Element x = late[at].load.back();
  late[at].load.pop_back();
  std::size_t transfer = at;
  while (std::ranges::find(late[transfer].fast_load, x) == late[transfer].fast_load.end()) {
    ++transfer;
  }
  ASSERT_GT(transfer, at);
  late[transfer].load.push_back(x);
  const ScheduleVerdict verdict = verdict_of(late, order.rules());
  EXPECT_TRUE(!verdict.valid() || verdict.ahead + 1 == order.facts().ahead);
}

}  // namespace
}  // namespace changeover::test::loads_ahead_test
