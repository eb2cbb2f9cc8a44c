// What a workbook says apart from its sheets: where they are, the texts and the formats that they
// share.
#pragma once

#include <string>
#include <vector>

#include "io/workbook/cell_text.hpp"
#include "io/workbook/zip_archive.hpp"

namespace changeover {

struct WorkbookParts {
  struct Sheet {
    std::string name;
    std::string member;  ///< of the archive; empty for a sheet without cells, as one of a chart
    bool hidden = false;
  };

  std::vector<Sheet> sheets;        ///< in the order of their tabs
  std::vector<std::string> texts;   ///< by number
  std::vector<NumberStyle> styles;  ///< by the number of the cell format
  bool from_1904 = false;           ///< days are counted from 1904 on
};

/// @throws BadInput with one line that begins with `file`.
[[nodiscard]] WorkbookParts workbook_parts(const ZipArchive& archive, const std::string& file);

/// A text of more bytes is none of a cell.
inline constexpr std::size_t longest_cell = 131'068;  // 32,767 characters

}  // namespace changeover
