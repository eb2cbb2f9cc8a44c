// Reads from the workbook of a parts list the request that it was made for, or lists on its other
// sheets.
#pragma once

#include <string>
#include <vector>

namespace changeover {

/// The pieces of a document for that sheet, short enough for cells.
[[nodiscard]] std::vector<std::string> question_pieces(const std::string& document);

}  // namespace changeover
