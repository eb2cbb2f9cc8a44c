// Workbooks whose sheets say different things of the same test, and sheets of another job.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/request/workbook/sheets_agree.hpp"
#include "zip_files.hpp"

namespace changeover::sheets_agree_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<std::string> names{"A", "B", "C", "D"};

using Named = std::vector<std::pair<std::string, std::string>>;

// Lists as sheets of a book: their rows as CSV, their inputs by name.
struct Sheets {
  std::vector<std::unique_ptr<Input>> inputs;
  std::vector<DoneList> lists;
  std::vector<std::string> notes;

  explicit Sheets(const std::vector<std::pair<std::string, std::string>>& sheets) {
    for (const auto& [name, rows] : sheets) {
      inputs.push_back(std::make_unique<SheetInput>(input_from_text("", "b.xlsx"), name));
      lists.push_back(
          read_done(*input_from_text("bench,step,slot_1,slot_2,result\n" + rows, "b.csv"), names));
    }
  }
  Sheets& agree() {
    make_agree(inputs, lists, notes);
    return *this;
  }
  std::string fault() {
    try {
      agree();
    } catch (const BadInput& bad) {
      return bad.what();
    }
    return "none";
  }
};

TEST(SheetsAgree, ATestOnTwoSheetsCountsOnce) {
  Sheets sheets({{"Done", ",1,A,B,pass\n,2,A,C,fail\n"}, {"Run sheet", ",2,C,A,FAILED\n"}});
  EXPECT_THAT(sheets.agree().notes,
              ElementsAre("b.xlsx:Done: 1 test is on another sheet, too, with the same result; it "
                          "counts once"));
  EXPECT_THAT(sheets.lists[0].setups(), ElementsAre(Block{0, 1}));
  EXPECT_THAT(sheets.lists[1].setups(), ElementsAre(Block{2, 0}));
}

TEST(SheetsAgree, DifferentResultsAreRefusedWithBothPlaces) {
  EXPECT_EQ(Sheets({{"Done", ",1,A,B,pass\n"}, {"Run sheet", ",2,A,C,ok\n,1,A,B,fail\n"}}).fault(),
            "b.xlsx:Run sheet: row 3: step 1 has the result 'fail', but 'pass' in row 2 of "
            "b.xlsx:Done; correct one, or delete that row");
}

TEST(SheetsAgree, OneStepWithOtherPartsIsOfAnotherPlan) {
  EXPECT_THAT(
      Sheets({{"Run sheet", ",1,A,B,pass\n"}, {"Other", ",1,A,C,pass\n"}}).fault(),
      AllOf(HasSubstr(
                "b.xlsx:Other: row 2: step 1 has other parts than in row 2 of b.xlsx:Run sheet; "),
            HasSubstr("delete the column step of one sheet")));
  // Earlier tests may have numbers of their own.
  EXPECT_THAT(Sheets({{"Done", ",1,A,B,pass\n"}, {"Run sheet", ",1,A,C,pass\n"}}).agree().notes,
              ElementsAre(HasSubstr("both count, as two tests")));
}

TEST(SheetsAgree, CopiesOfARunSheetAreOne) {
  Sheets days(
      {{"Day 1", ",1,A,B,pass\n,2,A,C,\n,3,A,D,\n"}, {"Day 2", ",1,A,B,\n,2,C,A,fail\n,3,A,D,\n"}});
  EXPECT_THAT(days.agree().notes, IsEmpty());
  EXPECT_THAT(days.lists[0].setups(), ElementsAre(Block{0, 1}, Block{0, 3}));
  EXPECT_THAT(days.lists[1].setups(), ElementsAre(Block{2, 0}));
}

TEST(SheetsAgree, OnOtherBenchesWithoutResultsOrNumbersNothingIsTheSame) {
  for (const char* row :
       {"S,1,A,B,fail\n", "N,1,A,B,\n", "N,1,A,B,skipped\n", "N,,A,B,fail\n", "N,3,A,B,fail\n"}) {
    Sheets sheets({{"Done", "N,1,A,B,pass\n"}, {"Run sheet", row}});
    EXPECT_THAT(sheets.agree().notes, IsEmpty()) << row;
    EXPECT_EQ(sheets.lists[0].rows.size(), 1U);
  }
}

