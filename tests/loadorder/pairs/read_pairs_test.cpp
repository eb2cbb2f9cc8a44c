// Files of pairs: numbers, names, headers, and what is wrong with them in one line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <set>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/wanted_pairs.hpp"
#include "message_of.hpp"

namespace changeover::test::read_pairs_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::shared_ptr<const PairGraph> read(const std::string& text,
                                      const PairFileOptions& options = {}) {
  return read_pairs(*input_from_text(text, "f"), options);
}

std::string fault(const std::string& text, const PairFileOptions& options = {}) {
  try {
    static_cast<void>(read(text, options));
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

TEST(ReadPairs, AByteOrderMarkIsNoPartOfAnItem) {
  const auto graph = read(
      "\xEF\xBB\xBF"
      "1 2\n2 3\n1 3\n");
  EXPECT_EQ(graph->items(), 4U);  // 0 is one of them, in no pair
}

// A pair whose cost is missing is no row of titles.
TEST(ReadPairs, AFirstRowIsOnlyTitlesWhereNoPairIsLost) {
  std::vector<std::string> notes;
  std::function<double(Element, Element)> costs;
  const auto pairs = [&](std::string text) {
    notes.clear();
    const auto input = input_from_text(std::move(text), "f");
    return read_pairs(*input, {.costs = &costs, .no_costs = "", .notes = &notes})->pairs();
  };
  const auto why_not = [&](const std::string& text) {
    try {
      return "pairs: " + std::to_string(pairs(text));
    } catch (const BadInput& bad) {
      return std::string(bad.what());
    }
  };
  for (const std::string word : {"nan", "NaN", "inf", "Infinity", "NA", "none", "null"}) {
    EXPECT_EQ(why_not("a b " + word + "\nb c 3\n"),
              "f:1:5: '" + word + "' is not a cost; give a number, 0 or more");
  }
  EXPECT_EQ(why_not("a b cost\nb c 3\n"),
            "f:1:5: 'cost' is not a cost, and 'b' is an item of later rows; write the cost of the "
            "pair, or begin the line with # if it names columns");
  EXPECT_EQ(pairs("from to cost\na b 2\nb c 3\n"), 2U);
  EXPECT_EQ(notes, std::vector<std::string>{
                       "f:1:1: the first row was read as names of columns: from, to, cost"});
  EXPECT_EQ(pairs("from to\n0 1\n1 2\n"), 2U);
  EXPECT_EQ(notes, std::vector<std::string>{
                       "f:1:1: the first row was read as names of columns: from, to"});
  EXPECT_EQ(pairs("NA nan\n0 1\n1 2\n"), 3U);
  EXPECT_EQ(notes,
            std::vector<std::string>{"f:1:1: the first row was read as a pair of items: NA, nan"});
  EXPECT_EQ(pairs("source,na\n1,2\n2,3\n"), 3U);
  EXPECT_EQ(notes, std::vector<std::string>{
                       "f:1:1: the first row was read as a pair of items: source, na"});
  EXPECT_EQ(pairs("source,na\na,b\n"), 2U);  // words below words are nothing special
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(why_not("from to\n0 1\n1 c\n"),
            "f:1:1: words above numbers name columns, but names of items come further down; begin "
            "the line with # if it names columns, or write it further down if it is a pair");
  EXPECT_EQ(pairs("a b\nc d\n"), 2U);
  EXPECT_TRUE(notes.empty());
}

TEST(ReadPairs, NumbersAreItemsAndEachPairCountsOnce) {
  const auto graph = read("# a comment\n0 3\r\n3,0\n% another\n\n1;\t2\n5 5\n3 1");
  EXPECT_EQ(graph->items(), 6U);
  EXPECT_EQ(graph->pairs(), 3U);
  EXPECT_THAT(graph->partners(3), ElementsAre(0, 1));
  EXPECT_TRUE(graph->is_needed(5));
  EXPECT_FALSE(graph->is_needed(4));
  EXPECT_TRUE(graph->names().empty());
  EXPECT_TRUE(graph->place(1, 3).has_value());
  EXPECT_EQ(graph->place(1, 3), graph->place(3, 1));
  EXPECT_FALSE(graph->place(1, 0).has_value());
  EXPECT_EQ(read("0 1\n", {.items = 7})->items(), 7U);
}

TEST(ReadPairs, OneWordMakesNamesOfAll) {
  const auto graph = read("7 8\n8 x\nx 7\nx7 7\n");
  EXPECT_THAT(graph->names(), ElementsAre("7", "8", "x", "x7"));
  EXPECT_EQ(graph->pairs(), 4U);
  EXPECT_EQ(read("a b")->names().size(), 2U);
  EXPECT_EQ(read("12345678901 1")->names().size(), 2U);  // too large for the number of an item
}

TEST(ReadPairs, WordsOverNumbersAreColumns) {
  EXPECT_TRUE(read("from,to\n0,1\n")->names().empty());
  EXPECT_EQ(read("from,to\n0,1\n")->pairs(), 1U);
  EXPECT_THAT(read("from,to\na,b\n")->names(), ElementsAre("from", "to", "a", "b"));
  EXPECT_THAT(read("a 1\n2 3\n")->names(), ElementsAre("a", "1", "2", "3"));
}

TEST(ReadPairs, ANumberIsWrittenInOneWay) {
  const std::string mend = "is not written like the whole numbers before it; write 1, or begin";
  for (const std::string word : {"01", "1.0", "+1", "1.", "0001.000"}) {
    EXPECT_THAT(fault("0 1\n2 " + word + "\n"), HasSubstr("f:2:3: '" + word + "' " + mend));
  }
  EXPECT_THAT(fault("0 1\n2 -1\n2 00\n"), HasSubstr("f:3:3: '0' and '00' are one number"));
  EXPECT_THAT(fault("0 1\n2 1.50\n"), HasSubstr("write 1.5, or"));
  EXPECT_EQ(fault("01 02\n1 2\n"),
            "f:2:1: '01' and '1' are one number and two names; write it in one way");
  EXPECT_THAT(fault("a 1\nb 1.0\n"), HasSubstr("f:2:3: '1' and '1.0' are one number"));
  // Names of equally many digits, large numbers, dates: none of them is another one.
  EXPECT_THAT(read("001 002\n002 100\n")->names(), ElementsAre("001", "002", "100"));
  EXPECT_THAT(read("1 10000000\n")->names(), ElementsAre("1", "10000000"));
  EXPECT_THAT(read("2.5.1 2.5\n1.2.3 .5\n- 1e3\n")->names(),
              ElementsAre("2.5.1", "2.5", "1.2.3", ".5", "-", "1e3"));
}

TEST(ReadPairs, ANameHasNoCharacterThatIsNotSeen) {
  const std::string sharp =
      "f:2:3: the name 'b\xE2\x80\x8B' has a character that cannot be seen, U+200B; remove it";
  EXPECT_EQ(fault("a b\na b\xE2\x80\x8B\n"), sharp);
  EXPECT_THAT(fault("a b\xC2\xA0\n"), HasSubstr("U+00A0"));
  EXPECT_THAT(fault("a \xF3\xA0\x84\x80z\n"), HasSubstr("U+E0100"));
  EXPECT_THAT(read("\xC3\xA9 \xE4\xB8\xAD\n\xF0\x9F\x98\x80 e\n")->names(),
              ElementsAre("\xC3\xA9", "\xE4\xB8\xAD", "\xF0\x9F\x98\x80", "e"));
}

TEST(ReadPairs, LinesAreReadTheSameHoweverTheyAreWritten) {
  const auto plain = read("0 1\n9999999 12\n12 0\n7 7\n");
  const auto other = read("# first\n0  1\n9999999\t12 \n;12,0\n 7;7\r\n");
  EXPECT_EQ(WantedPairs::listed(plain).hash(), WantedPairs::listed(other).hash());
  EXPECT_EQ(plain->items(), 10'000'000U);
  EXPECT_THAT(fault("0 1\n0 10000000\n1\n"), HasSubstr("f:3:1: one item"));
  EXPECT_THAT(fault("0 1\n5 9\n", {.items = 9}),
              HasSubstr("f:2:3: item 9 does not exist; items are 0 to 8"));
}

TEST(ReadPairs, AreCsvIfTheyAreWrittenSo) {
  const std::vector<std::string> names{"cam 0/x.JPG", "b"};
  for (const std::string text :
       {"\"cam 0/x.JPG\",\"b\"\n", "cam 0/x.JPG,b\n", "cam 0/x.JPG;b\n", "cam 0/x.JPG\tb\n",
        "\"cam 0/x.JPG\" b\n", "\"cam 0/x.JPG\"\tb \r\n", " \"cam 0/x.JPG\" , b ,\n",
        "\xEF\xBB\xBF\"cam 0/x.JPG\",b\n"}) {
    EXPECT_EQ(read(text)->names(), names) << text;
    EXPECT_EQ(read("# a comment\n" + text.substr(text[0] == '\xEF' ? 3 : 0))->names(), names)
        << text;
  }
  EXPECT_THAT(read("b \"say \"\"x, y\"\"\"\n")->names(), ElementsAre("b", "say \"x, y\""));
  EXPECT_THAT(read("\"#1\",\"%\"\n")->names(), ElementsAre("#1", "%"));
  EXPECT_THAT(read("5\" disk,b\n")->names(), ElementsAre("5\" disk", "b"));
  EXPECT_TRUE(read("from,to\n\"0\",\"1\"\n\"2\";\"0\"\n")->names().empty());
  EXPECT_THAT(read("\"0 1\",2\n")->names(), ElementsAre("0 1", "2"));
  EXPECT_EQ(
      fault("0 1\t2\n"),
      "f:1:1: '0 1' is more than one number; give two items per line, or put it in quotes if it is "
      "a name");
  EXPECT_THAT(fault("a,b\n0 1,0.5\n"), HasSubstr("f:2:1: '0 1' is more than one number"));
  EXPECT_THAT(fault("a,b\n\"c,d\n"), HasSubstr("f:2:1: a quote is opened and not closed"));
  EXPECT_THAT(fault("a,b\n\"c\"d,e\n"), HasSubstr("f:2:4: text after a closing quote"));
  EXPECT_THAT(fault("a,b\n\"\",e\n"), HasSubstr("f:2:4: one item stands alone"));
  EXPECT_THAT(fault("a,b\ncam 0 x\n"), HasSubstr("f:2:7: more than two items"));
}

TEST(ReadPairs, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(fault(""), HasSubstr("f: no pair is listed"));
  EXPECT_THAT(fault("# 1 2\n"), HasSubstr("no pair is listed"));
  EXPECT_THAT(fault("0 1\n2\n"), HasSubstr("f:2:1: one item stands alone"));
  EXPECT_THAT(fault("0 1 0.5\n"), HasSubstr("f:1:5: more than two items"));
  EXPECT_THAT(fault("0 1\n0 9\n", {.items = 9}),
              HasSubstr("f:2:3: item 9 does not exist; items are 0 to 8"));
  EXPECT_THAT(fault("a b\nc d\n", {.items = 3}), HasSubstr("f:2:3: 'd' is one name more"));
  EXPECT_THAT(fault("a b\na \x01z\n"), HasSubstr("f:2:3: control byte 0x01"));
  EXPECT_THAT(fault("a " + std::string(300, 'b')), HasSubstr("f:1:3: a name of more than 255"));
  EXPECT_THAT(fault("0 1", {.items = 0}), HasSubstr("give 1 to"));
  EXPECT_THAT(fault("0 1\n" + std::string(3 << 20, 'x')), HasSubstr("f:2:1: a line of more"));
  EXPECT_THROW(PairGraph(2, std::vector<ItemPair>{{0, 2}}), BadInput);
  EXPECT_REFUSAL(PairGraph(2, std::vector<ItemPair>{{0, 1}}, {"a"}), BadInput,
                 "1 name for 2 items; give all or none");
  EXPECT_THROW(read_pairs("no/such/file"), MissingResource);
}

TEST(ReadPairs, AllPairsWithinAGroupAreWanted) {
  const auto graph = read("# clusters\n0 3 5\r\n3;4\n% none\n7\n2 2\n5,3,0\n", {.groups = true});
  EXPECT_EQ(graph->items(), 8U);
  EXPECT_EQ(graph->pairs(), 4U);
  EXPECT_THAT(graph->partners(3), ElementsAre(0, 4, 5));
  EXPECT_FALSE(graph->is_needed(7));  // alone
  EXPECT_TRUE(graph->is_needed(2));   // with itself
  EXPECT_TRUE(graph->names().empty());
  EXPECT_THAT(read("a b \"c d\"\nb,x y,a\n", {.groups = true})->names(),
              ElementsAre("a", "b", "c d", "x y"));
  EXPECT_THAT(read("0 1 2\n3 x 0\n", {.groups = true})->names(),
              ElementsAre("0", "1", "2", "3", "x"));
  EXPECT_THAT(fault("query first second\n0 1 2\n", {.groups = true}),
              HasSubstr("f: words in the first line, numbers below; begin the line with #"));
  EXPECT_EQ(read("0 1 2\n", {.items = 9, .groups = true})->items(), 9U);
}

// Against every pair of every row.
TEST(ReadPairs, GroupsAreTheUnionOfTheirPairs) {
  std::mt19937_64 random(5);
  for (int round = 0; round < 300; ++round) {
    const std::uint64_t items = 2 + random() % 12;
    std::set<ItemPair> wanted;
    std::string text = "0 1\n";
    wanted.emplace(0, 1);
    for (std::uint64_t line = random() % 6; line > 0; --line) {
      std::vector<Element> group;
      for (std::uint64_t i = 1 + random() % 5; i > 0; --i) {
        group.push_back(static_cast<Element>(random() % items));
        text += (i % 3 == 0 ? " " : "  ") + std::to_string(group.back());
      }
      text += '\n';
      for (const Element x : group) {
        for (const Element y : group) {
          if (x < y) {
            wanted.emplace(x, y);
          }
        }
      }
    }
    const auto graph = read(text, {.items = items, .groups = true});
    EXPECT_EQ(graph->pairs(), wanted.size()) << text;
    for (const auto& [x, y] : wanted) {
      EXPECT_TRUE(graph->place(x, y).has_value()) << text;
    }
  }
}

TEST(ReadPairs, AGroupThatCannotBeIsRefusedWithItsPlace) {
  const PairFileOptions groups{.groups = true};
  EXPECT_EQ(fault("1\n2\n", groups), "f: no pair is in a group; give two items or more per line");
  EXPECT_THAT(fault("0 1 2\n1 03\n", groups), HasSubstr("f:2:3: '03' is not written like"));
  EXPECT_THAT(fault("0 1 2\n1 9 3\n", {.items = 4, .groups = true}),
              HasSubstr("f:2:3: item 9 does not exist; items are 0 to 3"));
  EXPECT_THAT(fault("a b\nc d\n", {.items = 3, .groups = true}), HasSubstr("f:2:3: 'd' is one"));
  EXPECT_THAT(fault("0 1,2\n", groups), HasSubstr("'0 1' is more than one number"));
  std::string all;
  for (int i = 0; i < 50'000; ++i) {
    all += std::to_string(i) + ' ';
  }
  EXPECT_THAT(fault("0 1\n" + all, groups),
              HasSubstr("f:2:1: with this group more than 1073741824 pairs"));
}

TEST(ReadPairs, AThirdColumnIsWhatAPairCosts) {
  std::function<double(Element, Element)> cost;
  const PairFileOptions costs{.costs = &cost};
  const auto numbers = read("0 1 2.5\n2 0 0\n1 0 2.5\n", costs);
  EXPECT_TRUE(numbers->names().empty());  // a cost with a point makes no names of numbers
  EXPECT_EQ(numbers->pairs(), 2U);
  ASSERT_TRUE(cost);
  EXPECT_EQ(cost(0, 1), 2.5);
  EXPECT_EQ(cost(2, 0), 0);
  const auto named = read("from,to,seconds\nx,y,3\n\"a b\",x,1e2\n", costs);
  EXPECT_THAT(named->names(), ElementsAre("x", "y", "a b"));
  EXPECT_EQ(cost(0, 2), 100);
  EXPECT_EQ(read("from to cost\n0 1 7\n", costs)->pairs(), 1U);
  EXPECT_EQ(cost(0, 1), 7);
  EXPECT_THAT(read("x y 7\n0 1 8\n", costs)->names(), ElementsAre("x", "y", "0", "1"));
  EXPECT_EQ(cost(1, 0), 7);
  cost = nullptr;
  EXPECT_EQ(read("0 1\n1 2\n", costs)->pairs(), 2U);
  EXPECT_FALSE(cost);

  const std::string mend = "; give one to every pair or to none";
  EXPECT_EQ(fault("0 1 2\n1 2\n", costs), "f:2:3: the pairs before have a cost each" + mend);
  EXPECT_EQ(fault("0 1\n1 2 5\n", costs), "f:2:5: the pairs before have no cost" + mend);
  EXPECT_EQ(fault("0 1 2\n0 2 1\n1 0 3\n", costs),
            "f: the pair of '1' and '0' has two costs, 2 and 3; keep one of the two");
  for (const std::string wrong : {"1e", "x5", "0x10", "-", "n/a", "\"12 min\"", "\"1,5\""}) {
    EXPECT_THAT(fault("a,b," + wrong + "\nc,d,2\n", costs), HasSubstr("f:1:5: ")) << wrong;
  }
  EXPECT_EQ(read("from,to,cost (s)\nx,y,3\n", costs)->pairs(), 1U);
  EXPECT_EQ(fault("0 1 x\n", costs), "f:1:5: 'x' is not a cost; give a number, 0 or more");
  EXPECT_EQ(fault("0 1 -2\n", costs), "f:1:5: '-2' is not a cost; give a number, 0 or more");
  EXPECT_THAT(fault("0 1 1e101\n", costs), HasSubstr("f:1:5: '1e101' is too much for a cost"));
  EXPECT_THAT(fault("a a 1\n", costs), HasSubstr("f:1:3: 'a' is both items"));
  EXPECT_THAT(fault("0 1 2 3\n", costs), HasSubstr("f:1:5: more than two items"));
  EXPECT_EQ(fault("0 1 2\n", {.no_costs = "; reason"}),
            "f:1:5: more than two items; give two per line, and names with blanks in quotes; "
            "reason");
}

}  // namespace
}  // namespace changeover::test::read_pairs_test
