// Some pairs only, for workers that never hold one item twice: against plain sets, and wrong orders
// refused.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "../pairs/pairs_support.hpp"
#include "changeover/loadorder/workers.hpp"
#include "loadorder/listed/lockstep_events.hpp"

namespace changeover::test::listed_disjoint_test {
namespace {

class KeptSteps final : public StepSource {
 public:
  explicit KeptSteps(std::vector<Step> steps) : steps_(std::move(steps)) {}

  bool next(Step& step) override { return next_ < steps_.size() && (step = steps_[next_++], true); }

 private:
  std::vector<Step> steps_;
  std::size_t next_ = 0;
};

// Plays all workers in sets: the first thing that is wrong, or "".
std::string fault_of(const LoadOrder& order, const std::set<ItemPair>& wanted) {
  const LoadOrderFacts& facts = order.facts();
  const std::uint64_t workers = facts.lockstep;
  StepWork work(order.stream(), order.rules(ComputeRules{}));
  const std::vector<Step> all = all_steps(work);
  std::vector<std::set<Element>> memory(workers);
  std::vector<std::set<Element>> idle(workers);
  std::set<ItemPair> computed;
  std::uint64_t loads = 0;
  std::uint64_t span = 0;
  if (all.size() != workers * facts.steps) {
    return fmt::format("{} steps of {} workers", all.size(), workers);
  }
  for (std::size_t begin = 0; begin < all.size(); begin += workers) {
    const std::vector<Step> round(all.begin() + static_cast<std::ptrdiff_t>(begin),
                                  all.begin() + static_cast<std::ptrdiff_t>(begin + workers));
    std::set<Element> held;
    std::uint64_t slowest = 0;
    for (std::size_t w = 0; w < workers; ++w) {
      const Step& step = round[w];
      if (step.worker != w || step.number != begin / workers + 1) {
        return "a step is of another worker";
      }
      for (const Element x : step.evict) {
        if (memory[w].erase(x) != 1) {
          return fmt::format("{} is not there", x);
        }
        if (idle[w].contains(x)) {
          return fmt::format("worker {} loads {} for nothing", w, x);
        }
      }
      slowest = std::max<std::uint64_t>(slowest, step.load.size());
      loads += step.load.size();
    }
    span += slowest;
    for (std::size_t w = 0; w < workers; ++w) {
      for (const Element x : round[w].load) {
        memory[w].insert(x);
        idle[w].insert(x);
      }
      for (const Element x : memory[w]) {
        if (!held.insert(x).second) {
          return fmt::format("{} is held twice", x);
        }
      }
      if (memory[w].size() > facts.room) {
        return "too much is held";
      }
      for (const ItemPair& pair : round[w].compute) {
        if (!memory[w].contains(pair.first) || !memory[w].contains(pair.second) ||
            !wanted.contains(pair) || !computed.insert(pair).second) {
          return "a wrong pair";
        }
        idle[w].erase(pair.first);
        idle[w].erase(pair.second);
      }
    }
  }
  for (const std::set<Element>& each : idle) {
    if (!each.empty()) {
      return fmt::format("{} is loaded for nothing", *each.begin());
    }
  }
  return computed != wanted                              ? "pairs are missing"
         : loads != facts.loads                          ? "other loads"
         : span != facts.span                            ? "another span"
         : loads < facts.bound.loads                     ? "fewer loads than the bound"
         : facts.makespan() < facts.makespan_bound.loads ? "fewer than the bound of the busiest"
                                                         : "";
}

TEST(ListedDisjoint, MeetTheDefinitionAndTheBounds) {
  for (const std::uint64_t workers : {1U, 2U, 3U, 7U, 40U}) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const std::uint64_t items = 3 + seed % 20;
      const std::uint64_t most = items * (items - 1) / 2;
      const auto pairs = random_pairs(items, 1 + (7 * seed) % most, seed);
      for (const std::uint64_t room : {2U, 3U, 6U}) {
        const LoadOrder order =
            plan_disjoint_order(listed(items, pairs), room, workers, hardly_searched());
        EXPECT_EQ(fault_of(order, {pairs.begin(), pairs.end()}), "")
            << workers << " " << seed << " " << room;
        if (pairs.size() <= 9 && items <= 8) {
          EXPECT_GE(order.facts().loads, fewest_loads(items, pairs, room));
          EXPECT_LE(order.facts().bound.loads, fewest_loads(items, pairs, room));
        }
      }
    }
  }
}

TEST(ListedDisjoint, ListsOfNeighboursTakeAboutAWorkersShare) {
  const auto pairs = close_points(600, 4000, 2);
  for (const std::uint64_t workers : {2U, 4U}) {
    const LoadOrder order = plan_disjoint_order(listed(600, pairs), 40, workers);
    EXPECT_EQ(fault_of(order, {pairs.begin(), pairs.end()}), "");
    EXPECT_LE(order.facts().span * 10, order.facts().makespan_bound.loads * 15)
        << order.facts().span << " " << order.facts().makespan_bound.loads;
  }
}

// Without a scope that ends it, a search is a round of changes.
LoadOrderOptions searched() {
  LoadOrderOptions options;
  options.search_pairs = [](const std::function<void()>& search) { search(); };
  return options;
}

