// Rows of fields out of a text or a sheet of a workbook, each field with its place.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "changeover/io/input.hpp"
#include "io/scan/input_lines.hpp"
#include "io/scan/peeked_input.hpp"
#include "io/workbook/workbook_sheet.hpp"

namespace changeover {

// Rows from memory, which need no parsing, for the reader of rows.

/// Rows of fields as an input of RowReader. Fields are taken as they are, as cells of a workbook
/// are: no row is a comment, and no quotes are removed. Only `header` is a header. Other readers
/// see an empty input.
class GivenRows final : public Input {
 public:
  using Fields = std::vector<std::string>;

  GivenRows(std::string name, Fields header, std::vector<Fields> rows)
      : Input(std::move(name)), header_(std::move(header)), rows_(std::move(rows)) {}

  /// The header; nothing if there is none.
  [[nodiscard]] const Fields& header() const { return header_; }
  [[nodiscard]] const std::vector<Fields>& rows() const { return rows_; }
  std::size_t read(std::span<char> /*buffer*/) override { return 0; }

 private:
  Fields header_;
  std::vector<Fields> rows_;
};

struct Field {
  std::string text;          ///< without quotes and the blanks around it
  std::size_t offset = 0;    ///< of its first byte in the line; in a workbook its column, from 0
  std::uint64_t line = 1;    ///< where it stands
  bool in_quotes = false;    ///< it was written in quotes, or is a cell of a workbook
  std::string in_full = {};  ///< with the blanks around it, in a workbook and if there are any
};
using Row = std::vector<Field>;

/// One sheet of a workbook as an input. Other readers see the bytes of the file.
class SheetInput final : public Input {
 public:
  SheetInput(std::unique_ptr<Input> file, std::string sheet)
      : Input(file->name()), file_(std::move(file)), sheet_(std::move(sheet)) {}

  [[nodiscard]] const std::string& sheet() const { return sheet_; }
  std::size_t read(std::span<char> buffer) override { return file_->read(buffer); }
  bool rewind() override { return file_->rewind(); }

 private:
  std::unique_ptr<Input> file_;
  std::string sheet_;
};

/// How rows are split into fields.
struct RowOptions {
  bool any_separator = false;  ///< commas, semicolons and tabs all separate, in each row on its own
  bool blanks = false;         ///< a row without any of them may be split by at_blanks()
  std::function<bool(const std::vector<Field>&)> is_no_comment =
      {};  ///< whether a row that begins with # is a row all the same, as the heads "#,A,B" are
  bool percent_too =
      false;  ///< a row that begins with % is a comment, too, and blanks may come before it
  std::size_t longest_line = std::size_t{1} << 24;
  std::string_view too_long = "a line of more than 16 MiB; split it, or name another file";
  std::uint64_t most_rows = std::uint64_t{1} << 22;
  std::uint64_t most_bytes = std::uint64_t{1} << 30;

  /// No limits of rows and bytes: for callers that do not hold the rows in memory.
  [[nodiscard]] static RowOptions of_any_length() {
    RowOptions options;
    options.most_rows = options.most_bytes = ~std::uint64_t{0};
    return options;
  }
};

/// Reads an input row by row: the only reader of CSV, for lists and for designs. It holds a line at
/// a time, so that endless inputs end with a fault. An input that begins like a workbook is one:
/// its first sheet is read, or that of a SheetInput. GivenRows are taken as they are. Every row of
/// a sheet has at least as many fields as the first one, and no row of it is a comment.
///
///     RowReader rows(input);
///     while (rows.next_line()) {
///       if (quick(rows.line())) continue;   // a line whose fields are not needed
///       if (rows.split(row)) …              // the fields of this line
///     }
class RowReader {
 public:
  /// The input must outlive this. @throws MissingResource if reading fails; BadInput for a workbook
  /// that cannot be read.
  explicit RowReader(Input& input, const RowOptions& options = {});

