#include "shell/roff.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cstddef>
#include <cstdint>

namespace changeover::cli {
namespace {

bool in_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
}

// Whether text[at], a minus sign, is a hyphen of a word that begins with no minus sign.
bool is_hyphen(std::string_view text, std::size_t at) {
  std::size_t begin = at;
  while (begin > 0 && in_word(text[begin - 1])) {
    --begin;
  }
  return text[begin] != '-' && at + 1 < text.size() && in_word(text[at + 1]) && text[at + 1] != '-';
}

// The character of UTF-8 that begins at `at`, which goes to its end; 0 if it is none.
char32_t decoded(std::string_view text, std::size_t& at) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const unsigned lead = byte(at);
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  char32_t value = lead & (0xffU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    value = value << 6U | (byte(at + i) & 0x3fU);
  }
  at += length;
  return value;
}

std::string escaped(std::string_view text, bool literal) {
  std::string out;
  if (!text.empty() && text.front() == '.') {
    out = "\\&";
  }
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if ((static_cast<unsigned char>(c) & 0x80U) != 0) {
      out += fmt::format("\\[u{:04X}]", static_cast<std::uint32_t>(decoded(text, at)));
      continue;
    }
    switch (c) {
      case '\\':
        out += "\\e";
        break;
      case '\'':
        out += "\\(aq";
        break;
      case '`':
        out += "\\(ga";
        break;
      case '^':
        out += "\\(ha";
        break;
      case '~':
        out += "\\(ti";
        break;
      case '"':
        out += "\\(dq";
        break;
      case '-':
        out += !literal && is_hyphen(text, at) ? "-" : "\\-";
        break;
      default:
        out += c;
    }
    ++at;
  }
  return out;
}

}  // namespace

std::string roff_text(std::string_view text) { return escaped(text, false); }
std::string roff_literal(std::string_view text) { return escaped(text, true); }
std::string roff_bold(std::string_view text) { return "\\fB" + roff_literal(text) + "\\fR"; }
std::string roff_italic(std::string_view text) { return "\\fI" + roff_literal(text) + "\\fR"; }

}  // namespace changeover::cli
