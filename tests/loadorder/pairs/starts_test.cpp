// Orders of closing items, and what finds better ones, on graphs of every size that is treated
// differently.
#include "loadorder/pairs/starts.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <numeric>

#include "loadorder/pairs/bucket_queue.hpp"
#include "loadorder/pairs/closing.hpp"
#include "loadorder/pairs/fewest_missing.hpp"
#include "loadorder/pairs/small_search.hpp"
#include "pairs_support.hpp"

namespace changeover::test::starts_test {
namespace {

RC_GTEST_PROP(BucketQueue, TakesWhatAListOfAllWouldTake, (bool newest)) {
  constexpr Element items = 12;
  BucketQueue queue(items, newest ? BucketQueue::Ties::newest : BucketQueue::Ties::oldest);
  std::map<Element, std::pair<std::uint32_t, int>> all;  // number, time
  const auto seed = *rc::gen::inRange<std::uint64_t>(1, 1'000'000);
  Random random(seed);
  for (int time = 1; time < 200; ++time) {
    const Element x = random.below(items);
    switch (random.below(4)) {
      case 0:
        queue.remove(x);
        all.erase(x);
        break;
      case 1: {
        const auto taken = queue.take_lowest();
        RC_ASSERT(taken.has_value() == !all.empty());
        if (taken) {
          const auto least =
              std::min_element(all.begin(), all.end(), [&](const auto& a, const auto& b) {
                const auto key = [&](const auto& item) {
                  return std::pair(item.second.first,
                                   newest ? -item.second.second : item.second.second);
                };
                return key(a) < key(b);
              });
          RC_ASSERT(*taken == least->first);
          all.erase(least);
        }
        break;
      }
      default: {
        const std::uint32_t number = random.below(5);
        queue.put(x, number);
        all[x] = {number, time};
      }
    }
    RC_ASSERT(queue.holds(x) == (all.count(x) == 1));
  }
}

RC_GTEST_PROP(Starts, AreOrdersOfAllItems, ()) {
  const auto items = *rc::gen::inRange<std::uint64_t>(2, 60);
  const auto room = *rc::gen::inRange<std::uint64_t>(2, 20);
  const auto count = *rc::gen::inRange<std::uint64_t>(1, items);
  const auto seed = *rc::gen::inRange<std::uint64_t>(1, 1'000'000);
  auto pairs = random_pairs(items, static_cast<std::size_t>(count / 2 + 1), seed);
  pairs.emplace_back(0, 0);
  const PairGraph graph(items, pairs);
  std::size_t starts = 0;
  each_start(graph, room, [&](const std::string&, std::vector<Element> order) {
    ++starts;
    std::sort(order.begin(), order.end());
    std::vector<Element> all(static_cast<std::size_t>(items));
    std::iota(all.begin(), all.end(), 0U);
    RC_ASSERT(order == all);
    return true;
  });
  RC_ASSERT(starts == 5U);
}

// The square of 30 × 30 items, each with its eight neighbours, numbered at random.
PairGraph square() {
  constexpr Element side = 30;
  std::vector<Element> names(side * side);
  std::iota(names.begin(), names.end(), 0U);
  Random random(1);
  for (std::uint32_t i = side * side; i > 1; --i) {
    std::swap(names[i - 1], names[random.below(i)]);
  }
  std::vector<ItemPair> pairs;
  for (Element y = 0; y < side; ++y) {
    for (Element x = 0; x < side; ++x) {
      for (const auto& [dx, dy] : {std::pair(1, 0), {0, 1}, {1, 1}, {-1, 1}}) {
        const int a = static_cast<int>(x) + dx;
        const int b = static_cast<int>(y) + dy;
        if (a >= 0 && a < static_cast<int>(side) && b < static_cast<int>(side)) {
          pairs.emplace_back(
              names[x + side * y],
              names[static_cast<std::size_t>(a) + side * static_cast<std::size_t>(b)]);
        }
      }
    }
  }
  return {side * side, pairs};
}

TEST(Starts, ThatKnowTheRoomAreBestWhereItIsSmall) {
  const PairGraph graph = square();
  std::map<std::string, std::uint64_t> loads;
  each_start(graph, 12, [&](const std::string& name, const std::vector<Element>& order) {
    loads[name] = Closing(graph, 12, order).run();
    return true;
  });
  EXPECT_LT(5 * loads["lacking, oldest"], 4 * loads["frontier"]);
  EXPECT_LT(5 * loads["lacking, oldest"], 4 * loads["breadth"]);
}

TEST(Lacking, IsEmptyOnceItIsGivenUp) {
  const PairGraph graph = square();
  std::vector<Element> roots(static_cast<std::size_t>(graph.items()));
  std::iota(roots.begin(), roots.end(), 0U);
  int asked = 0;
  EXPECT_TRUE(fewest_missing_order(graph, 12, roots, BucketQueue::Ties::newest, [&] {
                return ++asked == 20;
              }).empty());
  EXPECT_EQ(asked, 20);
}

TEST(Closing, GivesUpAboveItsLimitAndInAHurry) {
  const PairGraph graph = square();
  std::vector<Element> order(static_cast<std::size_t>(graph.items()));
  std::iota(order.begin(), order.end(), 0U);
  Closing closing(graph, 12, order);
  const std::uint64_t loads = closing.run();
  EXPECT_EQ(closing.run(loads), loads);
  EXPECT_EQ(closing.take_moves().size(), loads);
  EXPECT_GT(closing.run(loads / 2), loads / 2);
  EXPECT_EQ(closing.run(loads, [] { return true; }), loads + 1);
  // Without a limit it goes on to the end.
  const std::uint64_t hurried = closing.run(Closing::no_limit, [] { return true; });
  EXPECT_EQ(closing.take_moves().size(), hurried);
}

/// Each load is a step.
class OneByOne final : public StepSource {
 public:
  explicit OneByOne(std::vector<LoadMove> moves) : moves_(std::move(moves)) {}

