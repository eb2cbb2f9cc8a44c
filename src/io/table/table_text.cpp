// Tables for terminals.
#include <algorithm>
#include <numeric>

#include "changeover/io/tables.hpp"
#include "io/table/table.hpp"

namespace changeover {
namespace {

constexpr std::size_t column_gap = 2;

// The lines of a cell that are no longer than `width`, unless a word is.
std::vector<std::string> lines_of(const TableCell& cell, std::size_t width) {
  std::vector<std::string> lines;
  std::size_t columns = 0;  // of the last line
  for (std::size_t i = 0; i < cell.words.size(); ++i) {
    const auto breaks = [&](std::size_t at) { return !cell.breaks.empty() && cell.breaks[at]; };
    const bool last = i + 1 == cell.words.size() || breaks(i + 1);
    const std::string word = cell.words[i] + (last ? "" : ",");
    const std::size_t more = display_width(word);
    if (!lines.empty() && !breaks(i) && columns + 1 + more <= width) {
      lines.back() += " " + word;
      columns += 1 + more;
    } else {
      lines.push_back(word);
      columns = more;
    }
  }
  return lines;
}

class TextTable {
 public:
  TextTable(const Table& table, std::size_t width) : columns_(columns_in(table, in_text)) {
    for (const TableColumn* column : columns_) {
      heads_.push_back(head_line(*column, in_text));
      least_.push_back(std::max(display_width(heads_.back()), column->style.least_width));
    }
    widths_ = least_;
    for (std::size_t row = 0; row < table.rows; ++row) {
      rows_.emplace_back();
      for (std::size_t c = 0; c < columns_.size(); ++c) {
        rows_.back().push_back(columns_[c]->cell(row));
        measure(c, rows_.back().back());
      }
    }
    narrow(width);
  }

  [[nodiscard]] std::string text() const {
    std::string text;
    write(text, heads_);
    std::vector<std::string> cells(columns_.size());
    for (const std::vector<TableCell>& row : rows_) {
      std::vector<std::vector<std::string>> lines;
      std::size_t height = 1;
      for (std::size_t c = 0; c < columns_.size(); ++c) {
        lines.push_back(lines_of(row[c], widths_[c]));
        height = std::max(height, lines.back().size());
      }
      for (std::size_t i = 0; i < height; ++i) {
        for (std::size_t c = 0; c < columns_.size(); ++c) {
          cells[c] = i < lines[c].size() ? lines[c][i] : "";
        }
        write(text, cells);
      }
    }
    return text;
  }

 private:
  void measure(std::size_t c, const TableCell& cell) {
    for (const std::string& line : lines_of(cell, std::string::npos / 2)) {
      widths_[c] = std::max(widths_[c], display_width(line));
    }
    for (const std::string& word : cell.words) {
      least_[c] = std::max(least_[c], display_width(word) + (cell.words.size() > 1 ? 1 : 0));
    }
  }

  // The widest column that can be narrowed gives way.
  void narrow(std::size_t width) {
    while (std::accumulate(widths_.begin(), widths_.end(), column_gap * (widths_.size() - 1)) >
           width) {
      std::size_t widest = widths_.size();
      for (std::size_t c = 0; c < widths_.size(); ++c) {
        if (widths_[c] > least_[c] && (widest == widths_.size() || widths_[c] > widths_[widest])) {
          widest = c;
        }
      }
      if (widest == widths_.size()) {
        return;
      }
      --widths_[widest];
    }
  }

  void write(std::string& text, const std::vector<std::string>& cells) const {
    std::string line;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      const std::string pad(widths_[c] - std::min(widths_[c], display_width(cells[c])), ' ');
      line += (c == 0 ? "" : std::string(column_gap, ' ')) +
              (is_right(*columns_[c]) ? pad + cells[c] : cells[c] + pad);
    }
    line.resize(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }

  std::vector<const TableColumn*> columns_;
  std::vector<std::string> heads_;
  std::vector<std::size_t> least_;
  std::vector<std::size_t> widths_;
  std::vector<std::vector<TableCell>> rows_;
};

}  // namespace

std::string table_text(const Table& table, std::size_t width) {
  return TextTable(table, width).text();
}

}  // namespace changeover
