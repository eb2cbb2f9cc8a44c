// Lines of a catalog: what is written is read again, and nothing else is read.
#include "changeover/catalog/entry.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <utility>

#include "../entries.hpp"

namespace changeover::test::entry_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const Credit uncredited;

std::string refusal(const std::string& line) {
  return fault_of([&] { static_cast<void>(entry_from_line(line, "mine.jsonl", 7, uncredited)); });
}

// The keys of one good line with their values.
using Fields = std::vector<std::pair<std::string, std::string>>;

Fields good_fields() {
  return {
      {"label", R"("4.3.1.linear.3.fdc879cf")"},
      {"b", "3"},
      {"lower_bound", "3"},
      {"reason", R"("counting")"},
      {"recipe",
       R"({"construction":"literal","v":4,"k":3,"change":1,"kind":"linear","arguments":{},"inputs":[],"blocks":[[0,1,2],[0,1,3],[0,2,3]]})"},
      {"sha256", R"("fdc879cf58d819b2f1550061bf579ec55c0ec7cd10f723344cd6bba2b4e4cf12")"},
      {"cites", R"(["A","B"])"},
      {"note", R"("a note")"},
      {"credit", R"({"who":"me","date":"2026-02-28","program":"p","command":"c"})"},
      {"retracted", R"("was wrong")"}};
}

std::string line_of_fields(const Fields& fields) {
  std::string line = "{";
  for (const auto& [key, value] : fields) {
    line += fmt::format("{}\"{}\":{}", line.size() == 1 ? "" : ",", key, value);
  }
  return line + "}";
}

// The good line with another value for a key.
std::string with(const std::string& key, const std::string& value) {
  Fields fields = good_fields();
  for (auto& [name, old] : fields) {
    if (name == key) {
      old = value;
    }
  }
  return line_of_fields(fields);
}

TEST(Entry, WrittenReadWritten) {
  const std::string line = line_of_fields(good_fields());
  const CatalogEntry entry = entry_from_line(line, "mine.jsonl", 1, uncredited);
  EXPECT_EQ(line_of(entry, uncredited), line);
  EXPECT_EQ(entry.status(), "retracted");
  EXPECT_EQ(entry.credit.who, "me");
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    CatalogEntry each = random_entry(random);
    each.note = random() % 2 == 0 ? "" : "«δ» \\ \"";
    each.cites.assign(random() % 3, "Key2026");
    const Credit shared = random() % 2 == 0
                              ? each.credit
                              : Credit{.who = "they", .date = "", .program = "", .command = ""};
    const std::string written = line_of(each, shared);
    const CatalogEntry read = entry_from_line(written, "f", 1, shared);
    ASSERT_EQ(read, each) << written;
    ASSERT_EQ(line_of(read, shared), written);
  }
}

TEST(Entry, KeysInAnyOrder) {
  Fields fields = good_fields();
  std::mt19937 random(4);
  for (int i = 0; i < 50; ++i) {
    std::ranges::shuffle(fields, random);
    EXPECT_EQ(line_of(entry_from_line(line_of_fields(fields), "f", 1, uncredited), uncredited),
              line_of_fields(good_fields()));
  }
}

// Rows keep the words of the program that wrote them; what is read says it as bounds do now.
TEST(Entry, ReasonsAreInPresentWords) {
  const auto read = [](const std::string& reason) {
    return entry_from_line(with("reason", '"' + reason + '"'), "f", 1, uncredited).reason;
  };
  EXPECT_EQ(read("b >= ceil(10 / 2) = 5 (elements in every block do not help)"),
            "b >= ceil(10 / 2) = 5 (a design with elements in every block needs no fewer)");
  EXPECT_EQ(read("x; counting with this excess, least at 0 elements in every block, gives b >= 5"),
            "x; counting pairs with this excess gives b >= 5");
  EXPECT_EQ(read("x; counting with this excess, least at 2 elements in every block, gives b >= 5"),
            "x; counting pairs with this excess, least with 2 elements in every block, gives "
            "b >= 5");
}