  bool next(Step& step) override {
    if (at_ == moves_.size()) {
      return false;
    }
    const LoadMove& move = moves_[at_++];
    step.number = at_;
    step.load = {move.load};
    step.evict.clear();
    if (move.evict != LoadMove::nothing) {
      step.evict.push_back(move.evict);
    }
    return true;
  }

 private:
  std::vector<LoadMove> moves_;
  std::size_t at_ = 0;
};

TEST(SmallSearch, IsNeverWorseThanItsStartAndLoadsWhatItSays) {
  for (const std::uint64_t items : {5U, 64U, 65U, 127U, 128U, 129U, 256U}) {
    auto pairs = random_pairs(items, static_cast<std::size_t>(2 * items) - 1, items);
    pairs.emplace_back(3, 3);
    const WantedPairs wanted = listed(items + 7, pairs);
    const PairGraph& graph = *wanted.graph();
    ASSERT_TRUE(SmallSearch::serves(graph));
    const std::uint64_t room = 3 + items / 20;
    each_start(graph, room, [&](const std::string& name, const std::vector<Element>& order) {
      SmallSearch small(graph, room);
      Random random(1);
      const auto never = [] { return false; };
      const auto first = small.anneal(order, 0, 0, random, never);
      const auto better = small.anneal(order, 0, 300 * small.work_of_look(), random, never);
      EXPECT_LE(better.moves.size(), first.moves.size()) << name;
      for (const auto& found : {first, better}) {
        LoadOrderFacts facts;
        facts.items = items + 7;
        facts.room = room;
        facts.loads = facts.steps = found.moves.size();
        facts.wanted = wanted;
        const LoadOrder played(facts, [moves = found.moves]() -> std::unique_ptr<StepSource> {
          return std::make_unique<OneByOne>(moves);
        });
        EXPECT_EQ(defect(played), "") << name << ' ' << items;
      }
      return true;
    });
  }
}

TEST(SmallSearch, ServesShortListsOnly) {
  EXPECT_TRUE(SmallSearch::serves(PairGraph(1000, random_pairs(256, 300, 1))));
  std::vector<ItemPair> path;
  for (Element x = 0; x < 256; ++x) {
    path.emplace_back(x, x + 1);
  }
  EXPECT_FALSE(SmallSearch::serves(PairGraph(1000, path)));
}

}  // namespace
}  // namespace changeover::test::starts_test
