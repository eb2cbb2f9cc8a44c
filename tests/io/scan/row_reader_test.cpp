// Rows of fields out of text and CSV, as every list and design reads them.
#include "io/scan/row_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "changeover/core/error.hpp"

namespace changeover::test::row_reader_test {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::StartsWith;

using Texts = std::vector<std::vector<std::string>>;

Texts rows_of(const std::string& text, const RowOptions& options = {}) {
  const auto input = input_from_text(text, "f");
  RowReader reader(*input, options);
  Texts rows;
  while (const auto row = reader.next()) {
    std::vector<std::string>& fields = rows.emplace_back();
    for (const Field& field : *row) {
      fields.push_back(field.text);
    }
  }
  return rows;
}

std::string fault(const std::string& text, const RowOptions& options = {}) {
  try {
    rows_of(text, options);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

TEST(RowReader, SplitsAtTheSeparatorThatComesFirst) {
  EXPECT_EQ(rows_of("a,b;c\nd;e,f\n"), (Texts{{"a", "b;c"}, {"d;e", "f"}}));
  EXPECT_EQ(rows_of("a\nb;c,d\ne;f\n"), (Texts{{"a"}, {"b", "c,d"}, {"e", "f"}}));
  EXPECT_EQ(rows_of("a b\tc\n"), (Texts{{"a b", "c"}}));
  EXPECT_EQ(rows_of("a\t\n"), (Texts{{"a"}}));
  EXPECT_EQ(rows_of(" a , ,b,\n"), (Texts{{"a", "", "b", ""}}));
}

TEST(RowReader, TakesQuotesMarksLineEndsAndComments) {
  EXPECT_EQ(rows_of("\xEF\xBB\xBF\"a, \"\"b\"\"\" ,c\r\n# a comment\n\n , \n\" d \",5\"\n"),
            (Texts{{"a, \"b\"", "c"}, {" d ", "5\""}}));
  EXPECT_EQ(rows_of("\"a;b\";c\n"), (Texts{{"a;b", "c"}}));
  EXPECT_EQ(rows_of("%a,b\n"), (Texts{{"%a", "b"}}));
  EXPECT_EQ(rows_of(" % a\n\t# b\na,b\n", {.percent_too = true}), (Texts{{"a", "b"}}));
}

TEST(RowReader, SplitsAtAnySeparatorOrAtBlanksWhereAListAllowsIt) {
  const RowOptions any{.any_separator = true, .blanks = true};
  EXPECT_EQ(rows_of("a,b;c\nd\te f\n;g\n", any), (Texts{{"a", "b", "c"}, {"d", "e f"}, {"", "g"}}));
  EXPECT_EQ(rows_of("\"a, b\" c\nd \"e;f\"\ng h\n", any),
            (Texts{{"a, b", "c"}, {"d", "e;f"}, {"g h"}}));
  const RowOptions blanks{.blanks = true};
  EXPECT_EQ(rows_of("a \"b, c\"\nd,\"e f\"\n", blanks), (Texts{{"a", "b, c"}, {"d", "e f"}}));
  EXPECT_EQ(rows_of("5\" a, 3\" b\n", blanks), (Texts{{"5\" a", "3\" b"}}));
  const auto input = input_from_text(" a  \"b c\"\n", "f");
  RowReader reader(*input);
  const auto row = reader.next();
  std::vector<std::string> texts;
  std::vector<std::size_t> offsets;
  for (const Field& field : at_blanks(row->front(), reader)) {
    texts.push_back(field.text);
    offsets.push_back(field.offset);
  }
  EXPECT_THAT(texts, ElementsAre("a", "b c"));
  EXPECT_THAT(offsets, ElementsAre(1, 4));
}

TEST(RowReader, SaysLineAndColumn) {
  EXPECT_THAT(fault("a,b\nc,\"d\n"), StartsWith("f:2:3: a quote is opened and not closed"));
  EXPECT_THAT(fault("a,b\n\"c\"d,e\n"), StartsWith("f:2:4: text after a closing quote"));
  EXPECT_THAT(fault("a,b\nc,\x01\n"), StartsWith("f:2:3: control byte 0x01"));
  EXPECT_THAT(fault("a,b\rc\n"), StartsWith("f:1:4: carriage return inside a line"));
  EXPECT_THAT(fault("# a\rb\r"), StartsWith("f:1:4: carriage return inside a line"));
  EXPECT_THAT(fault("a,\xFF\n"), StartsWith("f:1:3: byte 0xff is not UTF-8"));
  EXPECT_EQ(fault("a\nbbbbb\n", {.longest_line = 4, .too_long = "too long a line"}),
            "f:2:1: too long a line");
  EXPECT_THAT(fault("a\nb\nc\n", {.most_rows = 2}), StartsWith("f:3:1: more than 2 rows"));
  EXPECT_THAT(fault(std::string(3 << 20, '\n') + "a\n", {.most_bytes = 1 << 20}),
              EndsWith(":1: more than 1 MiB; give a list without repetitions"));
}

TEST(RowReader, ReadsWhatIsWrittenInQuotes) {
  for (const std::string text :
       {"a", "a b", "a\tb", "a,b", "a;b", "\"", " a", "#a", "%a", "5\" disk", "é,"}) {
    EXPECT_EQ(rows_of(changeover::quoted_field(text) + "," + changeover::quoted_field("x") + "\n"),
              (Texts{{text, "x"}}))
        << text;
    const RowOptions any{.any_separator = true, .blanks = true, .percent_too = true};
    for (const std::string between : {" ", ",", ";", "\t"}) {
      const Texts rows = rows_of(quoted_among_blanks(text) + between + "\"x y\"\n", any);
      EXPECT_EQ(rows, (Texts{{text, "x y"}})) << text << between;
    }
  }
}

}  // namespace
}  // namespace changeover::test::row_reader_test
