// Plans for the rest of a sheet.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "changeover/plan/run_plan.hpp"
#include "core/each.hpp"
#include "message_of.hpp"
#include "random_jobs.hpp"

namespace changeover::rest_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

RunPlan planned(const Job& job, std::uint64_t steps, std::vector<Block> rest) {
  RunControl control({.threads = 1});
  return make_run_plan(
      job, {.steps = steps, .attempts = 1, .rest = std::move(rest), .design_moves = 0, .states = 0},
      control);
}

TEST(Rest, NoNewPlanIsDearerThanGoingOn) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Job job =
        seed % 2 == 0 ? test::random_job(seed, 14) : test::random_job_with_slots(seed, 14);
    const RunPlan whole = planned(job, 20'000, {});
    const std::vector<Block>& setups = whole.candidates.front().setups;
    for (std::size_t done = 0; done < setups.size(); done += 2) {
      const auto cut = setups.begin() + static_cast<std::ptrdiff_t>(done);
      Job left = job;
      mark_done(left, {setups.begin(), cut});
      const std::vector<Block> rest(cut, setups.end());
      // Hardly any search: what is as good as going on is going on.
      const RunPlan plan = planned(left, 1, rest);
      EXPECT_TRUE(plan.sheet.does_the_job());
      EXPECT_LE(plan.sheet.cost, run_sheet(left, rest).cost) << seed << ' ' << done;
    }
  }
}

TEST(Rest, IsMendedWhereItLacksPairsAndSkippedWhereItBreaksRules) {
  const auto units = [](std::uint64_t n) { return Amount{n * 1'000'000}; };
  Job job = make_job(7, 3, units(2), units(1));
  const std::vector<Block> fano{{0, 1, 2}, {0, 3, 4}, {0, 5, 6}, {1, 3, 5},
                                {1, 4, 6}, {2, 3, 6}, {2, 4, 5}};
  const auto has = [](const RunPlan& plan, const std::string& name) {
    return std::any_of(plan.candidates.begin(), plan.candidates.end(),
                       [&](const Candidate& c) { return c.name == name; });
  };
  EXPECT_TRUE(has(planned(job, 1, fano), "rest of the sheet"));
  const RunPlan fewer = planned(job, 1, {fano.begin(), fano.begin() + 4});
  EXPECT_FALSE(has(fewer, "rest of the sheet"));
  EXPECT_TRUE(has(fewer, "rest of the sheet, completed"));
  EXPECT_TRUE(fewer.sheet.does_the_job());
  job.never.insert(0, 1);
  job.needed = all_pairs_but(job.never);
  const RunPlan other = planned(job, 1, fano);
  EXPECT_FALSE(has(other, "rest of the sheet"));
  EXPECT_TRUE(other.sheet.does_the_job());
}

TEST(ReadDone, PartsThatAreGoneAreNamedOnce) {
  const std::string head = "step,take_out,put_in,slot_1,slot_2,new_pairs,cost,cost_so_far,result\n";
  const std::vector<std::string> names{"Pump", "Motor"};
  const auto read = [&](const std::string& rows) {
    return read_done(*input_from_text(head + rows, "d.csv"), names);
  };
  const DoneList list =
      read("1,,,Pump,Fan,1,1,1,pass\n2,,,Fan,Motor,1,1,1,\n3,,,Fan,Hose,1,1,1,x\n");
  EXPECT_THAT(list.setups(), ElementsAre(Block{0}, Block{1}, Block{}));
  EXPECT_THAT(list.gone, ElementsAre("Fan", "Hose"));
  EXPECT_THAT(each_of<std::string>(list.rows, &DoneRow::result), ElementsAre("pass", "", "x"));
  EXPECT_TRUE(list.has_results());
  EXPECT_THROW((void)read("1,,,pump,Motor,1,1,1,\n"), BadInput)
      << "a slip, not a part that is gone";
  EXPECT_THROW((void)read("1,,,,,1,1,1,\n"), BadInput);
  EXPECT_THAT(read_done(*input_from_text("Pump,Fan\n", "d.csv"), names).gone, ElementsAre("Fan"));
  EXPECT_THROW((void)read_setups(*input_from_text(head + "1,,,Pump,Fan,1,1,1,\n"), names),
               BadInput);
}

TEST(ReadDone, ADamagedSheetIsRefusedWhereItIsDamaged) {
  const auto complaint = [](const std::string& text) -> std::string {
    return message_of([&] { (void)read_done(*input_from_text(text, "d.csv"), {"a", "b", "c"}); });
  };
  const std::string head = "step,slot_1,slot_2,slot_3,result\n";
  EXPECT_EQ(complaint(head + "1,a,b,c,pass\n2,a,b,\n"), "");
  EXPECT_THAT(complaint(head + "1,a,b\n"), testing::StartsWith("d.csv:2:5: the row ends before"));
  EXPECT_THAT(complaint(head + "1,a,b,c,pass,x\n"), testing::HasSubstr("more fields than the 5"));
  EXPECT_EQ(complaint(head + "1,a,b,c,\n" + head), "") << "the heads again are no damage";
  EXPECT_THAT(complaint("step,slot_1,slot_2,result,Result\n1,a,b,pass,fail\n"),
              testing::HasSubstr("two columns are called 'result' and 'Result'"));
}

TEST(ReadDone, NoNumberBecomesAnotherPart) {
  const std::string sheet = "step,take_out,put_in,slot_1,slot_2\n1,,,1,3\n";
  // Part 2 of 1, 2, 3 is gone: 3 is still 3, and where 3 is gone, 3 is no_part.
  EXPECT_THAT(read_done(*input_from_text(sheet), {"1", "3"}).setups(), ElementsAre(Block{0, 1}));
  const DoneList list = read_done(*input_from_text(sheet), {"7", "1", "2"});
  EXPECT_THAT(list.setups(), ElementsAre(Block{1}));
  EXPECT_THAT(list.gone, ElementsAre("3"));
  EXPECT_THAT(read_done(*input_from_text(sheet), {"a", "b", "c"}).setups(),
              ElementsAre(Block{0, 2}));
}

TEST(ReadDone, AResultThatIsNotUnderstoodHasItsPlace) {
  const DoneList list = read_done(
      *input_from_text("step,slot_1,slot_2,result\n1,a,b,pass\n2,b,c,hot\n3,a,c,\n", "d.csv"),
      {"a", "b", "c"});
  EXPECT_THAT(each_of<std::string>(list.rows, &DoneRow::unread), ElementsAre("", "d.csv:3:7", ""));
}

}  // namespace
}  // namespace changeover::rest_test
