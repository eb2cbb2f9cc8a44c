// The heads of a run sheet as people change them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/plan/job.hpp"
#include "done_lists.hpp"
#include "plan/job/setups/setup_columns.hpp"
#include "some_models.hpp"

namespace changeover::heads_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

DoneList read(const std::string& text) { return test::done_list(text, 2); }
std::string fault(const std::string& text) { return test::fault_of_list(text, 2); }

TEST(Heads, TwoColumnsOfOneNameAreRefusedIfOneIsRead) {
  EXPECT_EQ(fault("step,slot_1,slot_2,result,Notes,notes\n1,A,B,pass,,\n"),
            "d.csv:1:33: two columns are called 'Notes' and 'notes'; rename or remove one");
  EXPECT_THAT(fault("slot_1,slot_1,result\nA,B,pass\n"),
              HasSubstr("two columns are called 'slot_1'"));
  EXPECT_THAT(fault("slot_1,slot_2,Ergebnis,ERGEBNIS\nA,B,pass,\n"),
              HasSubstr("'Ergebnis' and 'ERGEBNIS'"));
  EXPECT_THAT(fault("slot_1,slot_2,put_in,Put_in,result\nA,B,,,pass\n"),
              HasSubstr("'put_in' and 'Put_in'"));
  EXPECT_THAT(fault("date,slot_1,slot_2,date,result\n,A,B,,pass\n"),
              HasSubstr("two columns are called 'date'"));
  EXPECT_EQ(fault("Date,slot_1,slot_2,date,Who,who,Who,result\n,A,B,,,,,pass\n"), "none");
}

TEST(Heads, ADateIsNoResult) {
  EXPECT_EQ(result_column({"step", "slot_1", "new_pairs", "cost", "Date", "Status"}), 5U);
  EXPECT_EQ(result_column({"step", "slot_1", "new_pairs", "Datum", "Operator", "Status"}), 5U);
  EXPECT_EQ(result_column({"step", "slot_1", "new_pairs", "Status", "Date"}), 3U);
  EXPECT_EQ(result_column({"step", "slot_1", "new_pairs", "Date"}), std::nullopt);
  EXPECT_EQ(result_column({"step", "slot_1", "new_pairs", "Date", "notes"}), std::nullopt);
}

TEST(Heads, ThatBeginWithASignOfCommentsAreHeads) {
  for (const char* first : {"#", "# step", "#step"}) {
    const DoneList list =
        read(std::string(first) + ",slot_1,slot_2,new_pairs,result\n2,A,C,1,fail\n1,A,B,1,pass\n");
    EXPECT_THAT(list.setups(), ElementsAre(Block{0, 1}, Block{0, 2})) << first;
    EXPECT_EQ(list.rows.front().result, "pass");
  }
  // Comments stay comments.
  EXPECT_THAT(read("# of Monday, all of them\nslot_1,slot_2\nA,B\n#C,D\n").setups(),
              ElementsAre(Block{0, 1}));
  EXPECT_THAT(read("slot_1,slot_2\nA,B\n#,slot_1\n").notes, IsEmpty());
}

TEST(Heads, AColumnOfOursIsNotTheParameterOfItsName) {
  const Job job = test::job_of_text("Step: 1, 2\nDisk: x, y\n");
  const auto said = [&](const std::string& text) -> std::string {
    try {
      return std::to_string(read_done(*input_from_text(text, "d.csv"), job).rows.size());
    } catch (const BadInput& bad) {
      return bad.what();
    }
  };
  EXPECT_EQ(said("step,Disk,new_pairs,result\n1,x,1,pass\n"),
            "d.csv:1:1: the parameter 'Step' has no column 'slot_1 Step', and this one is not it; "
            "put that column back");
  EXPECT_EQ(said("step,slot_1 Step,Disk,new_pairs,result\n1,2,x,1,pass\n"), "1");
  EXPECT_EQ(said("Step,Disk,result\n1,x,pass\n"), "1") << "a table of one's own";
}

}  // namespace
}  // namespace changeover::heads_test