  /// The next row but comments and blank ones; nothing at the end. Rows are split at the separator
  /// that comes first outside quotes in the first row that has one: a comma, a semicolon, or a tab
  /// with text on both sides; otherwise as the options say. @throws BadInput with a place for text
  /// that is not plain, quotes that do not match, and lines or lists that are too long;
  /// MissingResource if reading fails; Stopped if the scope of this thread (run/control.hpp) wants
  /// to stop.
  [[nodiscard]] std::optional<Row> next();

  /// The same in two steps, into a row that is reused. Goes to the next line, or row of the sheet;
  /// false at the end.
  [[nodiscard]] bool next_line();
  /// The line as it is in the file; empty in a workbook.
  [[nodiscard]] std::string_view line() const {
    return is_workbook() ? std::string_view() : lines_.line();
  }
  /// Its fields; false if it is a comment or blank.
  [[nodiscard]] bool split(Row& row);

  /// Whether the last row of next() came below an empty line; a comment is none.
  [[nodiscard]] bool after_blank() const { return after_blank_; }

  /// @throws BadInput with the place of this offset in the line of the last row.
  [[noreturn]] void fail(std::size_t offset, std::string_view what) const;
  /// @throws BadInput with the place of this field, of any row.
  [[noreturn]] void fail(const Field& field, std::string_view what) const;

  /// The place of this field, of any row: "list.csv:3:7", "book.xlsx:Run!D3".
  [[nodiscard]] std::string place(const Field& field) const;

  /// The merged cells that this field of the last row is part of, "B5:C5", if what they say is in
  /// another column. Nothing outside workbooks.
  [[nodiscard]] std::optional<std::string> merged_with_others(const Field& field) const;

  /// The separator of the rows: ',', ';' or a tab; a comma as long as no row has one.
  [[nodiscard]] char separator() const { return separator_ == '\0' ? ',' : separator_; }

  /// Whether rows come from a workbook or GivenRows, whose cells are taken as they are; those of a
  /// text may have the apostrophe of csv_cell().
  [[nodiscard]] bool is_workbook() const { return sheet_.has_value() || given_ != nullptr; }

  /// Whether the rows are GivenRows, whose header is given and never guessed.
  [[nodiscard]] bool is_given() const { return given_ != nullptr; }

 private:
  /// The next row of the sheet that is not blank.
  std::optional<Row> next_of_sheet();
  std::optional<Row> next_given();
  /// Whether a line that begins like a comment is none; its fields are then in the row.
  [[nodiscard]] bool is_row_all_the_same(std::string_view line, Row& row) const;

  RowOptions options_;
  PeekedInput input_;
  InputLines lines_;
  std::optional<WorkbookSheet> sheet_;
  const GivenRows* given_ = nullptr;
  std::uint64_t given_next_ = 0;     // the header is 0, rows come after it
  std::optional<Row> of_sheet_;      // the last one that next_line() found, of given rows too
  std::uint64_t sheet_row_ = 1;      // its number
  std::size_t width_ = 0;            // of the first row of the sheet
  std::vector<MergedRange> across_;  // of its last row
  std::uint64_t rows_ = 0;
  char separator_ = '\0';  // not known yet
  bool after_blank_ = false;
};

/// Splits a row of one field at blanks; quotes hold a field with blanks together, and empty fields
/// are dropped. @throws BadInput through the reader.
[[nodiscard]] Row at_blanks(const Field& field, const RowReader& reader);

/// Splits one row at commas. @throws BadInput without a place.
[[nodiscard]] Row split_row(std::string_view line);

/// A field written so that it reads back the same: quoted if it has commas, semicolons, tabs,
/// quotes or outer blanks, or begins with #.
[[nodiscard]] std::string quoted_field(std::string_view field);

/// The same for a field among blanks: quoted if it holds a blank, too, or begins with %.
[[nodiscard]] std::string quoted_among_blanks(std::string_view field);

}  // namespace changeover
