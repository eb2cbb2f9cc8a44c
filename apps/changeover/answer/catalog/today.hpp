// The day on which something is credited.
#pragma once

#include <string>

namespace changeover::cli {

/// Today by the system's clock, in UTC: "2026-11-22".
[[nodiscard]] std::string today();

}  // namespace changeover::cli