TEST(SheetsAgree, ASheetWithoutAnyPartOfTheJobIsRefused) {
  EXPECT_EQ(Sheets({{"Run sheet", ",1,A,B,pass\n"}, {"Old", ",1,X,Y,pass\n"}}).fault(),
            "b.xlsx:Old: none of its parts is in the parts list; give the tests of this job, or "
            "delete the sheet");
  EXPECT_EQ(Sheets({{"Run sheet", ",1,A,B,pass\n"}, {"Old", ",5,X,A,pass\n"}}).fault(), "none");
}

TEST(SheetsAgree, ATestTwiceOnASheetCountsOnce) {
  Sheets sheets(Named{{"Run sheet", ",1,A,B,pass\n,2,A,C,\n,1,B,A,ok\n,2,A,C,\n,2,A,D,pass\n"}});
  EXPECT_EQ(sheets.agree().lists[0].rows.size(), 4U);
  EXPECT_THAT(sheets.notes,
              ElementsAre("b.xlsx:Run sheet: row 4: step 1 is on the sheet before, with the same "
                          "parts and result and counts once; give it another number to count "
                          "both"));
}

TEST(SheetsAgree, StepsThatNoSheetHasAreNoted) {
  Sheets sheets(Named{{"Tue", ",4,A,B,pass\n"}});
  note_lost_steps("b.xlsx", 0, sheets.lists, sheets.notes);
  note_lost_steps("b.xlsx", 2, sheets.lists, sheets.notes);
  note_lost_steps("b.xlsx", 3, sheets.lists, sheets.notes);
  EXPECT_THAT(sheets.notes,
              ElementsAre("b.xlsx: no sheet has tests with steps 1 to 3; if they were done, put "
                          "them back",
                          "b.xlsx: no sheet has tests with step 3; if it was done, put it back"));
  // A row that was deleted in between, and many of them.
  Sheets some(
      Named{{"Run sheet", ",1,A,B,pass\n,3,A,C,pass\n"}, {"Tue", ",7,A,D,\n,6,B,D,pass\n"}});
  note_lost_steps("b.xlsx", 0, some.lists, some.notes);
  note_lost_steps("b.xlsx", 3, some.lists, some.notes);
  note_lost_steps("b.xlsx", 5, some.lists, some.notes);
  EXPECT_THAT(some.notes,
              ElementsAre("b.xlsx: no sheet has tests with steps 2, 4 to 5; if they were done, put "
                          "them back",
                          "b.xlsx: no sheet has tests with steps 4 to 5; if they were done, put "
                          "them back"));
  std::string rows;
  for (int step = 2; step <= 30; step += 2) {
    rows += "," + std::to_string(step) + ",A,B,pass\n";
  }
  Sheets odd(Named{{"Run sheet", rows}});
  note_lost_steps("b.xlsx", 0, odd.lists, odd.notes);
  EXPECT_THAT(odd.notes, ElementsAre(HasSubstr("steps 1, 3, 5, 7, 9, 11, 13, 15, 17, 19 and 5 "
                                               "places more; if they were")));
}

TEST(SheetsAgree, TestsWithoutANumberThatAreAlikeCountAndAreNoted) {
  Sheets two(Named{{"Done", ",,A,B,pass\n,,A,C,pass\n,,B,A,pass\n,,A,B,fail\nN,,A,B,pass\n"}});
  EXPECT_THAT(two.agree().notes, ElementsAre("b.xlsx:Done: rows 2 and 4 are alike, and both "
                                             "count; delete one if it is a copy"));
  EXPECT_EQ(two.lists[0].rows.size(), 5U);
  Sheets more(Named{{"Done", ",,A,B,pass\n,,A,B,pass\n,,A,B,pass\n,,A,C,\n,,A,C,\n"}});
  EXPECT_THAT(more.agree().notes, ElementsAre("b.xlsx:Done: rows 2 and 3 are alike, as in 1 other "
                                              "case; all count: delete what is a copy"));
}

}  // namespace
}  // namespace changeover::sheets_agree_test