TEST(Entry, EveryKeyMissingOrTwice) {
  const Fields good = good_fields();
  for (std::size_t i = 0; i < good.size(); ++i) {
    Fields fields = good;
    fields.erase(fields.begin() + static_cast<std::ptrdiff_t>(i));
    const std::string said = refusal(line_of_fields(fields));
    EXPECT_EQ(said, i < 6 ? fmt::format("mine.jsonl:7:1: the entry lacks {}; add it", good[i].first)
                          : "");
    fields = good;
    fields.push_back(good[i]);
    EXPECT_THAT(refusal(line_of_fields(fields)), HasSubstr("is given twice")) << good[i].first;
  }
  EXPECT_THAT(refusal(with("credit", R"({"who":"a","who":"b"})")), HasSubstr("is given twice"));
}

TEST(Entry, ValuesOfAnotherType) {
  for (const auto& [key, value] : good_fields()) {
    for (const std::string wrong :
         {"null", "true", "-1", "1.5", "\"x\"", "[]", "{}", "[[]]", "7"}) {
      const bool fits =
          (key == "cites" && wrong == "[]") || (key == "credit" && wrong == "{}") ||
          (wrong == "\"x\"" && (key == "reason" || key == "note" || key == "retracted"));
      const std::string said = refusal(with(key, wrong));
      EXPECT_EQ(said.empty(), fits) << key << " " << wrong << " " << said;
      if (!said.empty()) {
        EXPECT_THAT(said, StartsWith("mine.jsonl:7:")) << key;
      }
    }
  }
}

TEST(Entry, WhatIsNoEntry) {
  for (const std::string line : {"", "x", "[]", "1", "{", "{}", "null", "\xff", "{\"label\"}",
                                 "{\"label\":}", "{\"label\":\"a\",}"}) {
    EXPECT_NE(refusal(line), "") << line;
  }
  const std::string good = line_of_fields(good_fields());
  EXPECT_NE(refusal(good + "{}"), "");
  EXPECT_NE(refusal(good + good), "");
  for (std::size_t length = 0; length < good.size(); ++length) {
    EXPECT_NE(refusal(good.substr(0, length)), "") << length;
  }
  Fields fields = good_fields();
  fields.emplace_back("colour", "\"red\"");
  EXPECT_THAT(refusal(line_of_fields(fields)), HasSubstr("unknown key 'colour'; remove it"));
  const std::string parts = R"("construction":"fix","v":4,"k":3,"change":1,"kind":"linear")";
  for (const auto& [rest, said] :
       {std::pair{"", "the recipe lacks arguments; add it"},
        {R"(,"arguments":{})", "the recipe lacks inputs; add it"},
        {R"(,"arguments":{},"input":[])", "unknown key 'input' in the recipe; remove it"}}) {
    EXPECT_THAT(refusal(with("recipe", "{" + parts + rest + "}")), HasSubstr(said)) << rest;
  }
  fields.back() = {"format", "\"changeover-catalog/1\""};
  EXPECT_THAT(refusal(line_of_fields(fields)), HasSubstr("only the first line"));
}

