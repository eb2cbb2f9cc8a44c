// Items of different size: every pair within so many bytes; the bound against searches through all
// that can be done; what must be refused; the executor, whose buffers keep to the bytes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <mutex>
#include <random>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/all_pairs.hpp"
#include "changeover/loadorder/load_request.hpp"
#include "loadorder/sizes/closing_search.hpp"
#include "message_of.hpp"
#include "sizes/sizes_support.hpp"

namespace changeover::test::sized_order_test {
namespace {

using ::testing::HasSubstr;

TEST(SizedOrder, EveryPairMeetsWithinTheMemory) {
  std::mt19937 random(1);
  for (int round = 0; round < 8; ++round) {
    const auto items = static_cast<std::size_t>(6 + random() % 37);
    std::vector<std::uint64_t> bytes;
    std::uint64_t largest = 0;
    for (std::size_t i = 0; i < items; ++i) {
      bytes.push_back(1 + random() % (round % 3 == 0 ? 3 : 50));
      largest = std::max(largest, bytes.back());
    }
    const auto sizes = sizes_of(bytes, 2 * largest + random() % (4 * largest));
    std::vector<WantedPairs> wanted{WantedPairs()};
    wanted.push_back(WantedPairs::between(1, items - 1));
    wanted.push_back(WantedPairs::beyond(1, items));
    wanted.push_back(listed(items, random_pairs(static_cast<Element>(items), 2 * items,
                                                static_cast<std::uint64_t>(round))));
    for (const WantedPairs& pairs : wanted) {
      const LoadOrder order = plan_sized_order(sizes, pairs);
      const auto [loaded, fault] = play(*order.stream(), *sizes, pairs);
      EXPECT_EQ(fault, "");
      EXPECT_EQ(loaded, order.facts().bytes);
      EXPECT_GE(loaded, order.facts().byte_bound.loads);
      EXPECT_LE(order.facts().most_bytes, sizes->memory);
      EXPECT_LE(order.facts().most_in_memory, order.facts().room);
      EXPECT_GE(order.facts().loads, order.facts().bound.loads);
      const LoadOrder again = repeat_order(LoadOrder(order.facts(), order.maker()), 3);
      EXPECT_GE(again.facts().bytes, again.facts().byte_bound.loads);
      EXPECT_LE(again.facts().most_bytes, sizes->memory);
    }
  }
}

TEST(SizedOrder, NoOrderOfFewItemsIsBelowTheBound) {
  std::mt19937 random(2);
  int reached = 0;
  for (int round = 0; round < 60; ++round) {
    const std::size_t items = 3 + random() % 3;
    const auto sizes = random_sizes(random, items, round % 2 == 0 ? 4 : 9, 5);
    std::vector<ItemPair> pairs;
    for (Element y = 1; y < items; ++y) {
      for (Element x = 0; x < y; ++x) {
        if (pairs.empty() || random() % 2 == 0) {
          pairs.emplace_back(x, y);
        }
      }
    }
    const WantedPairs wanted = round % 3 == 0 ? listed(items, pairs) : WantedPairs();
    const std::uint64_t fewest = fewest_bytes(*sizes, wanted);
    const LoadOrder order = plan_sized_order(sizes, wanted);
    EXPECT_LE(order.facts().byte_bound.loads, fewest) << round << order.facts().byte_bound.reason;
    EXPECT_GE(order.facts().bytes, fewest) << round;
    EXPECT_LE(order.facts().bytes, fewest + fewest / 4) << round;
    reached += order.facts().bytes == fewest ? 1 : 0;
  }
  EXPECT_GE(reached, 50);
}

TEST(SizedOrder, ItemsOfOneSizeHaveTheOrdersThatTheyHadWithoutSizes) {
  for (const auto& [items, room] :
       std::vector<std::pair<std::uint64_t, std::uint64_t>>{{8, 4}, {16, 8}, {64, 16}, {30, 6}}) {
    const auto sizes = sizes_of(std::vector<std::uint64_t>(items, 1000), 1000 * room + 999);
    const LoadOrder order = plan_sized_order(sizes, {});
    LoadOrderOptions quick;
    quick.closure_rules = false;
    EXPECT_LE(order.facts().loads, plan_load_order(items, room, quick).facts().loads);
    EXPECT_EQ(order.facts().byte_bound.loads, 1000 * load_lower_bound(items, room).loads);
  }
}

TEST(SizedOrder, WhatIsWrongIsFound) {
  const auto sizes = sizes_of({5, 4, 3, 2, 1, 3, 4}, 11);
  const LoadOrder order = plan_sized_order(sizes, {});
  const ScheduleRules rules = order.rules();
  const auto right = all_steps(*order.stream());
  ASSERT_TRUE(verdict_of(right, rules).valid());
  // A byte less does not hold what it holds.
  ScheduleRules less = rules;
  less.sizes = sizes_of(sizes->bytes, order.facts().most_bytes - 1);
  EXPECT_THAT(verdict_of(right, less).fault, HasSubstr("bytes where"));
  // What is not evicted takes its bytes.
  for (std::size_t i = 0; i < right.size(); ++i) {
    if (!right[i].evict.empty()) {
      std::vector<Step> steps = right;
      steps[i].evict.pop_back();
      EXPECT_FALSE(verdict_of(steps, rules).valid()) << i;
    }
  }
  EXPECT_REFUSAL(ScheduleCheck({.items = 6, .room = 3, .sizes = sizes}), BadInput,
                 "7 sizes of 6 items");
}

TEST(SizedOrder, RefusesWhatDoesNotFit) {
  const auto refusal = [](std::vector<std::uint64_t> bytes, std::uint64_t memory,
                          const WantedPairs& wanted = {}) -> std::string {
    return message_of(
        [&] { static_cast<void>(plan_sized_order(sizes_of(std::move(bytes), memory), wanted)); });
  };
  EXPECT_EQ(refusal({3, 5, 4}, 8),
            "items 1 and 2 have 9 bytes together, more than the 8 of memory; allow more");
  EXPECT_EQ(refusal({3, 5, 4}, 8, listed(3, {{0, 1}, {0, 2}})), "");
  EXPECT_EQ(refusal({3, 6, 4}, 8, listed(3, {{0, 1}, {0, 2}})),
            "items 0 and 1 have 9 bytes together, more than the 8 of memory; allow more");
  EXPECT_EQ(refusal({9}, 8), "item 0 has 9 bytes, more than the 8 of memory; allow more");
  EXPECT_NE(refusal({}, 8), "");
  EXPECT_EQ(refusal({1, 0, 2}, 8), "item 1 has no size; give at least 1 byte");
}

TEST(SizedOrder, IsReadFromRequests) {
  const auto facts = [](const std::string& json) -> std::string {
    try {
      const CheckedLoads asked = checked_loads(load_request(json), Door::document);
      return fmt::format("{}", fmt::join(asked.sizes()->bytes, " "));
    } catch (const Error& fault) {
      return fault.what();
    }
  };
  EXPECT_EQ(facts(R"({"sizes":[[1,5],[0,"2K"]],"memory":3000})"), "2000 5");
  EXPECT_EQ(facts(R"({"sizes":{"text":"item,bytes\n0,7\n1,8\n"},"memory":30})"), "7 8");
  EXPECT_EQ(facts(R"({"sizes":{"text":"7\n8\n9\n"},"memory":30})"), "7 8 9");
  EXPECT_EQ(facts(R"({"sizes":{"text":"b 7\na 8\n"},"memory":30})"), "7 8");
  EXPECT_EQ(facts(R"({"pairs":[["a","b"]],"sizes":{"text":"b 7\na 8\n"},"memory":30})"), "8 7");
  EXPECT_THAT(facts(R"({"pairs":[["a","b"]],"sizes":{"text":"b 7\n"},"memory":30})"),
              HasSubstr("item a has no size"));
  EXPECT_THAT(facts(R"({"pairs":[["a","b"]],"sizes":{"text":"b 7\nc 8\n"},"memory":30})"),
              HasSubstr("'c' is not in the listed pairs"));
  EXPECT_THAT(facts(R"({"sizes":[[0,5],[2,2]],"memory":30})"), HasSubstr("item 1 has no size"));
  EXPECT_THAT(facts(R"({"items":2,"sizes":[[0,5],[2,2]],"memory":30})"),
              HasSubstr("items are 0 to 1"));
  EXPECT_THAT(facts(R"({"sizes":{"text":"0 5\n0 6\n"},"memory":30})"), HasSubstr("already"));
  EXPECT_THAT(facts(R"({"sizes":{"text":"0 5\n1 -6\n"},"memory":30})"), HasSubstr(":2:3: '-6'"));
  EXPECT_THAT(facts(R"({"sizes":{"text":"0 5\n1 6 7\n"},"memory":30})"),
              HasSubstr("rows have different forms"));
  EXPECT_THAT(facts(R"({"sizes":[[0,5],[1,2]]})"), HasSubstr("memory"));
  EXPECT_THAT(facts(R"({"items":3,"room":2,"memory":30})"), HasSubstr("sizes"));
  EXPECT_THAT(facts(R"({"room":2,"sizes":[[0,5],[1,2]],"memory":30})"), HasSubstr("room"));
  // Which item is too large has its place.
  const auto refusal = [](const std::string& json, const std::string& name) {
    return message_of(
        [&] { static_cast<void>(checked_loads(load_request(json, name), Door::document)); });
  };
  EXPECT_EQ(refusal("{\"memory\":30,\n \"sizes\":[[0,5],\n[1,26]]}", "job.json"),
            "job.json:3:1: sizes[1]: items 1 and 0 have 31 bytes together, more than the 30 of "
            "memory; allow more");
  EXPECT_EQ(
      refusal(R"({"memory":30,"sizes":{"text":"item,bytes\n0,31\n"}})", "job.json"),
      "job.json:1:22: sizes:2:3: item 0 has 31 bytes, more than the 30 of memory; allow more");
  EXPECT_EQ(refusal(R"({"memory":30,"pairs":[["a","b"]],"sizes":{"text":"b 7\na 28\n"}})", ""),
            "sizes:2:3: items a and b have 35 bytes together, more than the 30 of memory; allow "
            "more");
}

TEST(SizedOrder, ListsOfSizesLoseNoRow) {
  const auto read = [](const std::string& text) -> std::string {
    try {
      const CheckedLoads asked = checked_loads(
          load_request(fmt::format(R"({{"sizes":{{"text":"{}"}},"memory":30}})", text)),
          Door::document);
      return fmt::format("{}", fmt::join(asked.sizes()->bytes, " "));
    } catch (const Error& fault) {
      return fault.what();
    }
  };
  // What is meant as a size is no heading.
  for (const std::string word : {"NaN", "nan", "inf", "-inf", "Infinity", "-3", "1e400", "0", "NA",
                                 "none", "null", "-", "?", "-.5", "+4"}) {
    EXPECT_THAT(read(fmt::format("a {}\\nb 3\\nc 4\\n", word)), HasSubstr(":1:3: '" + word + "'"));
    EXPECT_THAT(read(fmt::format("0 {}\\n1 3\\n", word)), HasSubstr(":1:3: '" + word + "'"));
    EXPECT_THAT(read(word + "\\n3\\n4\\n"), HasSubstr(":1:1: '" + word + "'"));
  }
  EXPECT_THAT(read("0 bytes\\n1 3\\n"), HasSubstr(":1:3: 'bytes'"));
  for (const std::string heading : {"item bytes", "name information", "name,größe", "nano,infer"}) {
    EXPECT_EQ(read(heading + "\\na 3\\nb 4\\n"), "3 4");
  }
  EXPECT_EQ(read("size\\n3\\n4\\n"), "3 4");
  // Without a row, too, it is said which list.
  EXPECT_THAT(read(""), HasSubstr(": no size is listed; give"));
  EXPECT_THAT(read("item bytes\\n"), HasSubstr(": no size is listed; give"));
  EXPECT_THAT(read("0 3\\n2 4\\n"), HasSubstr(": item 1 has no size"));
  // Names are those of other lists.
  EXPECT_THAT(read("a 3\\na\\u200b 4\\n"), HasSubstr(":2:1: the name 'a\u200b' has a char"));
  EXPECT_EQ(read("a 3\\nb|c 4\\n"), "3 4");
  EXPECT_THAT(read(std::string(256, 'a') + " 3\\nb 4\\n"), HasSubstr("more than 255 bytes"));
  EXPECT_THAT(read("0 3\\n01 4\\n"), HasSubstr(":2:1: '01' is not written like"));
  EXPECT_THAT(read("a 3\\n1 3\\n01 4\\n"), HasSubstr(":3:1: '1' and '01' are one number"));
}

TEST(SizedOrder, TheExecutorHoldsNoMoreThanTheMemory) {
  const std::vector<std::uint64_t> bytes{50'000, 9'000,  20'000, 33'000, 4'000,  8'000,
                                         41'000, 27'000, 3'000,  60'000, 10'000, 15'000};
  const auto sizes = sizes_of(bytes, 130'000);
  const LoadOrder order = plan_sized_order(sizes, {});
  CallbackItems items(bytes.size(), 60'000, [&](Element x, std::span<std::byte> buffer) {
    EXPECT_GE(buffer.size(), bytes[x]);
    EXPECT_LT(buffer.size(), bytes[x] + buffer_alignment);
    std::fill_n(buffer.begin(), bytes[x], static_cast<std::byte>(x));
    return static_cast<std::size_t>(bytes[x]);
  });
  std::mutex mutex;
  std::set<ItemPair> pairs;
  const AllPairsReport report = all_pairs(items, order, [&](const PairWork& pair) {
    EXPECT_EQ(pair.first.bytes.size(), bytes[pair.first.item]);
    EXPECT_EQ(pair.second.bytes.back(), static_cast<std::byte>(pair.second.item));
    const std::scoped_lock lock(mutex);
    EXPECT_TRUE(pairs.emplace(pair.first.item, pair.second.item).second);
  });
  EXPECT_TRUE(report.finished);
  EXPECT_EQ(pairs.size(), 66U + 12U);
  EXPECT_EQ(report.bytes_read, order.facts().bytes);
  EXPECT_LE(report.most_in_memory, order.facts().room);
  const PairCompute nothing = [](const PairWork&) {};
  EXPECT_REFUSAL(static_cast<void>(all_pairs(items, order, nothing, {.read_ahead = 1})), BadInput,
                 "items have sizes, and memory is for all that is loaded: give no read_ahead");
  // Shares, cut here or planned.
  const WorkerSplit split = split_sized_order(sizes, {}, 3);
  for (const bool planned : {false, true}) {
    pairs.clear();
    std::uint64_t read = 0;
    for (std::uint64_t w = 0; w < 3; ++w) {
      const auto compute = [&](const PairWork& pair) {
        const std::scoped_lock lock(mutex);
        EXPECT_TRUE(pairs.emplace(pair.first.item, pair.second.item).second);
      };
      const AllPairsOptions share{.share = {w, 3}};
      const AllPairsReport its = planned ? all_pairs(items, split, compute, share)
                                         : all_pairs(items, order, compute, share);
      EXPECT_TRUE(its.finished);
      EXPECT_LE(its.buffer_bytes, sizes->memory + buffer_alignment * order.facts().room);
      read += its.bytes_read;
    }
    EXPECT_EQ(pairs.size(), 66U + 12U);
    EXPECT_TRUE(!planned || read == split.facts().bytes);
  }
}

TEST(SizedOrder, MovesOfGroupsOneByOneEvictWhatEachLoadNeeds) {
  const std::vector<Move> moves{{{}, {0, 1}}, {{0, 1}, {2, 3}}};
  const std::vector<Move> steps = in_steps(one_by_one(moves, {{3, 1, 2, 2}, 4}));
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_EQ(steps[0].load, (std::vector<Element>{0, 1}));
  EXPECT_EQ(steps[1].load, std::vector<Element>{2});
  EXPECT_EQ(steps[1].evict, std::vector<Element>{0});
  EXPECT_EQ(steps[2].load, std::vector<Element>{3});
  EXPECT_EQ(steps[2].evict, std::vector<Element>{1});
}

}  // namespace
}  // namespace changeover::test::sized_order_test
