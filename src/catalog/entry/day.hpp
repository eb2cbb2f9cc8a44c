// Days as a catalog writes them.
#pragma once

#include <string_view>

namespace changeover {

/// Whether it is a day of the calendar, written as 2026-11-22.
[[nodiscard]] bool is_day(std::string_view text);

}  // namespace changeover
