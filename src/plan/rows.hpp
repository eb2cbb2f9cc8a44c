// Rows of fields out of a text, each field with its place.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace changeover::plan_detail {

struct Field {
  std::string text;        ///< without quotes and the blanks around it
  std::size_t offset = 0;  ///< in the text
};
using Row = std::vector<Field>;

/// A text with a name for messages.
class RowText {
 public:
  RowText(std::string_view text, std::string name);

  /// All rows but comments and blank ones, split at commas, or at semicolons if one comes first.
  /// @throws BadInput with a place for control bytes and quotes that do not match.
  [[nodiscard]] std::vector<Row> rows() const;

  /// @throws BadInput with the place of the byte at `offset`.
  [[noreturn]] void fail(std::size_t offset, std::string_view what) const;

 private:
  std::string text_;
  std::string name_;
};

/// One row at commas. @throws BadInput without a place.
[[nodiscard]] Row split_row(std::string_view line);

/// A field as it must be written so that it is read as it is: quoted if it holds commas, semicolons,
/// quotes or outer blanks, or begins with #.
[[nodiscard]] std::string quoted(std::string_view field);

}  // namespace changeover::plan_detail