TEST(Entry, HostileLines) {
  const std::string deep(100'000, '[');
  EXPECT_NE(refusal(with("recipe", deep)), "");
  EXPECT_NE(refusal(deep), "");
  std::string nested;
  for (int i = 0; i < 300; ++i) {
    nested += R"({"construction":"fix","v":4,"k":3,"inputs":[)";
  }
  EXPECT_NE(refusal(with("recipe", nested)), "");
  for (const std::string number :
       {"18446744073709551616", "1e400", "99999999999999999999999999999999", "3.0"}) {
    EXPECT_NE(refusal(with("b", number)), "") << number;
    EXPECT_NE(refusal(with("lower_bound", number)), "") << number;
  }
  EXPECT_THAT(refusal(with("note", "\"" + std::string(3000, 'x') + "\"")),
              HasSubstr("longer than"));
  for (const std::string text :
       {R"("\u001b[2J")", R"("a\nb")", R"("\u0000")", R"("\u202e")", "\"\xff\"", "\"\x01\""}) {
    for (const std::string key : {"label", "reason", "note", "retracted"}) {
      EXPECT_NE(refusal(with(key, text)), "") << key << " " << text;
    }
    EXPECT_NE(refusal(with("cites", "[" + text + "]")), "") << text;
    EXPECT_NE(refusal(with("credit", "{\"who\":" + text + "}")), "") << text;
    EXPECT_NE(refusal(with("recipe",
                           R"({"construction":"literal","v":4,"k":3,"change":1,"kind":"linear",)"
                           R"("arguments":{},"inputs":[],"blocks":[[0,1,2]],"provenance":)" +
                               text + "}")),
              "")
        << text;
  }
  std::string many = "[\"a\"";
  for (int i = 0; i < 40; ++i) {
    many += ",\"a\"";
  }
  EXPECT_THAT(refusal(with("cites", many + "]")), HasSubstr("more than 32 citations"));
}

TEST(Entry, WhatCannotBe) {
  EXPECT_THAT(refusal(with("b", "4")), HasSubstr("does not fit its entry"));
  EXPECT_THAT(refusal(with("lower_bound", "4")), HasSubstr("3 blocks, where the lower bound is 4"));
  EXPECT_THAT(refusal(with("b", "0")), HasSubstr("0 blocks"));
  EXPECT_THAT(refusal(with("label", R"("4.3.1.linear.3.fdc879ce")")),
              HasSubstr("does not fit its entry"));
  EXPECT_THAT(refusal(with("sha256", R"("fdc8")")), HasSubstr("64 digits"));
  for (const std::string date :
       {"2026-02-29", "2026-13-01", "2026-00-10", "2026-1-1", "26-01-01", "2026/01/01", "today"}) {
    EXPECT_THAT(refusal(with("credit", "{\"date\":\"" + date + "\"}")),
                HasSubstr("the date is not a day like"));
  }
  EXPECT_EQ(refusal(with("credit", R"({"date":"2024-02-29"})")), "");
  EXPECT_THAT(refusal(with("credit", R"({"age":"1"})")),
              HasSubstr("unknown key 'age' in the credit"));
}

TEST(Header, SaysWhatItIs) {
  const Credit credit{.who = "we", .date = "2026-11-22", .program = "p", .command = ""};
  EXPECT_EQ(shared_from_header(header_line(credit), "f"), credit);
  EXPECT_EQ(shared_from_header(header_line({}), "f"), Credit{});
  const auto said = [](const std::string& line) {
    return fault_of([&] { static_cast<void>(shared_from_header(line, "f")); });
  };
  EXPECT_THAT(said("{}"), HasSubstr("not a catalog"));
  EXPECT_THAT(said(R"({"format":"changeover-design/1"})"), HasSubstr("not a catalog"));
  EXPECT_THAT(said(R"({"format":"changeover-catalog/2"})"), HasSubstr("use a newer program"));
  EXPECT_THAT(said(R"({"format":"changeover-catalog/1","b":1})"),
              HasSubstr("format and credit only"));
  EXPECT_NE(said(R"({"format":"changeover-catalog/1","x":1})"), "");
  EXPECT_NE(said("[]"), "");
}

TEST(Header, FilesAreReadLineByLine) {
  const std::string line = line_of_fields(good_fields());
  const std::string header = header_line({});
  EXPECT_EQ(read_catalog(header + "\n" + line + "\n\n" + line, "f").entries.size(), 2U);
  EXPECT_EQ(read_catalog(header, "f").entries.size(), 0U);
  EXPECT_THAT(fault_of([&] { static_cast<void>(read_catalog("", "f")); }),
              HasSubstr(": the file is empty; the first line of a catalog must be "));
  EXPECT_THAT(
      fault_of([&] { static_cast<void>(read_catalog(header + "\n" + line + "\nx\n", "f")); }),
      StartsWith("f:3:1: "));
}

}  // namespace
}  // namespace changeover::test::entry_test
