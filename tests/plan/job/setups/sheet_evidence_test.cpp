// Run sheets that lost a column, a cell or their numbers on the way: what else is on them says so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/plan/job.hpp"
#include "done_lists.hpp"
#include "plan/job/setups/step_numbers.hpp"

namespace changeover::sheet_evidence_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

DoneList read(const std::string& text, std::uint64_t at_once = 3) {
  return test::done_list(text, at_once);
}
std::string fault(const std::string& text) { return test::fault_of_list(text, 3); }

TEST(SheetEvidence, AColumnOfPartsThatIsGoneIsMissed) {
  EXPECT_THAT(read("step,take_out,put_in,slot_1,slot_2,slot_3,new_pairs,result\n"
                   "1,,\"A, B, C\",A,B,C,3,pass\n2,B,D,A,D,C,2,fail\n")
                  .notes,
              IsEmpty());
  // Deleted: the last, one in between; renamed; emptied.
  EXPECT_THAT(fault("step,take_out,put_in,slot_1,slot_2,new_pairs,result\n"
                    "1,,\"A, B, C\",A,B,3,pass\n2,C,D,A,B,2,pass\n"),
              HasSubstr("d.csv:2:4: 'C' is put in here, but no column of parts has it; a column of "
                        "parts is missing or empty"));
  EXPECT_THAT(fault("step,take_out,put_in,slot_1,slot_3,new_pairs,result\n"
                    "1,,\"A, B, C\",A,C,1,pass\n"),
              HasSubstr("d.csv:2:4: 'B' is put in here"));
  EXPECT_THAT(fault("step,take_out,put_in,slot_1,bar,slot_3,new_pairs,result\n"
                    "1,,\"A, B, C\",A,B,C,3,pass\n"),
              HasSubstr("'B' is put in here"));
  EXPECT_THAT(fault("step,take_out,put_in,slot_1,slot_2,slot_3,new_pairs,result\n"
                    "1,,\"A, B, C\",A,,C,3,pass\n2,B,D,A,,C,2,pass\n"),
              HasSubstr("'B' is put in here"));
  // Later steps say it, too, of a plan that went on from what was mounted.
  EXPECT_THAT(fault("step,take_out,put_in,slot_1,slot_2,new_pairs,result\n"
                    "4,,,A,B,1,pass\n5,C,D,A,B,1,pass\n"),
              HasSubstr("d.csv:3:5: 'D' is put in here"));
}

TEST(SheetEvidence, FiguresSayItWhereNothingElseDoes) {
  EXPECT_THAT(fault("step,slot_1 CPU,slot_2 disk,new_pairs,result\n1,A,B,3,pass\n"),
              HasSubstr("d.csv:2:7: 3 new pairs, but the 2 parts here have only 1"));
  EXPECT_THAT(fault("step,slot_1,slot_2,new_triples,result\n1,A,B,1,pass\n"),
              HasSubstr("1 new triples, but the 2 parts here have only 0"));
  EXPECT_EQ(fault("step,slot_1,slot_2,new_pairs,result\n1,A,B,1,pass\n"), "none");
}

TEST(SheetEvidence, HeadsWithAGapAreRefusedOrNoted) {
  EXPECT_THAT(fault("slot_1,slot_3,result\nA,B,pass\n"),
              HasSubstr("d.csv:1:8: a column 'slot_3', but none is called slot_2"));
  EXPECT_THAT(fault("slot_2,slot_3,result\nA,B,pass\n"), HasSubstr("none is called slot_1"));
  // A slot that was given up leaves one.
  EXPECT_THAT(read("slot_1 CPU,slot_3 disk,result\nA,B,pass\n").notes,
              ElementsAre(HasSubstr("d.csv:1:12: no column is called slot_2")));
  EXPECT_THAT(read("slot_1,slot_2,result\nA,B,pass\n").notes,
              ElementsAre("d.csv:1:8: 2 columns of parts, and 3 fit at once; if a column is "
                          "missing, put it back"));
  EXPECT_THAT(read("slot_1,slot_2,result\nA,B,pass\n", 2).notes, IsEmpty());
}

