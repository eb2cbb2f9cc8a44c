// Closure rules on designs in memory.
#pragma once

#include <cstdint>
#include <optional>

#include "changeover/core/design.hpp"
#include "changeover/core/recipe.hpp"

namespace changeover {

/// The closure rule drop, for strength 2; the design itself for others.
[[nodiscard]] Design without_needless_blocks(const Design& design);

/// The closure rule truncate, so many times; nullopt if no element can go.
[[nodiscard]] std::optional<Design> truncated(const Design& design, std::uint64_t elements);

}  // namespace changeover
