// One table in every format.
#include "io/table/table.hpp"

#include <gtest/gtest.h>

#include "changeover/io/tables.hpp"
#include "io/table/table_document.hpp"

namespace changeover::table_table_test {
namespace {

// A table whose cells are written down, one column per row of `cells`.
TableColumn column(std::string head, std::vector<TableCell> cells, ColumnStyle style = {}) {
  return {std::move(head), [cells](std::size_t row) { return cells.at(row); }, std::move(style)};
}

Table of_columns(std::size_t rows, std::vector<TableColumn> columns) {
  return {.rows = rows, .columns = std::move(columns)};
}

constexpr ColumnStyle number{.kind = ColumnKind::number};
constexpr ColumnStyle list{.kind = ColumnKind::list};

TEST(TableText, WideCharactersTakeTwoColumnsAndAccentsNone) {
  EXPECT_EQ(table_text(of_columns(3, {column("part", {{"ポンプ"}, {"e\u0301cran"}, {"Motor"}}),
                                      column("n", {{"1"}, {"22"}, {"3"}}, number)}),
                       80),
            "part     n\n"
            "ポンプ   1\n"
            "e\u0301cran   22\n"
            "Motor    3\n");
}

TEST(TableText, WideNamesAreBrokenWhereTheLineEnds) {
  const std::vector<std::string> names{"モーター", "ポンプ", "ファン"};
  const std::string text = table_text(
      of_columns(1, {column("set-up", {{names}}, list), column("n", {{"1"}}, number)}), 22);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    EXPECT_LE(display_width(text.substr(at, end - at)), 22U) << text;
    at = end + 1;
  }
}

// A cell of a wide column of names has several lines; a number and a short list have one.
TEST(TableFormats, LatexBreaksWideLists) {
  const std::vector<std::string> names{"a pump with a long name", "another long name", "a third"};
  EXPECT_EQ(table_latex(of_columns(1, {column("set-up", {{names}}, list),
                                       column("new", {{std::vector<std::string>{"a", "b"}}}, list),
                                       column("n", {{"1"}}, number)})),
            "\\begin{tabular}{p{0.4\\linewidth}lr}\n\\toprule\n"
            "{\\raggedright set-up\\par} & new & n \\\\\n\\midrule\n"
            "{\\raggedright a pump with a long name, another long name, a third\\par} & a, b & 1 "
            "\\\\\n\\bottomrule\n\\end{tabular}\n");
}

// Each format escapes what it has to, and quotes what a list needs to be read again.
TEST(TableFormats, SayTheSameCellsEachInItsWay) {
  const std::vector<std::string> names{"Valve, large", "<b>|&"};
  const Table table = of_columns(
      1, {column("put\nin", {{names, {false, true}}}, {.kind = ColumnKind::list, .name = "put_in"}),
          column("cost", {{"=1.50"}}, {.kind = ColumnKind::cost}),
          column("how", {{"a_b"}}, {.kind = ColumnKind::remark, .in = for_people})});
  EXPECT_EQ(table_csv(table), "put_in,cost\n\"\"\"Valve, large\"\", <b>|&\",'=1.50\n");
  EXPECT_EQ(table_markdown(table),
            "| put in | cost | how |\n|:---|---:|:---|\n"
            "| Valve, large, **\\<b\\>\\|\\&** | =1.50 | a\\_b |\n");
  EXPECT_EQ(table_latex(table),
            "\\begin{tabular}{lrl}\n\\toprule\nput in & cost & how \\\\\n\\midrule\n"
            "Valve, large, " +
                latex_escaped("<b>|&") + " & =1.50 & $a_{b}$ \\\\\n\\bottomrule\n\\end{tabular}\n");
  EXPECT_EQ(
      table_html(table),
      "<table>\n<thead><tr><th>Put<br>in</th><th class=\"n\">Cost</th></tr></thead>\n<tbody>\n"
      "<tr><td><span class=\"part\">Valve, large</span> "
      "<span class=\"part in\">&lt;b&gt;|&amp;</span>"
      "<br><span class=\"small\">a_b</span></td><td class=\"n\">=1.50</td></tr>\n"
      "</tbody>\n</table>\n");
}

TEST(TableFormats, AColumnIsMadeOnlyForTheFormatsThatShowIt) {
  std::size_t made = 0;
  const Table table{.rows = 3,
                    .columns = {column("a", {{"1"}, {"2"}, {"3"}}),
                                {"b",
                                 [&](std::size_t) {
                                   ++made;
                                   return TableCell("x");
                                 },
                                 {.in = in_csv}}}};
  EXPECT_EQ(table_markdown(table), "| a |\n|:---|\n| 1 |\n| 2 |\n| 3 |\n");
  EXPECT_EQ(made, 0U);
  EXPECT_EQ(table_csv(table), "a,b\n1,x\n2,x\n3,x\n");
  EXPECT_EQ(made, 3U);
}

TEST(TableDocument, LinesOfAPageWithFiguresStandAtItsEnd) {
  TableDocument document{.title = "T & U", .headline = "2 tests", .lines = {"a_b"}};
  document.sections.push_back(
      {.heading = "Compared", .table = of_columns(1, {column("plan", {{"p"}})})});
  EXPECT_EQ(document_text(document, 80), "T & U\n2 tests\na_b\n\nCompared\nplan\np\n");
  EXPECT_EQ(document_markdown(document),
            "# T \\& U\n\n- 2 tests\n- a\\_b\n\n## Compared\n\n| plan |\n|:---|\n| p |\n");
  const auto order = [&](std::string_view before, std::string_view after) {
    const std::string page = document_html(document);
    return page.find(before) < page.find(after);
  };
  EXPECT_TRUE(order("a_b</p>", "<table>"));
  document.figures.push_back({.name = "Tests", .words = "2"});
  EXPECT_TRUE(order("<table>", "a_b</p>"));
  EXPECT_EQ(document_html(document).find("2 tests"), std::string::npos);
}

}  // namespace
}  // namespace changeover::table_table_test
