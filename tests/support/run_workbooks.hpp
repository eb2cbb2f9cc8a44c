// Workbooks of run sheets as people fill them in.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/workbook/workbook_sheet.hpp"
#include "zip_files.hpp"

namespace changeover::test {

// The member of the archive that is the sheet of this name.
inline std::string member_of(const std::string& bytes, const std::string& name) {
  const std::vector<SheetName> sheets = workbook_sheets(bytes, "f.xlsx");
  const auto found = std::ranges::find(sheets, name, &SheetName::name);
  return fmt::format("xl/worksheets/sheet{}.xml", found - sheets.begin() + 1);
}

// What a person does with a sheet: words in a column, from the first row below the head on; where
// there is none already.
inline std::string filled_in(const std::string& bytes, const std::vector<std::string>& results,
                             const std::string& name = "Run sheet",
                             const std::string& column_head = "result") {
  WorkbookSheet sheet(bytes, "f.xlsx", name);
  std::uint64_t column = 0;
  const std::optional<SheetRow> head = sheet.next();
  for (const SheetCell& cell : head.value().cells) {
    column = cell.text == column_head ? cell.column : column;
  }
  Members members = unzipped(bytes);
  std::string& xml = members[member_of(bytes, name)];
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (results[i].empty()) {
      continue;
    }
    const std::size_t start = xml.find(fmt::format("<row r=\"{}\"", i + 2));
    if (start == std::string::npos) {
      break;
    }
    const std::string place = fmt::format("{}{}", static_cast<char>('A' + column), i + 2);
    const std::size_t end = xml.find("</row>", start);
    // A cell that is there, empty but for its looks, makes room.
    const std::size_t old = xml.find(fmt::format("<c r=\"{}\"", place), start);
    const std::string cell =
        fmt::format("<c r=\"{}\" t=\"inlineStr\"><is><t>{}</t></is></c>", place, results[i]);
    old < end ? xml.replace(old, xml.find("/>", old) + 2 - old, cell) : xml.insert(end, cell);
  }
  return zipped(members);
}

// The workbook with one more row on a sheet; texts and numbers.
inline std::string with_row(const std::string& bytes, const std::string& name,
                            const std::vector<std::string>& cells) {
  WorkbookSheet sheet(bytes, "f.xlsx", name);
  std::uint64_t last = 0;
  while (const auto row = sheet.next()) {
    last = row->number;
  }
  std::string xml = fmt::format("<row r=\"{}\">", last + 1);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string place = fmt::format("{}{}", static_cast<char>('A' + i), last + 1);
    const bool is_number = cells[i].find_first_not_of("0123456789.") == std::string::npos;
    xml += cells[i].empty() ? ""
           : is_number
               ? fmt::format("<c r=\"{}\"><v>{}</v></c>", place, cells[i])
               : fmt::format("<c r=\"{}\" t=\"inlineStr\"><is><t>{}</t></is></c>", place, cells[i]);
  }
  Members members = unzipped(bytes);
  std::string& text = members[member_of(bytes, name)];
  text.insert(text.find("</sheetData>"), xml + "</row>");
  return zipped(members);
}

}  // namespace changeover::test
