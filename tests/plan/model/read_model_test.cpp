// Models from their texts: what is read, and what is refused where.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "message_of.hpp"
#include "some_models.hpp"

namespace changeover::read_model_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::string complaint(const std::string& text) {
  try {
    (void)test::model_of(text);
  } catch (const Error& fault) {
    return fault.what();
  }
  return "no complaint";
}

std::vector<std::string> labels(const ModelParameter& parameter) {
  std::vector<std::string> all;
  for (const ModelValue& value : parameter.values) {
    all.push_back(value.label);
  }
  return all;
}

TEST(ReadModel, ParametersWithTheirValues) {
  const Model model = test::model_of(
      "\xEF\xBB\xBF# a sample\r\n\r\nFile system :  FAT , FAT32,NTFS (10)\r\nSize: 10, 0x10, "
      "1e3\r\n"
      "  # not here\nURL, http, a b\nRange: ~-1, 0, ~ 5 (2), 7 | seven | VII\nCopy: <Size>, 4\n"
      "Odd: (x), <y>, a(b), (3)\n");
  ASSERT_EQ(model.parameters.size(), 6U);
  EXPECT_EQ(model.parameters[0].name, "File system");
  EXPECT_THAT(labels(model.parameters[0]), ElementsAre("FAT", "FAT32", "NTFS"));
  EXPECT_TRUE(model.parameters[1].numeric);
  EXPECT_EQ(model.parameters[1].values[1].number, 16.0);
  EXPECT_EQ(model.parameters[2].name, "URL");
  EXPECT_THAT(labels(model.parameters[2]), ElementsAre("http", "a b"));
  EXPECT_THAT(labels(model.parameters[3]), ElementsAre("~-1", "0", "~5", "7"));
  EXPECT_TRUE(model.parameters[3].values[0].negative);
  EXPECT_TRUE(model.parameters[3].numeric);
  EXPECT_THAT(model.parameters[3].values[3].names, ElementsAre("7", "seven", "VII"));
  EXPECT_THAT(labels(model.parameters[4]), ElementsAre("10", "0x10", "1e3", "4"));
  EXPECT_THAT(labels(model.parameters[5]), ElementsAre("(x)", "<y>", "a(b)", "(empty)"));
  EXPECT_EQ(model.values(), 3U + 3 + 2 + 4 + 4 + 4);
  EXPECT_EQ(model.parameter_of(5), 1U);
  EXPECT_EQ(model.parameter_of(6), 2U);
  EXPECT_THAT(
      model.notes,
      ElementsAre("m.txt:9:11: no parameter before this one is called 'y', so '<y>' is a value",
                  StartsWith("3 values have a weight")));
}

TEST(ReadModel, ValuesThatRulesCannotTellApart) {
  const Model model = test::model_of("A: On, on, On\nB: On, x\n");
  EXPECT_THAT(labels(model.parameters[0]), ElementsAre("On", "on (2)", "On (3)"));
  EXPECT_EQ(model.notes.size(), 2U);
  const Job job = job_of(model, Amount{}, Amount{});
  EXPECT_THAT(job.names, ElementsAre("A: On", "on (2)", "On (3)", "B: On", "x"));
}

TEST(ReadModel, RulesAmongParametersThatAreCalledLikeThem) {
  const Model model = test::model_of(
      "if: a, b\nNot so, c, d\nIf mode: [x], y\nIF\n[if] = \"a\" THEN [Not so] = \"c\";\n");
  EXPECT_EQ(model.parameters.size(), 3U);
  EXPECT_EQ(model.constraints.size(), 1U);
  EXPECT_EQ(model.constraints[0].line, 4U);
  EXPECT_EQ(test::model_of("A: a, b\nB: c, d\n(([A] = \"a\"));").constraints.size(), 1U);
  EXPECT_EQ(test::model_of("A: ~1, 2\nB: c, d\nIsPositive(A) OR [B] = \"c\";\n").constraints.size(),
            1U);
  EXPECT_EQ(test::model_of(
                "A: ~1, 2\nB: c, d\nNOT [B] = \"c\";\nIF NOT ISNEGATIVE ( A ) THEN [B] = \"d\";\n")
                .constraints.size(),
            2U);
}

TEST(ReadModel, SignsThatStandForThemselves) {
  const Model model = test::model_of(
      "a]b: x\"y, back\\slash, [z\nB: 1, 2\nIF [a\\]b] = \"x\\\"y\" OR [a\\]b] = "
      "\"back\\\\slash\" THEN [B] = 1;\n");
  EXPECT_EQ(test::all_tests(model).size(), 4U);
  EXPECT_THAT(complaint("A: a, b\nB: c, d\n[A] = \"a\\b\";\n"),
              StartsWith("m.txt:3:9: a backslash stands before"));
}

