// What came of looking for something.
//
//     to_string(Outcome::none);          // "none"
#pragma once

#include <cstdint>
#include <string_view>

namespace changeover {

enum class Outcome : std::uint8_t {
  found,
  none,     ///< there is none; on whose word, the search says
  unknown,  ///< stopped before; RunControl::why_stopped() says why
};

/// "found", "none", "unknown".
[[nodiscard]] constexpr std::string_view to_string(Outcome outcome) {
  return outcome == Outcome::found ? "found" : outcome == Outcome::none ? "none" : "unknown";
}

}  // namespace changeover
