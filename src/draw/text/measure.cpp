#include "draw/text/measure.hpp"

#include <array>

#include "changeover/draw/picture.hpp"
#include "changeover/io/tables.hpp"
#include "core/printable.hpp"

namespace changeover {
namespace {

// Thousandths of the font size, as DejaVu Sans has them, which is wider than most: from U+0020 on.
constexpr std::array<int, 95> advances = {
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};
// Widths of other characters by their columns on a terminal, 0 to 2: marks above letters; letters
// and signs; ideographs and pictographs.
constexpr std::array<double, 3> others = {0, 0.95, 1.25};
constexpr double wider_if_bold = 1.12;

}  // namespace

double text_width(std::string_view text, double font_size, bool bold) {
  double width = 0;
  while (!text.empty()) {
    const CodePoint point = first_code_point(text);
    const std::string_view piece = text.substr(0, point.bytes);
    text.remove_prefix(point.bytes);
    const bool ascii = point.valid && point.value >= 0x20 && point.value < 0x7F;
    width += ascii ? advances[point.value - 0x20] / 1000.0 : others[display_width(piece)];
  }
  return width * font_size * (bold ? wider_if_bold : 1);
}

std::string fitted(std::string_view text, double room, double font_size, bool bold) {
  if (text_width(text, font_size, bold) <= room) {
    return std::string(text);
  }
  constexpr std::string_view dots = "…";
  room -= text_width(dots, font_size, bold);
  std::string start;
  double used = 0;
  while (!text.empty()) {
    const std::string_view piece = text.substr(0, first_code_point(text).bytes);
    used += text_width(piece, font_size, bold);
    if (used > room) {
      break;
    }
    start += piece;
    text.remove_prefix(piece.size());
  }
  return start + std::string(dots);
}

}  // namespace changeover