TEST(ReadModel, SaysWhatIsWrongAndWhere) {
  const std::string two = "A: a, b\nN: 1, 2\n";
  EXPECT_EQ(complaint(""),
            "m.txt:1:1: no parameter is listed; write one per line, as in OS: Debian, Windows");
  EXPECT_THAT(complaint("A: a, b\n"), HasSubstr("there is only one parameter"));
  EXPECT_EQ(complaint("A: a\nword\n"),
            "m.txt:2:1: 'word' is not a parameter; write its name, a colon and its values");
  EXPECT_EQ(complaint("A: a\n: b\n"),
            "m.txt:2:1: a parameter has no name; write one before its values");
  EXPECT_EQ(complaint("A: a\nB: b\na: c\n"),
            "m.txt:3:1: a second parameter is called 'a'; rename one");
  EXPECT_THAT(complaint("A: a, b\n$R: x\n"),
              StartsWith("m.txt:2:1: '$R' is a parameter of expected results"));
  EXPECT_THAT(complaint("A: a | , b\nB: c\n"),
              StartsWith("m.txt:1:4: a value of 'A' has an empty name beside |"));
  EXPECT_THAT(complaint("A: ~a, ~b\nB: c\n"), HasSubstr("all values of 'A' are out of range"));
  EXPECT_THAT(complaint("A: a, b\x01\nB: c\n"), StartsWith("m.txt:1:8: "));
  EXPECT_THAT(complaint("A: a, \xFF\nB: c\n"), StartsWith("m.txt:1:7: "));
  EXPECT_THAT(complaint("A: a\nB: c\n{ A, C } @ 2\n"),
              StartsWith("m.txt:3:6: no parameter is called 'C'"));
  EXPECT_THAT(complaint("A: a\nB: c\n{ A, B @ 2\n"),
              StartsWith("m.txt:3:1: a sub-model is not closed"));
  EXPECT_THAT(complaint("A: a\nB: c\n{ A, B } 2\n"),
              StartsWith("m.txt:3:10: a sub-model lacks its strength"));
  EXPECT_THAT(complaint("A: a\nB: c\n{ A, B } @ 0\n"),
              StartsWith("m.txt:3:10: found '0'; write a strength after @"));
  EXPECT_THAT(complaint(two + "[A] = \"a\"\n"),
              StartsWith("m.txt:4:1: found the end; end the rule with a semicolon"));
  EXPECT_THAT(complaint(two + "[A] = \"a\";;\n"),
              StartsWith("m.txt:3:11: found ';'; begin a condition with a parameter in [ ]"));
  EXPECT_THAT(complaint(two + "[A] = \"a\";\n[C] = 1;\n"),
              StartsWith("m.txt:4:1: no parameter is called 'C'"));
  EXPECT_THAT(complaint(two + "IF [A] = \"a\" [N] = 1;\n"),
              StartsWith("m.txt:3:14: found 'N'; write THEN after the condition of IF"));
  EXPECT_THAT(complaint(two + "IF [A] = \"a\" THEN;\n"),
              StartsWith("m.txt:3:18: found ';'; begin a condition"));
  EXPECT_THAT(complaint(two + "[A] != \"a\";\n"), StartsWith("m.txt:3:5: found '!'; write =, <>"));
  EXPECT_THAT(complaint(two + "[A] = a;\n"),
              StartsWith("m.txt:3:7: found 'a'; write a number, or a text in quotes"));
  EXPECT_THAT(complaint(two + "[A] = 1;\n"), StartsWith("m.txt:3:7: the values of 'A' are texts"));
  EXPECT_THAT(complaint(two + "[N] = \"1\";\n"),
              StartsWith("m.txt:3:7: all values of 'N' are numbers"));
  EXPECT_THAT(complaint(two + "[N] LIKE \"1\";\n"), StartsWith("m.txt:3:10: LIKE is for texts"));
  EXPECT_THAT(complaint(two + "[A] LIKE 1;\n"),
              StartsWith("m.txt:3:10: found '1'; write a pattern in quotes after LIKE"));
  EXPECT_THAT(complaint(two + "[A] = [N];\n"),
              StartsWith("m.txt:3:7: 'A' and 'N' cannot be compared"));
  EXPECT_THAT(complaint(two + "[A] = [a];\n"),
              StartsWith("m.txt:3:7: a parameter is compared with itself"));
  EXPECT_THAT(complaint(two + "[A] NOT = \"a\";\n"),
              StartsWith("m.txt:3:9: found '='; write LIKE or IN after NOT"));
  EXPECT_THAT(complaint(two + "[A] IN \"a\";\n"),
              StartsWith("m.txt:3:8: found 'a'; write values in { } after IN"));
  EXPECT_THAT(complaint(two + "[A] IN {};\n"), StartsWith("m.txt:3:9: found '}'; write a number"));
  EXPECT_THAT(complaint(two + "[A] IN {\"a\" \"b\"};\n"),
              StartsWith("m.txt:3:13: found 'b'; end the list of values with }"));
  EXPECT_THAT(complaint(two + "([A] = \"a\";\n"),
              StartsWith("m.txt:3:11: found ';'; close the bracket before it"));
  EXPECT_THAT(complaint(two + "[A = \"a\";\n"),
              StartsWith("m.txt:3:1: the name of a parameter is not closed"));
  EXPECT_THAT(complaint(two + "[A] = \"a;\n"),
              StartsWith("m.txt:3:7: a text is not closed; end it with a quote"));
  EXPECT_THAT(complaint(two + "IsNegative A;\n"), HasSubstr("m.txt:3:1: "));
}

