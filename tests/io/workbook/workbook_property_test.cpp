// Sheets at random are read as they were written, and a workbook that was damaged never says
// something else: its parts have checksums.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <iterator>

#include "damage.hpp"
#include "io/workbook/cell_text.hpp"
#include "io/workbook/workbook_sheet.hpp"
#include "zip_files.hpp"

namespace changeover::workbook_property_test {
namespace {

using test::Damage;
using test::some_number;

// What cells say, by row and column.
using Cells = std::map<std::pair<std::uint64_t, std::uint64_t>, std::string>;

std::string escaped(const std::string& text) {
  std::string xml;
  for (const char c : text) {
    xml += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  }
  return xml;
}

std::string some_text() {
  return test::some_text(
      {"Pump", "Valve, large", " ", "&", "<b>", "\"", "é", "漢", "0042", "=1+1", "]]>", "'"}, 4);
}

// A cell as spreadsheet programs write it; `says` is what it means.
struct Cell {
  std::string xml;  // its attributes without the place, and what is in it
  std::string says;
};

Cell some_cell(std::vector<std::string>& shared) {
  switch (some_number(6)) {
    case 0: {
      shared.push_back(some_text());
      return {fmt::format(" t='s'><v>{}</v>", shared.size() - 1), shared.back()};
    }
    case 1: {
      const std::string text = some_text();
      return {" t='inlineStr'><is><t xml:space='preserve'>" + escaped(text) + "</t></is>", text};
    }
    case 2: {
      const std::string text = some_text();
      const bool is_empty = text.empty();
      return {" t='str'><f>A1</f><v>" + escaped(is_empty ? "0" : text) + "</v>",
              is_empty ? "0" : text};
    }
    case 3: {
      const bool yes = some_number(1) == 1;
      return {fmt::format(" t='b'><v>{}</v>", yes ? 1 : 0), yes ? "TRUE" : "FALSE"};
    }
    case 4: {
      const std::uint64_t day = some_number(27);
      return {fmt::format(" s='1'><v>{}</v>", 45658 + day), fmt::format("2025-01-{:02}", day + 1)};
    }
    case 5: {
      const std::string digits = fmt::format("{}.{}", some_number(99'999), 1 + some_number(8));
      return {"><v>" + digits + "000</v>", digits};
    }
    default:
      const std::string digits = std::to_string(some_number(999'999'999'999'999));
      return {"><v>" + digits + "</v>", digits};
  }
}

struct Book {
  Cells cells;
  test::Members members;
};

Book some_book() {
  Book book;
  std::vector<std::string> shared;
  std::string xml;
  std::uint64_t row = 0;
  for (std::uint64_t rows = some_number(4); rows > 0; --rows) {
    row += 1 + some_number(2);
    xml += fmt::format("<row r='{}'>", row);
    std::uint64_t column = 0;
    for (std::uint64_t cells = some_number(4); cells > 0; --cells) {
      column += some_number(30);
      const Cell cell = some_cell(shared);
      xml += fmt::format("<c r='{}'{}</c>\n", cell_name(column, row), cell.xml);
      if (!cell.says.empty()) {
        book.cells[{row, column}] = cell.says;
      }
      ++column;
    }
    xml += "</row>";
  }
  std::string texts;
  for (const std::string& text : shared) {
    texts += "<si><t xml:space='preserve'>" + escaped(text) + "</t></si>\n";
  }
  book.members = test::workbook_of({{"Costs", xml}}, texts,
                                   "<cellXfs><xf numFmtId='0'/><xf numFmtId='14'/></cellXfs>");
  return book;
}

Cells read(const std::string& bytes) {
  WorkbookSheet sheet(bytes, "f.xlsx");
  Cells cells;
  std::uint64_t last = 0;
  while (const auto row = sheet.next()) {
    RC_ASSERT(row->number > last);
    RC_ASSERT(!row->cells.empty());
    last = row->number;
    for (const SheetCell& cell : row->cells) {
      RC_ASSERT(!cell.text.empty());
      RC_ASSERT(cell_place(cell_name(cell.column, row->number)) ==
                (CellPlace{cell.column, row->number}));
      RC_ASSERT((cells.emplace(std::pair(row->number, cell.column), cell.text).second));
    }
  }
  return cells;
}

RC_GTEST_PROP(WorkbookProperty, CellsAreReadAsTheyWereWritten, ()) {
  const Book book = some_book();
  RC_ASSERT(read(test::zipped(book.members)) == book.cells);
}

RC_GTEST_PROP(WorkbookProperty, ADamagedFileIsRefusedOrSaysTheSame, (const Damage& damage)) {
  const Book book = some_book();
  const std::string bytes = damage.of(test::zipped(book.members));
  Cells cells;
  if (begins_like_a_workbook(bytes) && test::accepted("f.xlsx:", [&] { cells = read(bytes); })) {
    RC_ASSERT(cells == book.cells);
  }
}

// A workbook of these texts, one a row.
std::vector<std::string> read_again(const std::vector<std::string>& texts) {
  std::string xml;
  for (const std::string& text : texts) {
    xml += "<row><c t='str'><v>" + escaped(with_escapes(text)) + "</v></c></row>";
  }
  std::vector<std::string> again;
  for (const auto& [place, text] : read(test::zipped(test::workbook_of({{"Costs", xml}})))) {
    again.push_back(text);
  }
  return again;
}

// Where the parts themselves are written wrongly, with right checksums: a sheet that is one, or one
// line.
RC_GTEST_PROP(WorkbookProperty, DamagedXmlIsRefusedOrASheet,
              (const std::array<Damage, 4>& damages)) {
  const Book book = some_book();
  for (const Damage& damage : damages) {
    test::Members members = book.members;
    auto part = members.find("xl/worksheets/sheet1.xml");
    if (some_number(1) == 0) {
      part =
          std::next(members.begin(), static_cast<std::ptrdiff_t>(some_number(members.size() - 1)));
    }
    part->second = damage.of(part->second);
    Cells cells;
    if (!test::accepted("f.xlsx:", [&] { cells = read(test::zipped(members)); })) {
      continue;
    }
    std::vector<std::string> texts;
    for (const auto& [place, text] : cells) {
      RC_ASSERT(text.find_first_of("\n\r\t") == std::string::npos);
      texts.push_back(text);
    }
    RC_ASSERT(read_again(texts) == texts);
  }
}

}  // namespace
}  // namespace changeover::workbook_property_test
