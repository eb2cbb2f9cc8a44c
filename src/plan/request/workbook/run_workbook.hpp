// A workbook that was made as a run sheet, or as those of several benches: which sheets it has, and
// what is written on them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/io/input.hpp"
#include "changeover/io/request.hpp"
#include "io/workbook/workbook_sheet.hpp"
#include "plan/job/setups/setup_columns.hpp"

namespace changeover {

/// The hidden sheet with the question, below a head that is the format of the document: the
/// document in pieces, one a row.
inline constexpr std::string_view question_sheet = "changeover-question";
/// The sheets of a run sheet: what is to be done on one bench, and what was done before.
inline constexpr std::string_view steps_sheet = "Run sheet";
inline constexpr std::string_view done_sheet = "Done";
inline constexpr std::string_view parts_sheet = "Parts";

/// A workbook in memory.
struct RunWorkbook {
  std::shared_ptr<const std::string> bytes;
  std::string name;               ///< in messages
  std::vector<SheetName> sheets;  ///< in the order of the tabs
  RequestList list;               ///< that it came as

  /// The sheet of this name, in whatever case; null if there is none.
  [[nodiscard]] const SheetName* sheet(std::string_view wanted) const;
  /// Such a list, of one sheet.
  [[nodiscard]] RequestList on_sheet(const std::string& wanted) const;
  /// The same to be read. It holds on to the bytes.
  [[nodiscard]] std::unique_ptr<Input> open(std::string_view wanted) const;
  /// A sheet, row by row.
  [[nodiscard]] WorkbookSheet rows(const std::string& wanted) const;
  /// The sheets with what is to be done, in their order: that of this name, and those whose heads
  /// are those of steps, whatever their tabs are called. Of copies, the one with most results; a
  /// line in `notes` says which.
  [[nodiscard]] std::vector<std::string> run_sheets(
      std::vector<std::string>* notes = nullptr) const;
  /// The sheets of tests that were done before: that of this name first, then all others with such
  /// heads and some result, which people add.
  [[nodiscard]] std::vector<std::string> tests_done() const;

  /// The other visible sheets that have a head of results.
  [[nodiscard]] std::vector<std::string> unread_results() const;

  /// The hidden sheets with steps or tests and some result, which are not read.
  [[nodiscard]] std::vector<std::string> hidden_results() const;

  /// Notes name the sheets of both.
  void note_unread_results(std::vector<std::string>& notes) const;

 private:
  [[nodiscard]] SheetShape shape(const std::string& wanted) const;
};

/// The first row of a sheet, or that below its titles, which has the heads of a run sheet. The next
/// row of the sheet is then the first below it.
struct HeadRow {
  std::uint64_t number = 0;
  Heads heads;
};
[[nodiscard]] std::optional<HeadRow> head_row(WorkbookSheet& sheet);

/// The text of a cell in this column; "" if it is empty.
[[nodiscard]] std::string cell_text(const SheetRow& row, std::size_t column);

/// The workbook that a list is, if no sheet of it is named. A file that can be read once only is
/// left alone. @throws BadInput for one that cannot be read; MissingResource
[[nodiscard]] std::optional<RunWorkbook> run_workbook(const RequestList& list,
                                                      const std::string& spelled);

/// The inputs of a list of tests that were done, in their order: of a workbook with run sheets or a
/// question, its sheets of tests that were done and then these; else the list itself.
/// @throws as open()
[[nodiscard]] std::vector<std::unique_ptr<Input>> open_done(const RequestList& list,
                                                            const std::string& spelled);

}  // namespace changeover
