#include "core/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace changeover {
namespace {

// A terminal shows a name with one of these in another order than that of its letters.
bool turns_around(char32_t c) {
  return (c >= 0x202a && c <= 0x202e) || (c >= 0x2066 && c <= 0x2069);
}

// Zero-width characters, joiners, marks of direction, soft hyphens, and what chooses between
// shapes.
bool takes_no_room(char32_t c) {
  return c == 0xad || c == 0x34f || c == 0x61c || c == 0x180e || (c >= 0x200b && c <= 0x200f) ||
         (c >= 0x2060 && c <= 0x2064) || (c >= 0xfe00 && c <= 0xfe0f) || c == 0xfeff;
}

bool is_another_blank(char32_t c) {
  return c == 0xa0 || (c >= 0x2000 && c <= 0x200a) || c == 0x202f || c == 0x205f || c == 0x3000;
}

bool ends_a_line(char32_t c) { return c == 0x2028 || c == 0x2029; }

}  // namespace

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
  return point.valid && c >= 0x20 && !(c >= 0x7f && c <= 0x9f) && !ends_a_line(c) &&
         !turns_around(c);
}

std::string shown(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string_view rest = word;
  while (!rest.empty()) {
    const std::size_t bytes = first_code_point(rest).bytes;
    if (word.size() - rest.size() + bytes > longest) {
      break;
    }
    rest.remove_prefix(bytes);
  }
  const std::string_view front = word.substr(0, word.size() - rest.size());
  return "'" + printable(front) + (rest.empty() ? "'" : "…'");
}

std::string control_byte_defect(char byte) {
  return fmt::format("control byte 0x{:02x}; give plain text in UTF-8",
                     static_cast<unsigned char>(byte));
}

std::optional<TextDefect> first_defect(std::string_view text, bool allow_tabs) {
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = static_cast<unsigned char>(text[at]);
    if (byte >= 0x20 && byte < 0x7f) {  // almost all texts
      ++at;
      continue;
    }
    if (byte == '\t') {
      if (!allow_tabs) {
        return TextDefect{at, "a tab; write a blank, and a comma between fields"};
      }
      ++at;
      continue;
    }
    if (byte == '\r') {
      return TextDefect{at, std::string(lone_carriage_return)};
    }
    if (byte < 0x20 || byte == 0x7f) {
      return TextDefect{at, control_byte_defect(text[at])};
    }
    const CodePoint point = first_code_point(text.substr(at));
    if (!point.valid) {
      return TextDefect{at,
                        fmt::format("byte 0x{:02x} is not UTF-8; save the text as UTF-8", byte)};
    }
    const auto number = static_cast<std::uint32_t>(point.value);
    if (point.value < 0xa0) {
      return TextDefect{
          at, fmt::format("control character U+{:04X}; give plain text in UTF-8", number)};
    }
    if (turns_around(point.value)) {
      return TextDefect{
          at, fmt::format("U+{:04X}, which reverses the direction of writing; remove it", number)};
    }
    if (ends_a_line(point.value)) {
      return TextDefect{at, fmt::format("U+{:04X}, which ends a line; remove it", number)};
    }
    at += point.bytes;
  }
  return std::nullopt;
}

std::string visible(std::string_view name) {
  std::string seen;
  while (!name.empty()) {
    const CodePoint point = first_code_point(name);
    if (is_another_blank(point.value)) {
      seen += ' ';
    } else if (!takes_no_room(point.value)) {
      seen += name.substr(0, point.bytes);
    }
    name.remove_prefix(point.bytes);
  }
  const std::size_t first = std::min(seen.find_first_not_of(' '), seen.size());
  const std::size_t last = seen.find_last_not_of(' ');
  return last == std::string::npos ? "" : seen.substr(first, last + 1 - first);
}

}  // namespace changeover
