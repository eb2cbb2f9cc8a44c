#include "changeover/io/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "core/utf8.hpp"

namespace changeover {

namespace {

struct Range {
  char32_t first, last;
};

template <std::size_t N>
bool in_ranges(char32_t value, const std::array<Range, N>& ranges) {
  return std::any_of(ranges.begin(), ranges.end(),
                     [=](Range r) { return r.first <= value && value <= r.last; });
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

}  // namespace changeover
