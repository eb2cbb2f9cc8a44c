#include "changeover/loadorder/workers.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>

#include "changeover/core/error.hpp"
#include "core/words.hpp"
#include "loadorder_support.hpp"
#include "message_of.hpp"

namespace changeover::test::workers_test {
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
                  items == 1
                      ? "every step read, no pair is wanted"
                      : "every step read, " + all_of(items * (items - 1) / 2, "pair") + " met");
        const std::string& method = split.order().facts().method;
        if (method != "quorums" && method != "held and streamed groups" &&
            !method.ends_with("plane") && method != "held groups, a block a worker") {
          const std::string groups = "Of " + std::to_string(facts.groups) + " groups";
          EXPECT_EQ(facts.explanation.starts_with(groups), facts.groups < items);
        }
        EXPECT_GE(makespan, facts.makespan_bound.loads) << items << " " << room << " " << workers;
      }
    }
  }
}

// The larger question, all pairs, is an answer to each smaller one.
TEST(Workers, AreNeverWorseThanForTheLargerQuestion) {
  for (std::uint64_t items = 3; items <= 26; items += items < 10 ? 1 : 4) {
    for (const std::uint64_t room : {2U, 3U, 5U, 8U}) {
      for (std::uint64_t workers = 1; workers <= 5; ++workers) {
        const std::uint64_t all = split_load_order(items, room, workers).facts().makespan;
        for (std::uint64_t done = 1; done < items; done += 1 + items / 6) {
          const WantedPairs wanted = WantedPairs::beyond(done, items);
          const WorkerSplit split = split_load_order(wanted, room, workers);
          const SplitFacts& facts = split.facts();
          EXPECT_LE(facts.makespan, all) << items << " " << room << " " << workers << " " << done;
          EXPECT_GE(facts.makespan, facts.makespan_bound.loads);
          ScheduleCheck check({.items = items, .room = room, .wanted = wanted});
          std::uint64_t makespan = 0;
          for (std::uint64_t w = 0; w < workers; ++w) {
            std::uint64_t loads = 0;
            Step step;
            for (const auto steps = split.stream(w); steps->next(step);) {
              check.read(step);
              loads += step.load.size();
            }
            EXPECT_EQ(loads, facts.workers[static_cast<std::size_t>(w)].loads);
            makespan = std::max(makespan, loads);
          }
          EXPECT_TRUE(check.finish().valid()) << check.finish().fault;
          EXPECT_EQ(makespan, facts.makespan);
        }
      }
    }
  }
  EXPECT_LE(split_load_order(WantedPairs::beyond(512, 1024), 64, 16).facts().makespan,
            split_load_order(1024, 64, 16).facts().makespan);
}

// No other cut of the same order into stretches has a smaller makespan.
TEST(Workers, StretchesOfUnlikeStepsAreCutByLoads) {
  const WantedPairs wanted = WantedPairs::between(4, 9);
  const LoadOrder order = plan_load_order(wanted, 4);
  std::vector<std::uint64_t> held;
  std::vector<std::uint64_t> loaded;
  Step step;
  for (const auto steps = order.stream(); steps->next(step);) {
    held.push_back((held.empty() ? 0 : held.back()) + step.load.size() - step.evict.size());
    loaded.push_back(step.load.size());
  }
  const std::size_t n = held.size();
  ASSERT_LT(n, 60U);
  const auto loads = [&](std::size_t from, std::size_t to) {
    return std::accumulate(loaded.begin() + static_cast<std::ptrdiff_t>(from + 1),
                           loaded.begin() + static_cast<std::ptrdiff_t>(to), held[from]);
  };
  for (std::uint64_t workers = 1; workers <= 4; ++workers) {
    // The least largest share of the steps from `from` on.
    const std::function<std::uint64_t(std::size_t, std::uint64_t)> least =
        [&](std::size_t from, std::uint64_t left) -> std::uint64_t {
      std::uint64_t best = loads(from, n);
      for (std::size_t to = from + 1; to < n && left > 1; ++to) {
        best = std::min(best, std::max(loads(from, to), least(to, left - 1)));
      }
      return best;
    };
    const LoadOrderFacts facts = order.facts();
    const WorkerSplit split = split_order(LoadOrder(facts, [&order] { return order.stream(); }),
                                          wanted.items(), 4, workers);
    EXPECT_EQ(split.facts().makespan, least(0, workers)) << workers;
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
  EXPECT_REFUSAL(static_cast<void>(split_load_order(9, 4, 0)), BadInput,
                 "0 workers: give 1 to 65536");
  EXPECT_REFUSAL(static_cast<void>(split_load_order(9, 4, 1'000'000)), BadInput,
                 "1000000 workers: give 1 to 65536");
  EXPECT_REFUSAL(static_cast<void>(split_load_order(9, 4, 2).stream(2)), BadInput,
                 "there is no worker 2: the order is for 2; count from 0");
}

}  // namespace
}  // namespace changeover::test::workers_test
