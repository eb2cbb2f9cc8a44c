#include "core/printable.hpp"

#include <fmt/format.h>

#include <iterator>

#include "core/utf8.hpp"

namespace changeover {

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const CodePoint point = first_code_point(text);
    const std::string_view piece = text.substr(0, point.bytes);
    text.remove_prefix(point.bytes);
    if (is_printable(point)) {
      result += piece;
    } else if (piece == "\n") {
      result += "\\n";
    } else if (piece == "\r") {
      result += "\\r";
    } else if (piece == "\t") {
      result += "\\t";
    } else if (piece.size() == 1) {
      fmt::format_to(std::back_inserter(result), "\\x{:02x}", static_cast<unsigned char>(piece[0]));
    } else {
      fmt::format_to(std::back_inserter(result), "\\u{{{:04x}}}",
                     static_cast<std::uint32_t>(point.value));
    }
  }
  return result;
}

bool is_printable(std::string_view text) {
  while (!text.empty()) {
    const CodePoint point = first_code_point(text);
    if (!is_printable(point)) {
      return false;
    }
    text.remove_prefix(point.bytes);
  }
  return true;
}

}  // namespace changeover
