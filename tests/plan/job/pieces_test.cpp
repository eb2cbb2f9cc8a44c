// Several equal pieces of a part: what they are for, and that nothing is lost by naming them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>

#include "changeover/core/error.hpp"
#include "changeover/plan/run_plan.hpp"
#include "message_of.hpp"
#include "plan/search/first_pieces.hpp"
#include "run/random.hpp"

namespace changeover::pieces_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// Parts of two slots, the first of which needs so many.
Job some_job(std::uint64_t parts, std::uint64_t least, std::uint64_t room) {
  Job job = make_job(parts, room, Amount{2'000'000}, Amount{1'000'000});
  std::vector<std::string> slots(parts, "a");
  slots.back() = "b";
  for (std::size_t i = 0; i < parts; ++i) {
    job.names[i] = "p" + job.names[i];
    job.change_costs[i] = Amount{(1 + i) * 500'000};
  }
  set_slots(job, slots, {{"a", least, least}, {"b", 1, 1}});
  return job;
}

TEST(Pieces, AreAsManyAsASlotMayNeed) {
  Job job = some_job(4, 3, 4);
  EXPECT_EQ(add_pieces(job, {4, 2, 1, 9}), 3U);
  EXPECT_THAT(job.names, ElementsAre("p1", "p2", "p3", "p4", "p1 #2", "p1 #3", "p2 #2"));
  EXPECT_THAT(job.piece_of, ElementsAre(0, 1, 2, 3, 0, 0, 1));
  EXPECT_EQ(job.needed.size(), 6U);
  // Four pieces are shared among the three that a set-up may have.
  EXPECT_THAT(job.quantities, ElementsAre(2U, 1U, 1U, 9U, 1U, 1U, 1U));
  EXPECT_EQ(job.change_costs[5], job.change_costs[0]);
  EXPECT_THAT(defects(job), IsEmpty());
}

TEST(Pieces, AreNotAddedWithoutNeed) {
  Job job = some_job(4, 1, 3);
  EXPECT_EQ(add_pieces(job, {4, 2, 1, 9}), 0U);
  EXPECT_THAT(job.piece_of, IsEmpty());
  EXPECT_THAT(job.quantities, ElementsAre(4U, 2U, 1U, 9U));
  Job without = make_job(3, 2, Amount{1}, Amount{1});
  EXPECT_EQ(add_pieces(without, {5, 5, enough_for_all}), 0U);
}

TEST(Pieces, MustNotMeetWhatThePartMustNot) {
  Job job = some_job(4, 2, 4);
  job.never.insert(0, 1);
  job.why_never.set(0, 1, "too hot");
  job.needed = all_pairs_but(job.never);
  add_pieces(job, {2, 2, 2, 1});
  for (const auto& [x, y] :
       std::vector<std::pair<Element, Element>>{{0, 1}, {0, 5}, {4, 1}, {4, 5}}) {
    EXPECT_TRUE(job.never.contains(x, y));
    EXPECT_EQ(job.why_never(x, y), "too hot");
  }
  EXPECT_EQ(job.never.size(), 4U);
  EXPECT_FALSE(job.never.contains(0, 4));
}

TEST(Pieces, NamesOfPiecesAreNoParts) {
  Job job = some_job(3, 2, 3);
  job.names[1] = "p1 #2";
  EXPECT_THROW(add_pieces(job, {2, 1, 1}), BadInput);
  EXPECT_EQ(job.names.size(), 3U) << "the job is as it was";
  EXPECT_REFUSAL(add_pieces(job, {1, 1}), BadInput,
                 "the quantities do not fit the number of parts; give one each");
}

// The least cost of any list in which a set-up is how many pieces of each part are mounted, by a
// search through all of them: what meets is parts. Costs are per piece that comes.
std::uint64_t least_cost(const Job& parts, const std::vector<std::uint64_t>& quantities,
                         const Job& limits) {
  using Count = std::vector<std::uint64_t>;
  const std::size_t v = quantities.size();
  std::vector<Count> setups;
  Count now(v, 0);
  const std::function<void(std::size_t)> choose = [&](std::size_t part) {
    if (part == v) {
      std::vector<std::uint64_t> there(limits.slots.size(), 0);
      std::uint64_t all = 0;
      for (std::size_t i = 0; i < v; ++i) {
        there[limits.slot_of[i]] += now[i];
        all += now[i];
      }
      bool good = all <= limits.at_once && all > 0;
      for (std::size_t s = 0; s < there.size(); ++s) {
        good = good && there[s] >= limits.slots[s].least && there[s] <= limits.slots[s].most;
      }
      if (good) {
        setups.push_back(now);
      }
      return;
    }
    for (now[part] = 0; now[part] <= quantities[part]; ++now[part]) {
      choose(part + 1);
    }
    now[part] = 0;
  };
  choose(0);
  std::vector<std::pair<Element, Element>> pairs;
  parts.needed.for_each(100, [&](Element x, Element y) { pairs.emplace_back(x, y); });
  using State =
      std::pair<std::size_t, unsigned>;  // the last set-up, one more than its number; what has met
  std::map<State, std::uint64_t> best{{{0, 0U}, 0}};
  std::map<std::pair<std::uint64_t, State>, bool> queue{{{0, {0, 0U}}, true}};
  while (!queue.empty()) {
    const auto [cost, state] = queue.begin()->first;
    queue.erase(queue.begin());
    if (state.second + 1 == 1U << pairs.size()) {
      return cost;
    }
    if (best[state] < cost) {
      continue;
    }
    for (std::size_t i = 0; i < setups.size(); ++i) {
      std::uint64_t step = parts.test_cost.millionths;
      for (std::size_t x = 0; x < v; ++x) {
        const std::uint64_t before = state.first == 0 ? 0 : setups[state.first - 1][x];
        step += (setups[i][x] - std::min(setups[i][x], before)) * parts.change_costs[x].millionths;
      }
      unsigned met = state.second;
      for (std::size_t p = 0; p < pairs.size(); ++p) {
        met |= setups[i][pairs[p].first] > 0 && setups[i][pairs[p].second] > 0 ? 1U << p : 0U;
      }
      const State next{i + 1, met};
      const auto found = best.find(next);
      if (found == best.end() || cost + step < found->second) {
        best[next] = cost + step;
        queue[{cost + step, next}] = true;
      }
    }
  }
  return 0;
}

// Named pieces lose nothing: the cheapest plan costs what the cheapest list of numbers of pieces
// costs.
TEST(Pieces, NoPlanIsLostByNamingThem) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed, 9);
    const std::uint64_t parts = 4 + random.below(2);
    Job plain = some_job(parts, 2 + random.below(2), 4);
    std::vector<std::uint64_t> quantities;
    for (std::uint64_t i = 0; i < parts; ++i) {
      quantities.push_back(1 + random.below(3));
      plain.change_costs[i] = Amount{(1 + random.below(5)) * 500'000ULL};
    }
    Job job = plain;
    if (add_pieces(job, quantities) == 0) {
      continue;
    }
    drop_needed(job, cannot_meet(job));
    plain.needed = PairSet(parts);
    job.needed.for_each(100, [&](Element x, Element y) { plain.needed.insert(x, y); });
    if (!defects(job).empty()) {
      continue;
    }
    RunControl control({.threads = 1});
    const RunPlan plan = make_run_plan(job, {.steps = 20'000}, control);
    const std::uint64_t least = least_cost(plain, quantities, plain);
    EXPECT_GE(plan.sheet.cost.millionths, least) << seed;
    EXPECT_LE(plan.bound.cost.millionths, least) << seed;
    EXPECT_EQ(plan.sheet.cost.millionths, least) << seed;
    const RunPlan first = with_first_pieces(job, plan);
    EXPECT_TRUE(first.sheet.does_the_job());
    EXPECT_EQ(first.sheet.cost, plan.sheet.cost);
    for (const RunStep& step : first.sheet.steps) {
      for (const Element x : step.setup) {  // a further piece is there with those before it
        for (Element y = 0; y < x; ++y) {
          EXPECT_TRUE(job.piece_of[y] != job.piece_of[x] ||
                      std::ranges::binary_search(step.setup, y));
        }
      }
    }
  }
}

}  // namespace
}  // namespace changeover::pieces_test
