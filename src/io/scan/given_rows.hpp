// Rows that nobody has to parse: whoever has them as data hands them to the reader of rows.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "changeover/io/input.hpp"

namespace changeover {

/// Rows of fields as an input of RowReader. A field says what it says, as a cell of a workbook does: no row is a comment, no
/// quotes are taken off. Only what is given as `header` is one. To others it is empty.
class GivenRows final : public Input {
 public:
  using Fields = std::vector<std::string>;

  GivenRows(std::string name, Fields header, std::vector<Fields> rows)
      : Input(std::move(name)), header_(std::move(header)), rows_(std::move(rows)) {}

  /// Nothing if no row is a header.
  [[nodiscard]] const Fields& header() const { return header_; }
  [[nodiscard]] const std::vector<Fields>& rows() const { return rows_; }
  std::size_t read(std::span<char> /*buffer*/) override { return 0; }

 private:
  Fields header_;
  std::vector<Fields> rows_;
};

}  // namespace changeover
