#include "changeover/plan/amount.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>

#include "changeover/core/checked.hpp"
#include "changeover/core/error.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t unit = 1'000'000;
constexpr unsigned most_decimals = 6;
constexpr auto largest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());

Amount in_range(std::uint64_t millionths) {
  if (millionths > largest) {
    throw ImpossibleParameters("these costs are too large: a total exceeds 9.2e12");
  }
  return {millionths};
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

Amount operator+(Amount a, Amount b) { return in_range(checked_add(a.millionths, b.millionths)); }

Amount operator*(Amount a, std::uint64_t times) {
  return in_range(checked_multiply(a.millionths, times));
}

Amount operator-(Amount a, Amount b) {
  if (b > a) {
    throw InternalError("an amount of money became negative");
  }
  return {a.millionths - b.millionths};
}

Amount parse_amount(std::string_view text) {
  const std::string shown(text.substr(0, 40));
  if (text.starts_with('-')) {
    throw BadInput(fmt::format("the cost '{}' is negative; give 0 or more", shown));
  }
  const std::size_t point = std::min(text.find('.'), text.size());
  const std::string_view whole = text.substr(0, point);
  const std::string_view decimals = point < text.size() ? text.substr(point + 1) : "";
  if (whole.size() + decimals.size() == 0 || !std::all_of(whole.begin(), whole.end(), is_digit) ||
      !std::all_of(decimals.begin(), decimals.end(), is_digit)) {
    throw BadInput(fmt::format("'{}' is not a cost; write it as 12 or 12.50", shown));
  }
  if (decimals.size() > most_decimals) {
    throw BadInput(fmt::format("the cost '{}' has more than six decimals; round it", shown));
  }
  std::uint64_t millionths = 0;
  for (const char c : whole) {
    millionths =
        in_range(checked_add(checked_multiply(millionths, 10), static_cast<std::uint64_t>(c - '0')))
            .millionths;
  }
  millionths = in_range(checked_multiply(millionths, unit)).millionths;
  std::uint64_t weight = unit;
  for (const char c : decimals) {
    weight /= 10;
    millionths = checked_add(millionths, static_cast<std::uint64_t>(c - '0') * weight);
  }
  return in_range(millionths);
}

unsigned decimals_needed(Amount amount) {
  std::uint64_t rest = amount.millionths % unit;
  if (rest == 0) {
    return 0;
  }
  unsigned decimals = most_decimals;
  for (; rest % 10 == 0; rest /= 10) {
    --decimals;
  }
  return std::max(2U, decimals);
}

std::string to_string(Amount amount, unsigned at_least_decimals) {
  const unsigned decimals =
      std::min(most_decimals, std::max(at_least_decimals, decimals_needed(amount)));
  std::string text = fmt::format("{}", amount.millionths / unit);
  if (decimals > 0) {
    const std::string all = fmt::format("{:06}", amount.millionths % unit);
    text += "." + all.substr(0, decimals);
  }
  return text;
}

}  // namespace changeover
