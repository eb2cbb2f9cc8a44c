// Two levels for items of different sizes: the definition in plain code, bounds, epochs, and what
// is wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/load_request.hpp"
#include "changeover/loadorder/workers.hpp"
#include "message_of.hpp"
#include "sizes/sizes_support.hpp"

namespace changeover::test::sized_levels_test {
namespace {

using ::testing::HasSubstr;

std::shared_ptr<const ItemSizes> with_levels(std::vector<std::uint64_t> bytes, std::uint64_t memory,
                                             std::uint64_t fast_memory) {
  return std::make_shared<const ItemSizes>(ItemSizes{std::move(bytes), memory, fast_memory});
}

struct Played {
  std::string fault;
  std::uint64_t bytes = 0;
  std::uint64_t fast_bytes = 0;
  std::set<ItemPair> met;  // on the accelerator
};

Played play_levels(StepSource& steps, const ItemSizes& sizes) {
  Played played;
  std::uint64_t worker = 0;
  std::set<Element> memory;
  std::set<Element> fast;
  const auto bytes_in = [&](const std::set<Element>& items) {
    std::uint64_t bytes = 0;
    for (const Element x : items) {
      bytes += sizes.bytes[x];
    }
    return bytes;
  };
  for (Step step; steps.next(step);) {
    bool right = true;
    if (step.worker != std::exchange(worker, step.worker)) {
      memory.clear();
      fast.clear();
    }
    for (const Element x : step.fast_evict) {
      right = fast.erase(x) == 1 && right;
    }
    for (const Element x : step.evict) {
      right = memory.erase(x) == 1 && fast.count(x) == 0 && right;
    }
    for (const Element x : step.load) {
      right = memory.insert(x).second && right;
      played.bytes += sizes.bytes[x];
    }
    for (const Element x : step.fast_load) {
      right = memory.count(x) == 1 && fast.insert(x).second && right;
      played.fast_bytes += sizes.bytes[x];
      for (const Element y : fast) {
        played.met.emplace(std::min(x, y), std::max(x, y));
      }
    }
    right = bytes_in(memory) <= sizes.memory && bytes_in(fast) <= sizes.fast_memory && right;
    played.fault = right ? played.fault : "wrong step";
  }
  return played;
}

TEST(SizedLevels, EveryPairMeetsOnTheAccelerator) {
  std::mt19937 random(1);
  for (int round = 0; round < 24; ++round) {
    const auto fast = random_sizes(random, 2 + random() % 24, round % 3 == 0 ? 3 : 40, 100);
    const auto sizes = with_levels(fast->bytes, fast->memory + random() % 300, fast->memory);
    const std::uint64_t items = sizes->bytes.size();
    for (const WantedPairs& wanted :
         {WantedPairs(items), WantedPairs::between(items / 2, items - items / 2),
          listed(items, random_pairs(items, 1 + random() % (items - 1), random()))}) {
      const LoadOrder order = plan_two_levels(sizes, wanted);
      const LoadOrderFacts& facts = order.facts();
      const Played played = play_levels(*order.stream(), *sizes);
      EXPECT_EQ(played.fault, "");
      EXPECT_TRUE(have_all_met(played.met, items, wanted));
      EXPECT_EQ(played.bytes, facts.bytes);
      EXPECT_EQ(played.fast_bytes, facts.transfer_bytes);
      EXPECT_GE(facts.bytes, facts.byte_bound.loads);
      EXPECT_GE(facts.transfer_bytes, facts.transfer_byte_bound.loads);
      const LoadOrder again = repeat_order(plan_two_levels(sizes, wanted), 3);
      EXPECT_EQ(play_levels(*again.stream(), *sizes).fault, "");
      EXPECT_GE(again.facts().transfer_bytes, again.facts().transfer_byte_bound.loads);
    }
  }
}

TEST(SizedLevels, OfSeveralWorkersComputeEachPairOnceAtOneOfThem) {
  std::mt19937 random(4);
  for (int round = 0; round < 4; ++round) {
    const auto fast = random_sizes(random, 2 + random() % 12, round % 3 == 0 ? 3 : 40, 100);
    const auto sizes = with_levels(fast->bytes, fast->memory + random() % 300, fast->memory);
    const std::uint64_t items = sizes->bytes.size();
    const std::uint64_t workers = 1 + random() % 6;
    for (const WantedPairs& wanted :
         {WantedPairs(items), WantedPairs::between(items / 2, items - items / 2),
          listed(items, random_pairs(items, 1 + random() % (items - 1), random()))}) {
      const WorkerSplit split = split_two_levels(sizes, wanted, workers);
      const SplitFacts& facts = split.facts();
      const LoadOrderFacts& whole = split.order().facts();
      const Played played = play_levels(*split.stream(), *sizes);
      EXPECT_EQ(played.fault, "");
      EXPECT_TRUE(have_all_met(played.met, items, wanted));
      EXPECT_EQ(played.bytes, facts.bytes);
      EXPECT_EQ(played.fast_bytes, whole.transfer_bytes);
      EXPECT_GE(facts.makespan_bytes, facts.makespan_bytes_bound.loads);
      EXPECT_GE(whole.transfer_bytes, whole.transfer_byte_bound.loads);
      const ScheduleRules rules = split.rules(ComputeRules{});
      StepWork work(split.stream(), rules, split.owners());
      std::vector<Step> steps = all_steps(work);
      EXPECT_TRUE(verdict_of(steps, rules).valid());
      EXPECT_EQ(verdict_of(steps, rules).computed, wanted.among(items).count());
      // One item that is not transferred, or one byte less on the accelerator.
      ItemSizes less = *sizes;
      less.fast_memory = 1;
      ScheduleRules narrow = rules;
      narrow.sizes = std::make_shared<const ItemSizes>(less);
      EXPECT_THAT(verdict_of(steps, narrow).fault, HasSubstr("are free"));
      const auto transfers = std::ranges::find_if(
          steps, [](const Step& step) { return !step.fast_load.empty() && !step.compute.empty(); });
      transfers->fast_load.clear();
      EXPECT_FALSE(verdict_of(steps, rules).valid());
      const WorkerSplit again = repeat_shares(split_two_levels(sizes, wanted, workers), 3);
      EXPECT_GE(again.order().facts().transfer_bytes,
                again.order().facts().transfer_byte_bound.loads);
      EXPECT_LE(again.order().facts().transfer_bytes, 3 * whole.transfer_bytes);
      EXPECT_GE(again.facts().makespan_bytes, again.facts().makespan_bytes_bound.loads);
    }
  }
}

TEST(SizedLevels, IfAllFitsEachItemMovesOnce) {
  const LoadOrder order = plan_two_levels(with_levels({3, 4, 5}, 20, 12), 3);
  EXPECT_EQ(order.facts().bytes, 12U);
  EXPECT_EQ(order.facts().transfer_bytes, 12U);
  EXPECT_EQ(split_two_levels(with_levels({3}, 20, 12), 1, 4).facts().bytes, 3U);
}

TEST(SizedLevels, TheCheckFindsTooManyBytesOnTheAccelerator) {
  ScheduleCheck check(
      {.items = 3, .room = 3, .fast_room = 3, .sizes = with_levels({3, 4, 5}, 12, 8)});
  check.read({.number = 1, .load = {0, 1, 2}, .fast_load = {0, 1, 2}});
  EXPECT_THAT(check.finish().fault, HasSubstr("transfers 2 of 5 bytes where 1 are free"));
}

TEST(SizedLevels, RequestsAreRefused) {
  const auto refusal = [](const std::string& keys) {
    return message_of([&] {
      static_cast<void>(checked_loads(
          load_request(R"({"sizes":[[0,5],[1,2]],"memory":30,)" + keys + "}"), Door::document));
    });
  };
  EXPECT_EQ(refusal(R"("fast_memory":9)"), "");
  EXPECT_THAT(refusal(R"("fast_memory":31)"), HasSubstr("of memory 30 give 2 to 30"));
  EXPECT_THAT(refusal(R"("fast_memory":6)"),
              HasSubstr("items 0 and 1 have 7 bytes together, more than the 6 of the accelerator"));
  EXPECT_EQ(refusal(R"("fast_memory":9,"workers":2,"epochs":2)"), "");
  EXPECT_THAT(refusal(R"("fast_memory":9,"workers":2,"write_back":true)"),
              HasSubstr("add disjoint"));
  EXPECT_THAT(refusal(R"("fast_room":2)"),
              HasSubstr("fast_room counts items, not their bytes; with sizes give fast_memory"));
}

}  // namespace
}  // namespace changeover::test::sized_levels_test
