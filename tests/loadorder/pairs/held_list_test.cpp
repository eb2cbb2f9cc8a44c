// Groups of a list that stay in turn: played step by step, and held to closing and to all pairs;
// and the check of lists that are dense, and of lists that are not.
#include <gtest/gtest.h>

#include <set>

#include "changeover/loadorder/schedule.hpp"
#include "loadorder/pairs/held/held_list.hpp"
#include "pairs_support.hpp"

namespace changeover::test::held_list_test {
namespace {

// The moves one by one, played with plain sets. Empty, or what is wrong.
std::string defect_of(const PairGraph& graph, std::uint64_t room, const HeldList& held) {
  const std::vector<LoadMove> moves = held.moves(graph);
  if (moves.size() != held.loads) {
    return fmt::format("{} loads, and {} were promised", moves.size(), held.loads);
  }
  std::set<Element> memory;
  std::set<ItemPair> met;
  std::set<Element> seen;
  for (const LoadMove& move : moves) {
    if (move.evict != LoadMove::nothing && memory.erase(move.evict) == 0) {
      return fmt::format("{} is evicted and not there", move.evict);
    }
    if (memory.contains(move.load)) {
      return fmt::format("{} is loaded and there", move.load);
    }
    for (const Element y : memory) {
      met.emplace(std::min(move.load, y), std::max(move.load, y));
    }
    memory.insert(move.load);
    seen.insert(move.load);
    if (memory.size() > room) {
      return "memory is full";
    }
  }
  for (Element x = 0; x < graph.items(); ++x) {
    if (graph.is_needed(x) && !seen.contains(x)) {
      return fmt::format("{} is not loaded", x);
    }
    for (const Element y : graph.partners(x)) {
      if (!met.contains({std::min(x, y), std::max(x, y)})) {
        return fmt::format("{{{},{}}} did not meet", x, y);
      }
    }
  }
  return "";
}

TEST(HeldList, BringsAllListedPairsTogetherWithTheLoadsThatItPromises) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const std::uint64_t items = 3 + seed % 40;
    const std::uint64_t most = items * (items - 1) / 2;
    auto pairs = random_pairs(items, static_cast<std::size_t>(1 + seed * 7919 % most), seed);
    if (seed % 3 == 0) {
      const auto alone = static_cast<Element>(seed % items);
      pairs.emplace_back(alone, alone);
    }
    const PairGraph graph(items, pairs);
    for (const std::uint64_t room : {2U, 3U, 5U, 11U}) {
      const HeldList held = held_list(graph, room, [] { return false; });
      EXPECT_EQ(defect_of(graph, room, held), "") << seed << " " << room;
    }
  }
}

TEST(HeldList, IsTakenWhereMostPairsAreListed) {
  // Of 80 items 40, 60 and 80 % of the pairs: closing one item after another takes far more.
  for (const std::size_t count : {1264U, 1896U, 2528U}) {
    const auto pairs = random_pairs(80, count, count);
    const LoadOrder order = plan_load_order(listed(80, pairs), 12, hardly_searched());
    EXPECT_EQ(defect(order), "");
    const PairGraph graph(80, pairs);
    EXPECT_LE(order.facts().loads, held_list(graph, 12, [] { return false; }).loads);
    EXPECT_LE(order.facts().loads, plan_load_order(80, 12).facts().loads);
  }
}

// An order for `wanted` with one step taken out, for every step: the check names a pair.
void loses_what_a_step_brings(const WantedPairs& wanted, std::uint64_t room) {
  const LoadOrder order = plan_load_order(wanted, room, hardly_searched());
  const ScheduleRules rules = order.rules();
  std::vector<Step> steps;
  const auto stream = order.stream();
  for (Step step; stream->next(step);) {
    steps.push_back(step);
  }
  ASSERT_TRUE(verdict_of(steps, rules).valid());
  std::uint64_t found = 0;
  for (std::size_t out = 1; out < steps.size(); out += 7) {
    std::vector<Step> fewer = steps;
    fewer[out].load.clear();
    fewer[out].evict.clear();
    std::set<Element> memory;
    for (Step& step : fewer) {
      std::erase_if(step.evict, [&](Element x) { return !memory.contains(x); });
      for (const Element x : step.evict) {
        memory.erase(x);
      }
      std::erase_if(step.load,
                    [&](Element x) { return memory.contains(x) || memory.size() >= room; });
      for (const Element x : step.load) {
        memory.insert(x);
      }
    }
    const ScheduleVerdict verdict = verdict_of(fewer, rules);
    // By the definition, pair by pair.
    std::set<ItemPair> met;
    memory.clear();
    for (const Step& step : fewer) {
      for (const Element x : step.evict) {
        memory.erase(x);
      }
      for (const Element x : step.load) {
        for (const Element y : memory) {
          met.emplace(std::min(x, y), std::max(x, y));
        }
        memory.insert(x);
      }
    }
    std::uint64_t missing = 0;
    for (const ItemPair& pair : pairs_of(wanted)) {
      missing += met.contains(pair) ? 0U : 1U;
    }
    EXPECT_EQ(verdict.missing, missing) << out;
    found += missing > 0 ? 1U : 0U;
  }
  EXPECT_GT(found, 0U);
}

TEST(CheckOfLists, CountsWhatIsMissingInDenseListsAndInOthers) {
  loses_what_a_step_brings(listed(60, random_pairs(60, 900, 1)), 8);     // looked up by rows
  loses_what_a_step_brings(listed(60, random_pairs(60, 900, 1)), 40);    // the same in words
  loses_what_a_step_brings(listed(700, close_points(700, 1500, 2)), 8);  // one by one
  loses_what_a_step_brings(listed(700, close_points(700, 1500, 2)), 40);
}

}  // namespace
}  // namespace changeover::test::held_list_test
