// What a first row is, and how fields are split.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "changeover/plan/job.hpp"
#include "plan/job/parts/part_columns.hpp"

namespace changeover::part_columns_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

PartList parts(const std::string& text, Header header = Header::guessed) {
  return read_parts(*input_from_text(text, "p.csv"), header);
}

std::string complaint(const std::string& text, Header header = Header::guessed) {
  try {
    return "read as " + testing::PrintToString(parts(text, header).names);
  } catch (const BadInput& fault) {
    return fault.what();
  }
}

TEST(PartColumns, AHeaderIsToldByItsCosts) {
  const PartList wines = parts("wine,price\nRiesling,9.50\nMerlot,11\n");
  EXPECT_THAT(wines.names, ElementsAre("Riesling", "Merlot"));
  EXPECT_EQ(wines.change_costs[0], parse_amount("9.5"));
  EXPECT_THAT(wines.note, HasSubstr("names in 'wine', change costs in 'price'"));
  EXPECT_THAT(parts("Was,Wieviel\nA,1\n", Header::given).names, ElementsAre("A"));
  EXPECT_EQ(parts("Was,Wieviel\nA,1\n", Header::given).change_costs[0], parse_amount("1"));
  EXPECT_THAT(parts("Sample\nA\nB\nC\n").names, ElementsAre("A", "B", "C"));
  EXPECT_THAT(parts("A,1\nB\n").names, ElementsAre("A", "B"));
  EXPECT_THAT(parts("A,1\nB\n").note, IsEmpty());
  EXPECT_THAT(parts("name,5\nB,2\n").names, ElementsAre("name", "B")) << "no header has a cost";
}

TEST(PartColumns, TwoColumnsForOneThingAreRefused) {
  EXPECT_THAT(complaint("name,price,cost\nA,1,2\nB,1,2\n"),
              AllOf(StartsWith("p.csv:1:12: "), HasSubstr("'price' and 'cost' may both")));
  EXPECT_THAT(complaint("part,cost,slot,slots\nA,1,x,y\nB,1,x,y\n"), HasSubstr("head the slots"));
  EXPECT_THAT(parts("name,price,change cost\nA,1,2\nB,1,2\n").note,
              HasSubstr("change costs in 'change cost'"));
}

TEST(PartColumns, WhatMayBeEitherIsRefused) {
  for (const char* text : {"tool,weight\nA\nB\n", "crate\nA,1\nB,2\n", "crate\nA\nB\n",
                           "crate\nX1\nX22\n", "beer\nHelles\nPils\n"}) {
    EXPECT_THAT(complaint(text), AllOf(StartsWith("p.csv:1:1: "), HasSubstr("--no-header")))
        << text;
  }
  // What stands for no number is not the name of a column.
  EXPECT_THAT(complaint("Pump;n/a\nValve;3\nHose;2\n"), StartsWith("p.csv:1:6: 'n/a' is not"));
  EXPECT_THAT(parts("crate\nA\nB\n", Header::none).names, ElementsAre("crate", "A", "B"));
  EXPECT_THAT(parts("crate\nA\nB\n", Header::given).names, ElementsAre("A", "B"));
  EXPECT_THAT(parts("name\nA\nB\n", Header::none).names, ElementsAre("name", "A", "B"));
  EXPECT_THAT(complaint("crate\n", Header::given), HasSubstr("no part is listed"));
  EXPECT_THAT(parts("Helles\nPils\n").note, HasSubstr("no header: 'Helles' is the first part"));
}

TEST(PartColumns, ARunSheetIsNoListOfParts) {
  EXPECT_THAT(complaint("step,take_out,put_in,slot_1,slot_2,new_pairs,cost,cost_so_far\n"
                        "1,,\"A, B\",A,B,1,3,3\n"),
              HasSubstr("this is a run sheet"));
}

TEST(PartColumns, SeparatorsAndDecimalCommas) {
  const PartList semicolons = parts("Teil;Kosten\nA;9,00\nB;2,5\n\"C;x\";3\n");
  EXPECT_THAT(semicolons.names, ElementsAre("A", "B", "C;x"));
  EXPECT_EQ(semicolons.change_costs[0], parse_amount("9"));
  EXPECT_EQ(semicolons.change_costs[1], parse_amount("2.5"));
  const PartList tabs = parts("A x\t0,125\nB\t2\n");
  EXPECT_THAT(tabs.names, ElementsAre("A x", "B"));
}

