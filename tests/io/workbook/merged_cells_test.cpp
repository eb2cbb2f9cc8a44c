// Merged cells: what stands in the first one stands for those below it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "io/scan/row_reader.hpp"
#include "io/workbook/workbook_sheet.hpp"
#include "zip_files.hpp"

namespace changeover::merged_cells_test {
namespace {

using test::Members;
using testing::ElementsAre;
using testing::HasSubstr;

std::string cell(const std::string& place, const std::string& text) {
  return "<c r='" + place + "' t='inlineStr'><is><t>" + text + "</t></is></c>";
}

// One sheet with these merged ranges below its rows.
std::string merged(const std::string& rows, const std::string& ranges) {
  Members members = test::workbook_of({{"Run", rows}});
  for (auto& [name, text] : members) {
    const std::string end = "</sheetData>";
    if (const std::size_t at = text.find(end); at != std::string::npos) {
      text.insert(at + end.size(), "<mergeCells>" + ranges + "</mergeCells>");
    }
  }
  return test::zipped(members);
}

std::string said(const std::string& bytes) {
  std::string text;
  try {
    WorkbookSheet sheet(bytes, "f.xlsx");
    while (const auto row = sheet.next()) {
      text += text.empty() ? "" : " | ";
      for (const SheetCell& each : row->cells) {
        text += sheet.place(each.column, row->number).substr(11) + "=" + each.text + " ";
      }
      text += row->across.empty() ? "" : "(" + range_name(row->across.front()) + ")";
    }
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return text;
}

TEST(MergedCells, StandForEachRowThatHasSomethingElse) {
  const std::string rows = "<row r='1'>" + cell("A1", "1") + cell("B1", "Pump") +
                           "</row><row r='2'>" + cell("A2", "2") + "</row><row r='4'>" +
                           cell("C4", "x") + "</row><row r='5'>" + cell("A5", "5") + "</row>";
  EXPECT_EQ(said(merged(rows, "<mergeCell ref='B1:B4'/>")),
            "A1=1 B1=Pump  | A2=2 B2=Pump  | B4=Pump C4=x  | A5=5 ");
  EXPECT_EQ(said(merged(rows, "")), "A1=1 B1=Pump  | A2=2  | C4=x  | A5=5 ");
  // A range of which the first cell is empty says nothing; one cell alone is none.
  EXPECT_EQ(said(merged(rows, "<mergeCell ref='C2:C4'/>")),
            "f.xlsx:Run!C4: it is hidden by the merged cells C2:C4, and says something else; "
            "separate them");
  EXPECT_EQ(said(merged(rows, "<mergeCell ref='D1:D5'/><mergeCell ref='A1'/>")),
            "A1=1 B1=Pump  | A2=2  | C4=x  | A5=5 ");
  EXPECT_THAT(said(merged(rows, "<mergeCell ref='4:B'/>")),
              HasSubstr("merged cells without a range"));
}

TEST(MergedCells, AreNotWithoutEnd) {
  std::string ranges;
  for (int i = 0; i <= 100'000; ++i) {
    ranges += "<mergeCell ref='D1:D5'/>";
  }
  EXPECT_EQ(said(merged("<row r='1'>" + cell("A1", "1") + "</row>", ranges)),
            "f.xlsx:Run: more than 100000 merged ranges; separate these cells");
}

TEST(MergedCells, OfSeveralColumnsStandInTheFirst) {
  const std::string bytes = merged(
      "<row r='1'>" + cell("A1", "a") + cell("B1", "b") + cell("C1", "c") + "</row><row r='2'>" +
          cell("A2", "Tuesday") + "</row><row r='3'>" + cell("C3", "z") + "</row>",
      "<mergeCell ref='A2:B3'/>");
  EXPECT_EQ(said(bytes), "A1=a B1=b C1=c  | A2=Tuesday (A2:B3) | A3=Tuesday C3=z (A2:B3)");
  const auto input = input_from_text(bytes, "f.xlsx");
  RowReader reader(*input);
  Row row = reader.next().value();
  EXPECT_EQ(reader.merged_with_others(row[1]), std::nullopt);
  row = reader.next().value();
  EXPECT_EQ(reader.merged_with_others(row[0]), std::nullopt);
  EXPECT_EQ(reader.merged_with_others(row[1]), "A2:B3");
  EXPECT_EQ(reader.merged_with_others(row[2]), std::nullopt);
}

TEST(MergedCells, OfManyRowsAreReadInTheirTime) {
  std::string rows = "<row r='1'>" + cell("A1", "1") + cell("B1", "Pump") + "</row>";
  constexpr int last = 3000;
  for (int r = 2; r <= last; ++r) {
    rows += "<row r='" + std::to_string(r) + "'>" + cell("A" + std::to_string(r), "x") + "</row>";
  }
  WorkbookSheet sheet(merged(rows, "<mergeCell ref='B1:B1048576'/>"), "f.xlsx");
  int filled = 0;
  while (const auto row = sheet.next()) {
    filled += row->cells.size() == 2 ? 1 : 0;
  }
  EXPECT_EQ(filled, last);
}

}  // namespace
}  // namespace changeover::merged_cells_test
