// Rows from memory, which need no parsing, for the reader of rows.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "changeover/io/input.hpp"

namespace changeover {

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

}  // namespace changeover
