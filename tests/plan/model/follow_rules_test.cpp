// Rules of models against what they say, said again as code and tried on every row.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

#include "some_models.hpp"

namespace changeover::follow_rules_test {
namespace {

using testing::HasSubstr;

// The words of a row by the names of the parameters.
using Words = std::map<std::string, std::string>;
using Says = std::function<bool(const Words&)>;

Words words_of(const Model& model, const Block& row) {
  Words words;
  for (const Element x : row) {
    words[model.parameters[model.parameter_of(x)].name] = model.value(x).names.front();
  }
  return words;
}

double number(const Words& row, const std::string& name) { return std::stod(row.at(name)); }

// Every row follows the rule exactly if the code says so; both happen.
void expect_rule(const std::string& parameters, const std::string& rule, const Says& says) {
  const Model model = test::model_of(parameters + "\n" + rule + "\n");
  std::size_t good = 0;
  std::size_t bad = 0;
  for (const Block& row : test::all_choices(model)) {
    const bool expected = says(words_of(model, row));
    ++(expected ? good : bad);
    EXPECT_EQ(follows(model, row), expected) << rule;
  }
  EXPECT_GT(good, 0U) << rule;
  EXPECT_GT(bad, 0U) << rule;
}

const std::string letters = "A: a, b, c, d\nB: a, b, c\nN: -1, 0, 2.5, 10\nM: 0, 2.5, 1e1";

TEST(FollowRules, EveryRelationOfTextsAndNumbers) {
  const auto a = [](const Words& row) { return row.at("A"); };
  expect_rule(letters, "[A] = \"b\";", [&](const Words& r) { return a(r) == "b"; });
  expect_rule(letters, "[A] <> \"b\";", [&](const Words& r) { return a(r) != "b"; });
  expect_rule(letters, "[A] < \"b\";", [&](const Words& r) { return a(r) < "b"; });
  expect_rule(letters, "[A] <= \"B\";", [&](const Words& r) { return a(r) <= "b"; });
  expect_rule(letters, "[A] > \"b\";", [&](const Words& r) { return a(r) > "b"; });
  expect_rule(letters, "[a] >= \"b\";", [&](const Words& r) { return a(r) >= "b"; });
  expect_rule(letters, "[N] = 10.0;", [&](const Words& r) { return number(r, "N") == 10; });
  expect_rule(letters, "[N] < 2.5;", [&](const Words& r) { return number(r, "N") < 2.5; });
  expect_rule(letters, "[N] >= -.5;", [&](const Words& r) { return number(r, "N") >= -0.5; });
  expect_rule(letters, "[A] IN {\"a\", \"D\", \"x\"};",
              [&](const Words& r) { return a(r) == "a" || a(r) == "d"; });
  expect_rule(letters, "[N] not in {0, 10};",
              [&](const Words& r) { return number(r, "N") != 0 && number(r, "N") != 10; });
  expect_rule(letters, "[A] = [B];", [&](const Words& r) { return a(r) == r.at("B"); });
  expect_rule(letters, "[A] > [B];", [&](const Words& r) { return a(r) > r.at("B"); });
  expect_rule(letters, "[N] <= [M];",
              [&](const Words& r) { return number(r, "N") <= number(r, "M"); });
}

TEST(FollowRules, NotBeforeAndBeforeOr) {
  const auto is = [](const std::string& name, const std::string& value) {
    return [=](const Words& row) { return row.at(name) == value; };
  };
  const Says a = is("A", "a");
  const Says b = is("B", "b");
  const Says n = is("N", "0");
  expect_rule(letters, "[A]=\"a\"or[B]=\"b\"AND[N]=0;",
              [&](const Words& r) { return a(r) || (b(r) && n(r)); });
  expect_rule(letters, "([A] = \"a\" OR [B] = \"b\") and [N] = 0;",
              [&](const Words& r) { return (a(r) || b(r)) && n(r); });
  expect_rule(letters, "NOT [A] = \"a\" AND [B] = \"b\";",
              [&](const Words& r) { return !a(r) && b(r); });
  expect_rule(letters, "[A] = \"a\" OR NOT NOT ([B] = \"b\" OR [N] = 0);",
              [&](const Words& r) { return a(r) || b(r) || n(r); });
  expect_rule(letters, "if [A] = \"a\" then [B] = \"b\";",
              [&](const Words& r) { return !a(r) || b(r); });
  expect_rule(letters,
              "IF\n  [A] = \"a\"\n# a comment; within a rule\nTHEN [B] = \"b\"\nELSE\n[N] = 0;",
              [&](const Words& r) { return a(r) ? b(r) : n(r); });
}

TEST(FollowRules, PatternsOfLike) {
  const std::string files = "F: fat, FAT32, ntfs, f, \xC3\xA9t\xC3\xA9, a*b\nG: x, y";  // été
  const auto like = [&](const std::string& pattern, const std::set<std::string>& expected) {
    const Model model = test::model_of(files + "\n[F] LIKE \"" + pattern + "\";\n");
    std::set<std::string> found;
    for (const Block& row : test::all_tests(model)) {
      found.insert(model.value(row[0]).names.front());
    }
    EXPECT_EQ(found, expected) << pattern;
  };
  like("fat*", {"fat", "FAT32"});
  like("f?t", {"fat"});
  like("*t*", {"fat", "FAT32", "ntfs", "\xC3\xA9t\xC3\xA9"});
  like("?t?", {"\xC3\xA9t\xC3\xA9"});
  like("**", {"fat", "FAT32", "ntfs", "f", "\xC3\xA9t\xC3\xA9", "a*b"});
  like("*f", {"f"});
  like("n*f*", {"ntfs"});
  like("?", {"f"});
  like("*32", {"FAT32"});
  like("a*b", {"a*b"});
}

TEST(FollowRules, ValuesOutOfRangeComeAlone) {
  const std::string ranges = "A: ~-1, 0, 1\nB: ~-1, 0, 2\nC: x, y";
  const Model model = test::model_of(ranges);
  EXPECT_TRUE(follows(model, {0, 4, 6}));
  EXPECT_TRUE(follows(model, {1, 3, 6}));
  EXPECT_EQ(broken_rule(model, {0, 3, 6}), "~-1 and ~-1 are out of range both");
  const auto row_of = [](const Words& r) { return r.at("A") == "-1" || r.at("B") == "-1"; };
  const auto both = [](const Words& r) { return r.at("A") == "-1" && r.at("B") == "-1"; };
  expect_rule(ranges, "IF IsNegative( ) THEN [C] = \"x\";",
              [&](const Words& r) { return !both(r) && (!row_of(r) || r.at("C") == "x"); });
  expect_rule(ranges, "IF ISPOSITIVE(A) AND IsPositive([B]) THEN [C] = \"x\";",
              [&](const Words& r) { return !both(r) && (row_of(r) || r.at("C") == "x"); });
  expect_rule(ranges, "if [A] = -1 then [B] = 0;",
              [&](const Words& r) { return !both(r) && (r.at("A") != "-1" || r.at("B") == "0"); });
}

TEST(FollowRules, OnlyTheFirstNameCounts) {
  const Model model = test::model_of(
      "S: Professional, Server | Datacenter\nT: 1, 2\nIF [S] = \"Server\" THEN [T] = 1;\n"
      "IF [S] = \"Datacenter\" THEN [T] = 2;\n");
  EXPECT_TRUE(follows(model, {1, 2}));
  EXPECT_FALSE(follows(model, {1, 3}));
}

TEST(FollowRules, SaysWhichRuleIsBroken) {
  const Model model =
      test::model_of("A: a, b\nB: a, b\n\n[A] = [B];\nIF [A] = \"a\"\n   THEN [B]\t<> \"x\";\n");
  EXPECT_EQ(broken_rule(model, {0, 3}), "the rule on line 4 is broken: [A] = [B]");
  EXPECT_EQ(model.constraints.at(1).text, "IF [A] = \"a\" THEN [B] <> \"x\"");
  EXPECT_EQ(broken_rule(model, {0}), "B has no value");
  EXPECT_EQ(broken_rule(model, {0, 1}), "A has two values, a and b");
  EXPECT_EQ(broken_rule(model, {0, 9}), "there is no value 10 of 4");
}

const std::string acts =
    "[System]\nName: some\n\n[Parameter]\n-- a comment\nN (int) : -2, 0, 3\nM (int): 1, 2\n"
    "E (enum) : fast, exact, 10\nOn (boolean) : true, false\nFree : 1, 2\n\n[Constraint]";

TEST(FollowRules, ThoseOfActs) {
  const auto n = [](const Words& r) { return number(r, "N"); };
  const auto m = [](const Words& r) { return number(r, "M"); };
  const auto e = [](const Words& r) { return r.at("E"); };
  const auto on = [](const Words& r) { return r.at("On") == "true"; };
  expect_rule(acts, "N > 0", [&](const Words& r) { return n(r) > 0; });
  expect_rule(acts, "(E = \"exact\") => (On = FALSE)",
              [&](const Words& r) { return e(r) != "exact" || !on(r); });
  expect_rule(acts, "E==\"exact\"||E != \"fast\"&&!On",
              [&](const Words& r) { return e(r) == "exact" || (e(r) != "fast" && !on(r)); });
  expect_rule(acts, "((E)!=(\"exact\"))||((On)!=(true))",
              [&](const Words& r) { return e(r) != "exact" || !on(r); });
  expect_rule(acts, "On", [&](const Words& r) { return on(r); });
  expect_rule(acts, "On => N = 0 => M = 1",
              [&](const Words& r) { return !on(r) || n(r) != 0 || m(r) == 1; });
  expect_rule(acts, "N + M * 2 > 3 - 1", [&](const Words& r) { return n(r) + m(r) * 2 > 2; });
  expect_rule(acts, "(N + M) * 2 <= -M",
              [&](const Words& r) { return (n(r) + m(r)) * 2 <= -m(r); });
  expect_rule(acts, "N % 2 = 0", [&](const Words& r) { return static_cast<int>(n(r)) % 2 == 0; });
  expect_rule(acts, "N / M = -1", [&](const Words& r) {
    return static_cast<int>(n(r)) / static_cast<int>(m(r)) == -1;
  });
  expect_rule(acts, "M / N >= 0",
              [&](const Words& r) {  // nothing is in a relation to what there is not
                return n(r) != 0 && static_cast<int>(m(r)) / static_cast<int>(n(r)) >= 0;
              });
  expect_rule(acts, "!(M / N >= 0)", [&](const Words& r) {
    return n(r) == 0 || static_cast<int>(m(r)) / static_cast<int>(n(r)) < 0;
  });
  expect_rule(acts, "E = 10", [&](const Words& r) { return e(r) == "10"; });
  expect_rule(acts, "E = exact", [&](const Words& r) { return e(r) == "exact"; });
  expect_rule(acts, "N = \"3\"", [&](const Words& r) { return n(r) == 3; });
  expect_rule(acts, "Free >= M", [&](const Words& r) { return number(r, "Free") >= m(r); });
  expect_rule(acts, "(N > 0) = On", [&](const Words& r) { return (n(r) > 0) == on(r); });
  expect_rule(acts, "(N > 0) != (M = 1 || On)",
              [&](const Words& r) { return (n(r) > 0) != (m(r) == 1 || on(r)); });
}

}  // namespace
}  // namespace changeover::follow_rules_test
