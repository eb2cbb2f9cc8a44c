#include "plan/job/parts/cost_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "changeover/core/error.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "plan/job/parts/heading_words.hpp"

namespace changeover {
namespace {

bool is_of_number(char c) { return is_digit(c) || c == '.' || c == ','; }

bool is_currency(std::string_view sign) {
  constexpr auto all = std::to_array<std::string_view>(
      {"€", "$", "£", "¥", "eur", "euro", "usd", "gbp", "chf", "jpy", "fr.", "sfr."});
  return std::ranges::find(all, sign) != all.end();
}

// The unit of time of a sign, as in "15 min"; none for currencies and units of length.
CostUnit unit_of_sign(const std::string& sign) { return unit_in_heading("(" + sign + ")"); }

}  // namespace

bool CostReader::is_like_a_cost(std::string_view text) {
  for (const std::string_view sign : {"€", "$", "£", "¥"}) {
    if (text.starts_with(sign)) {
      text.remove_prefix(sign.size());
    }
  }
  const std::size_t start = text.find_first_not_of(' ');
  if (start == std::string_view::npos ||
      !(is_of_number(text[start]) || text[start] == '-' || text[start] == '+')) {
    return false;
  }
  // A date has two signs between its numbers: 2024-05-01, 1/5/24.
  return text.find_first_of("-/", start + 1) == std::string_view::npos;
}

std::string CostReader::without_sign(const Field& field) {
  const std::string& text = field.text;
  const std::size_t begin = std::min(text.find_first_of("0123456789.,+-"), text.size());
  std::size_t end = begin;
  while (end < text.size() && (is_of_number(text[end]) || text[end] == '+' || text[end] == '-')) {
    ++end;
  }
  const auto trimmed = [](const std::string& sign) {
    const std::size_t first = sign.find_first_not_of(' ');
    const std::size_t last = sign.find_last_not_of(' ');
    return first == std::string::npos ? "" : lower_case(sign.substr(first, last - first + 1));
  };
  const std::string before = trimmed(text.substr(0, begin));
  const std::string after = trimmed(text.substr(end));
  const std::string sign = before.empty() ? after : before;
  const CostUnit unit = before.empty() && !after.empty() ? unit_of_sign(after) : CostUnit::none;
  if (begin == end || sign.empty() || (!before.empty() && !after.empty()) ||
      (unit == CostUnit::none && !is_currency(sign))) {
    return text;  // then the number is at fault
  }
  if (!sign_.empty() && sign_ != sign && (unit != unit_ || unit == CostUnit::none)) {
    reader_->fail(field, fmt::format("some costs are in {} and some in {}; use one of them",
                                     shown(sign_), shown(sign)));
  }
  sign_ = sign;
  unit_ = unit;
  return text.substr(begin, end - begin);
}

std::optional<Amount> CostReader::on_clock(const Field& field, std::string_view text) {
  std::array<std::uint64_t, 3> parts{};
  std::size_t count = 0;
  std::size_t digits = 0;
  for (const char c : text) {
    if (c == ':' && digits > 0 && count < 2) {
      ++count;
      digits = 0;
    } else if (is_digit(c) && digits < (count == 0 ? 6U : 2U)) {
      parts[count] = parts[count] * 10 + static_cast<std::uint64_t>(c - '0');
      ++digits;
    } else {
      return std::nullopt;
    }
  }
  constexpr std::uint64_t sixty = 60;
  constexpr std::uint64_t millionths = 1'000'000;
  if (count == 0 || digits != 2 || parts[1] >= sixty || parts[2] >= sixty) {
    return std::nullopt;
  }
  if (parts[2] * millionths % sixty != 0) {
    reader_->fail(field, fmt::format("{} is not a decimal of minutes; write seconds as a number, "
                                     "below a head such as 'Swap time (s)'",
                                     shown(text)));
  }
  return Amount{(parts[0] * sixty + parts[1]) * millionths + parts[2] * millionths / sixty};
}

Amount CostReader::number(const Field& field, std::string text) {
  const bool comma = reader_->separator() != ',' && std::ranges::count(text, ',') == 1 &&
                     text.find('.') == std::string::npos;
  if (comma) {
    const std::size_t at = text.find(',');
    constexpr std::size_t of_thousands = 3;
    if (text.size() - at - 1 == of_thousands && at >= 1 && at <= of_thousands && text[0] != '0') {
      reader_->fail(field, fmt::format("{} may be thousands or a fraction; write {}{} or {}.{}0",
                                       shown(text), text.substr(0, at), text.substr(at + 1),
                                       text.substr(0, at), text.substr(at + 1)));
    }
    text[at] = '.';
  }
  const bool point = !comma && text.find('.') != std::string::npos;
  // A number in a workbook has no decimal sign.
  if (!reader_->is_workbook() && ((comma && points_) || (point && commas_))) {
    reader_->fail(field, "some costs have a decimal comma and some a point; use one of them");
  }
  commas_ = commas_ || comma;
  points_ = points_ || point;
  try {
    return parse_amount(text);
  } catch (const Error& fault) {
    reader_->fail(field, comma
                             ? fmt::format("{} is not a cost; write a number, such as 12 or 12,50",
                                           shown(field.text))
                             : std::string(fault.what()));
  }
}

Amount CostReader::read(const Field& field) {
  const auto clock = on_clock(field, field.text);
  (clock ? clocks_ : numbers_) = true;
  if (clocks_ && numbers_) {
    reader_->fail(field, "some costs are times as 0:15 and some are numbers; use one form");
  }
  if (clock) {
    unit_ = CostUnit::minutes;
    return *clock;
  }
  return number(field, without_sign(field));
}

}  // namespace changeover
