#include "io/workbook/cell_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>

#include "core/parsed.hpp"

namespace changeover {
namespace {

std::string without_zeros_at_end(std::string text) {
  if (text.find('.') != std::string::npos) {
    while (text.ends_with('0')) {
      text.pop_back();
    }
    if (text.ends_with('.')) {
      text.pop_back();
    }
  }
  return text;
}

void append_utf8(std::string& text, std::uint32_t c) {
  constexpr std::uint32_t low = 0x3f;
  if (c < 0x80) {
    text += static_cast<char>(c);
  } else if (c < 0x800) {
    text += static_cast<char>(0xc0 | (c >> 6));
    text += static_cast<char>(0x80 | (c & low));
  } else {
    text += static_cast<char>(0xe0 | (c >> 12));
    text += static_cast<char>(0x80 | ((c >> 6) & low));
    text += static_cast<char>(0x80 | (c & low));
  }
}

constexpr std::size_t escape_length = 7;  // _x000D_

// The code of an escape with which the text begins.
std::optional<std::uint32_t> escape_at(std::string_view text) {
  if (text.size() < escape_length || !text.starts_with("_x") || text[escape_length - 1] != '_') {
    return std::nullopt;
  }
  std::uint32_t code = 0;
  const char* const end = text.data() + escape_length - 1;
  const auto [stop, failure] = std::from_chars(text.data() + 2, end, code, 16);
  return failure == std::errc() && stop == end ? std::optional(code) : std::nullopt;
}

}  // namespace

std::string number_text(double number) {
  constexpr double no_more_digits = 1e15;
  constexpr double least_plain = 1e-4;
  const double size = std::fabs(number);
  if (size == 0) {
    return "0";
  }
  if (size >= no_more_digits) {
    return fmt::format("{:.0f}", number);
  }
  return size < least_plain ? without_zeros_at_end(fmt::format("{:.20f}", number))
                            : fmt::format("{:.15g}", number);
}

NumberStyle style_of_format(std::string_view format) {
  format = format.substr(0, format.find(';'));
  for (std::size_t at = 0; at < format.size(); ++at) {
    const char c = format[at];
    if (c == '"') {
      at = std::min(format.find('"', at + 1), format.size());
    } else if (c == '\\' || c == '_' || c == '*') {
      ++at;
    } else if (c == '[') {
      const std::size_t end = std::min(format.find(']', at), format.size());
      const std::string_view inner = format.substr(at + 1, end - at - 1);
      if (!inner.empty() && inner.find_first_not_of("hHmMsS") == std::string_view::npos) {
        return NumberStyle::number;
      }
      at = end;
    } else if (std::string_view("dDmMyYhHsS").find(c) != std::string_view::npos) {
      return NumberStyle::date;
    }
  }
  return NumberStyle::number;
}

NumberStyle style_of_built_in(std::uint64_t format) {
  const bool date = (format >= 14 && format <= 22) || (format >= 27 && format <= 36) ||
                    (format >= 45 && format <= 47 && format != 46) ||
                    (format >= 50 && format <= 58);
  return date ? NumberStyle::date : NumberStyle::number;
}

std::string date_text(double days, bool from_1904) {
  constexpr double end_of_calendar = 2'958'466;  // 10000-01-01
  constexpr std::int64_t seconds_a_day = 86'400;
  if (!(days >= 0 && days < end_of_calendar)) {
    return number_text(days);
  }
  const auto seconds = static_cast<std::int64_t>(std::llround(days * seconds_a_day));
  const std::int64_t day = seconds / seconds_a_day;
  const std::int64_t rest = seconds % seconds_a_day;
  std::string time = fmt::format("{:02}:{:02}:{:02}", rest / 3600, rest / 60 % 60, rest % 60);
  if (day == 0 && !from_1904) {
    return time;
  }
  using namespace std::chrono;
  // Spreadsheets took over that 1900 was a leap year.
  constexpr std::int64_t leap_day = 60;
  const sys_days start = from_1904        ? sys_days(year{1904} / January / 1)
                         : day < leap_day ? sys_days(year{1899} / December / 31)
                                          : sys_days(year{1899} / December / 30);
  const year_month_day date(start + std::chrono::days(day));
  std::string text =
      day == leap_day && !from_1904
          ? "1900-02-29"
          : fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                        static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
  return rest == 0 ? text : text + " " + time;
}

std::string without_escapes(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const auto code = escape_at(text.substr(at));
    if (code && !(*code >= 0xd800 && *code < 0xe000)) {
      append_utf8(result, *code);
      at += escape_length;
    } else {
      result += text[at++];
    }
  }
  return result;
}

std::string with_escapes(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    result += escape_at(text.substr(at)) ? "_x005F_" : std::string(1, text[at]);
  }
  return result;
}

std::string on_one_line(std::string_view text) {
  std::string line;
  for (const char c : text) {
    if (c != '\n' && c != '\r' && c != '\t') {
      line += c;
    } else if (!line.ends_with(' ')) {
      line += ' ';
    }
  }
  return line;
}

std::string cell_name(std::uint64_t column, std::uint64_t row) {
  std::string letters;
  for (std::uint64_t rest = column + 1; rest > 0; rest = (rest - 1) / 26) {
    letters.insert(letters.begin(), static_cast<char>('A' + (rest - 1) % 26));
  }
  return letters + std::to_string(row);
}

std::optional<CellPlace> cell_place(std::string_view name) {
  CellPlace place;
  std::size_t at = 0;
  for (; at < name.size() && name[at] >= 'A' && name[at] <= 'Z'; ++at) {
    place.column = place.column * 26 + static_cast<std::uint64_t>(name[at] - 'A') + 1;
    if (place.column > most_sheet_columns) {
      return std::nullopt;
    }
  }
  place.row = parsed<std::uint64_t>(name.substr(at)).value_or(0);
  if (at == 0 || place.row == 0 || place.row > most_sheet_rows) {
    return std::nullopt;
  }
  --place.column;
  return place;
}

}  // namespace changeover
