// Rows of fields out of a text, each field with its place.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/io/input.hpp"
#include "io/read/input_lines.hpp"

namespace changeover {

struct Field {
  std::string text;        ///< without quotes and the blanks around it
  std::size_t offset = 0;  ///< of its first byte in the line
  std::uint64_t line = 1;  ///< where it stands
  bool in_quotes = false;  ///< it was written in quotes
};
using Row = std::vector<Field>;

/// Reads an input row by row; it holds a line at a time, so that endless inputs end with a fault.
class RowReader {
 public:
  /// The input must outlive this.
  explicit RowReader(Input& input);

  /// The next row but comments and blank ones; nothing at the end. Rows are split at what comes first outside
  /// quotes in the first row that has it: a comma, a semicolon, or a tab with text on both sides.
  /// @throws BadInput with a place for what is no plain text, quotes that do not match and lines or lists
  /// beyond all measure; MissingResource if reading fails; Stopped if the scope of this thread
  /// (run/scope.hpp) wants to stop.
  [[nodiscard]] std::optional<Row> next();

  /// @throws BadInput with the place of this offset in the line of the last row.
  [[noreturn]] void fail(std::size_t offset, std::string_view what) const;
  /// @throws BadInput with the place of this field, of whatever row.
  [[noreturn]] void fail(const Field& field, std::string_view what) const;

  /// What splits the rows: ',', ';' or a tab; a comma as long as no row needs any.
  [[nodiscard]] char separator() const { return separator_ == '\0' ? ',' : separator_; }

 private:
  /// Goes to the next line; false at the end of the input.
  bool next_line();

  InputLines lines_;
  std::uint64_t rows_ = 0;
  char separator_ = '\0';  // not known yet
};

/// One row at commas. @throws BadInput without a place.
[[nodiscard]] Row split_row(std::string_view line);

/// A field as it must be written so that it is read as it is: quoted if it holds commas, semicolons,
/// quotes or outer blanks, or begins with #.
[[nodiscard]] std::string quoted(std::string_view field);

}  // namespace changeover
