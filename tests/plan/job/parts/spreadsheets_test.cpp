// Lists as they come out of spreadsheets: which column has the costs, what is no part, how many
// there are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "changeover/core/error.hpp"
#include "changeover/plan/job.hpp"
#include "damage.hpp"

namespace changeover::spreadsheets_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

PartList parts(const std::string& text, const PartListOptions& options = {}) {
  return read_parts(*input_from_text(text, "p.csv"), options);
}

std::string complaint(const std::string& text, const PartListOptions& options = {}) {
  try {
    return "read as " + testing::PrintToString(parts(text, options).names);
  } catch (const BadInput& fault) {
    return fault.what();
  }
}

std::vector<std::string> costs(const PartList& list) {
  std::vector<std::string> texts;
  for (const auto& cost : list.change_costs) {
    texts.push_back(cost ? to_string(*cost) : "none");
  }
  return texts;
}

TEST(Spreadsheets, TimesAndWorkAreCosts) {
  const std::vector<std::pair<std::string, CostUnit>> heads{
      {"Swap time (min)", CostUnit::minutes},
      {"Time", CostUnit::none},
      {"Hours", CostUnit::hours},
      {"Duration", CostUnit::none},
      {"Effort", CostUnit::none},
      {"Duration [h]", CostUnit::hours},
      {"Minutes", CostUnit::minutes},
      {"Time (s)", CostUnit::seconds},
      {"Rüstzeit (min)", CostUnit::minutes},
      {"Dauer", CostUnit::none},
      {"Swap (min)", CostUnit::minutes},
      {"Full clean [min]", CostUnit::minutes},
      {"Stunden", CostUnit::hours},
      {"Changeover time", CostUnit::none},
      {"Change cost (min)", CostUnit::minutes}};
  for (const auto& [head, unit] : heads) {
    const PartList list = parts("Component,Vendor," + head + "\nA,x,5\nB,y,2.5\n");
    EXPECT_THAT(costs(list), ElementsAre("5", "2.50")) << head;
    EXPECT_EQ(list.unit, unit) << head;
    EXPECT_THAT(list.note, HasSubstr("change costs in '" + head + "'; not used: 'Vendor'"));
  }
}

TEST(Spreadsheets, WhatIsNoCostIsNamedAsUnused) {
  for (const std::string head : {"Lead time", "Date/Time", "Runtime", "Test time", "Serial",
                                 "Part(s) list", "Weight", "Std", "Min"}) {
    const PartList list = parts("Component," + head + ",Rack\nA,5,x\nB,2,y\n");
    EXPECT_THAT(costs(list), ElementsAre("none", "none")) << head;
    EXPECT_THAT(list.note, HasSubstr("no change costs")) << head;
    EXPECT_THAT(list.note, HasSubstr("not used: '" + head + "', 'Rack'")) << head;
  }
  // Times of which most are no numbers are when something was.
  EXPECT_THAT(costs(parts("Component,Time,Rack\nA,2024-05-01,1\nB,noon,2\n")),
              ElementsAre("none", "none"));
  EXPECT_THAT(complaint("Component,Time,Rack\nA,5,1\nB,2,2\nC,noon,2\n"),
              StartsWith("p.csv:4:3: 'noon' is not a cost"));
}

TEST(Spreadsheets, OneColumnOfSeveralIsTheBest) {
  const auto taken = [](const std::string& one, const std::string& other) {
    const std::string note = parts("part," + one + "," + other + "\nA,1,2\nB,1,2\n").note;
    return note.substr(note.find("costs in '") + 10,
                       note.find("';") - note.find("costs in '") - 10);
  };
  EXPECT_EQ(taken("Price", "Swap time (min)"), "Swap time (min)");
  EXPECT_EQ(taken("Time", "Cost"), "Cost");
  EXPECT_EQ(taken("Swap time", "Change cost"), "Change cost");
  EXPECT_EQ(taken("Cleaning time", "Time"), "Cleaning time");
  EXPECT_THAT(
      complaint("part,Time,Hours\nA,1,2\nB,1,2\n"),
      HasSubstr("'Time' and 'Hours' may both head the costs; say which with --cost-column"));
}