TEST(ReadModel, WordsThatNoValueHasAreSaid) {
  const Model model =
      test::model_of("A: a, b\nN: 1, 2\nIF [A] = \"x\" THEN [N] IN {1, 3};\n[A] < \"x\";\n");
  EXPECT_THAT(model.notes,
              ElementsAre("m.txt:3:10: A has no value 'x'", "m.txt:3:30: N has no value '3'"));
}

TEST(ReadModel, RelationsAreOfAllParametersAndTheStrengthOfTheWhole) {
  const auto refusal = [](const std::string& text, std::uint64_t strength) -> std::string {
    const Model model = test::model_of(text);
    return message_of([&] { check_relations(model, strength); });
  };
  const std::string three = "A: a, b\nB: c, d\nC: e, f\n";
  EXPECT_EQ(refusal(three, 2), "");
  EXPECT_EQ(refusal(three + "{ a, B, C, B } @ 2\n", 2), "");
  EXPECT_EQ(refusal(three + "{ A, B, C }\n", 3), "");
  EXPECT_THAT(refusal(three + "{ A, B, C } @ 2\n", 3),
              StartsWith("m.txt:4:1: sub-models are not supported"));
  EXPECT_THAT(refusal(three + "{ A, B }\n", 2),
              StartsWith("m.txt:4:1: sub-models are not supported"));
  EXPECT_EQ(refusal("A @ 2: a, b\nB: c\n", 2), "");
  EXPECT_THAT(refusal("A @ 3: a, b\nB: c\n", 2),
              StartsWith("m.txt:1:1: A asks for the strength 3"));
  EXPECT_EQ(test::model_of("A@B: a, b\nB: c\n").parameters[0].name, "A@B");
}

TEST(ReadModel, TheSectionsOfActs) {
  const std::string begin =
      "-- a tool of NIST\n[System]\nName: phone\n[Parameter]\nA (int) : 1, 2\nB (enum): 1, "
      "2\nC(boolean):TRUE,FALSE\n";
  const Model model =
      test::model_of(begin + "[Relation]\nR1 : (A, B, C, 2)\n[constraint]\nA = 1 => C\n");
  ASSERT_EQ(model.parameters.size(), 3U);
  EXPECT_TRUE(model.parameters[0].numeric);
  EXPECT_FALSE(model.parameters[1].numeric);
  EXPECT_EQ(model.relations.size(), 1U);
  EXPECT_EQ(model.relations[0].strength, 2U);
  EXPECT_EQ(model.constraints[0].line, 11U);
  EXPECT_EQ(model.constraints[0].text, "A = 1 => C");
  EXPECT_THAT(complaint(begin + "[Test Set]\nA,B,C\n"),
              StartsWith("m.txt:8:1: the section '[Test Set]' is not supported"));
  EXPECT_THAT(complaint("[System]\n[Parameter]\nA (date) : 1\n"),
              StartsWith("m.txt:3:1: the type 'date' is not supported"));
  EXPECT_THAT(complaint("[System]\n[Parameter]\nA (int) : 1, x\n"),
              StartsWith("m.txt:3:14: 'x' is not a number"));
  EXPECT_THAT(complaint("[System]\n[Parameter]\nA (int) : 1, 2; 3\n"),
              StartsWith("m.txt:3:14: '2; 3' is more than a value"));
  EXPECT_THAT(complaint("[System]\n[Parameter]\nA : 1,,2\n"),
              StartsWith("m.txt:3:7: a value of 'A' has no name"));
  EXPECT_THAT(complaint(begin + "[Relation]\nR1 A, B\n"),
              StartsWith("m.txt:9:1: this is not a relation"));
  EXPECT_THAT(complaint(begin + "[Constraint]\nA = 1 B\n"),
              StartsWith("m.txt:9:7: found 'B' after the end of a rule"));
  EXPECT_THAT(complaint(begin + "[Constraint]\nA\n"),
              StartsWith("m.txt:9:1: this is not a condition"));
  EXPECT_THAT(complaint(begin + "[Constraint]\nA = (1\n"),
              StartsWith("m.txt:9:7: found the end of the line; close the bracket before it"));
  EXPECT_THAT(complaint(begin + "[Constraint]\nA = \"x\"\n"),
              StartsWith("m.txt:9:5: 'x' is not a number"));
  EXPECT_THAT(complaint(begin + "[Constraint]\nA = B\n"),
              StartsWith("m.txt:9:1: a number and a text"));
  EXPECT_THAT(complaint(begin + "[Constraint]\nB + 1 = 2\n"),
              StartsWith("m.txt:9:1: only numbers"));
  EXPECT_THAT(complaint(begin + "[Constraint]\nA =\n"), HasSubstr("found the end of the line"));
  EXPECT_THAT(complaint(begin + "[Constraint]\n(A = 1) < (A = 2)\n"),
              StartsWith("m.txt:9:2: conditions have no order"));
  EXPECT_THAT(complaint(begin + "[Constraint]\n[Parameter]\nD : 1\n"),
              StartsWith("m.txt:9:1: parameters stand after"));
}

