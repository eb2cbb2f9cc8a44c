// One sheet of a workbook (.xlsx), row by row.
//
//     WorkbookSheet sheet(bytes, "parts.xlsx", "Costs");     // or its first sheet
//     while (const auto row = sheet.next()) row->cells;       // those with something in them
//
// An .xlsx is a zip archive of XML [ISO/IEC 29500]: the sheet itself is unpacked and read a piece
// at a time; what the whole workbook shares (texts, formats of numbers) is held in memory. A cell
// says what a reader of the sheet sees: a text, a number in full, TRUE or FALSE, a date as
// 2024-05-01; a formula says the value that the file holds for it. Line ends and tabs within a cell
// are blanks. What merged cells say, each row of them says in their first column, if it has
// something else in it, too. Hidden sheets are found by their name only.
//
// Limits: 64 MiB as a file; unpacked, 512 MiB of the sheet and 64 MiB of what is shared; 32,767
// characters a cell and 16 MiB a row; 1 GiB of text in all.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace changeover {

struct SheetCell {
  std::uint64_t column = 0;  ///< from 0
  std::string text;          ///< never empty
};

/// Cells that are shown as one.
struct MergedRange {
  std::uint64_t first_column = 0;  ///< from 0
  std::uint64_t first_row = 0;     ///< from 1
  std::uint64_t last_column = 0;
  std::uint64_t last_row = 0;
};
/// "B2:B4".
[[nodiscard]] std::string range_name(const MergedRange& range);

struct SheetRow {
  std::uint64_t number = 0;         ///< from 1
  std::vector<SheetCell> cells;     ///< at least one; columns increase
  std::vector<MergedRange> across;  ///< that it is part of and that have several columns
};

/// Whether a file that begins like this may be a workbook, an old or an encrypted one included;
/// eight bytes are enough.
[[nodiscard]] bool begins_like_a_workbook(std::string_view beginning);

/// A sheet of a workbook, in the order of the tabs.
struct SheetName {
  std::string name;
  bool hidden = false;

  bool operator==(const SheetName&) const = default;
};

/// The sheets that have cells. @throws BadInput as WorkbookSheet.
[[nodiscard]] std::vector<SheetName> workbook_sheets(std::string bytes, const std::string& file);

class WorkbookSheet {
 public:
  /// The sheet of this name, compared without regard to the case of ASCII letters, or the first
  /// visible one.
  /// @throws BadInput with one line that begins with `file` if it is no workbook that can be read,
  /// or there is no such sheet.
  WorkbookSheet(std::string bytes, const std::string& file,
                const std::optional<std::string>& sheet = {});
  ~WorkbookSheet();
  WorkbookSheet(const WorkbookSheet&) = delete;
  WorkbookSheet& operator=(const WorkbookSheet&) = delete;

  /// The next row that has something in it; nothing at the end. @throws BadInput with file, sheet
  /// and cell.
  [[nodiscard]] std::optional<SheetRow> next();

  /// "parts.xlsx:Costs!B3".
  [[nodiscard]] std::string place(std::uint64_t column, std::uint64_t row) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace changeover
