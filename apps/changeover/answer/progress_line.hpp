// Progress in one line of the width that there is.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "changeover/run/control.hpp"

namespace changeover::cli {

/// "5 s", "1:05 min", "2:00 h".
[[nodiscard]] std::string clock_time(std::chrono::duration<double> time);

/// What a running search tells, in at most `width` columns. Where they do not suffice, the rate
/// goes first, then the bound, what is missing, and the end of the phase; the best and the time
/// left stay longest.
[[nodiscard]] std::string progress_line(const Progress& progress, std::size_t width);

}  // namespace changeover::cli
