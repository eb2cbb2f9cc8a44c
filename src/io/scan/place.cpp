#include "io/scan/place.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/error.hpp"

namespace changeover {

Place place_of(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t newline = before.rfind('\n');
  const std::size_t start = newline == std::string_view::npos ? 0 : newline + 1;
  return {static_cast<std::uint64_t>(std::ranges::count(before, '\n')) + 1,
          before.size() - start + 1};
}

std::string_view without_byte_order_mark(std::string_view text) {
  return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

void fail(const std::string& name, Place place, std::string_view what) {
  throw BadInput(fmt::format("{}:{}:{}: {}", name, place.line, place.column, what));
}

}  // namespace changeover