TEST(SheetEvidence, WhatPeopleChangedIsTaken) {
  const std::string head = "step,take_out,put_in,slot_1,slot_2,slot_3,new_pairs,result\n";
  const std::string first = "1,,\"A, B, C\",A,B,C,3,pass\n";
  // A part that was not there: its cell is empty, which is said.
  EXPECT_THAT(read(head + first + "2,B,D,A,,C,2,pass\n").notes,
              ElementsAre("d.csv:3:5: 'D' is put in here, but no column of parts has it; what a "
                          "test lacks does not count with it: write it in its column if it was "
                          "there"));
  EXPECT_THAT(read(head + first + "2,B,D,A,,C,2,\n3,,E,A,E,C,2,pass\n").notes, IsEmpty())
      << "it has no result";
  // Another part instead; the old one stayed; a bench with fewer places; a part that is gone.
  EXPECT_THAT(read(head + first + "2,B,D,A,E,C,2,pass\n").notes, IsEmpty());
  EXPECT_THAT(read(head + first + "2,B,D,A,B,C,2,pass\n").notes, IsEmpty());
  EXPECT_THAT(read(head + first + "1,,\"D, E\",D,E,,1,pass\n").notes, IsEmpty());
  EXPECT_THAT(read(head + first + "2,B,Old,A,Old,C,2,pass\n").gone, ElementsAre("Old"));
}

// One row alone proves nothing: it may be another set-up.
TEST(SheetEvidence, ARowThatMayHaveLostAPartIsNoted) {
  const std::string head = "step,take_out,put_in,slot_1,slot_2,slot_3,new_pairs,result\n";
  EXPECT_THAT(
      read(head + "3,F,D,A,B,,1,pass\n").notes,
      ElementsAre(HasSubstr("d.csv:2:5: 'D' is put in here, but no column of parts has it")));
  EXPECT_THAT(read(head + "3,F,D,A,B,E,2,pass\n").notes, IsEmpty());  // another part in its place
}

TEST(StepNumbers, ThatAreNoneAreRefusedOrNoted) {
  const auto with = [](const std::string& a, const std::string& b) {
    return "step,slot_1,result\n" + a + ",A,pass\n" + b + ",B,pass\n";
  };
  for (const char* bad :
       {"-1", "1e300", "1000000000000001", "18446744073709551616", "-0.5", "1e400", "-1e400"}) {
    EXPECT_THAT(fault(with("1", bad)),
                HasSubstr("d.csv:3:1: '" + std::string(bad) + "' is not the number of a step"));
  }
  EXPECT_EQ(read(with("1", "1000000000000000"), 1).rows.back().step, most_steps);
  EXPECT_EQ(read(with("1", "2.0"), 1).rows.back().step, 2U);
  for (const char* word : {"No 2", "step 2", "2.5", "+2", "inf", "2e"}) {
    EXPECT_THAT(read(with("1", word), 1).notes,
                ElementsAre(HasSubstr("d.csv:3:1: '" + std::string(word) +
                                      "' is not the number of a step, and a test")));
  }
  EXPECT_THAT(read("step,slot_1,result\nNo 1,A,pass\nNo 2,B,pass\nNo 3,C,pass\n", 1).notes,
              ElementsAre(HasSubstr("'No 1' is not the number of a step, nor are 2 others, and")));
  EXPECT_THAT(read(with("1", ""), 1).notes, IsEmpty());
}

