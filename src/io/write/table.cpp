#include "changeover/io/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include "io/write/block_name.hpp"

namespace changeover {
namespace {

struct Column {
  std::size_t width = 0;
  std::vector<std::string> cells;  // header first, without padding
  std::vector<std::size_t> widths;
  std::vector<char> tones;  // of each cell: '*' introduced, '.' leaving, ' ' kept, 'B' header
};

Column make_column(const Design& design, const AlignedBlock& block, std::size_t index,
                   const TableOptions& options) {
  Column column;
  const auto add = [&](std::string text, char tone) {
    column.widths.push_back(display_width(text));
    column.width = std::max(column.width, column.widths.back());
    column.cells.push_back(std::move(text));
    column.tones.push_back(tone);
  };
  add("B" + block_name(options.names, index), 'B');
  for (const MarkedElement& cell : block) {
    std::string text = design.label(cell.element);
    if (options.introduced && cell.introduced) {
      text += '*';
    }
    if (options.leaving && cell.leaving) {
      text += '.';
    }
    add(std::move(text), cell.introduced ? '*' : cell.leaving ? '.' : ' ');
  }
  return column;
}

std::string_view colour_of(char tone) {
  switch (tone) {
    case '*':
      return "\x1b[32m";
    case '.':
      return "\x1b[31m";
    case 'B':
      return "\x1b[1m";
    default:
      return "\x1b[2m";
  }
}

constexpr std::size_t gap = 2;

class Band {
 public:
  Band(const TableOptions& options, bool margin) : options_(&options), margin_(margin) {}

  bool fits(const Column& column) const {
    const std::size_t after = positions_width() + width_ + (columns_.empty() ? 0 : gap);
    return columns_.empty() || after + column.width <= options_->width;
  }

  void add(Column column, bool marked_after) {
    width_ += (columns_.empty() ? 0 : gap) + column.width;
    columns_.push_back(std::move(column));
    marked_.push_back(marked_after);
  }

  bool empty() const { return columns_.empty(); }

  void write(Sink& sink, bool mark_before) {
    std::string text;
    for (std::size_t row = 0; row < columns_[0].cells.size(); ++row) {
      std::size_t owed = margin_ ? gap : 0;  // blanks that are due before the next cell
      for (const Column& column : columns_) {
        text.append(owed, ' ');
        if (options_->colour) {
          text += colour_of(column.tones[row]);
          text += column.cells[row];
          text += "\x1b[0m";
        } else {
          text += column.cells[row];
        }
        owed = column.width - column.widths[row] + gap;
      }
      text += '\n';
    }
    std::string marks(margin_ ? gap : 0, ' ');
    if (margin_ && mark_before) {
      marks[0] = '^';
    }
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      marks.append(columns_[i].width, ' ');
      marks += marked_[i] ? "^ " : "  ";
    }
    marks.erase(marks.find_last_not_of(' ') + 1);
    if (!marks.empty()) {
      text += marks + '\n';
    }
    sink.write(text);
    columns_.clear();
    marked_.clear();
    width_ = 0;
  }

 private:
  std::size_t positions_width() const { return (margin_ ? gap : 0) + (marks() ? 1 : 0); }
  bool marks() const { return !options_->positions.empty(); }

  const TableOptions* options_;
  bool margin_;  // room for the mark of position 0
  std::vector<Column> columns_;
  std::vector<bool> marked_;
  std::size_t width_ = 0;
};

}  // namespace

void write_table(const Design& design, Sink& sink, const TableOptions& options) {
  const std::unordered_set<std::uint64_t> positions(options.positions.begin(),
                                                    options.positions.end());
  Band band(options, positions.contains(0));
  bool first_band = true;
  const auto flush = [&] {
    if (!first_band) {
      sink.write("\n");
    }
    band.write(sink, first_band);
    first_band = false;
  };
  const std::vector<AlignedBlock> blocks = aligned_rows(design);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    Column column = make_column(design, blocks[i], i, options);
    if (!band.fits(column)) {
      flush();
    }
    band.add(std::move(column), positions.contains(i + 1));
  }
  if (!band.empty()) {
    flush();
  }
}

}  // namespace changeover
