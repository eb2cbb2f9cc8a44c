#include "io/write/csv_cell.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

namespace changeover::csv_cell_test {
namespace {

// A cell without its quotes, as any reader of CSV takes them off.
std::string without_quotes(const std::string& cell) {
  if (!cell.starts_with('"')) {
    return cell;
  }
  std::string text;
  for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
    text += cell[i];
    i += cell[i] == '"' ? 1U : 0U;
  }
  return text;
}

TEST(CsvCell, LeavesOrdinaryTextAsItIs) {
  for (const std::string text : {"", "B-12", "a b", "o'clock", "'tis", "x=1", "°C", "12", "007"}) {
    EXPECT_EQ(csv_cell(text), text);
    EXPECT_EQ(csv_text(text), text);
  }
}

TEST(CsvCell, DisarmsWhatASpreadsheetWouldCompute) {
  EXPECT_EQ(csv_cell("=1+1"), "'=1+1");
  EXPECT_EQ(csv_cell("+cmd"), "'+cmd");
  EXPECT_EQ(csv_cell("-2+3"), "'-2+3");
  EXPECT_EQ(csv_cell("@SUM(A1)"), "'@SUM(A1)");
  EXPECT_EQ(csv_cell("-"), "'-");
  EXPECT_EQ(csv_cell("\t=1"), "\"'\t=1\"");
  EXPECT_EQ(csv_cell("\r=1"), "\"'\r=1\"");
  EXPECT_EQ(csv_cell(" =1"), "' =1");
  EXPECT_EQ(csv_cell("=1+1, C, D"), "\"'=1+1, C, D\"");
  EXPECT_EQ(csv_cell("＝1"), "'＝1");
}

TEST(CsvCell, KeepsNumbersNumbers) {
  for (const std::string number : {"-1", "+5", "-1.5", "-.5", "+2e-3", "-7."}) {
    EXPECT_EQ(csv_cell(number), number);
  }
  for (const std::string formula : {"-1-1", "-1e", "-.", "-1.5.2", "+1e5+A1", "--1"}) {
    EXPECT_EQ(csv_cell(formula), "'" + formula);
  }
}

TEST(CsvCell, QuotesWhatWouldEndTheCell) {
  EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_cell("a;b"), "\"a;b\"");
  EXPECT_EQ(csv_cell("say \"when\""), "\"say \"\"when\"\"\"");
  EXPECT_EQ(csv_cell("two\nlines"), "\"two\nlines\"");
  EXPECT_EQ(csv_cell(" a"), "\" a\"");
}

TEST(CsvCell, AnApostropheThatWasThereStaysThere) {
  EXPECT_EQ(csv_cell("'=1"), "''=1");
  EXPECT_EQ(csv_text("''=1"), "'=1");
  EXPECT_EQ(csv_text("'=1"), "=1");
  EXPECT_EQ(csv_text("'tis"), "'tis");
  EXPECT_EQ(csv_text("'-1"), "'-1") << "csv_cell() puts nothing before a number";
}

RC_GTEST_PROP(CsvCell, AnyTextComesBackAndNoneIsAFormula, ()) {
  const auto characters = *rc::gen::container<std::vector<char>>(rc::gen::element(
      '\'', '=', '+', '-', '@', '\t', '\r', '\n', ' ', ',', ';', '"', '0', '1', '.', 'e', 'a'));
  const std::string text(characters.begin(), characters.end());
  const std::string cell = without_quotes(csv_cell(text));
  RC_ASSERT(std::string(csv_text(cell)) == text);
  if (!cell.empty() && std::string("=@\t\r\n").find(cell[0]) != std::string::npos) {
    RC_FAIL("a formula: " + cell);
  }
}

}  // namespace
}  // namespace changeover::csv_cell_test
