#include "plan/sheet/layout.hpp"

#include <algorithm>
#include <numeric>

#include "changeover/io/tables.hpp"

namespace changeover {
namespace {

// The lines of a cell that are no longer than `width`, unless a word is.
std::vector<std::string> lines_of(const Cell& cell, std::size_t width) {
  std::vector<std::string> lines;
  std::size_t columns = 0;  // of the last line
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const std::string word = cell[i] + (i + 1 < cell.size() ? "," : "");
    const std::size_t more = display_width(word);
    if (!lines.empty() && columns + 1 + more <= width) {
      lines.back() += " " + word;
      columns += 1 + more;
    } else {
      lines.push_back(word);
      columns = more;
    }
  }
  return lines;
}

}  // namespace

std::string laid_out(std::vector<Column> columns, const std::vector<std::vector<Cell>>& rows,
                     std::size_t width) {
  constexpr std::size_t gap = 2;
  std::vector<std::size_t> least;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    least.push_back(display_width(columns[c].head));
    columns[c].width = least.back();
    for (const std::vector<Cell>& row : rows) {
      for (const std::string& line : lines_of(row[c], std::string::npos / 2)) {
        columns[c].width = std::max(columns[c].width, display_width(line));
      }
      for (const std::string& word : row[c]) {
        least[c] = std::max(least[c], display_width(word) + (row[c].size() > 1 ? 1 : 0));
      }
    }
  }
  // The widest column that can be narrowed gives way.
  const auto total = [&] {
    return std::accumulate(columns.begin(), columns.end(), gap * (columns.size() - 1),
                           [](std::size_t sum, const Column& c) { return sum + c.width; });
  };
  while (total() > width) {
    std::size_t widest = columns.size();
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (columns[c].width > least[c] &&
          (widest == columns.size() || columns[c].width > columns[widest].width)) {
        widest = c;
      }
    }
    if (widest == columns.size()) {
      break;
    }
    --columns[widest].width;
  }
  std::string text;
  const auto write = [&](const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const std::string pad(columns[c].width - std::min(columns[c].width, display_width(cells[c])),
                            ' ');
      line += (c == 0 ? "" : std::string(gap, ' ')) +
              (columns[c].right ? pad + cells[c] : cells[c] + pad);
    }
    line.resize(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  };
  std::vector<std::string> cells;
  cells.reserve(columns.size());
  for (const Column& column : columns) {
    cells.push_back(column.head);
  }
  write(cells);
  for (const std::vector<Cell>& row : rows) {
    std::vector<std::vector<std::string>> lines;
    std::size_t height = 1;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      lines.push_back(lines_of(row[c], columns[c].width));
      height = std::max(height, lines.back().size());
    }
    for (std::size_t i = 0; i < height; ++i) {
      for (std::size_t c = 0; c < columns.size(); ++c) {
        cells[c] = i < lines[c].size() ? lines[c][i] : "";
      }
      write(cells);
    }
  }
  return text;
}

}  // namespace changeover
