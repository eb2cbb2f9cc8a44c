// A number that is a whole text.
//
//     parsed<std::uint64_t>("12")      // 12
//     parsed<std::uint64_t>("12 ")     // nothing; nor for "", "-1" and what is too large
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace changeover {

template <typename Number>
[[nodiscard]] std::optional<Number> parsed(std::string_view text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [rest, fault] = std::from_chars(text.data(), end, value);
  return fault == std::errc() && rest == end ? std::optional(value) : std::nullopt;
}

}  // namespace changeover
