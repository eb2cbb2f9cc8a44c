#include "plan/sheet/benches/bench_calendar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "changeover/core/error.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

constexpr Amount night_and_day{24'000'000};

std::optional<int> digits(std::string_view text) {
  int number = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool plain = std::ranges::all_of(text, is_digit);
  return failure == std::errc() && end == text.data() + text.size() && plain ? std::optional(number)
                                                                             : std::nullopt;
}

bool is_weekend(std::chrono::sys_days day) {
  const std::chrono::weekday weekday(day);
  return weekday == std::chrono::Saturday || weekday == std::chrono::Sunday;
}

}  // namespace

std::chrono::sys_days parse_day(std::string_view text) {
  constexpr std::size_t length = 10;
  const bool shaped = text.size() == length && text[4] == '-' && text[7] == '-';
  const auto year = shaped ? digits(text.substr(0, 4)) : std::nullopt;
  const auto month = shaped ? digits(text.substr(5, 2)) : std::nullopt;
  const auto day = shaped ? digits(text.substr(8, 2)) : std::nullopt;
  if (year && month && day) {
    const std::chrono::year_month_day date{std::chrono::year(*year),
                                           std::chrono::month(static_cast<unsigned>(*month)),
                                           std::chrono::day(static_cast<unsigned>(*day))};
    constexpr int first_year = 1900;
    if (date.ok() && *year >= first_year) {
      return date;
    }
  }
  throw BadInput(fmt::format("{} is not a day; write it as 2025-03-31", shown(std::string(text))));
}

BenchCalendar::BenchCalendar(const Job& job, const std::vector<Bench>& benches,
                             std::optional<std::chrono::sys_days> first, bool weekends)
    : unit_(job.cost_unit == CostUnit::minutes   ? "minute"
            : job.cost_unit == CostUnit::seconds ? "second"
                                                 : "hour"),
      first_(first),
      weekends_(weekends) {
  const std::uint64_t hour = costs_of_hour(job);
  for (const Bench& bench : benches) {
    if (!bench.down) {
      has_days_ = has_days_ || bench.hours.has_value();
      hours_ = std::max(hours_, (bench.hours.value_or(night_and_day) * hour).millionths);
    }
  }
  hours_ = hours_ == 0 ? (night_and_day * hour).millionths : hours_;
  while (first_ && !weekends_ && is_weekend(*first_)) {
    *first_ += std::chrono::days(1);
  }
}

std::uint64_t BenchCalendar::day(Amount begin) const { return begin.millionths / hours_ + 1; }

std::uint64_t BenchCalendar::last_day(Amount end) const {
  return end.millionths == 0 ? 1 : (end.millionths - 1) / hours_ + 1;
}

Amount BenchCalendar::hour(Amount begin) const { return Amount{begin.millionths % hours_}; }

Amount BenchCalendar::last_hour(Amount end) const {
  return Amount{end.millionths - (last_day(end) - 1) * hours_};
}

std::optional<std::chrono::sys_days> BenchCalendar::nth(std::uint64_t day) const {
  constexpr std::uint64_t farthest = 1'000'000;  // more than two thousand years
  if (!first_ || day == 0 || day > farthest) {
    return std::nullopt;
  }
  const auto more = static_cast<std::int64_t>(day - 1);
  constexpr std::int64_t workdays = 5;
  constexpr std::int64_t week = 7;
  const auto monday = static_cast<std::int64_t>(std::chrono::weekday(*first_).iso_encoding()) - 1;
  const std::int64_t from_monday = monday + more;
  const std::chrono::sys_days date =
      *first_ +
      std::chrono::days(
          weekends_ ? more : from_monday / workdays * week + from_monday % workdays - monday);
  constexpr std::chrono::sys_days last{std::chrono::year{9999} / std::chrono::December / 31};
  return date > last ? std::nullopt : std::optional(date);  // A year has four digits.
}

std::string BenchCalendar::iso_date(std::uint64_t day) const {
  const auto date = nth(day);
  if (!date) {
    return "";
  }
  const std::chrono::year_month_day ymd(*date);
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(ymd.year()),
                     static_cast<unsigned>(ymd.month()), static_cast<unsigned>(ymd.day()));
}

std::string BenchCalendar::date(std::uint64_t day) const {
  constexpr std::array<std::string_view, 7> names{"Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"};
  const auto date = nth(day);
  return date ? fmt::format("{} {}", names[std::chrono::weekday(*date).c_encoding()], iso_date(day))
              : "";
}

}  // namespace changeover
