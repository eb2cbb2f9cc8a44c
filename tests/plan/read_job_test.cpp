#include "changeover/plan/read_job.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "changeover/core/error.hpp"

namespace changeover {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

PartList parts(const std::string& text) { return read_parts(*input_from_text(text, "parts.csv")); }

template <typename Read>
std::string complaint(Read&& read) {
  try {
    read();
  } catch (const BadInput& fault) {
    return fault.what();
  }
  return "no complaint";
}

const std::vector<std::string> names{"Pump A", "Valve, large", "Motor", "2", "say \"hi\""};

TEST(ReadParts, TakesNamesWithAndWithoutCosts) {
  const PartList list =
      parts("\xEF\xBB\xBF# bench\nPump A, 12.50\r\n\n\"Valve, large\",8\nMotor\n");
  EXPECT_THAT(list.names, ElementsAre("Pump A", "Valve, large", "Motor"));
  EXPECT_EQ(list.change_costs[0], parse_amount("12.5"));
  EXPECT_EQ(list.change_costs[1], parse_amount("8"));
  EXPECT_EQ(list.change_costs[2], std::nullopt);
}

TEST(ReadParts, FindsColumnsByTheirNames) {
  const PartList list =
      parts("id;component;weight;change cost\n7;Pump;3 kg;1.25\n8;Motor;9 kg;2\n");
  EXPECT_THAT(list.names, ElementsAre("Pump", "Motor"));
  EXPECT_EQ(list.change_costs[1], parse_amount("2"));
  EXPECT_THAT(parts("name\nA\nB\n").names, ElementsAre("A", "B"));
  EXPECT_THAT(parts("Bauteil,Kosten\nA,1\n").names, ElementsAre("A"));
  EXPECT_THAT(parts("A,1\nB,2\n").names, ElementsAre("A", "B"));
}

TEST(ReadParts, SaysWhereItIsWrong) {
  const auto says = [](const std::string& text) { return complaint([&] { (void)parts(text); }); };
  EXPECT_THAT(says("A,1\nB,x2\n"), StartsWith("parts.csv:2:3: 'x2' is not a cost"));
  EXPECT_THAT(says("A,1\nB,-2\n"), StartsWith("parts.csv:2:3: the cost '-2' is negative"));
  EXPECT_THAT(says("A,1\nB,2\nA,3\n"), StartsWith("parts.csv:3:1: a second part is called 'A'"));
  EXPECT_THAT(says("A,1\n,2\n"), StartsWith("parts.csv:2:1: a row without a name"));
  EXPECT_THAT(says("A,1,5\n"), StartsWith("parts.csv:1:5: a third field"));
  EXPECT_THAT(says("A,1\n\"B,2\n"), StartsWith("parts.csv:2:1: a quote is opened"));
  EXPECT_THAT(says("A,1\n\"B\"c,2\n"), StartsWith("parts.csv:2:4: text after a closing quote"));
  EXPECT_THAT(says("A\x01,1\n"), StartsWith("parts.csv:1:2: control byte 0x01"));
  EXPECT_THAT(says("A,99999999999999999999\n"), StartsWith("parts.csv:1:3: "));
  EXPECT_THAT(says("# nothing\n"), StartsWith("parts.csv:1:1: no part is listed"));
  EXPECT_THAT(says(""), HasSubstr("no part is listed"));
  EXPECT_THAT(says(std::string(256, 'a')), HasSubstr("255 bytes"));
  std::string many;
  for (int i = 0; i <= 1000; ++i) {
    many += "p" + std::to_string(i) + "\n";
  }
  EXPECT_THAT(says(many), StartsWith("parts.csv:1001:1: more than 1000 parts"));
}

TEST(ReadPairs, TakesNamesAndNumbers) {
  const PairSet pairs = read_pairs(
      *input_from_text("Pump A,\"Valve, large\"\n# by number\n1,3\n\"Motor\", 2\n3,1\n"), names);
  EXPECT_EQ(pairs.size(), 3U);
  EXPECT_TRUE(pairs.contains(0, 1));
  EXPECT_TRUE(pairs.contains(0, 2));
  EXPECT_TRUE(pairs.contains(2, 3)) << "a name wins over a number";
}

TEST(ReadPairs, SaysWhereItIsWrong) {
  const auto says = [](const std::string& text) {
    return complaint([&] { (void)read_pairs(*input_from_text(text, "p.csv"), names); });
  };
  EXPECT_THAT(says("1,3\n1,pump a\n"), StartsWith("p.csv:2:3: there is no part 'pump a'; did you"));
  EXPECT_THAT(says("1,9\n"), StartsWith("p.csv:1:3: there is no part '9'; give a name"));
  EXPECT_THAT(says("1,0\n"), StartsWith("p.csv:1:3: there is no part '0'"));
  EXPECT_THAT(says("1,1\n"), StartsWith("p.csv:1:3: '1' stands here twice"));
  EXPECT_THAT(says("1\n"), StartsWith("p.csv:1:1: one part stands here"));
  EXPECT_THAT(says("1,3,4\n"), StartsWith("p.csv:1:1: more than two stand here"));
}

TEST(ReadSetUps, TakesEveryWayOfWritingThem) {
  const auto read = [](const std::string& text) {
    return read_setups(*input_from_text(text, "d.csv"), names);
  };
  EXPECT_THAT(read("1,3,5\n\"Valve, large\"\n"), ElementsAre(Block{0, 2, 4}, Block{1}));
  EXPECT_THAT(read("1 3 5\n1 2\n"), ElementsAre(Block{0, 2, 4}, Block{0, 3}));
  EXPECT_THAT(read("step,set_up\n1,\"Pump A, \"\"Valve, large\"\"\"\n2,Motor\n"),
              ElementsAre(Block{0, 1}, Block{2}));
  EXPECT_THAT(complaint([&] { read("1,3\n1,4,7\n"); }), StartsWith("d.csv:2:5: there is no part"));
  EXPECT_THAT(complaint([&] { read("step,set_up\n1,\"Pump A, Fan\"\n"); }),
              StartsWith("d.csv:2:3: there is no part 'Fan'"));
  EXPECT_THAT(complaint([&] { read("step,set_up\n1\n"); }), StartsWith("d.csv:2:1: a row without"));
}

TEST(PartsText, IsReadBack) {
  const Block all{4, 3, 2, 1, 0};
  EXPECT_EQ(parts_text(all, names), "\"say \"\"hi\"\"\", 2, Motor, \"Valve, large\", Pump A");
  EXPECT_EQ(parse_parts(parts_text(all, names), names), all);
  EXPECT_THAT(complaint([&] { (void)parse_parts("Motor,Fan", names); }), HasSubstr("'Fan'"));
}

RC_GTEST_PROP(PartsText, IsReadBackWhateverTheNames, (std::vector<std::string> given)) {
  std::vector<std::string> distinct;
  for (std::string name : given) {
    std::erase_if(name, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
    if (!name.empty() && std::find(distinct.begin(), distinct.end(), name) == distinct.end()) {
      distinct.push_back(name);
    }
  }
  Block all;
  for (Element x = 0; x < distinct.size(); ++x) {
    all.push_back(x);
  }
  RC_PRE(!all.empty());
  RC_ASSERT(parse_parts(parts_text(all, distinct), distinct) == all);
}

}  // namespace
}  // namespace changeover
