// Items of different size for several workers and with prefetch: every pair within the memory of a
// worker, computed once; the bound against searches through all that can be done; what is wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/load_request.hpp"
#include "changeover/loadorder/workers.hpp"
#include "message_of.hpp"
#include "sizes/sizes_support.hpp"

namespace changeover::test::sized_split_test {
namespace {

using ::testing::HasSubstr;

struct Case {
  std::shared_ptr<const ItemSizes> sizes;
  std::vector<WantedPairs> wanted;
};

Case random_case(std::mt19937& random, std::size_t most, std::uint64_t largest) {
  const std::size_t items = 3 + random() % most;
  std::vector<std::uint64_t> bytes;
  for (std::size_t i = 0; i < items; ++i) {
    bytes.push_back(1 + random() % largest);
  }
  std::vector<std::uint64_t> sorted = bytes;
  std::sort(sorted.rbegin(), sorted.rend());
  const std::uint64_t all = std::accumulate(bytes.begin(), bytes.end(), std::uint64_t{0});
  Case made{sizes_of(bytes, sorted[0] + sorted[1] + random() % (1 + all / 2)), {}};
  made.wanted.emplace_back();
  made.wanted.push_back(WantedPairs::between(items / 2, items - items / 2));
  made.wanted.push_back(WantedPairs::beyond(1 + random() % (items - 1), items));
  made.wanted.push_back(listed(items, random_pairs(items, 1 + random() % items, random())));
  return made;
}

TEST(SizedSplit, EveryPairMeetsAtAWorker) {
  std::mt19937 random(1);
  for (int round = 0; round < 12; ++round) {
    const Case made = random_case(random, 24, round % 3 == 0 ? 3 : 50);
    const ItemSizes& sizes = *made.sizes;
    const std::uint64_t items = sizes.bytes.size();
    const std::uint64_t workers = 1 + random() % 9;
    for (const WantedPairs& wanted : made.wanted) {
      LoadOrderOptions options;
      options.balance = round % 4 != 3;
      const WorkerSplit split = split_sized_order(made.sizes, wanted, workers, options);
      const SplitFacts& facts = split.facts();
      ASSERT_EQ(facts.workers.size(), workers);
      std::set<ItemPair> met;
      std::uint64_t most = 0;
      std::uint64_t sum = 0;
      for (std::uint64_t w = 0; w < workers; ++w) {
        const auto [bytes, fault] = play(*split.stream(w), sizes, met);
        EXPECT_EQ(fault, "");
        EXPECT_EQ(bytes, facts.workers[w].bytes);
        most = std::max(most, bytes);
        sum += bytes;
      }
      EXPECT_TRUE(have_all_met(met, items, wanted));
      EXPECT_EQ(most, facts.makespan_bytes);
      EXPECT_EQ(sum, facts.bytes);
      EXPECT_GE(most, facts.makespan_bytes_bound.loads) << facts.makespan_bytes_bound.reason;
      EXPECT_NE(facts.makespan_bytes_bound.reason, "");
      EXPECT_GE(sum, split.order().facts().byte_bound.loads);
      EXPECT_LE(split.order().facts().most_bytes, sizes.memory);
      // What is computed, each pair once.
      StepWork work(split.stream(), split.rules(ComputeRules{}), split.owners());
      EXPECT_TRUE(check_schedule(work, split.rules(ComputeRules{})).valid());
      const std::uint64_t once = facts.bytes;
      const LoadBound bound = facts.makespan_bytes_bound;
      const WorkerSplit again =
          repeat_shares(split_sized_order(made.sizes, wanted, workers, options), 3);
      EXPECT_GE(again.facts().makespan_bytes, again.facts().makespan_bytes_bound.loads);
      EXPECT_GE(again.facts().makespan_bytes_bound.loads, bound.loads);
      EXPECT_LE(again.facts().bytes, 3 * once);
    }
  }
}

// The fewest bytes of the busiest of two workers, through all ways to give pairs to them.
std::uint64_t least_busiest(const ItemSizes& sizes, const std::vector<ItemPair>& pairs) {
  const std::size_t items = sizes.bytes.size();
  std::vector<std::uint64_t> fewest(std::size_t{1} << pairs.size(), 0);
  for (std::size_t some = 1; some < fewest.size(); ++some) {
    std::vector<ItemPair> its;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if ((some >> i & 1U) != 0) {
        its.push_back(pairs[i]);
      }
    }
    fewest[some] = fewest_bytes(sizes, listed(items, its));
  }
  std::uint64_t least = ~std::uint64_t{0};
  for (std::size_t some = 0; some < fewest.size(); ++some) {
    least = std::min(least, std::max(fewest[some], fewest[fewest.size() - 1 - some]));
  }
  return least;
}

TEST(SizedSplit, NoSplitOfFewItemsIsBelowTheBound) {
  std::mt19937 random(2);
  int reached = 0;
  int attained = 0;
  constexpr int rounds = 60;
  for (int round = 0; round < rounds; ++round) {
    const std::size_t items = 3 + random() % 2;
    const auto sizes = random_sizes(random, items, round % 2 == 0 ? 3 : 9, 5);
    std::vector<ItemPair> pairs;
    for (Element y = 1; y < items; ++y) {
      for (Element x = 0; x < y; ++x) {
        if (round % 3 != 0 || pairs.empty() || random() % 2 == 0) {
          pairs.emplace_back(x, y);
        }
      }
    }
    const WantedPairs wanted = round % 3 == 0 ? listed(items, pairs) : WantedPairs();
    const std::uint64_t least = least_busiest(*sizes, pairs);
    const SplitFacts facts = split_sized_order(sizes, wanted, 2).facts();
    EXPECT_LE(facts.makespan_bytes_bound.loads, least)
        << round << ": " << facts.makespan_bytes_bound.reason;
    EXPECT_GE(facts.makespan_bytes, least) << round;
    EXPECT_LE(facts.makespan_bytes, 2 * least) << round;
    reached += facts.makespan_bytes == least ? 1 : 0;
    attained += facts.makespan_bytes_bound.loads == least ? 1 : 0;
  }
  EXPECT_GE(reached, rounds / 2);
  EXPECT_GE(attained, 1);
}

// Planes: where groups are even the bound is attained.
TEST(SizedSplit, LinesOfAPlaneAttainTheBound) {
  const auto sizes = sizes_of(std::vector<std::uint64_t>(130, 1000), 100'000);
  const SplitFacts facts = split_sized_order(sizes, {}, 13).facts();
  EXPECT_EQ(facts.makespan_bytes, 40'000U);
  EXPECT_EQ(facts.makespan_bytes_bound.loads, 40'000U);
}

TEST(SizedSplit, OneWorkerHasTheOrder) {
  const auto sizes = sizes_of({5, 4, 3, 2, 1, 3, 4}, 11);
  const WorkerSplit split = split_sized_order(sizes, {}, 1);
  const LoadOrder order = plan_sized_order(sizes, {});
  EXPECT_EQ(split.facts().bytes, order.facts().bytes);
  EXPECT_EQ(split.facts().workers[0].steps, order.facts().steps);
  EXPECT_EQ(split.facts().makespan_bytes_bound.loads, order.facts().byte_bound.loads);
}

// What is in memory while items load, by the definition.
std::string fault_of_overlap(StepSource& steps, const ItemSizes& sizes) {
  std::set<Element> memory;
  std::uint64_t worker = 0;
  const auto bytes = [&](const auto& items) {
    std::uint64_t sum = 0;
    for (const Element x : items) {
      sum += sizes.bytes[x];
    }
    return sum;
  };
  for (Step step; steps.next(step);) {
    if (step.worker != std::exchange(worker, step.worker)) {
      memory.clear();
    }
    for (std::size_t i = 0; i < step.evict.size(); ++i) {
      if (i == step.evict.size() - step.late && bytes(memory) + bytes(step.load) > sizes.memory) {
        return "too much while items load";
      }
      memory.erase(step.evict[i]);
    }
    if (bytes(memory) + bytes(step.load) > sizes.memory) {
      return "too much";
    }
    memory.insert(step.load.begin(), step.load.end());
  }
  return "";
}

TEST(SizedSplit, LoadsThatOverlapHaveTheirBytes) {
  std::mt19937 random(3);
  bool some_spare = false;
  bool some_late = false;
  for (int round = 0; round < 10; ++round) {
    const Case made = random_case(random, 20, 40);
    for (const WantedPairs& wanted : made.wanted) {
      const PrefetchPlan plan = plan_prefetch(made.sizes, wanted);
      ScheduleRules rules = plan.order.rules(ComputeRules{});
      rules.overlap = true;
      ASSERT_EQ(rules.sizes->memory, made.sizes->memory);
      StepWork work(plan.order.stream(), rules);
      const auto steps = all_steps(work);
      const ScheduleVerdict verdict = verdict_of(steps, rules);
      EXPECT_TRUE(verdict.valid()) << verdict.fault;
      StepWork again(plan.order.stream(), rules);
      EXPECT_EQ(fault_of_overlap(again, *made.sizes), "");
      EXPECT_GE(plan.order.facts().bytes, plan.order.facts().byte_bound.loads);
      some_spare = some_spare || plan.spare > 0;
      // What leaves late and was needed for the loads is found.
      for (std::size_t i = 0; i < steps.size(); ++i) {
        std::vector<Step> wrong = steps;
        wrong[i].late = wrong[i].evict.size();
        some_late = some_late || steps[i].late > 0;
        const std::string fault = verdict_of(wrong, rules).fault;
        std::uint64_t early = 0;
        for (std::size_t j = 0; j + steps[i].late < steps[i].evict.size(); ++j) {
          early += made.sizes->bytes[steps[i].evict[j]];
        }
        EXPECT_EQ(!fault.empty(), early > 0) << fault;
      }
      const PrefetchSplit split = split_prefetch(made.sizes, wanted, 3);
      ScheduleRules its = split.order.rules(ComputeRules{});
      its.overlap = true;
      StepWork of_workers(split.order.stream(), its, split.order.owners());
      EXPECT_TRUE(check_schedule(of_workers, its).valid());
      StepWork once_more(split.order.stream(), its, split.order.owners());
      EXPECT_EQ(fault_of_overlap(once_more, *made.sizes), "");
    }
  }
  EXPECT_TRUE(some_spare);
  EXPECT_TRUE(some_late);
}

TEST(SizedSplit, WhatIsWrongIsFound) {
  const auto sizes = sizes_of({5, 4, 3, 2, 1, 3, 4, 6, 2}, 14);
  const WorkerSplit split = split_sized_order(sizes, {}, 3);
  const ScheduleRules rules = split.rules();
  const auto right = all_steps(*split.stream());
  ASSERT_TRUE(verdict_of(right, rules).valid());
  EXPECT_EQ(verdict_of(right, rules).worker_bytes.size(), 3U);
  ScheduleRules less = rules;
  less.sizes = sizes_of(sizes->bytes, split.order().facts().most_bytes - 1);
  EXPECT_THAT(verdict_of(right, less).fault, HasSubstr("bytes where"));
  // A worker's steps left out leave pairs out.
  for (std::uint64_t w = 0; w < 3; ++w) {
    std::vector<Step> steps = right;
    std::erase_if(steps, [&](const Step& step) { return step.worker == w; });
    EXPECT_GT(verdict_of(steps, rules).missing, 0U);
  }
}

TEST(SizedSplit, RefusesWhatCannotBe) {
  const auto sizes = sizes_of({5, 4, 3}, 9);
  EXPECT_REFUSAL(static_cast<void>(split_sized_order(sizes, {}, 0)), BadInput, "0 workers");
  EXPECT_REFUSAL(static_cast<void>(split_sized_order(sizes_of({5, 4, 3}, 8), {}, 2)), BadInput,
                 "items 0 and 1 have 9 bytes together");
  EXPECT_REFUSAL(static_cast<void>(plan_prefetch(sizes_of({5, 4, 3}, 8), WantedPairs())), BadInput,
                 "items 0 and 1 have 9 bytes together");
  const auto refusal = [](const std::string& keys) {
    return message_of([&] {
      static_cast<void>(checked_loads(
          load_request(R"({"sizes":[[0,5],[1,2]],"memory":30,)" + keys + "}"), Door::document));
    });
  };
  EXPECT_EQ(refusal(R"("workers":2)"), "");
  EXPECT_EQ(refusal(R"("prefetch":true)"), "");
  EXPECT_THAT(refusal(R"("workers":0)"), HasSubstr("workers 0: give at least 1 worker"));
  EXPECT_THAT(refusal(R"("workers":65537)"), HasSubstr("workers 65537: give 1 to 65536"));
  EXPECT_THAT(refusal(R"("workers":2,"worker":2)"),
              HasSubstr("worker 2: of workers 2 give 0 to 1"));
  EXPECT_THAT(refusal(R"("workers":2,"write_back":true)"), HasSubstr("add disjoint"));
  EXPECT_EQ(refusal(R"("workers":2,"disjoint":true,"write_back":true)"), "");
  EXPECT_THAT(refusal(R"("fast_room":2)"),
              HasSubstr("fast_room counts items, not their bytes; with sizes give fast_memory"));
  EXPECT_THAT(refusal(R"("from_step":0)"), HasSubstr("from_step 0"));
}

}  // namespace
}  // namespace changeover::test::sized_split_test
