#include "io/scan/place.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "core/printable.hpp"
#include "core/utf8.hpp"

namespace changeover {

Place place_of(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t newline = before.rfind('\n');
  const std::size_t start = newline == std::string_view::npos ? 0 : newline + 1;
  return {static_cast<std::uint64_t>(std::count(before.begin(), before.end(), '\n')) + 1,
          before.size() - start + 1};
}

std::string_view without_byte_order_mark(std::string_view text) {
  return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

void fail(const std::string& name, Place place, std::string_view what) {
  throw BadInput(fmt::format("{}:{}:{}: {}", name, place.line, place.column, what));
}

std::string control_byte_defect(char byte) {
  return fmt::format("control byte 0x{:02x}; the input must be plain text",
                     static_cast<unsigned char>(byte));
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

}  // namespace changeover
