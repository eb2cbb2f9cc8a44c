// The times of benches for people: days and hours, and dates if the day of the first tests is
// given.
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

/// Parses a day such as "2025-03-07". @throws BadInput (without a place) for other texts, and for
/// years before 1900 or after 9999.
[[nodiscard]] std::chrono::sys_days parse_day(std::string_view text);

class BenchCalendar {
 public:
  /// @param first  the day of the first tests, moved to the next working day if necessary
  /// @param weekends  whether Saturdays and Sundays are working days, too
  BenchCalendar(const Job& job, const std::vector<Bench>& benches,
                std::optional<std::chrono::sys_days> first, bool weekends);

  /// The unit of times within a day: "hour", or "minute" or "second" if costs are these.
  [[nodiscard]] const std::string& unit() const { return unit_; }
  /// Whether a working bench has hours per day: otherwise times are not shown as days.
  [[nodiscard]] bool has_days() const { return has_days_; }
  /// The day, counted from 1, that contains this time as the begin of a test.
  [[nodiscard]] std::uint64_t day(Amount begin) const;
  /// The day on which something ends that ends at this time: at the end of a day, this day.
  [[nodiscard]] std::uint64_t last_day(Amount end) const;
  /// The hours after the beginning of that day.
  [[nodiscard]] Amount hour(Amount begin) const;
  [[nodiscard]] Amount last_hour(Amount end) const;
  /// "Mon 2025-03-10"; empty without a first day.
  [[nodiscard]] std::string date(std::uint64_t day) const;
  /// "2025-03-10"; empty without a first day.
  [[nodiscard]] std::string iso_date(std::uint64_t day) const;

 private:
  [[nodiscard]] std::optional<std::chrono::sys_days> nth(std::uint64_t day) const;

  bool has_days_ = false;
  std::uint64_t hours_ = 0;  // of a day, as costs in millionths
  std::string unit_;
  std::optional<std::chrono::sys_days> first_;
  bool weekends_;
};

}  // namespace changeover
