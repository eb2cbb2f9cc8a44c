// Tables of what changes cost by what is replaced, read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "changeover/plan/job.hpp"

namespace changeover::change_costs_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::vector<std::string> names{"Pump", "Valve, large", "Fan"};

std::vector<Amount> read(const std::string& text) {
  return read_change_costs(*input_from_text(text, "costs.csv"), names);
}

std::string complaint(const std::string& text) {
  try {
    (void)read(text);
  } catch (const BadInput& fault) {
    return fault.what();
  }
  return "no complaint";
}

std::vector<Amount> units(const std::vector<std::uint64_t>& all) {
  std::vector<Amount> amounts;
  for (const std::uint64_t each : all) {
    amounts.push_back(Amount{each * 100'000});
  }
  return amounts;
}

TEST(ChangeCosts, RowsAreTakenOutAndColumnsPutIn) {
  const std::vector<Amount> expected = units({0, 10, 25, 30, 0, 40, 50, 60, 0});
  EXPECT_EQ(read(",Pump,\"Valve, large\",Fan\nPump,,1,2.5\n\"Valve, large\",3,,4\nFan,5,6\n"),
            expected);
  EXPECT_EQ(read("from\\to;Fan;Pump;2\nFan;;5;6\n# a comment\n2;4;3;\nPump;2,5;;1\n"), expected);
  EXPECT_EQ(read("\t1\t2\t3\n1\t\t1\t2.5\n2\t3\t\t4\n3\t5\t6\t\n"), expected);
}

TEST(ChangeCosts, AreOfOneSlotWhereThereAreSlots) {
  const std::string text = ",Pump,\"Valve, large\",Fan\nPump,,1,\n\"Valve, large\",3,,4\nFan\n";
  EXPECT_EQ(read_change_costs(*input_from_text(text, "costs.csv"), names, {0, 0, no_slot}),
            units({0, 10, 0, 30, 0, 0, 0, 0, 0}));
  EXPECT_THROW((void)read_change_costs(*input_from_text(text, "costs.csv"), names, {0, 0, 0}),
               BadInput);
}

TEST(ChangeCosts, SaysWhatIsWrongAndWhere) {
  const std::string head = ",1,2,3\n";
  EXPECT_EQ(complaint(head + "1,,1,2\n2,3,,4\n1,,1,2\n"),
            "costs.csv:4:1: '1' heads two rows; remove one");
  EXPECT_EQ(complaint(",1,2,1\n"), "costs.csv:1:6: '1' heads two columns; remove one");
  EXPECT_EQ(complaint(",1,2\n1,,2\n2,1,\n"),
            "costs.csv:1:1: no column for 'Fan'; give every part a row and a column");
  EXPECT_EQ(complaint(head + "1,,1,2\n2,3,,4\n"),
            "costs.csv:1:1: no row for 'Fan'; give every part a row and a column");
  EXPECT_THAT(complaint(",1,2,fan\n"),
              StartsWith("costs.csv:1:6: there is no part 'fan'; did you"));
  EXPECT_THAT(complaint(head + "Belt,1,2,3\n"), StartsWith("costs.csv:2:1: there is no part"));
  EXPECT_THAT(complaint(head + "1,,-1,2\n"), StartsWith("costs.csv:2:4: "));
  EXPECT_THAT(complaint(head + "1,,x,2\n"), StartsWith("costs.csv:2:4: "));
  EXPECT_THAT(complaint(head + "1,7,1,2\n"),
              StartsWith("costs.csv:2:3: 'Pump' does not replace itself; leave this field empty"));
  EXPECT_THAT(complaint(head + "1,,,2\n"),
              HasSubstr("no cost of putting in 'Valve, large' where 'Pump' was taken out"));
  EXPECT_THAT(complaint(head + "1,,1\n"), HasSubstr("no cost of putting in 'Fan' where 'Pump'"));
  EXPECT_THAT(complaint(head + "1,,1,2,3\n"),
              StartsWith("costs.csv:2:8: more than 3 costs in this row"));
  EXPECT_THAT(complaint(",1,2,3,\n"), HasSubstr("a column without a part at its head"));
  EXPECT_THAT(complaint(head + ",1,2,3\n"), HasSubstr("a row without a part at its head"));
  EXPECT_THAT(complaint("# nothing\n"), HasSubstr("no cost is listed"));
}

}  // namespace
}  // namespace changeover::change_costs_test
