// Tables for terminals.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace changeover {

/// A cell is a list of words that are never broken; lines break between them.
using Cell = std::vector<std::string>;

struct Column {
  std::string head;
  bool right = false;
  std::size_t width = 0;
};

/// The table, its head first, no wider than `width` unless words are.
[[nodiscard]] std::string laid_out(std::vector<Column> columns,
                                   const std::vector<std::vector<Cell>>& rows, std::size_t width);

}  // namespace changeover
