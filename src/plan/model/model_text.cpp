#include "plan/model/model_text.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace changeover {
namespace {

char capital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

}  // namespace

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) {
    return text.substr(0, 0);
  }
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::vector<std::string_view> split_values(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) {
      return parts;
    }
    text.remove_prefix(end + 1);
  }
}

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  std::ranges::transform(capitals, capitals.begin(), capital);
  return capitals;
}

bool same_word(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, {}, capital, capital);
}

std::optional<double> number_in(std::string_view text) {
  const bool minus = text.starts_with('-');
  if (minus || text.starts_with('+')) {
    text.remove_prefix(1);
  }
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  text.remove_prefix(hexadecimal ? 2 : 0);
  constexpr std::string_view digits = "0123456789abcdefABCDEF";
  const bool begins_well =
      !text.empty() && (digits.substr(0, hexadecimal ? digits.size() : 10).find(text.front()) !=
                            std::string_view::npos ||
                        (!hexadecimal && text.size() > 1 && text.front() == '.'));
  double value = 0;
  const auto [end, fault] =
      std::from_chars(text.data(), text.data() + text.size(), value,
                      hexadecimal ? std::chars_format::hex : std::chars_format::general);
  if (!begins_well || fault != std::errc() || end != text.data() + text.size()) {
    return std::nullopt;
  }
  return minus ? -value : value;
}

}  // namespace changeover