TEST(StepNumbers, SayTheOrderWhateverTheirHead) {
  const DoneList list = read("Nr,slot_1,new_pairs,result\n2,A,0,pass\n1,B,0,pass\n", 1);
  EXPECT_THAT(list.setups(), ElementsAre(Block{1}, Block{0}));
  EXPECT_THAT(list.notes, ElementsAre("d.csv:1:1: the steps are those of the column 'Nr'",
                                      HasSubstr("d.csv:1:1: the rows are not in the order")));
  // No figures say that it is a run sheet.
  EXPECT_THAT(read("Nr,slot_1,result\n2,A,pass\n1,B,pass\n", 1).notes,
              ElementsAre(HasSubstr("d.csv:1:1: the column 'Nr' is not read; the tests are taken "
                                    "in the order of the rows")));
  EXPECT_THAT(read("slot_1,new_pairs,result\nA,0,pass\n", 1).notes,
              ElementsAre(HasSubstr("d.csv:1:1: the sheet has no column step")));
  EXPECT_THAT(read("slot_1,result\nA,pass\n", 1).notes, IsEmpty());
}

// Without a column of results all tests would count as passed.
TEST(OtherResults, InAColumnOfAnotherNameAreRefused) {
  EXPECT_THAT(
      fault("step,slot_1,slot_2,slot_3,Status\n1,A,B,C,pass\n2,D,E,F,fail\n"),
      HasSubstr(
          "d.csv:2:9: 'pass' in the column 'Status', and no column is called result; call it so "
          "if it has the results, or remove it"));
  EXPECT_THAT(read("step,slot_1,slot_2,slot_3,Room\n1,A,B,C,north\n").notes, IsEmpty());
  EXPECT_THAT(read("step,slot_1,slot_2,slot_3,result,Status\n1,A,B,C,,fail\n").notes,
              ElementsAre(HasSubstr("the column 'Status' says pass or fail, but that of the "
                                    "results is empty")));
}

TEST(SetupColumns, PlacesMayBeWrittenAsWords) {
  const DoneList list = read("Step,Slot 1,slot 2,SLOT_3 disk,Result\n1,A,B,C,pass\n2,D,E,F,\n");
  ASSERT_EQ(list.rows.size(), 2U);
  EXPECT_EQ(list.rows[0].setup, (Block{0, 1, 2}));
  EXPECT_EQ(list.rows[0].result, "pass");
  EXPECT_EQ(list.places.at(2).slot, "disk");
}

TEST(OtherResults, AreNamedOrRefused) {
  EXPECT_THAT(read("slot_1,result,Ergebnis\nA,pass,ok\n", 1).notes,
              ElementsAre(HasSubstr("d.csv:1:15: the column 'Ergebnis' is not read")));
  EXPECT_THAT(fault("slot_1,result,Ergebnis\nA,pass,fail\n"),
              HasSubstr("d.csv:2:8: 'fail' in the column 'Ergebnis', but the column 'result' says "
                        "'pass'; keep one column of results"));
  EXPECT_THAT(fault("slot_1,result,Ergebnis\nA,,fail\n"),
              HasSubstr("the column 'result' says nothing"));
  for (const char* row : {"A,pass,Meier", "A,pass,", "A,fail,12.5"}) {
    EXPECT_THAT(read("slot_1,result,passed by\n" + std::string(row) + "\n", 1).notes, IsEmpty());
  }
  EXPECT_THAT(read("slot_1,result,result comment\nA,pass,failed at first\n", 1).notes, IsEmpty());
}

// Where nothing says what was put in, pairs that are counted as new say that one is missing.
TEST(SheetEvidence, FiguresOfAllTestsShowAnEmptiedCell) {
  const std::string slots = "step,slot_1 CPU,slot_2 disk,slot_3 disk,new_pairs,result\n";
  EXPECT_THAT(read(slots + "1,A,B,C,3,pass\n2,A,D,,2,pass\n").notes,
              Contains("d.csv:3:7: the cell is empty, and the parts here have only 1 of the 2 "
                       "new pairs; write the part that was there: what was tested with it does "
                       "not count"));
  EXPECT_THAT(read(slots + "1,A,B,C,3,pass\n2,A,D,,1,pass\n3,A,E,,2,\n").notes, IsEmpty());
}

}  // namespace
}  // namespace changeover::sheet_evidence_test
