#include "changeover/plan/job.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <span>

#include "changeover/core/error.hpp"
#include "message_of.hpp"
#include "run/random.hpp"

namespace changeover::read_job_test {
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
  EXPECT_THAT(says("1,1\n"), StartsWith("p.csv:1:3: '1' occurs twice"));
  EXPECT_THAT(says("1\n"), StartsWith("p.csv:1:1: only one part"));
  EXPECT_THAT(says("1,3,4\n"), StartsWith("p.csv:1:1: more than two parts"));
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

TEST(ReadParts, RefusesWhatIsNoPlainTextWithOneLine) {
  const auto says = [](const std::string& text) { return complaint([&] { (void)parts(text); }); };
  EXPECT_THAT(says("A,1\nB\x1b[2J,1\n"), StartsWith("parts.csv:2:2: control byte 0x1b"));
  EXPECT_THAT(says("caf\xe9,1\n"), StartsWith("parts.csv:1:4: byte 0xe9 is not UTF-8; save"));
  EXPECT_THAT(says("A\xc2\x85,1\n"), StartsWith("parts.csv:1:2: control character U+0085"));
  EXPECT_THAT(says("A\xe2\x80\xae,1\n"), StartsWith("parts.csv:1:2: U+202E, which reverses"));
  EXPECT_THAT(says("\"A\tB\",1\n"), HasSubstr("a tab"));
  EXPECT_THAT(says(std::string(1000, '\0')), StartsWith("parts.csv:1:1: control byte 0x00"));
  EXPECT_THAT(says("\xff\xfe" + std::string("A\0\n\0", 4)), HasSubstr("save the text as UTF-8"));
  EXPECT_THAT(parts("Gr\xc3\xb6\xc3\x9f"
                    "e,1\n")
                  .names,
              ElementsAre("Gr\xc3\xb6\xc3\x9f"
                          "e"));
}

// The same bytes over and over, without an end.
class Endless final : public Input {
 public:
  explicit Endless(std::string bytes) : Input("endless"), bytes_(std::move(bytes)) {}
  std::size_t read(std::span<char> buffer) override {
    for (char& c : buffer) {
      c = bytes_[at_++ % bytes_.size()];
    }
    return buffer.size();
  }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

TEST(ReadJob, InputsWithoutAnEndAreRefused) {
  const auto says = [](const std::string& bytes) {
    return complaint([&] {
      Endless input(bytes);
      (void)read_pairs(input, names);
    });
  };
  EXPECT_THAT(says(std::string(1, '\0')), StartsWith("endless:1:1: control byte 0x00"));
  EXPECT_THAT(says("a"), StartsWith("endless:1:1: a line of more than 16 MiB"));
  EXPECT_THAT(
      says("1,3\n"),
      StartsWith("endless:4194305:1: more than 4194304 rows; give a list without repetitions"));
}

TEST(ReadSetUps, SaysWhereOneIsLargerThanWhatFits) {
  EXPECT_THAT(
      complaint([&] { (void)read_setups(*input_from_text("1,3\n1,3,5\n", "d.csv"), names, 2); }),
      StartsWith("d.csv:2:1: 3 parts, but only 2 fit at once; remove some"));
}

TEST(ReadSetUps, TakesSheetsWithAColumnASlot) {
  const std::string head = "step,take_out,put_in,slot_1,slot_2,new_pairs,cost,cost_so_far\n";
  const auto read = [](const std::string& text, const std::vector<std::string>& of) {
    return read_setups(*input_from_text(text, "d.csv"), of);
  };
  EXPECT_THAT(read(head + "1,,x,Motor,\"Valve, large\",1,1,1\n2,y,,2,,0,1,2\n", names),
              ElementsAre(Block{2, 1}, Block{3}));
  EXPECT_THAT(read("step,take_out,put_in,new_pairs,cost,cost_so_far\n", names), ElementsAre());
  EXPECT_THAT(complaint([&] { read(head + "1,,x,Motor,Fan,1,1,1\n", names); }),
              StartsWith("d.csv:2:12: there is no part 'Fan'"));
  EXPECT_THAT(complaint([&] { read(head + "1,,x,,,1,1,1\n", names); }),
              StartsWith("d.csv:2:1: a row without a set-up"));
  const std::vector<std::string> confusing{"step", "slot_1", "set_up", "'=1", "=1"};
  EXPECT_THAT(read("step,slot_1\nset_up,4\n", confusing), ElementsAre(Block{0, 1}, Block{2, 3}));
  EXPECT_THAT(read(head + "1,,x,slot_1,step,1,1,1\n2,,x,'=1,''=1,1,1,1\n", confusing),
              ElementsAre(Block{1, 0}, Block{4, 3}));
}

// Whatever the bytes, a reader answers or says in one line what is wrong.
TEST(ReadJob, AnyMutantIsReadOrRefusedWithOneLine) {
  const std::vector<std::string> seeds{
      "component,change cost\nPump A,12.50\n\"Valve, large\",8\n# x\nMotor\n",
      "id;part;cost\n1;Pump A;3\n2;Motor;4\n",
      "Pump A,Motor\n1,3\n\"Valve, large\", 2\n",
      "1 3 5\nPump A,2\n",
      "step,set_up\n1,\"Pump A, \"\"Valve, large\"\"\"\n2,Motor\n",
      "step,take_out,put_in,slot_1,slot_2,new_pairs,cost,cost_so_far\n1,,a,Motor,2,1,1,1\n"};
  const std::vector<std::string> pieces{"\"",
                                        ",",
                                        ";",
                                        "\n",
                                        "\r",
                                        "\t",
                                        "'",
                                        "=",
                                        "#",
                                        "-1",
                                        "1e308",
                                        "\xff",
                                        "\xe2\x80\xae",
                                        "set_up",
                                        "slot_1",
                                        "Motor",
                                        "18446744073709551616",
                                        std::string(1, '\0'),
                                        std::string(300, 'x')};
  Random random(7);
  std::uint64_t refused = 0;
  constexpr std::uint64_t mutants = 6000;
  for (std::uint64_t i = 0; i < mutants; ++i) {
    std::string text = seeds[random.below(static_cast<std::uint32_t>(seeds.size()))];
    for (std::uint32_t change = 1 + random.below(3); change > 0; --change) {
      const std::size_t at = random.below(static_cast<std::uint32_t>(text.size() + 1));
      switch (random.below(4)) {
        case 0:
          text.erase(at, random.below(5));
          break;
        case 1:
          text.insert(at, pieces[random.below(static_cast<std::uint32_t>(pieces.size()))]);
          break;
        case 2:
          text.insert(at, text.substr(at / 2, random.below(12)));
          break;
        default:
          text.insert(at, 1, static_cast<char>(random.below(256)));
      }
    }
    for (int reader = 0; reader < 3; ++reader) {
      try {
        const auto input = input_from_text(text, "f");
        if (reader == 0) {
          const PartList list = read_parts(*input);
          Job job = make_job(list.names.size(), 2, Amount{}, Amount{});
          job.names = list.names;
          if (job.parts() >= 2) {
            ASSERT_EQ(defects(job), std::vector<std::string>()) << testing::PrintToString(text);
          }
        } else if (reader == 1) {
          (void)read_pairs(*input, names);
        } else {
          for (const Block& setup : read_setups(*input, names, 3)) {
            ASSERT_LE(setup.size(), 3U);
          }
        }
      } catch (const BadInput& fault) {
        ++refused;
        const std::string line = fault.what();
        ASSERT_EQ(line.find_first_of("\n\r\t"), std::string::npos) << testing::PrintToString(text);
        ASSERT_TRUE(line.starts_with("f:")) << line;
        ASSERT_LT(line.size(), 300U) << line;
      }
    }
  }
  EXPECT_GT(refused, mutants);
  EXPECT_LT(refused, 3 * mutants);
}

TEST(ReadParts, NamesThatLookTheSameAreRefused) {
  const auto complaint = [](const std::string& text) -> std::string {
    return message_of([&] { (void)read_parts(*input_from_text(text, "p.csv"), Header::none); });
  };
  EXPECT_EQ(complaint("Pump A,1\nPump\u200b B,2\nFan,3\n"), "") << "one that looks like no other";
  EXPECT_EQ(complaint("Pump,1\nPu\u200bmp,2\n").find("p.csv:2:1: a second part looks like 'Pump'"),
            0U);
  EXPECT_EQ(complaint("Pump A,1\nFan,1\nPump\u00a0A,2\n").find("p.csv:3:1: a second part"), 0U);
  EXPECT_EQ(complaint("\u200b,1\nFan,1\n").find("p.csv:1:1: the name has no visible"), 0U);
  Job job = make_job(3, 2, parse_amount("1"), parse_amount("1"));
  job.names[1] = "1\u2060";
  EXPECT_THROW(check(job), BadInput);
}

TEST(Pairs, MayHaveBlanksBetweenThemAndQuotesAroundThem) {
  const std::vector<std::string> bench{"Pump A", "Valve", "x, y", "5"};
  const auto pairs = [&](const std::string& text) {
    return read_pairs(*input_from_text(text, "pairs.csv"), bench);
  };
  for (const std::string text : {"Pump A,Valve\n", "\"Pump A\";\"Valve\"\n", "\"Pump A\" Valve\n",
                                 "Valve \"Pump A\"\n", "1 2\n", "2\t1\n"}) {
    EXPECT_TRUE(pairs(text).contains(0, 1)) << text;
  }
  EXPECT_TRUE(pairs("\"x, y\" 5\n1 2\n").contains(2, 3));
  EXPECT_TRUE(pairs("Valve \"x, y\"\n").contains(1, 2));
  EXPECT_TRUE(read_priorities(*input_from_text("1 2 2.5\n\"Pump A\" 5 7\n"), bench).weighs(0, 3));
  const auto says = [&](const std::string& text) -> std::string {
    return message_of([&] { pairs(text); });
  };
  EXPECT_THAT(says("1 2\n1 9\n"), StartsWith("pairs.csv:2:3: there is no part '9'"));
  EXPECT_THAT(says("Pump A\n"), StartsWith("pairs.csv:1:1: only one part"));
  EXPECT_THAT(says("\"Pump A\"x Valve\n"), StartsWith("pairs.csv:1:9: text after a closing quote"));
}

}  // namespace
}  // namespace changeover::read_job_test
