#include "plan/sheet/clock.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace changeover {
namespace {

constexpr std::uint64_t sixty = 60;
constexpr std::uint64_t whole_unit = 1'000'000;  // in millionths

std::uint64_t seconds_in(CostUnit unit) {
  return unit == CostUnit::hours ? sixty * sixty : unit == CostUnit::minutes ? sixty : 1;
}

}  // namespace

Clock::Clock(const Job& job) {
  if (job.cost_unit == CostUnit::none) {
    return;
  }
  const std::uint64_t seconds = seconds_in(job.cost_unit);
  const auto is_whole = [&](Amount cost) {
    // If fractions of a unit in seconds, and whole units of seconds, are minutes.
    return cost.millionths % whole_unit * seconds % (whole_unit * sixty) == 0 &&
           cost.millionths / whole_unit % sixty * seconds % sixty == 0;
  };
  shows_seconds_ = !is_whole(job.test_cost) || !std::ranges::all_of(job.change_costs, is_whole) ||
                   !std::ranges::all_of(job.replace_costs, is_whole);
  ticks_ = seconds;
}

std::string Clock::operator()(Amount so_far) const {
  const std::uint64_t rest = so_far.millionths % whole_unit * ticks_;
  const std::uint64_t seconds =
      so_far.millionths / whole_unit * ticks_ + (rest + whole_unit - 1) / whole_unit;
  const std::uint64_t minutes = seconds / sixty;
  return shows_seconds_
             ? fmt::format("{}:{:02}:{:02}", minutes / sixty, minutes % sixty, seconds % sixty)
             : fmt::format("{}:{:02}", minutes / sixty, minutes % sixty);
}

std::string_view word_of(CostUnit unit) {
  switch (unit) {
    case CostUnit::seconds:
      return "seconds";
    case CostUnit::minutes:
      return "minutes";
    case CostUnit::hours:
      return "hours";
    case CostUnit::none:
      break;
  }
  return "";
}

}  // namespace changeover
