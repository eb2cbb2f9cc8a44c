// Cells of parts that were emptied: the tests before and after say what stood there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/plan/job.hpp"
#include "some_models.hpp"

namespace changeover::emptied_cells_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<std::string> names{"A", "B", "C", "D", "E", "F"};
const std::string head = "step,take_out,put_in,slot_1,slot_2,slot_3,result\n";

std::string fault(const std::string& text) {
  try {
    static_cast<void>(read_done(*input_from_text(text, "d.csv"), names, 3));
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return "none";
}

TEST(EmptiedCells, APartThatNothingTakesOutIsThere) {
  EXPECT_EQ(fault(head + "1,,\"A, B, C\",A,B,C,pass\n2,B,D,A,D,,pass\n"),
            "d.csv:3:11: the cell is empty, but 'C' is there in the test before and nothing takes "
            "it out; write it here, or under take_out if it was taken out");
  // Sorted by parts, the steps are still in their order; benches have their own.
  EXPECT_THAT(fault(head + "2,B,D,A,D,,pass\n1,,\"A, B, C\",A,B,C,pass\n"),
              HasSubstr("d.csv:2:11: the cell is empty, but 'C' is there in the test before"));
  const std::string benches = "bench," + head;
  EXPECT_EQ(fault(benches + "N,1,,\"A, B, C\",A,B,C,pass\nS,2,,D,D,,,pass\n"), "none");
}

TEST(EmptiedCells, APartThatNothingPutsInWasThere) {
  EXPECT_EQ(fault(head + "4,A,B,,B,C,pass\n5,C,D,A,B,D,pass\n"),
            "d.csv:2:7: the cell is empty, but 'A' is there in the test after it and nothing puts "
            "it in; write it here, or under put_in there if it was put in");
  EXPECT_EQ(fault(head + "4,E,B,,B,C,\n5,C,D,A,B,D,pass\n"), "none") << "it has no result";
}

TEST(EmptiedCells, WhatMayBeIsTaken) {
  const std::string first = head + "1,,\"A, B, C\",A,B,C,pass\n";
  EXPECT_EQ(fault(first + "2,\"B, C\",D,A,D,,pass\n"), "none") << "taken out";
  EXPECT_EQ(fault(first + "3,B,D,A,D,,pass\n"), "none") << "step 2 is missing";
  EXPECT_EQ(fault(first + "2,C and more,D,A,D,,pass\n"), "none") << "a remark";
  EXPECT_EQ(fault(first + "2,E,,A,B,,pass\n"), "none") << "step 1 was not as planned";
  EXPECT_EQ(fault(first + "2,B,D,A,D,C,pass\n3,A,E,E,D,C,pass\n"), "none");
  // Without numbers, rows may be missing: both sides have to say it.
  const std::string plain =
      "take_out,put_in,slot_1,slot_2,slot_3,result\n,\"A, B, C\",A,B,C,pass\n";
  EXPECT_EQ(fault(plain + "B,D,A,D,,pass\n"), "none");
  EXPECT_THAT(fault(plain + "B,D,A,D,,pass\nA,E,E,D,C,pass\n"),
              HasSubstr("d.csv:3:9: the cell is empty, but 'C' is there in the test before"));
}

// Workbooks with slots do not say what is taken out.
TEST(EmptiedCells, BetweenTwoOfOnePartAreNoted) {
  const auto notes = [](const std::string& rows) {
    return read_done(
               *input_from_text("step,slot_1 CPU,slot_2 NIC,new_pairs,result\n" + rows, "d.csv"),
               names, 2)
        .notes;
  };
  EXPECT_THAT(notes("1,A,C,1,pass\n2,,C,0,pass\n3,A,,0,pass\n4,A,C,0,pass\n"),
              ElementsAre("d.csv:3:3: the cell is empty, and 'A' is there in the tests before and "
                          "after, as in 1 other cell; write it here if it was there in "
                          "this one"));
  EXPECT_THAT(notes("1,A,C,1,pass\n2,,C,0,pass\n3,B,C,1,pass\n"), IsEmpty());
  EXPECT_THAT(notes("1,A,C,1,pass\n3,,C,0,pass\n4,A,C,1,pass\n"), IsEmpty());
}

TEST(EmptiedCells, OfAModelAreRefusedOrNoted) {
  const Job job = test::job_of_text("OS: Win, Deb\nLog: On, Off\nNet: x, y\n");
  const auto read = [&](const std::string& text) {
    return read_done(*input_from_text(text, "d.csv"), job);
  };
  const std::string tests =
      "step,set,OS,Log,Net,result\n1,\"OS: Win, Log: On, Net: x\",Win,On,x,pass\n";
  EXPECT_THROW((void)read(tests + "2,Net: y,Win,,y,pass\n"), BadInput);
  EXPECT_THAT(read(tests + "2,Log: Off,Win,,x,pass\n").notes,
              testing::Contains(HasSubstr("'Off' is put in here")));
  EXPECT_THAT(read("OS,Log,Net,result\nWin,On,x,pass\nWin,,x,pass\nWin,,y,pass\n").notes,
              ElementsAre("d.csv:3:5: no value is here, as in 1 other row; what was tested with it "
                          "does not count: write it if it was set"));
  EXPECT_THAT(read("OS,Log,Net,result\nWin,On,x,pass\nWin,,x,\n").notes, IsEmpty());
}

TEST(EmptiedCells, AColumnThatIsEmptyIsNoted) {
  const std::vector<std::string> notes =
      read_done(*input_from_text(
                    "step,slot_1,slot_2,slot_3,new_pairs,result\n1,A,,B,1,pass\n2,A,,C,1,pass\n",
                    "d.csv"),
                names, 3)
          .notes;
  EXPECT_THAT(notes, ElementsAre("d.csv:1:13: no row has a part in the column 'slot_2'; if it was "
                                 "emptied, fill it in: its parts do not count"));
}

TEST(EmptiedCells, AnOwnTestBetweenOthersIsTaken) {
  const std::string rows = head + "1,,\"A, B, C\",A,B,C,pass\n";
  EXPECT_EQ(fault(rows + ",,,D,B,,pass\n2,B,E,A,E,C,pass\n"), "none");
  // What is emptied is seen all the same.
  EXPECT_THAT(fault(rows + ",,,D,B,,pass\n2,B,E,A,E,,pass\n"),
              HasSubstr("d.csv:4:11: the cell is empty, but 'C' is there"));
}

}  // namespace
}  // namespace changeover::emptied_cells_test