TEST(PartColumns, WordsOfCostsAreWholeWords) {
  for (const std::string heads : {"cost", "Costs", "unit_cost", "changeCost", "unitprice",
                                  "Preis (EUR)", "in EUR", "price/EUR", "Umbaukosten", "Stückpreis",
                                  "coût", "Prix unitaire", "precio", "preço", "€", "USD"}) {
    EXPECT_TRUE(heads_costs(heads)) << heads;
  }
  for (const std::string other :
       {"Europe", "neuron", "precision", "Precinct", "Costa Rica", "caprice", "accosted",
        "priceless", "amateur", "usdx", "kostenlos", "Preisklasse", ""}) {
    EXPECT_FALSE(heads_costs(other)) << other;
  }
  // A column that begins like a word of costs is not one, and "exchange" is no change.
  EXPECT_THAT(parts("part,Europe,US\nA,1,2\nB,3,4\n").change_costs,
              ElementsAre(std::nullopt, std::nullopt));
  EXPECT_THAT(parts("part,Europe,cost\nA,x,2\nB,y,4\n").change_costs,
              ElementsAre(parse_amount("2"), parse_amount("4")));
  EXPECT_THAT(complaint("part,exchange price,cost\nA,1,2\n"), HasSubstr("may both head the costs"));
}

TEST(PartColumns, ASeparatorMayComeLate) {
  EXPECT_THAT(parts("A\nB\nC;4,5\n").names, ElementsAre("A", "B", "C"));
  EXPECT_THAT(complaint("Sample\nA;3\nB;4,5\n"), StartsWith("p.csv:2:3: more fields than the 1"));
  EXPECT_THAT(complaint("A,1\nB;2\n"), HasSubstr("'B;2' has a separator in it"));
  EXPECT_THAT(complaint("A;1\nB,2\n"), HasSubstr("'B,2' has a separator in it"));
  EXPECT_THAT(parts("A,1\n\"B;2\",2\n").names, ElementsAre("A", "B;2"));
  EXPECT_THAT(parts("A\t,1\nB,\t2\n").names, ElementsAre("A", "B"));
}

TEST(PartColumns, NoCostIsReadInTwoWays) {
  EXPECT_THAT(complaint("A;1,000\n"), HasSubstr("write 1000 or 1.0000"));
  EXPECT_THAT(complaint("A;12,500\n"), HasSubstr("may be thousands"));
  EXPECT_THAT(complaint("A;1,50\nB;1.50\n"), StartsWith("p.csv:2:3: some costs have"));
  EXPECT_THAT(complaint("A;1.000,50\n"), HasSubstr("is not a cost"));
  EXPECT_THAT(complaint("A;1,5,0\n"), HasSubstr("is not a cost"));
  EXPECT_THAT(complaint("A,9,00\n"), HasSubstr("a third field"));
  EXPECT_THAT(complaint("part,cost\nA,9,50\n"), StartsWith("p.csv:2:5: more fields than the 2"));
}

TEST(PartColumns, ColumnsForSlots) {
  const PartList list = parts("slot,part,cost\nCPU,A,1\nPSU,B,2\n,C,3\n");
  EXPECT_THAT(list.names, ElementsAre("A", "B", "C"));
  EXPECT_THAT(list.slots, ElementsAre("CPU", "PSU", ""));
  EXPECT_THAT(parts("part,cost\nA,1\n").slots, IsEmpty());
  EXPECT_THAT(parts("part,slot\nA,CPU\nB,PSU\n").change_costs,
              ElementsAre(std::nullopt, std::nullopt));
}

TEST(PartColumns, PairsHaveAHeaderOnlyIfItNamesNoPart) {
  const std::vector<std::string> names{"A", "B", "From"};
  const auto pairs = [&](const std::string& text) -> std::string {
    try {
      return std::to_string(read_pairs(*input_from_text(text, "n.csv"), names).size());
    } catch (const BadInput& fault) {
      return fault.what();
    }
  };
  EXPECT_EQ(pairs("part 1,part 2\nA,B\n"), "1");
  EXPECT_EQ(pairs("first\tsecond\nA\tB\n"), "1");
  EXPECT_EQ(pairs("component;component2\nA;B\n"), "1");
  EXPECT_THAT(pairs("from,to\nA,B\n"), HasSubstr("there is no part 'from'; did you mean 'From'"));
  EXPECT_THAT(pairs("Aa,Bb\nA,B\n"), StartsWith("n.csv:1:1: there is no part 'Aa'"));
  EXPECT_THAT(pairs("A,B\npart 1,part 2\n"), StartsWith("n.csv:2:1: "));
}

}  // namespace
}  // namespace changeover::part_columns_test