TEST(Spreadsheets, AColumnCanBeNamed) {
  const std::string text = "part,Time,Hours,n\nA,1,2,x\nB,3,4,y\n";
  EXPECT_THAT(costs(parts(text, {.cost_column = "hours"})), ElementsAre("2", "4"));
  EXPECT_EQ(parts(text, {.cost_column = "hours"}).unit, CostUnit::hours);
  EXPECT_THAT(costs(parts(text, {.cost_column = "-"})), ElementsAre("none", "none"));
  EXPECT_THAT(
      complaint(text, {.cost_column = "Price"}),
      StartsWith("p.csv:1:1: no column is called 'Price'; there are 'part', 'Time', 'Hours', 'n'"));
  EXPECT_THAT(complaint(text, {.cost_column = "part"}), HasSubstr("has the names, and no costs"));
  EXPECT_THAT(complaint(text, {.cost_column = "n"}), StartsWith("p.csv:2:7: 'x' is not a cost"));
  // A header whose words are not known is one if the column is named.
  EXPECT_THAT(parts("Was,Wieviel\nA,1\nB,2\n", {.cost_column = "Wieviel"}).names,
              ElementsAre("A", "B"));
}

TEST(Spreadsheets, TitlesAboveAndASumBelowAreNoParts) {
  const PartList list = parts(
      "Lab 3: inventory\n\nas of May\n\"#\",Model,Slot,Swap time (min)\n1,A,CPU,5\n2,B,,2\n3,C,CPU,4\n,Total,,11\n");
  EXPECT_THAT(list.names, ElementsAre("A", "B", "C"));
  EXPECT_THAT(list.slots, ElementsAre("CPU", "", "CPU"));
  EXPECT_EQ(
      list.note,
      "p.csv: row 4 is a header: names in 'Model', change costs in 'Swap time (min)', slots in "
      "'Slot'; not used: '#'; the last row, 'Total', is a sum and no part");
  // A part may be called so.
  EXPECT_THAT(parts("part,cost\nA,5\nB,2\nTotal,4\n").names, ElementsAre("A", "B", "Total"));
  EXPECT_THAT(parts("part,cost\nA,5\nSum:,5\nB,2\n").names, ElementsAre("A", "Sum:", "B"));
  // One column has no titles.
  EXPECT_THAT(complaint("A\nB\nC\n"), HasSubstr("read as { \"A\", \"B\", \"C\" }"));
}

TEST(Spreadsheets, NumbersOfRowsAreNoNames) {
  EXPECT_THAT(parts("\"#\",Typ,Cost\n1,X,2\n2,Y,3\n").names, ElementsAre("X", "Y"));
  EXPECT_THAT(parts("ID,Cost,Rack\n1,2,x\n2,3,y\n").names, ElementsAre("x", "y"));
  EXPECT_THAT(parts("ID,Cost\n7,2\n8,3\n").names, ElementsAre("7", "8"));
  EXPECT_THAT(parts("Part number,Part name,Cost\n1-1,X,2\n1-2,Y,3\n").names, ElementsAre("X", "Y"));
}

TEST(Spreadsheets, Quantities) {
  const PartList list = parts("part,Qty,cost\nA,4,1\nB,,2\nC,0,3\nD,1,4\n");
  EXPECT_THAT(list.names, ElementsAre("A", "B", "D"));
  EXPECT_THAT(list.quantities, ElementsAre(4U, 1U, 1U));
  EXPECT_THAT(list.note, HasSubstr("quantities in 'Qty'; left out, since there is none: 'C'"));
  EXPECT_THAT(parts("part,cost\nA,4\n").quantities, IsEmpty());
  EXPECT_THAT(complaint("part,Qty,cost\nA,some,1\n"),
              StartsWith("p.csv:2:3: 'some' is not a number of pieces"));
  EXPECT_THAT(complaint("part,Qty,cost\nA,1.5,1\n"), HasSubstr("is not a number of pieces"));
  EXPECT_THAT(complaint("part,Qty,cost\nA,-1,1\n"), HasSubstr("is not a number of pieces"));
  EXPECT_THAT(complaint("part,Qty,Count\nA,1,1\n"), HasSubstr("may both head the quantities"));
}

