// Logarithms and powers that are the same on every machine, so that a search with a seed is.
//
// C libraries round their own functions differently. These use only operations that IEEE 754 rounds
// in one way.
#pragma once

#include <array>

namespace changeover {

/// ln x, for 0 < x < ∞, within a few units of the last place.
[[nodiscard]] double natural_log(double x);

/// 2^x, for −1000 ≤ x ≤ 1000, within a few units of the last place.
[[nodiscard]] double power_of_two(double x);

/// −ln of 4096 evenly spread numbers in (0,1), to six decimals: how much worse a step of annealing
/// may be, in temperatures.
[[nodiscard]] const std::array<double, 4096>& log_table();

/// About 2^−octaves, for octaves ≥ 0: how far a search has cooled.
[[nodiscard]] double two_to_minus(double octaves);

}  // namespace changeover