TEST(ReadModel, WhatIsTooMuchIsRefusedSoon) {
  std::string doubled = "A: a\n";
  for (int i = 0; i < 40; ++i) {
    doubled += "P" + std::to_string(i) + ": <" + (i == 0 ? "A" : "P" + std::to_string(i - 1)) +
               ">, <" + (i == 0 ? "A" : "P" + std::to_string(i - 1)) + ">\n";
  }
  EXPECT_THAT(complaint(doubled), HasSubstr("more than 1000 values in all"));
  const std::string two = "A: a, b\nB: c, d\n";
  EXPECT_THAT(complaint(two + std::string(100'000, '(') + "[A] = \"a\";"),
              HasSubstr("brackets more than 200 deep"));
  std::string nots = two;
  for (int i = 0; i < 100'000; ++i) {
    nots += "NOT ";
  }
  EXPECT_THAT(complaint(nots + "[A] = \"a\";"), HasSubstr("brackets more than 200 deep"));
  std::string many = two;
  for (int i = 0; i < 100'001; ++i) {
    many += "[A]=\"a\";\n";
  }
  EXPECT_THAT(complaint(many), StartsWith("m.txt:100003:"));
  EXPECT_THAT(complaint(many), HasSubstr("more than 100000 conditions in all rules together"));
  const std::string acts =
      "[System]\n[Parameter]\nA (boolean): true, false\nB (int): 1, 2\n[Constraint]\n";
  EXPECT_THAT(complaint(acts + std::string(100'000, '(') + "A"),
              HasSubstr("brackets more than 200 deep"));
  EXPECT_THAT(complaint(acts + std::string(100'000, '!') + "A"),
              HasSubstr("brackets more than 200 deep"));
  std::string arrows = acts;
  for (int i = 0; i < 100'000; ++i) {
    arrows += "A => ";
  }
  EXPECT_THAT(complaint(arrows + "A"), HasSubstr("brackets more than 200 deep"));
  std::string equal = acts + "A";
  for (int i = 0; i < 100; ++i) {
    equal = acts + "(" + equal.substr(acts.size()) + ") = (A = true)";
  }
  EXPECT_THAT(complaint(equal), HasSubstr("more than 100000 conditions"));
  std::string sums = acts + "B";
  for (int i = 0; i < 100'000; ++i) {
    sums += "+B";
  }
  EXPECT_THAT(complaint(sums + " > 3"), HasSubstr("operators in a rule"));
}

TEST(ReadModel, NamesAreNotTooLong) {
  const std::string longest(255, 'x');
  EXPECT_EQ(complaint(longest + ": " + longest + ", b\nB: c\n"), "no complaint");
  EXPECT_THAT(complaint(longest + "x: a\nB: c\n"),
              StartsWith("m.txt:1:1: a name of more than 255 bytes"));
  EXPECT_THAT(complaint("A: a, " + longest + "x\nB: c\n"),
              StartsWith("m.txt:1:7: a name of more than 255 bytes"));
}

}  // namespace
}  // namespace changeover::read_model_test
