// Minima that are known by exhaustive search and that no formula here reaches.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "changeover/core/parameters.hpp"

namespace changeover {

struct KnownMinimum {
  std::uint64_t blocks = 0;
  std::string_view by;  ///< what settled it
};

/// The minimum for exactly these parameters, if it is in the table.
[[nodiscard]] std::optional<KnownMinimum> known_minimum(const Parameters& p);

}  // namespace changeover
