#include "answer/progress_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/each.hpp"

namespace changeover::cli {
namespace {

std::string short_number(double number) {
  if (number < 1e4) {
    return fmt::format("{:.0f}", number);
  }
  return number < 1e7 ? fmt::format("{:.0f} k", number / 1e3)
                      : fmt::format("{:.0f} M", number / 1e6);
}

}  // namespace

std::string clock_time(std::chrono::duration<double> time) {
  constexpr double most = 1e9;  // A clock that shows more is of no use.
  const auto whole = static_cast<std::uint64_t>(std::clamp(std::ceil(time.count()), 0.0, most));
  if (whole < 60) {
    return fmt::format("{} s", whole);
  }
  return whole < 3600 ? fmt::format("{}:{:02} min", whole / 60, whole % 60)
                      : fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

std::string progress_line(const Progress& progress, std::size_t width) {
  enum Part : std::size_t { phase, steps, rate, missing, best, bound, time, parts };
  std::array<std::string, parts> part;
  part[phase] = progress.phase;
  const double seconds = progress.elapsed.count();
  if (progress.steps > 0) {
    const auto number = static_cast<double>(progress.steps);
    part[steps] = fmt::format("; {} {}", short_number(number), progress.unit);
    part[rate] = seconds > 0 ? fmt::format(" ({}/s)", short_number(number / seconds)) : "";
  }
  if (progress.missing) {
    part[missing] = fmt::format("; {} missing", *progress.missing);
  }
  if (progress.best) {
    part[best] = fmt::format("; best {}", *progress.best);
  }
  if (progress.lower_bound) {
    part[bound] = fmt::format("; bound {}", *progress.lower_bound);
  }
  part[time] = "; " + clock_time(progress.elapsed);
  if (progress.left) {
    part[time] += ", " + clock_time(*progress.left) + " left";
  }
  const auto length = [&] {
    return sum_of<std::size_t>(part, [&](const std::string& text) { return text.size(); });
  };
  for (const Part least : {rate, steps, missing, bound}) {
    if (length() > width) {
      part[least].clear();
    }
  }
  if (const std::size_t all = length(); all > width) {
    part[phase].resize(part[phase].size() - std::min(part[phase].size(), all - width));
  }
  std::string line = joined(part, "");
  line.resize(std::min(line.size(), width));
  return line;
}

}  // namespace changeover::cli
