// Coordinates as short as they can be.
#pragma once

#include <fmt/format.h>

#include <string>

namespace changeover {

/// With at most two decimals: "12", "0.5", "-3.25".
[[nodiscard]] inline std::string coordinate(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') {
    text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

}  // namespace changeover
