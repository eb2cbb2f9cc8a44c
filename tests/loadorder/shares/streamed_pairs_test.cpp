#include <gtest/gtest.h>

#include <set>

#include "../loadorder_support.hpp"
#include "changeover/core/error.hpp"
#include "changeover/loadorder/workers.hpp"
#include "loadorder/order/streamed_order.hpp"
#include "message_of.hpp"

namespace changeover::test::streamed_pairs_test {
namespace {

// Orders of all kinds: windows, with further items, after rounds; rounds to the end.
std::vector<StreamedShape> shapes() {
  std::vector<StreamedShape> all;
  for (std::uint64_t room = 2; room <= 7; ++room) {
    for (std::uint64_t items = 1; items <= 46; items += items < 12 ? 1 : 3) {
      all.push_back(best_streamed_shape(items, room));
      all.push_back(hold_and_stream_shape(items, room));
      const std::uint64_t n = room - 1;
      for (std::uint64_t rounds = 0; rounds <= 3; ++rounds) {
        const std::uint64_t rest = items - std::min(items, rounds * n);
        if (rest < 2 * n + 1 || items <= room) {
          continue;
        }
        StreamedShape shape{.items = items, .room = room, .rounds = rounds};
        shape.c = (rest - 1) / (2 * n);
        shape.w = (rest - 1) % (2 * n);
        if (shape.w <= n) {
          std::uint64_t loads = 0;
          for (std::uint64_t r = 0; r < rounds; ++r) {
            loads += items - r * n - (r == 0 ? 0 : 1);
          }
          loads += (rounds == 0 ? room : n) + shape.c * (2 * shape.c * n + 1) - 1 +
                   2 * shape.c * shape.w + shape.w;
          shape.loads = loads;
          all.push_back(shape);
        }
      }
    }
  }
  return all;
}

TEST(StreamedOrders, CanBeReadFromAnyStep) {
  for (const StreamedShape& shape : shapes()) {
    const auto reader = streamed_steps(shape);
    const std::vector<Step> all = all_steps(*reader);
    ASSERT_EQ(all.size(), shape.steps());
    std::set<Element> memory;
    for (const Step& step : all) {
      const auto from = streamed_steps(shape);
      std::vector<Element> held;
      ASSERT_TRUE(from->jump(step.number, held));
      EXPECT_EQ(std::set<Element>(held.begin(), held.end()), memory)
          << shape.items << " " << shape.room << " rounds " << shape.rounds << " c " << shape.c
          << " w " << shape.w << " step " << step.number;
      EXPECT_EQ(held.size(), memory.size());
      Step next;
      for (std::size_t i = step.number - 1; i < std::min<std::size_t>(all.size(), step.number + 2);
           ++i) {
        ASSERT_TRUE(from->next(next));
        EXPECT_EQ(next, all[i]);
      }
      for (const Element x : step.evict) {
        memory.erase(x);
      }
      memory.insert(step.load.begin(), step.load.end());
    }
    std::vector<Element> held;
    EXPECT_FALSE(streamed_steps(shape)->jump(all.size() + 1, held));
  }
}

TEST(StreamedOrders, ItIsKnownWhoMeetsForTheFirstTime) {
  for (const StreamedShape& shape : shapes()) {
    const StreamedPairs pairs(shape);
    const auto reader = streamed_steps(shape);
    std::set<Element> memory;
    std::set<Element> loaded;
    std::set<ItemPair> met;
    for (Step step; reader->next(step);) {
      for (const Element x : step.evict) {
        memory.erase(x);
      }
      for (const Element x : step.load) {
        EXPECT_EQ(pairs.first_load(x) == step.number, loaded.insert(x).second);
        for (const Element y : memory) {
          const bool is_new = met.emplace(std::min(x, y), std::max(x, y)).second;
          EXPECT_EQ(pairs.meet_first(step.number, x, y), is_new)
              << shape.items << " " << shape.room << " rounds " << shape.rounds << " c " << shape.c
              << " w " << shape.w << " step " << step.number << ": " << x << " " << y;
        }
        memory.insert(x);
      }
      EXPECT_EQ(pairs.met_after(step.number), met.size())
          << shape.items << " " << shape.room << " rounds " << shape.rounds << " c " << shape.c
          << " w " << shape.w << " step " << step.number;
    }
  }
}

TEST(StreamedOrders, StreamFromLoadsWhatIsThere) {
  const LoadOrder order = plan_load_order(200'000, 100);
  const std::uint64_t step = order.facts().steps / 2;
  const auto from = order.stream_from(step);
  Step first;
  ASSERT_TRUE(from->next(first));
  EXPECT_EQ(first.number, step);
  EXPECT_EQ(first.load.size(), 100U);
  EXPECT_TRUE(first.evict.empty());
  Step second;
  ASSERT_TRUE(from->next(second));
  EXPECT_EQ(second.number, step + 1);
  EXPECT_EQ(second.load.size(), 1U);
  EXPECT_THROW(static_cast<void>(order.stream_from(0)), BadInput);
  EXPECT_THROW(static_cast<void>(order.stream_from(order.facts().steps + 1)), BadInput);
  EXPECT_REFUSAL(static_cast<void>(plan_disjoint_order(12, 4, 2).stream_from(1)), BadInput,
                 "an order for workers in lockstep can only be read from its first step");
}

// Whatever the order is made of.
TEST(LoadOrders, StreamFromIsTheRestOfTheOrder) {
  for (const std::uint64_t items : {5U, 9U, 20U, 31U}) {
    for (const std::uint64_t room : {3U, 5U, 8U}) {
      const LoadOrder order = plan_load_order(items, room);
      const auto reader = order.stream();
      const std::vector<Step> all = all_steps(*reader);
      std::set<Element> memory;
      for (const Step& step : all) {
        for (const Element x : step.evict) {
          memory.erase(x);
        }
        memory.insert(step.load.begin(), step.load.end());
        const auto from = order.stream_from(step.number);
        const std::vector<Step> rest = all_steps(*from);
        ASSERT_EQ(rest.size(), all.size() - step.number + 1);
        EXPECT_EQ(std::set<Element>(rest[0].load.begin(), rest[0].load.end()), memory);
        EXPECT_TRUE(std::equal(rest.begin() + 1, rest.end(),
                               all.begin() + static_cast<std::ptrdiff_t>(step.number)));
      }
    }
  }
}

}  // namespace
}  // namespace changeover::test::streamed_pairs_test
