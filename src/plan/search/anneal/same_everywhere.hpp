// Logarithms and powers that are the same on every machine, so that a search with a seed is.
#pragma once

#include <array>

namespace changeover {

/// −ln of 4096 evenly spread numbers in (0,1), rounded.
[[nodiscard]] const std::array<double, 4096>& log_table();

/// About 2^−octaves, for octaves ≥ 0.
[[nodiscard]] double two_to_minus(double octaves);

}  // namespace changeover
