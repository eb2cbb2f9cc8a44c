#include "request/range.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

#include "cli/cli.hpp"

namespace changeover::cli {

Range range_of(const std::string& option, const std::string& text, std::uint64_t least) {
  const auto number = [&](std::string_view digits) {
    std::uint64_t value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [rest, failure] = std::from_chars(digits.data(), end, value);
    if (failure != std::errc() || rest != end || digits.empty()) {
      throw UsageError{fmt::format("{} {}: write A..B, ..B or A with whole numbers", option, text)};
    }
    return value;
  };
  const std::size_t dots = text.find("..");
  Range range;
  if (dots == std::string::npos) {
    range.from = range.to = number(text);
  } else {
    range.from = dots == 0 ? least : number(std::string_view(text).substr(0, dots));
    range.to = number(std::string_view(text).substr(dots + 2));
  }
  if (range.from > range.to) {
    throw UsageError{
        fmt::format("{} {}: the range is empty; write the smaller number first", option, text)};
  }
  return range;
}

}  // namespace changeover::cli
