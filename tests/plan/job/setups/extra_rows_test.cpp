// Rows of a sheet that are no tests: sums, the names of days, the heads again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/plan/job.hpp"
#include "done_lists.hpp"

namespace changeover::extra_rows_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string head = "step,put_in,slot_1,slot_2,new_pairs,result,seen\n";
const std::string first = "1,\"A, B\",A,B,1,pass,\n";

DoneList read(const std::string& text) { return test::done_list(text, 2); }
std::string fault(const std::string& text) { return test::fault_of_list(text, 2); }

TEST(ExtraRows, SumsDaysAndHeadsAreSkippedWithOneNote) {
  const DoneList list = read(head + first + "Tuesday\n" + head + "2,C,A,C,1,fail,\n" +
                             "3,D,A,D,1,,\n,,,,,,\nTotal,,,,3,,\n");
  EXPECT_THAT(list.setups(), ElementsAre(Block{0, 1}, Block{0, 2}, Block{0, 3}));
  EXPECT_THAT(list.notes, ElementsAre("d.csv:3:1: skipped, as they are not tests: rows 3 "
                                      "('Tuesday'), 4 (the heads again), 8 ('Total')"));
  EXPECT_THAT(list.gone, IsEmpty());
  // Where the first column is one of parts, and where an emptied step is left.
  const std::string plain = "slot_1,slot_2,result\nA,B,pass\n";
  EXPECT_THAT(read(plain + "Tuesday,,\nC,D,pass\n").notes,
              ElementsAre("d.csv:3:1: skipped, as it is not a test: row 3 ('Tuesday')"));
  EXPECT_EQ(read(plain + "Tuesday,,\nC,D,pass\n").rows.size(), 2U);
  EXPECT_THAT(read(head + first + "2,,,,,,\n").notes,
              ElementsAre("d.csv:3:1: skipped, as it is not a test: row 3"));
  EXPECT_THAT(read(head + first + "2,,,,,not run,\n").rows.size(), 1U);
}

TEST(ExtraRows, AResultWithoutPartsIsRefusedByItsCell) {
  EXPECT_EQ(fault(head + first + "2,,,,1,pass,\n"),
            "d.csv:3:8: the result 'pass', but the row has no set-up; write its parts, or remove "
            "the result");
  EXPECT_THAT(fault(head + first + "Total,,,,3,1 of 2,\n"), HasSubstr("the result '1 of 2'"));
  // In another column of results.
  EXPECT_THAT(fault("step,slot_1,slot_2,result,Ergebnis\n1,A,B,pass,\n2,,,,pass\n"),
              HasSubstr("'pass' in the column 'Ergebnis'"));
}

TEST(ExtraRows, WhatMayBeATestIsNotSkipped) {
  // Without results each row is a test.
  EXPECT_THAT(fault("step,slot_1,slot_2\n1,A,B\n2,,\n"),
              HasSubstr("d.csv:3:1: a row without a set-up"));
  EXPECT_THAT(fault(head + first + "2,D\n"), HasSubstr("the row ends before its last slot"));
  EXPECT_THAT(fault(head + first + "2\n"), HasSubstr("the row ends before its last slot"));
  EXPECT_THAT(read("slot_1,slot_2,result\nA,,\nB,,pass\n").rows.size(), 2U) << "a part alone";
  EXPECT_THAT(read("slot_1,slot_2,result\nA,B,pass\nOld,,pass\n").gone, ElementsAre("Old"));
}

TEST(ExtraRows, OtherHeadsAreOfAnotherSheet) {
  EXPECT_THAT(
      fault(head + first + "step,slot_1,slot_2,put_in,new_pairs,result,seen\n"),
      HasSubstr("d.csv:3:1: these headings differ from those in row 1; give one sheet at a time"));
  EXPECT_THAT(fault(head + first + "step,put_in,slot_1,slot_2,slot_3,result,seen\n"),
              HasSubstr("these headings differ from those in row 1"));
}

TEST(ExtraRows, ALineWithASignOfCommentsIsATestIfItHasOne) {
  const std::string heads = "step,put_in,slot_1,slot_2,new_pairs,result";
  const DoneList steps = read(heads + "\n#2,C,A,C,1,fail\n#1,\"A, B\",A,B,1,pass\n# Day 2\n");
  EXPECT_THAT(steps.setups(), ElementsAre(Block{0, 1}, Block{0, 2}));
  EXPECT_EQ(steps.rows.front().step, 1U);
  EXPECT_EQ(read("ticket," + heads + "\n#40,1,\"A, B\",A,B,1,pass\n").rows.size(), 1U);
  EXPECT_EQ(read("remark," + heads + "\n#2 with photo,1,\"A, B\",A,B,1,\n").rows.size(), 1U);
  EXPECT_EQ(read(heads + "\n1,\"A, B\",A,B,1,pass\n#,was,late,and,so,on\n").rows.size(), 1U);
  const DoneList out = read("slot_1,slot_2,result\nA,B,pass\n#C,D,pass\n");
  EXPECT_EQ(out.rows.size(), 1U);
  EXPECT_THAT(out.notes, ElementsAre("d.csv:3:1: the row begins with #, so it is a comment; "
                                     "remove the # if the test was run"));
}

TEST(ExtraRows, HeadsInAnotherCaseAndSumsUnderPartsAreNoTests) {
  EXPECT_THAT(read(head + first + "Step,PUT_IN,Slot_1,slot_2,NEW_PAIRS,Result,seen\n").notes,
              ElementsAre("d.csv:3:1: skipped, as it is not a test: row 3 (the heads again)"));
  const std::string plain = "slot_1,slot_2,result\nA,B,pass\n";
  EXPECT_THAT(fault(plain + "Total:,,pass\n"), HasSubstr("but the row has no set-up"));
  EXPECT_THAT(read(plain + "Sum,,\n").rows.size(), 1U);
}

}  // namespace
}  // namespace changeover::extra_rows_test