TEST(ListedDisjoint, ASearchShortensTheSteps) {
  const auto pairs = close_points(100, 400, 3);
  std::uint64_t quick_span = 0;
  std::uint64_t span = 0;
  for (const std::uint64_t workers : {2U, 4U, 7U}) {
    const LoadOrder quick = plan_disjoint_order(listed(100, pairs), 12, workers);
    const LoadOrder order = plan_disjoint_order(listed(100, pairs), 12, workers, searched());
    EXPECT_EQ(fault_of(order, {pairs.begin(), pairs.end()}), "");
    EXPECT_LE(order.facts().span, quick.facts().span);
    quick_span += quick.facts().span;
    span += order.facts().span;
  }
  EXPECT_LT(span, quick_span);
}

TEST(ListedDisjoint, MostPairsAreListedForWhichAnOrderForAllIsGood) {
  const auto pairs = random_pairs(40, 660, 2);
  for (const std::uint64_t workers : {2U, 3U}) {
    const LoadOrder order = plan_disjoint_order(listed(40, pairs), 6, workers);
    EXPECT_EQ(fault_of(order, {pairs.begin(), pairs.end()}), "");
    EXPECT_EQ(order.facts().explanation.substr(0, 23), "An order for all pairs.");
    EXPECT_LE(order.facts().span, plan_disjoint_order(40, 6, workers).facts().span);
  }
}

TEST(ListedDisjoint, TwoSetsAndNewItemsAreListsToo) {
  for (const WantedPairs& wanted : {WantedPairs::between(9, 14), WantedPairs::beyond(15, 20)}) {
    const auto pairs = pairs_of(wanted);
    const LoadOrder order = plan_disjoint_order(wanted, 5, 3);
    EXPECT_EQ(fault_of(order, {pairs.begin(), pairs.end()}), "");
  }
}

TEST(ListedDisjoint, ChangesAreStoredInEachEpochAndSpreadOverSteps) {
  const auto pairs = close_points(40, 150, 3);
  for (const std::uint64_t epochs : {1U, 3U}) {
    const LoadOrder order =
        repeat_order(plan_disjoint_order(listed(40, pairs), 6, 3, hardly_searched()), epochs);
    ScheduleRules rules =
        order.rules(ComputeRules{.ordered = true, .self = true, .spread = std::uint64_t{5}});
    rules.store = true;
    std::vector<Step> steps = work_of(order.stream(), rules);
    const ScheduleVerdict verdict = verdict_of(steps, rules);
    EXPECT_TRUE(verdict.valid()) << verdict.fault << verdict.missing;
    EXPECT_EQ(verdict.computed, epochs * (2 * pairs.size() + 40));
    for (std::size_t w = 0; w < 3; ++w) {
      if (Step& last = steps[steps.size() - 3 + w]; !last.store.empty()) {
        auto lost = steps;
        lost[steps.size() - 3 + w].store.pop_back();
        EXPECT_NE(verdict_of(lost, rules).fault.find("loses"), std::string::npos);
      }
    }
  }
}

TEST(ListedDisjoint, ChecksRefuseWhatIsWrong) {
  const auto pairs = close_points(30, 90, 5);
  const WantedPairs wanted = listed(30, pairs);
  const LoadOrder order = plan_disjoint_order(wanted, 5, 2, hardly_searched());
  const std::vector<Step> right = all_steps(*order.stream());
  ASSERT_TRUE(verdict_of(right, order.rules()).valid());
  auto wrong = right;
  wrong[1].load.push_back(wrong[0].load[0]);
  wrong[1].load.erase(wrong[1].load.begin());
  EXPECT_NE(verdict_of(wrong, order.rules()).fault.find("in memory of worker 0"),
            std::string::npos);
  // Shares that are no lockstep are refused where two workers hold one item.
  const WorkerSplit split = split_load_order(wanted, 5, 2, hardly_searched());
  std::vector<Step> shares;
  const auto first = all_steps(*split.stream(0));
  const auto second = all_steps(*split.stream(1));
  for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
    shares.push_back(first[i]);
    shares.push_back(second[i]);
  }
  EXPECT_FALSE(verdict_of(shares, order.rules()).valid());
  // Two items of a pair that are held at once by two workers have not met.
  const std::vector<Step> apart{{.number = 1, .load = {0}, .worker = 0},
                                {.number = 1, .load = {1}, .worker = 1}};
  const WantedPairs pair = listed(2, {{0, 1}});
  ScheduleRules rules{.items = 2, .room = 2, .lockstep = 2, .wanted = pair};
  EXPECT_EQ(verdict_of(apart, rules).missing, 1U);
  rules.compute = ComputeRules{};
  StepWork work(std::make_unique<KeptSteps>(apart), rules);
  for (const Step& step : all_steps(work)) {
    EXPECT_TRUE(step.compute.empty());
  }
}

TEST(LockstepEvents, StaysWithoutANewPairAreLeftOutAndFillsAreOneStep) {
  const PairGraph graph(4, std::vector<ItemPair>{{0, 1}, {2, 3}});
  const LockstepLists lists = lists_of({{{0, 0, true},
                                         {1, 1, true},
                                         {2, 0, false},
                                         {2, 2, true},  // meets nothing that it lacks
                                         {4, 2, false},
                                         {5, 0, true}},
                                        {{5, 2, true}, {6, 3, true}}},
                                       &graph);
  EXPECT_EQ(lists.loads, 4U);
  EXPECT_EQ(lists.workers, 2U);
  EXPECT_EQ(lists.span, lists.steps == 1 ? 2U : 4U);
}

}  // namespace
}  // namespace changeover::test::listed_disjoint_test
