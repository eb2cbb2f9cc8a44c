#include "core/words.hpp"

#include <fmt/format.h>

#include <array>

namespace changeover {

std::string count_of(std::uint64_t n, std::string_view one, std::string_view many) {
  return n == 1         ? fmt::format("1 {}", one)
         : many.empty() ? fmt::format("{} {}s", n, one)
                        : fmt::format("{} {}", n, many);
}

std::string all_of(std::uint64_t n, std::string_view one) {
  return n == 1 ? fmt::format("the {}", one) : "all " + count_of(n, one);
}

std::string leading_defect(const std::vector<std::string>& messages) {
  std::string message = messages.front();
  if (messages.size() > 1) {
    message.insert(std::min(message.rfind("; "), message.size()),
                   fmt::format(" (and {} more like this)", messages.size() - 1));
  }
  return message;
}

std::string change_name(std::uint64_t m) {
  return m == 1 ? "single-change" : m == 2 ? "double-change" : fmt::format("{}-change", m);
}

bool is_missing_number(std::string_view word) {
  constexpr auto values = std::to_array<std::string_view>(
      {"nan", "inf", "infinity", "na", "n/a", "n.a.", "none", "null", "nil", "?", ""});
  const std::string small = lower_case(word);
  const std::size_t first = std::min(small.find_first_not_of("+-."), small.size());
  return std::ranges::find(values, std::string_view(small).substr(first)) != values.end();
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return lower;
}

}  // namespace changeover
