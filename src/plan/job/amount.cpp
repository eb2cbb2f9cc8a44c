#include "changeover/plan/job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>

#include "changeover/core/error.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t one_unit = 1'000'000;
constexpr unsigned most_decimals = 6;
constexpr auto largest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
constexpr std::uint64_t too_many = std::numeric_limits<std::uint64_t>::max();

Amount in_range(std::uint64_t millionths) {
  if (millionths > largest) {
    throw ImpossibleParameters(
        "these costs are too large: a total exceeds 9.2e12; use a larger unit");
  }
  return {millionths};
}

}  // namespace

Amount operator+(Amount a, Amount b) {
  std::uint64_t sum = 0;
  const bool wrapped = __builtin_add_overflow(a.millionths, b.millionths, &sum);
  return in_range(wrapped ? too_many : sum);
}

Amount operator*(Amount a, std::uint64_t times) {
  std::uint64_t product = 0;
  const bool wrapped = __builtin_mul_overflow(a.millionths, times, &product);
  return in_range(wrapped ? too_many : product);
}

Amount operator-(Amount a, Amount b) {
  if (b > a) {
    throw BadOption("a larger amount cannot be subtracted from a smaller one; compare them first");
  }
  return {a.millionths - b.millionths};
}

Amount parse_amount(std::string_view text) {
  const std::string said = shown(text);
  if (text.starts_with('-')) {
    throw BadInput(fmt::format("the cost {} is negative; give 0 or more", said));
  }
  const std::size_t point = std::min(text.find('.'), text.size());
  const std::string_view whole = text.substr(0, point);
  const std::string_view decimals = point < text.size() ? text.substr(point + 1) : "";
  if (whole.size() + decimals.size() == 0 || !std::ranges::all_of(whole, is_digit) ||
      !std::ranges::all_of(decimals, is_digit)) {
    throw BadInput(fmt::format("{} is not a cost; write a number, such as 12 or 12.50", said));
  }
  if (decimals.size() > most_decimals) {
    throw BadInput(fmt::format("the cost {} has more than six decimals; round it", said));
  }
  std::uint64_t units = 0;
  for (const char c : whole) {
    units = 10 * units + static_cast<std::uint64_t>(c - '0');
    if (units > largest / one_unit) {
      throw ImpossibleParameters(fmt::format(
          "the cost {} is too large; a total can be 9.2e12, so use a larger unit", said));
    }
  }
  std::uint64_t millionths = units * one_unit;
  std::uint64_t weight = one_unit;
  for (const char c : decimals) {
    weight /= 10;
    millionths += static_cast<std::uint64_t>(c - '0') * weight;
  }
  return in_range(millionths);
}

unsigned decimals_needed(Amount amount) {
  std::uint64_t rest = amount.millionths % one_unit;
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
  std::string text = fmt::format("{}", amount.millionths / one_unit);
  if (decimals > 0) {
    const std::string all = fmt::format("{:06}", amount.millionths % one_unit);
    text += "." + all.substr(0, decimals);
  }
  return text;
}

}  // namespace changeover
