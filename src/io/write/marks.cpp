#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_set>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/io/tables.hpp"
#include "core/printable.hpp"
#include "io/write/element_text.hpp"

namespace changeover {

namespace {

struct Range {
  char32_t first, last;
};

template <std::size_t N>
bool in_ranges(char32_t value, const std::array<Range, N>& ranges) {
  return std::ranges::any_of(ranges, [=](Range r) { return r.first <= value && value <= r.last; });
}

// Ranges of combining marks and joiners, and of characters that terminals draw over two columns.
constexpr std::array<Range, 7> no_width = {{{0x300, 0x36F},
                                            {0x483, 0x489},
                                            {0x1AB0, 0x1AFF},
                                            {0x1DC0, 0x1DFF},
                                            {0x200B, 0x200F},
                                            {0x20D0, 0x20FF},
                                            {0xFE00, 0xFE0F}}};
constexpr std::array<Range, 8> two_columns = {{{0x1100, 0x115F},
                                               {0x2E80, 0xA4CF},
                                               {0xAC00, 0xD7A3},
                                               {0xF900, 0xFAFF},
                                               {0xFE30, 0xFE6F},
                                               {0xFF00, 0xFF60},
                                               {0x1F300, 0x1F64F},
                                               {0x20000, 0x3FFFD}}};

}  // namespace

std::size_t display_width(std::string_view text) {
  std::size_t width = 0;
  while (!text.empty()) {
    const CodePoint point = first_code_point(text);
    text.remove_prefix(point.bytes);
    if (point.valid && in_ranges(point.value, no_width)) {
      continue;
    }
    width += point.valid && in_ranges(point.value, two_columns) ? 2U : 1U;
  }
  return width;
}

std::vector<AlignedBlock> aligned_rows(const Design& design) {
  DesignSource source(design);
  return aligned_rows(source, 0);
}

std::vector<AlignedBlock> aligned_rows(BlockSource& source, std::uint64_t first,
                                       std::uint64_t last) {
  const std::uint64_t v = source.parameters().v;
  if (v > max_elements_in_memory) {
    throw ImpossibleParameters(
        fmt::format("v = {} exceeds {}: too many elements to lay out", v, max_elements_in_memory));
  }
  std::vector<AlignedBlock> columns;
  Block rows;  // the elements of the block before, or of this one once it is placed
  // By element: the number of the block it was last in, introduced in, and left in; from 1.
  struct Seen {
    std::uint64_t in = 0, introduced = 0, leaving = 0;
  };
  std::vector<Seen> seen(static_cast<std::size_t>(v));
  for (Transitions steps(source); steps.next() && steps.index() <= last;) {
    if (steps.index() < first) {
      continue;
    }
    const std::uint64_t number = steps.index() + 1;
    for (const Element x : steps.introduced()) {
      seen[x].introduced = number;
    }
    for (const Element x : steps.leaving()) {
      seen[x].leaving = number;
    }
    if (rows.empty()) {
      rows.assign(steps.block().begin(), steps.block().end());
    } else {
      Block entering;
      for (const Element x : steps.block()) {
        if (seen[x].in != number - 1) {
          entering.push_back(x);
        }
      }
      for (const Element x : steps.block()) {
        seen[x].in = number;
      }
      auto next = entering.begin();
      for (Element& row : rows) {
        if (seen[row].in != number) {
          row = *next++;
        }
      }
    }
    AlignedBlock column;
    for (const Element x : rows) {
      seen[x].in = number;
      column.push_back({x, seen[x].introduced == number, seen[x].leaving == number});
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

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