TEST(Spreadsheets, HeadingsOfQuantities) {
  for (const std::string head : {"how many",     "How many?",      "COUNT",
                                 "Count:",       "stock",          "In stock",
                                 "in_stock",     "InStock",        "QTY",
                                 "qty.",         "Qty (pcs.)",     "Number of pieces",
                                 "No. of units", "# pieces",       "Stock qty",
                                 "Qty on hand",  "Units in stock", "Wie viele?",
                                 "Anzahl",       "Lagerbestand",   "Cantidad",
                                 "個数"}) {
    const PartList list = parts("part," + head + "\nA,4\nB,2\n");
    EXPECT_THAT(list.quantities, ElementsAre(4U, 2U)) << head;
    EXPECT_THAT(costs(list), ElementsAre("none", "none")) << head;
    EXPECT_THAT(list.note, HasSubstr("no change costs, quantities in '" + head + "'"));
    EXPECT_THAT(parts("part,cost," + head + "\nA,1,4\nB,2,2\n").quantities, ElementsAre(4U, 2U));
  }
  // Others are not, and the note says so.
  for (const std::string head : {"Stock code", "Number of ports", "Minimum stock", "Reorder qty",
                                 "How many cores", "Counter"}) {
    const PartList list = parts("part,cost," + head + "\nA,1,4\nB,2,2\n");
    EXPECT_THAT(list.quantities, IsEmpty()) << head;
    EXPECT_THAT(list.note, HasSubstr("; not used: '" + head + "'"));
  }
}

TEST(Spreadsheets, NumbersWithSignsAndTimesOnAClock) {
  const PartList minutes = parts("part,Swap time\nA,15 min\nB,2.5min\nC,3\n");
  EXPECT_THAT(costs(minutes), ElementsAre("15", "2.50", "3"));
  EXPECT_EQ(minutes.unit, CostUnit::minutes);
  EXPECT_THAT(costs(parts("part;cost\nA;12,50 €\nB;€ 3\nC;4\n")), ElementsAre("12.50", "3", "4"));
  EXPECT_EQ(parts("part,cost\nA,$12\nB,$3\n").unit, CostUnit::none);
  const PartList clock = parts("part,Duration\nA,0:15\nB,1:05:30\nC,00:00:03\n");
  EXPECT_THAT(costs(clock), ElementsAre("15", "65.50", "0.05"));
  EXPECT_EQ(clock.unit, CostUnit::minutes);
  EXPECT_THAT(complaint("part,Duration\nA,0:15\nB,5\n"),
              StartsWith("p.csv:3:3: some costs are times as 0:15 and some are numbers"));
  EXPECT_THAT(complaint("part,Duration\nA,0:15\nB,0:00:07\n"),
              HasSubstr("not a decimal of minutes"));
  EXPECT_THAT(complaint("part,cost\nA,5 min\nB,2 h\n"),
              HasSubstr("some costs are in 'min' and some in 'h'"));
  EXPECT_THAT(complaint("part,cost\nA,5 €\nB,2 $\n"),
              HasSubstr("some costs are in '€' and some in '$'"));
  EXPECT_THAT(complaint("part,cost\nA,5 kg\n"), HasSubstr("'5 kg' is not a cost"));
  EXPECT_THAT(complaint("part,cost\nA,0:75\nB,1\n"), HasSubstr("'0:75' is not a cost"));
}

