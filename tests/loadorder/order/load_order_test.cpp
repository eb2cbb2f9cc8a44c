// Load orders against a simulation with sets, for all small parameters.
#include "changeover/loadorder/load_order.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "loadorder_support.hpp"
#include "message_of.hpp"

namespace changeover::test::load_order_test {
namespace {

TEST(LoadOrder, BringsEveryPairTogetherForAllSmallItemsAndRoom) {
  LoadOrderOptions without_rules;
  without_rules.read_up_to = 0;  // only the simulation reads it
  for (std::uint64_t room = 2; room <= 12; ++room) {
    for (std::uint64_t items = 1; items <= 40; ++items) {
      LoadOrder order = plan_load_order(items, room, without_rules);
      const Simulation simulation = simulate(order, items, room);
      EXPECT_EQ(simulation.fault, "") << items << " " << room;
      EXPECT_EQ(simulation.missing(), 0U) << items << " " << room;
      EXPECT_EQ(simulation.loads, order.facts().loads) << items << " " << room;
      EXPECT_EQ(simulation.steps, order.facts().steps) << items << " " << room;
      EXPECT_GE(simulation.loads, order.facts().bound.loads) << items << " " << room;
    }
  }
}

TEST(LoadOrder, FromConstructionsIsNeverWorseThanTheStreamedOne) {
  LoadOrderOptions streamed;
  streamed.constructions = false;
  for (std::uint64_t room : {2U, 3U, 5U, 8U, 12U}) {
    for (std::uint64_t items = 1; items <= 40; items += 3) {
      LoadOrder order = plan_load_order(items, room);
      const Simulation simulation = simulate(order, items, room);
      EXPECT_EQ(simulation.fault, "") << items << " " << room;
      EXPECT_EQ(simulation.missing(), 0U) << items << " " << room;
      EXPECT_EQ(simulation.loads, order.facts().loads);
      EXPECT_EQ(simulation.steps, order.facts().steps);
      EXPECT_LE(order.facts().loads, plan_load_order(items, room, streamed).facts().loads);
      EXPECT_TRUE(order.facts().every_step_read);
    }
  }
}

TEST(LoadOrder, StreamsWindowsRightForMoreItems) {
  LoadOrderOptions streamed;
  streamed.constructions = false;
  for (const std::uint64_t room : {2U, 3U, 4U, 9U, 16U, 31U}) {
    for (std::uint64_t items = 41; items <= 260; items += 7) {
      LoadOrder order = plan_load_order(items, room, streamed);  // read by the library's check
      Step step;
      std::uint64_t loads = 0;
      std::uint64_t steps = 0;
      while (order.next(step)) {
        loads += step.load.size();
        ++steps;
        EXPECT_TRUE(steps == 1 || step.load.size() == 1);
      }
      EXPECT_EQ(loads, order.facts().loads);
      EXPECT_EQ(steps, order.facts().steps);
      EXPECT_TRUE(order.facts().every_step_read);
    }
  }
}

TEST(LoadOrder, ReachesWhatIsKnownOnTheGridOfMarius) {
  struct Cell {
    std::uint64_t items, room, blocks;
  };
  for (const Cell& cell : {Cell{8, 4, 9}, Cell{12, 4, 21}, Cell{15, 4, 34}, Cell{16, 4, 39},
                           Cell{16, 8, 17}, Cell{20, 5, 49}, Cell{26, 6, 67}, Cell{32, 4, 165},
                           Cell{32, 8, 73}, Cell{32, 16, 33}, Cell{64, 8, 291}, Cell{64, 16, 137},
                           Cell{64, 32, 65}, Cell{1000, 100, 5054}, Cell{2000, 100, 20'209}}) {
    EXPECT_LE(plan_load_order(cell.items, cell.room).facts().loads, cell.blocks + cell.room - 1)
        << cell.items << " " << cell.room;
  }
}

TEST(LoadOrder, LoadsEverythingAtOnceWhenItFits) {
  LoadOrder order = plan_load_order(5, 9);
  EXPECT_EQ(order.facts().loads, 5U);
  EXPECT_EQ(order.facts().steps, 1U);
  EXPECT_EQ(order.facts().bound.loads, 5U);
  EXPECT_EQ(order.facts().gap(), 0);
  Step step;
  ASSERT_TRUE(order.next(step));
  EXPECT_EQ(step, (Step{1, {}, {0, 1, 2, 3, 4}}));
  EXPECT_FALSE(order.next(step));
  EXPECT_EQ(plan_load_order(1, 2).facts().loads, 1U);
}

TEST(LoadOrder, OfAMillionItemsStartsAtOnceAndIsAuditedOnTheWay) {
  for (const std::uint64_t room : {2U, 10U, 1000U, 999'999U}) {
    LoadOrder order = plan_load_order(1'000'000, room);
    EXPECT_FALSE(order.facts().every_step_read);
    EXPECT_NE(order.facts().certificate.find("structure"), std::string::npos);
    CheckOptions watch;
    watch.all_pairs = false;
    ScheduleCheck check({.items = 1'000'000, .room = room}, watch);
    Step step;
    for (int i = 0; i < 1000 && order.next(step); ++i) {
      check.read(step);
    }
    EXPECT_EQ(check.finish().fault, "");
    EXPECT_GE(order.facts().loads, order.facts().bound.loads);
    // Within a thousandth of the bound, but for hardly any room to change.
    EXPECT_LT(order.facts().gap(), 0.001);
  }
}

TEST(LoadOrder, TooLargeToKeepPairsInMindStillBringsAllOfAFewItemsTogether) {
  LoadOrder order = plan_load_order(70'000, 30'000);
  EXPECT_FALSE(order.facts().every_step_read);
  CheckOptions watch;
  watch.all_pairs = false;
  ScheduleCheck check({.items = 70'000, .room = 30'000}, watch);
  Step step;
  while (order.next(step)) {
    check.read(step);
  }
  const ScheduleVerdict verdict = check.finish();
  EXPECT_TRUE(verdict.valid()) << verdict.fault << verdict.example;
  EXPECT_EQ(verdict.loads, order.facts().loads);
}

TEST(LoadOrder, TakesAnImprovedDesignOnlyIfItIsBetterAndRight) {
  const auto no_constructions = [](LoadOrderOptions options) {
    options.constructions = false;
    return options;
  };
  int asked = 0;
  LoadOrderOptions options;
  options.improve = [&](const Design& start, std::uint64_t least) -> std::optional<Design> {
    ++asked;
    EXPECT_EQ(start.parameters(), (Parameters{.v = 20, .k = 5, .change = 1}));
    EXPECT_EQ(least, 46U);
    return std::nullopt;
  };
  EXPECT_EQ(plan_load_order(20, 5, no_constructions(options)).facts().loads, 53U);
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(plan_load_order(9, 4, options).facts().gap(), 0);  // minimum already
  EXPECT_EQ(asked, 1);

  // A tight SCCD(12,4), given as if a search had found it, is taken before the streamed order.
  const Design tight = Registry::standard().build_design(
      Registry::standard().best({.v = 12, .k = 4, .change = 1})->recipe);
  options.improve = [&](const Design&, std::uint64_t) { return std::optional<Design>(tight); };
  LoadOrder order = plan_load_order(12, 4, no_constructions(options));
  EXPECT_EQ(order.facts().method, "improved");
  EXPECT_EQ(order.facts().loads, 24U);

  // One that lacks its last block is not let out.
  options.improve = [&](const Design&, std::uint64_t) {
    Design broken(tight.parameters());
    for (std::size_t i = 0; i + 1 < tight.block_count(); ++i) {
      broken.append(tight.block(i));
    }
    return std::optional<Design>(broken);
  };
  EXPECT_THROW(static_cast<void>(plan_load_order(12, 4, no_constructions(options))), InternalError);
}

TEST(LoadOrder, RefusesWhatHasNoOrder) {
  EXPECT_REFUSAL(static_cast<void>(plan_load_order(0, 4)), BadInput,
                 "a load order of 0 items: give at least 1 item");
  EXPECT_THROW(static_cast<void>(plan_load_order(9, 1)), BadInput);
  EXPECT_THROW(static_cast<void>(plan_load_order(9, 0)), BadInput);
  EXPECT_REFUSAL(static_cast<void>(plan_load_order(1'000'000'000, 4)), ImpossibleParameters,
                 "items: a load order has at most");
}

TEST(LoadOrder, OfADesignLoadsWhatBlocksIntroduce) {
  auto design =
      std::make_shared<Design>(Parameters{.v = 6, .k = 4, .change = 2},
                               std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 1}});
  LoadOrder order = load_order_of(design, "mine", "by hand");
  EXPECT_EQ(order.facts().loads, 8U);
  const Simulation simulation = simulate(order, 6, 4);
  EXPECT_EQ(simulation.fault, "");
  EXPECT_EQ(simulation.missing(), 0U);
  design->set_kind(Kind::circular);
  EXPECT_REFUSAL(static_cast<void>(load_order_of(design, "", "")), BadInput,
                 "a load order needs a linear design with at least one block");
}

// The bound is reached by exhaustive minima and never passed: it holds for steps that load several
// too.
TEST(LoadOrder, BoundIsThatOfSingleChangeDesigns) {
  EXPECT_EQ(load_lower_bound(12, 4).loads, 24U);
  EXPECT_EQ(load_lower_bound(20, 5).loads, 50U);
  EXPECT_EQ(load_lower_bound(1000, 100).loads, 5096U);
  EXPECT_EQ(load_lower_bound(3, 9).loads, 3U);
}

}  // namespace
}  // namespace changeover::test::load_order_test
