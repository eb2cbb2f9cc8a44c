// The times of benches as people say them: days and hours, and dates if it is said on which day the
// first tests are.
//
//     BenchCalendar calendar(job, benches, parse_day("2025-03-07"), false);   // a Friday
//     calendar.day(parse_amount("9.5"));     // with 8 hours a day: 2
//     calendar.date(2);                      // "Mon 2025-03-10"
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/plan/benches.hpp"

namespace changeover {

/// "2025-03-07". @throws BadInput (without a place) for what is no day, or a year before 1900 or
/// after 9999.
[[nodiscard]] std::chrono::sys_days parse_day(std::string_view text);

class BenchCalendar {
 public:
  /// @param first  the day of the first tests, or the first one after it that is worked on
  /// @param weekends  Saturdays and Sundays are worked on, too
  BenchCalendar(const Job& job, const std::vector<Bench>& benches,
                std::optional<std::chrono::sys_days> first, bool weekends);

  /// "hour", or "minute" or "second" if costs are these: what times of a day are told in.
  [[nodiscard]] const std::string& unit() const { return unit_; }
  /// Whether a bench that works has hours a day: otherwise times are not told as days.
  [[nodiscard]] bool has_days() const { return has_days_; }
  /// On which day, from 1, something begins at this time.
  [[nodiscard]] std::uint64_t day(Amount begin) const;
  /// On which day something is done that ends at this time: what ends with a day ends on that day.
  [[nodiscard]] std::uint64_t last_day(Amount end) const;
  /// Hours after the beginning of that day.
  [[nodiscard]] Amount hour(Amount begin) const;
  [[nodiscard]] Amount last_hour(Amount end) const;
  /// "Mon 2025-03-10"; empty without a first day.
  [[nodiscard]] std::string date(std::uint64_t day) const;
  /// "2025-03-10"; empty without a first day.
  [[nodiscard]] std::string iso_date(std::uint64_t day) const;

 private:
  [[nodiscard]] std::optional<std::chrono::sys_days> nth(std::uint64_t day) const;

  bool has_days_ = false;
  std::uint64_t hours_ = 0;  // of a day, as much as they cost, in millionths
  std::string unit_;
  std::optional<std::chrono::sys_days> first_;
  bool weekends_;
};

}  // namespace changeover