// What is read is never something that is not written there: names are texts of the list, costs are
// numbers of it.
RC_GTEST_PROP(SpreadsheetsProperty, DamagedListsAreRefusedOrHoldTheirTexts,
              (const test::Damage& damage)) {
  const std::string good =
      "Inventory of lab 3\n#,Component,Slot,Swap time (min),Qty,Vendor\n1,Xeon,CPU,5 min,1,x\n2,Epyc,CPU,4 min,2,y\n"
      "3,E810,NIC,2.5 min,4,z\n,Total,,11.50,,\n";
  const std::string bad = damage.of(good);
  PartList list;
  if (test::accepted("p.csv:", [&] { list = parts(bad); })) {
    RC_ASSERT(!list.names.empty());
    RC_ASSERT(list.change_costs.size() == list.names.size());
    RC_ASSERT((list.slots.empty() || list.slots.size() == list.names.size()));
    RC_ASSERT((list.quantities.empty() || list.quantities.size() == list.names.size()));
    for (const std::string& name : list.names) {
      RC_ASSERT((bad.find(name) != std::string::npos || bad.find('"') != std::string::npos));
    }
  }
}

TEST(Spreadsheets, PairsHaveHeadersAndReasons) {
  const std::vector<std::string> names{"Xeon", "Epyc", "RAID", "4"};
  PairReasons why;
  const auto pairs = [&](const std::string& text) -> std::string {
    why = {};
    try {
      return std::to_string(read_pairs(*input_from_text(text, "n.csv"), names, &why).size());
    } catch (const BadInput& fault) {
      return fault.what();
    }
  };
  for (const std::string head : {"Part A,Part B,Why", "part,not with,reason", "A,B,comment",
                                 "Component 1,Component 2,Notes", "Model,Model 2,x"}) {
    EXPECT_EQ(pairs(head + "\nXeon,RAID,\"no driver, yet\"\nEpyc,RAID,\n"), "2") << head;
    EXPECT_EQ(why(0, 2), "no driver, yet") << head;
    EXPECT_EQ(why(1, 2), "");
  }
  EXPECT_EQ(pairs("Xeon,RAID,no driver\n"), "1");
  EXPECT_EQ(why(2, 0), "no driver");
  EXPECT_EQ(pairs("why,part,part 2,day\nheat,Xeon,Epyc,4\n"), "1");
  EXPECT_EQ(why(0, 1), "heat");
  EXPECT_THAT(pairs("Xeon,RAID,Epyc\n"), StartsWith("n.csv:1:1: more than two parts"));
  EXPECT_THAT(pairs("Xeon,RAID,4\n"), StartsWith("n.csv:1:1: more than two parts"));
  EXPECT_EQ(pairs("part 1,part 2,why\nXeon,RAID,4\n"), "1") << "below a header it is a reason";
  EXPECT_THAT(pairs("Xeon,RAID,a,b\n"), StartsWith("n.csv:1:1: more than two parts"));
  EXPECT_THAT(pairs("Xeom,RAID,why\n"), StartsWith("n.csv:1:1: there is no part 'Xeom'"));
  EXPECT_THAT(pairs("part 1,part 2\nXeon,RAID,late\n"), StartsWith("n.csv:2:11: more fields"));
}

