#include "changeover/plan/run_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "message_of.hpp"

namespace changeover::run_sheet_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Amount units(std::uint64_t n) { return Amount{n * 1'000'000}; }

// The covering of the introduction of [ChafeeStevens2025], in the order shown there.
const std::vector<Block> covering{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {0, 3, 6}, {1, 4, 7}, {2, 5, 8},
                                  {0, 4, 8}, {1, 5, 6}, {2, 3, 7}, {0, 5, 7}, {1, 3, 8}, {2, 4, 6}};

TEST(RunSheet, CountsTheCostsOfThePaper) {
  const RunSheet costly_changes = run_sheet(make_job(9, 3, units(1), units(5)), covering);
  EXPECT_TRUE(costly_changes.does_the_job());
  EXPECT_EQ(costly_changes.cost, units(177));
  EXPECT_EQ(costly_changes.changes, 33U);
  EXPECT_EQ(run_sheet(make_job(9, 3, units(10), units(1)), covering).cost, units(153));
}

TEST(RunSheet, SaysWhatToDoAtEachStep) {
  Job job = make_job(4, 3, units(2), units(1));
  job.change_costs[3] = Amount{500'000};
  job.start = {2, 1};
  const RunSheet sheet = run_sheet(job, {{2, 0, 1}, {3, 1, 0}, {2, 3}});
  ASSERT_EQ(sheet.steps.size(), 3U);
  EXPECT_THAT(sheet.steps[0].take_out, IsEmpty());
  EXPECT_THAT(sheet.steps[0].put_in, ElementsAre(0));
  EXPECT_THAT(sheet.steps[1].take_out, ElementsAre(2));
  EXPECT_THAT(sheet.steps[1].put_in, ElementsAre(3));
  EXPECT_THAT(sheet.steps[1].new_pairs,
              ElementsAre(std::pair<Element, Element>{0, 3}, std::pair<Element, Element>{1, 3}));
  EXPECT_EQ(sheet.steps[1].cost, Amount{2'500'000});
  EXPECT_EQ(sheet.steps[2].cost_so_far, Amount{8'500'000});
  EXPECT_EQ(sheet.cost, Amount{8'500'000});
  EXPECT_EQ(sheet.change_cost, Amount{2'500'000});
  EXPECT_TRUE(sheet.does_the_job());
  EXPECT_EQ(sheet.constant_change(), std::nullopt);
}

TEST(RunSheet, ListsEveryFault) {
  Job job = make_job(5, 3, units(1), units(1));
  job.never.insert(0, 4);
  job.needed = all_pairs_but(job.never);
  job.mounted = {1};
  const auto faults = [&](const Block& setup) { return run_sheet(job, {setup}).faults; };
  EXPECT_THAT(faults({1, 2, 3}), IsEmpty());
  EXPECT_THAT(faults({0, 2, 3}), ElementsAre(HasSubstr("lacks a part that stays mounted")));
  EXPECT_THAT(faults({0, 1, 4}), ElementsAre(HasSubstr("holds 1 and 5")));
  EXPECT_THAT(faults({1, 2, 3, 4}), ElementsAre(HasSubstr("has 4 parts, 3 fit")));
  EXPECT_THAT(faults({1, 2, 2}), testing::Contains(HasSubstr("twice")));
  EXPECT_REFUSAL((void)run_sheet(job, {{1, 5}}), BadInput,
                 "a set-up names part 6 of 5; name parts that there are");
}

TEST(RunSheet, RefusesAnyChangeOfACompleteList) {
  const Job job = make_job(9, 3, units(1), units(1));
  for (std::size_t i = 0; i < covering.size(); ++i) {
    std::vector<Block> one_less = covering;
    one_less.erase(one_less.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(run_sheet(job, one_less).does_the_job());
    for (std::size_t j = 0; j < 3; ++j) {
      std::vector<Block> other = covering;
      while (std::count(covering[i].begin(), covering[i].end(), other[i][j]) != 0) {
        other[i][j] = (other[i][j] + 1) % 9;
      }
      EXPECT_FALSE(run_sheet(job, other).does_the_job());
    }
  }
}

TEST(RunSheet, RecognisesAConstantChange) {
  const Job job = make_job(6, 4, units(1), units(1));
  const RunSheet sheet = run_sheet(job, {{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 1}});
  EXPECT_EQ(sheet.constant_change(), std::optional<std::uint64_t>(2));
  EXPECT_TRUE(sheet.does_the_job());
}

TEST(RunSheet, ReportsAForbiddenPairOfAnyStep) {
  Job job = make_job(6, 3, units(1), units(1));
  job.never.insert(0, 4);
  job.needed = all_pairs_but(job.never);
  EXPECT_THAT(run_sheet(job, {{1, 2, 3}, {1, 2, 0}, {1, 4, 0}}).faults,
              ElementsAre(HasSubstr("set-up 3 holds 1 and 5")));
  EXPECT_THAT(run_sheet(job, {{1, 2, 4}, {1, 4, 3}, {0, 4, 3}}).faults,
              ElementsAre(HasSubstr("set-up 3 holds 1 and 5")));
  EXPECT_THAT(run_sheet(job, {{1, 2, 3}, {0, 4, 5}}).faults,
              ElementsAre(HasSubstr("set-up 2 holds 1 and 5")));
}

}  // namespace
}  // namespace changeover::run_sheet_test
