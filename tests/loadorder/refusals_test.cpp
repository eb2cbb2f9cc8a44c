// What callers of the library are told, and no request reaches: requests are checked before.
#include <gmock/gmock.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/all_pairs.hpp"
#include "changeover/loadorder/changeover_loadorder.h"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/schedule.hpp"
#include "changeover/loadorder/workers.hpp"
#include "loadorder/run/earlier_shares.hpp"
#include "loadorder/shares/split_maker.hpp"
#include "loadorder_support.hpp"
#include "message_of.hpp"
#include "run_program.hpp"

namespace changeover::test::refusals_test {
namespace {

using ::testing::HasSubstr;

TEST(Refusals, SayWhatIsWrongWithACall) {
  TemporaryFolder folder;
  spit(folder.file("data"), std::string(24, 'x'));
  spit(folder.file("old"), "changeover journal 2: shares x; share y\n");
  const auto nothing = [](const auto&) {};
  const auto graph = [](std::uint64_t items) { return PairGraph(items, std::vector<ItemPair>{}); };
  struct Case {
    std::function<void()> call;
    std::string words;
  };
  for (
      const auto& [call, words] : std::vector<Case>{
          {[&] { (void)graph(10'000'001); },
           "10000001 items: at most 10000000; group items into larger ones"},
          {[] { (void)plan_load_order(WantedPairs::between(6'000'000, 6'000'000), 4); },
           "that is 12000000 items together, and 10000000 is the most; take fewer"},
          {[] { (void)split_order(plan_load_order(9, 4), 8, 4, 2); },
           "8 items cannot be put into 9 groups; give no more groups than items"},
          {[] { (void)repeat_shares(repeat_shares(split_load_order(9, 4, 2), 2), 2); },
           "shares of several epochs are not repeated; give those of one epoch"},
          {[] { (void)repeat_order(repeat_order(plan_load_order(9, 4), 2), 2); },
           "an order of several epochs is not repeated; give that of one epoch"},
          {[&] {
             CallbackItems items(9, 1, [](Element, std::span<std::byte>) { return 1; });
             (void)all_pairs(items, repeat_order(plan_load_order(9, 4), 2), nothing);
           },
           "all_pairs() computes each pair once: give an order of one epoch, or take "
           "update_pairs()"},
          {[&] {
             CallbackItems items(9, 1, [](Element, std::span<std::byte>) { return 1; });
             (void)all_pairs(items, split_load_order(9, 4, 2), nothing,
                             {.share = {.index = 0, .of = 2}, .earlier = {"journal"}});
           },
           "shares that were planned cannot use journals of an earlier run; give the order instead"},
          {[] { (void)EarlierShares({"journal"}, {}, plan_load_order(5001, 100)); },
           "a job of 5001 items goes on with as many shares as before; of at most 5000 items their "
           "number may change"},
          {[] { (void)plan_disjoint_order(70'000, 4, 2); },
           "70000 items: disjoint workers have at most 65535; group items into larger ones"},
          {[] { (void)plan_two_levels(70'000, 4, 2); },
           "70000 items: two levels have at most 65535; group items into larger ones"},
          {[&] { (void)EarlierShares({folder.file("old")}, {}, plan_load_order(9, 4)); },
           ": is the journal of another version; name the journals of this job"},
          {[&] { (void)update_pairs(plan_disjoint_order(8194, 2, 4097), nothing, {}); },
           "4097 workers: a job has at most 4096"},
          {[&] {
             const auto sizes = std::make_shared<const ItemSizes>(ItemSizes{{1, 2, 3}, 5});
             (void)update_pairs(plan_disjoint_order(sizes, 3, 1), nothing, {});
           },
           "items that change have one size, item_bytes; give an order without sizes"},
          {[] {
             WorkerSplit split = split_load_order(5001, 100, 2);
             SplitMaker::spread(split, [](Element, Element) { return false; });
           },
           "too many items for a part of their pairs to be left out"},
          {[&] {
             FileItems items(folder.file("data"), 8);
             std::vector<std::byte> buffer(items.buffer_bytes());
             (void)items.read(3, buffer);
           },
           ": there is no item 3, only 3; plan for these"}}) {
    EXPECT_THAT(message_of<Error>(call), HasSubstr(words));
  }
}

TEST(Refusals, SayWhichStepIsWrong) {
  const ScheduleRules plain{.items = 4, .room = 3};
  ScheduleRules epochs = plain;
  epochs.epochs = 2;
  ScheduleRules accelerator = plain;
  accelerator.fast_room = 2;
  ScheduleRules sizes = plain;
  sizes.sizes = std::make_shared<const ItemSizes>(ItemSizes{{3, 3, 1, 1}, 5});
  ScheduleRules computes = plain;
  computes.compute = ComputeRules{};
  struct Case {
    ScheduleRules rules;
    std::vector<Step> steps;
    std::string words;
  };
  for (const auto& [rules, steps, words] : std::vector<Case>{
           {plain,
            {{.number = 1, .load = {0}, .worker = std::numeric_limits<std::uint64_t>::max()}},
            "is not of one of "},
           {epochs,
            {{.number = 1, .load = {0}, .worker = 1}},
            "is not of worker 0, whose epochs these are"},
           {epochs,
            {{.number = 1, .load = {0}, .epoch = 3}},
            "is of epoch 3 of 2 where epoch 1 is"},
           {plain, {{.number = 2, .load = {0}}}, "step 2 is numbered so where 1 is next"},
           {accelerator,
            {{.number = 1, .load = {0}, .fast_evict = {0}}},
            "takes 0 from the accelerator, where it is not"},
           {plain, {{.number = 1, .load = {0}, .late = 1}}, "evicts 1 item late, of 0"},
           {plain, {{.number = 1, .evict = {0}}}, "evicts 0, which is not in memory"},
           {plain, {{.number = 1, .load = {0, 0}}}, "loads 0, which is in memory"},
           {plain, {{.number = 1, .load = {4}}}, "loads 4, which is not an item"},
           {sizes, {{.number = 1, .load = {0, 1}}}, "loads 1 of 3 bytes where 2 are free"},
           {computes,
            {{.number = 1, .load = {0}, .compute = {{0, 1}}}},
            "computes (0,1), which are not both in memory"}}) {
    EXPECT_THAT(verdict_of(steps, rules).fault, HasSubstr(words));
  }
}

TEST(Refusals, AreKeptForCallersInC) {
  changeover_loadorder* const order = changeover_loadorder_open(9, 4, nullptr, 0);
  ASSERT_NE(order, nullptr);
  EXPECT_EQ(changeover_loadorder_next(order, nullptr), CHANGEOVER_LOADORDER_ERROR);
  EXPECT_STREQ(changeover_loadorder_error(order), "step is NULL; give the address of a step");
  EXPECT_EQ(changeover_loadorder_take_worker(order, 1), CHANGEOVER_LOADORDER_ERROR);
  EXPECT_STREQ(changeover_loadorder_error(order), "there is no worker 1; give 0");
  EXPECT_EQ(changeover_loadorder_seek(order, 0), CHANGEOVER_LOADORDER_ERROR);
  EXPECT_STREQ(
      changeover_loadorder_error(order),
      ("there is no step 0; give 1 to " + std::to_string(changeover_loadorder_steps(order)))
          .c_str());
  changeover_loadorder_close(order);
  changeover_loadorder_options pairs{};
  pairs.size = sizeof pairs;
  pairs.with_pairs = 1;
  changeover_loadorder* const computing = changeover_loadorder_open_with(9, 4, &pairs, nullptr, 0);
  ASSERT_NE(computing, nullptr);
  EXPECT_EQ(changeover_loadorder_seek(computing, 2), CHANGEOVER_LOADORDER_ERROR);
  EXPECT_STREQ(changeover_loadorder_error(computing),
               "steps of several workers, and with pairs, are read from the first");
  changeover_loadorder_close(computing);
}

}  // namespace
}  // namespace changeover::test::refusals_test