TEST(Spreadsheets, SlotsAreKnownByTheirNames) {
  const PartListOptions known{.slots = {"CPU", "NIC"}};
  const std::string text = "Component,Kind,Rack,Swap time (min)\nXeon,CPU,NIC,5\nE810,NIC,4,2\n";
  const PartList list = parts(text, known);
  EXPECT_THAT(list.slots, ElementsAre("CPU", "NIC"));
  EXPECT_THAT(list.note, HasSubstr("slots in 'Kind'; not used: 'Rack'"));
  EXPECT_THAT(parts(text).slots, IsEmpty());
  EXPECT_THAT(parts(text, {.slots = {"CPU"}}).slots, IsEmpty()) << "one of two is no evidence";
  EXPECT_THAT(parts("Component,Kind\nXeon,CPU\nEpyc,CPU\nE810,NIC\n", {.slots = {"CPU"}}).slots,
              ElementsAre("CPU", "CPU", "NIC"))
      << "so that the slot without limits is named";
  EXPECT_THAT(parts("Component,Kind\nXeon,CPU\nBoard,\nE810,NIC\n", known).slots,
              ElementsAre("CPU", "", "NIC"));
  // A column that says so wins, and so does one of names.
  EXPECT_THAT(parts("Slot,Kind,Part\nCPU,NIC,Xeon\nNIC,CPU,E810\n", known).slots,
              ElementsAre("CPU", "NIC"));
  EXPECT_THAT(parts("part,type\nCPU,NIC\nNIC,CPU\n", known).names, ElementsAre("CPU", "NIC"));
  EXPECT_THAT(complaint("Component,Kind,Type\nXeon,CPU,CPU\nE810,NIC,NIC\n", known),
              HasSubstr("'Kind' and 'Type' may both head the slots; call one of them slot"));
}

TEST(Spreadsheets, PrioritiesHaveHeaders) {
  const std::vector<std::string> names{"A", "B", "C"};
  const auto weight = [&](const std::string& text) -> std::string {
    try {
      return to_string(read_priorities(*input_from_text(text, "w.csv"), names)(0, 1));
    } catch (const BadInput& fault) {
      return fault.what();
    }
  };
  EXPECT_EQ(weight("part 1,part 2,priority\nA,B,5\n"), "5");
  EXPECT_EQ(weight("part,with,points\nA,B,5\n"), "5");
  EXPECT_EQ(weight("weight,first,second\n2.5,A,B\n"), "2.50");
  EXPECT_THAT(weight("part 1,part 2,priority\nA,B,high\n"),
              StartsWith("w.csv:2:5: 'high' is not a weight"));
  EXPECT_THAT(weight("part 1,part 2,priority\nA,B\n"),
              StartsWith("w.csv:2:3: 'B' is not a weight"));
}

TEST(Spreadsheets, SlotsHaveHeaders) {
  const auto slots = [](const std::string& text) -> std::string {
    try {
      std::string all;
      for (const Slot& slot : read_slots(*input_from_text(text, "s.csv"))) {
        all += slot.name + " " + std::to_string(slot.least) + ".." +
               (slot.most == Slot{}.most ? "" : std::to_string(slot.most)) + ";";
      }
      return all;
    } catch (const BadInput& fault) {
      return fault.what();
    }
  };
  EXPECT_EQ(slots("Slot,Min,Max\nCPU,1,1\nNIC,,2\nfan,1,\n"), "CPU 1..1;NIC 0..2;fan 1..;");
  EXPECT_EQ(slots("Max,Type,Min\n4,DIMM,2\n"), "DIMM 2..4;");
  EXPECT_EQ(slots("slot,quantity\nCPU,1\nDIMM,4\n"), "CPU 1..1;DIMM 4..4;");
  EXPECT_EQ(slots("Slot,from,to,remark\nCPU,1,2,both sockets\n"), "CPU 1..2;");
  EXPECT_EQ(slots("CPU,1,1\n"), "CPU 1..1;");
  EXPECT_EQ(slots("Min,1,1\n"), "Min 1..1;") << "it has numbers, so it is no header";
  EXPECT_THAT(slots("Slot,Min,Max\nCPU,x,1\n"),
              StartsWith("s.csv:2:5: 'x' is not a number of parts"));
  EXPECT_THAT(slots("Slot,Min,Max\nCPU,2,1\n"), HasSubstr("at least 2 and at most 1"));
  EXPECT_THAT(slots("Slot,Min,Max\n,2,1\n"), HasSubstr("expected a slot with its least"));
  EXPECT_THAT(slots("Slot,Least,Most\n"), HasSubstr("no slot is listed"));
}

}  // namespace
}  // namespace changeover::spreadsheets_test
