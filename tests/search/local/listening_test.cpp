// Every search holds its limits of time and memory, also where the parameters are large, and loses
// nothing by it.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "changeover/search/base_block_search.hpp"
#include "changeover/search/local_search.hpp"
#include "changeover/verify/verdict.hpp"
#include "run/random.hpp"
#include "search/local/random_list.hpp"
#include "search/local/segment_orbits.hpp"
#include "search/local/segment_pairs.hpp"
#include "search/local/segment_subsets.hpp"
#include "search/symmetric/base_block_sat.hpp"

namespace changeover::listening_test {
namespace {

using Seconds = std::chrono::duration<double>;

// Generous: machines are busy. Without listening these take a minute and more.
constexpr Seconds soon{60};

std::vector<Block> random_blocks(const Parameters& p, std::size_t count) {
  Random random(5);
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < count; ++i) {
    blocks.push_back(random_block(p, random));
  }
  return blocks;
}

TEST(Listening, LocalSearchStopsWhileItMakesItsFirstDesign) {
  RunControl control({.time = Seconds(0.1), .threads = 2});
  const ImproveResult result = improve({.v = 240, .k = 6, .strength = 4}, {}, control);
  EXPECT_LT(control.elapsed(), soon);
  EXPECT_FALSE(result.design.has_value());
  EXPECT_EQ(result.why_stopped, WhyStopped::time_limit);
}

TEST(Listening, WhatIsKnownIsHandedOutEvenWithoutAnyTime) {
  RunControl control({.time = Seconds(0)});
  const ImproveResult result = improve({.v = 130, .k = 6}, {}, control);
  ASSERT_TRUE(result.design.has_value());
  EXPECT_TRUE(verify(*result.design).valid());
  EXPECT_EQ(result.why_stopped, WhyStopped::time_limit);
}

TEST(Listening, LocalSearchStopsAmongExpensiveMoves) {
  // A move changes some C(99,3) counters in each of several blocks.
  const Parameters p{.v = 110, .k = 100, .strength = 4};
  Random random(1);
  const Design list = *random_list(p, 6, random);
  RunControl control({.time = Seconds(0.1)});
  const RepairResult result = repair(list, {.moves = std::uint64_t{1} << 40}, control);
  EXPECT_LT(control.elapsed(), soon);
  EXPECT_TRUE(!result.design || verify(*result.design).valid());
}

TEST(Listening, WithoutMemoryForTheSearchTheKnownDesignIsHandedOut) {
  RunControl control({.memory_bytes = 60'000});
  const ImproveResult result = improve({.v = 130, .k = 6}, {.moves = 100'000}, control);
  EXPECT_TRUE(verify(result.design.value()).valid());
  EXPECT_EQ(result.moves, 0U);
  EXPECT_NE(result.unsearched.find("memory"), std::string::npos) << result.unsearched;
  EXPECT_EQ(result.unsearched.find('\n'), std::string::npos);
}

TEST(Listening, WithLittleMemoryOnlySmallAttemptsAreMade) {
  RunControl control({.memory_bytes = 200'000});
  const ImproveResult result = improve({.v = 130, .k = 6}, {.moves = 100'000}, control);
  EXPECT_TRUE(verify(result.design.value()).valid());
  EXPECT_GT(result.moves, 0U);
  EXPECT_EQ(result.unsearched, "");
}

TEST(Listening, BeyondTheReachOfLocalSearchTheKnownDesignIsHandedOut) {
  RunControl control({});
  const ImproveResult result = improve({.v = 4200, .k = 600}, {}, control);
  EXPECT_TRUE(verify(result.design.value()).valid());
  EXPECT_EQ(result.moves, 0U);
  EXPECT_NE(result.unsearched.find("4096"), std::string::npos) << result.unsearched;
}

TEST(Listening, StatesNeedNoMoreMemoryThanTheySay) {
  // An order of magnitude is what the limits are for.
  EXPECT_GT(SegmentPairs<std::uint8_t>::bytes(4000, 4, 1'600'000), 6'400'000'000U);
  EXPECT_LT(SegmentPairs<std::uint8_t>::bytes(4000, 4, 1'600'000), 7'500'000'000U);
  EXPECT_GT(SegmentSubsets::bytes({.v = 120, .k = 6, .strength = 4}, 1000), 100'000'000U);
  EXPECT_GT(SegmentOrbits::bytes({.v = 4000, .k = 4, .kind = Kind::circular}, {2, 2000}, 800'000),
            3'200'000'000U);
  EXPECT_THROW(static_cast<void>(SegmentOrbits::bytes({.v = 4000, .k = 4}, {2, 2000},
                                                      std::numeric_limits<std::uint64_t>::max())),
               ImpossibleParameters);
}

TEST(Listening, RepairAndExtendStopWhereCoveringTakesLong) {
  const Parameters p{.v = 20'000, .k = 4};
  Random random(1);
  const Design list = *random_list(p, 3, random);
  RunControl first({.time = Seconds(0.1), .memory_bytes = 1'000'000'000});
  EXPECT_FALSE(repair(list, {}, first).design.has_value());
  EXPECT_LT(first.elapsed(), soon);
  RunControl second({.time = Seconds(0.1), .memory_bytes = 1'000'000'000});
  EXPECT_FALSE(extend(list, {}, second).design.has_value());
  EXPECT_LT(second.elapsed(), soon);
  RunControl little({.memory_bytes = 1'000'000});
  EXPECT_THROW(static_cast<void>(repair(list, {}, little)), MissingResource);
}

TEST(Listening, WithoutMemoryToAnnealAListIsCompletedOneByOne) {
  const Parameters p{.v = 60, .k = 5};
  Random random(1);
  const Design list = *random_list(p, 10, random);
  RunControl first({.memory_bytes = 10'000});
  const RepairResult repaired = repair(list, {}, first);
  EXPECT_TRUE(verify(repaired.design.value()).valid());
  EXPECT_NE(repaired.unsearched.find("memory"), std::string::npos);
  RunControl second({.memory_bytes = 10'000});
  const ExtendResult extended = extend(list, {}, second);
  EXPECT_TRUE(verify(extended.design.value()).valid());
  EXPECT_NE(extended.unsearched.find("memory"), std::string::npos);
}

TEST(Listening, OrdersOfManyBlocksStop) {
  const Parameters p{.v = 40, .k = 6};
  const std::vector<Block> blocks = random_blocks(p, 30'000);
  RunControl first({.time = Seconds(0.2)});
  const LeastChangeOrder least = order_for_least_change(blocks, {.v = p.v}, {}, first);
  EXPECT_LT(first.elapsed(), soon);
  EXPECT_LE(least.cost, least.first_cost);
  EXPECT_EQ(change_cost(blocks, least.order, {.v = p.v}), least.cost);
  EXPECT_EQ(least.why_stopped, WhyStopped::time_limit);
  RunControl second({.time = Seconds(0.1)});
  const ChangeOrder change = order_for_change(blocks, {.v = p.v, .m = 2}, {}, second);
  EXPECT_LT(second.elapsed(), soon);
  EXPECT_EQ(change.outcome, Outcome::unknown);
}

TEST(Listening, BaseBlockSearchStops) {
  RunControl control({.time = Seconds(0.2)});
  const BaseBlockResult result =
      search_base_blocks({.v = 1999, .k = 5, .kind = Kind::circular}, {}, control);
  EXPECT_LT(control.elapsed(), soon);
  EXPECT_TRUE(result.found() || result.why_stopped == WhyStopped::time_limit);
}

TEST(Listening, FormulasForBaseBlocksAreCountedBeforeTheyAreBuilt) {
  const Parameters p{.v = 1999, .k = 4, .kind = Kind::circular};
  RunControl control({.memory_bytes = 1'000'000'000});
  EXPECT_THROW(static_cast<void>(base_blocks_by_sat(p, {{1999, 1, 0}, 200}, true, 1000, control)),
               MissingResource);
  BaseBlockOptions options;
  options.method = BaseBlockMethod::sat;
  RunControl again({.memory_bytes = 1'000'000});
  EXPECT_THROW(static_cast<void>(search_base_blocks(p, options, again)), MissingResource);
}

TEST(Listening, WhatACallbackThrowsArrivesAfterTheSolver) {
  RunControl control(
      {.on_progress = [](const Progress&) { throw std::runtime_error("the callback"); },
       .progress_interval = Seconds(0)});
  try {
    static_cast<void>(base_blocks_by_sat({.v = 28, .k = 6, .kind = Kind::circular}, {{7, 4, 0}, 6},
                                         true, 100'000, control));
    ADD_FAILURE() << "nothing arrived";
  } catch (const std::runtime_error& fault) {
    EXPECT_STREQ(fault.what(), "the callback");
  }
}

TEST(Listening, ShapesTakeAnyNumber) {
  const Parameters p{.v = 10, .k = 4, .kind = Kind::circular};
  constexpr std::uint64_t half = std::uint64_t{1} << 63;
  for (const std::uint64_t number :
       {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1} << 31, std::uint64_t{1} << 32,
        half - 1, half, half + 1, std::numeric_limits<std::uint64_t>::max() - 1,
        std::numeric_limits<std::uint64_t>::max()}) {
    for (const bool tight : {false, true}) {
      for (const ShapeOptions& options : {ShapeOptions{.n = number, .tight = tight},
                                          ShapeOptions{.fixed = number, .tight = tight},
                                          ShapeOptions{.base_blocks = number, .tight = tight},
                                          ShapeOptions{.tight = tight, .most_blocks = number}}) {
        for (const BaseBlockShape& shape : base_block_shapes(p, options)) {
          EXPECT_EQ(shape.v(), p.v);
          EXPECT_GE(shape.b(), shape.base_blocks);
        }
      }
    }
  }
}

}  // namespace
}  // namespace changeover::listening_test
