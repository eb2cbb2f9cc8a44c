// Ranges of whole numbers on the command line.
#pragma once

#include <cstdint>
#include <string>

namespace changeover::cli {

struct Range {
  std::uint64_t from = 0;
  std::uint64_t to = 0;
};

/// "A..B", "..B" (from `least`) or "A". @throws UsageError that names the option if it is none, or
/// empty.
[[nodiscard]] Range range_of(const std::string& option, const std::string& text,
                             std::uint64_t least);

}  // namespace changeover::cli
