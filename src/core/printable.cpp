#include "core/printable.hpp"

#include <fmt/format.h>

#include <array>

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
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(piece[0]));
    } else {
      result += fmt::format("\\u{{{:04x}}}", static_cast<std::uint32_t>(point.value));
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

CodePoint first_code_point(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) {
    return {lead, 1, true};
  }
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) {
    return {};
  }
  char32_t value = lead & (0xFFU >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xC0) != 0x80) {
      return {};
    }
    value = value << 6 | (byte & 0x3F);
  }
  constexpr std::array<char32_t, 5> least = {0, 0, 0x80, 0x800, 0x10000};
  if (value < least[bytes] || value > 0x10FFFF || (value >= 0xD800 && value <= 0xDFFF)) {
    return {};
  }
  return {value, bytes, true};
}

bool is_printable(const CodePoint& point) {
  const char32_t c = point.value;
  return point.valid && c >= 0x20 && !(c >= 0x7f && c <= 0x9f) && !(c >= 0x2028 && c <= 0x202e) &&
         !(c >= 0x2066 && c <= 0x2069);
}

}  // namespace changeover
