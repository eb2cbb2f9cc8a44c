// Counting arithmetic that refuses to overflow: parameters can be large, and a wrapped count would
// be a false claim.
//
//     std::uint64_t pairs = binomial(v, 2);                 // throws rather than wraps
//     std::uint64_t b = ceil_div(pairs, 2 * k - 3);
#pragma once

#include <cstdint>

#include "changeover/core/error.hpp"

namespace changeover {

/// Holds the product of two counts.
__extension__ using Wide = unsigned __int128;

/// a + b. @throws ImpossibleParameters if the sum does not fit in 64 bits.
[[nodiscard]] inline std::uint64_t checked_add(std::uint64_t a, std::uint64_t b) {
  std::uint64_t sum = 0;
  if (__builtin_add_overflow(a, b, &sum)) {
    throw ImpossibleParameters(
        "these parameters are too large, a count exceeds 64 bits; give smaller ones");
  }
  return sum;
}

/// a · b. @throws ImpossibleParameters if the product does not fit in 64 bits.
[[nodiscard]] inline std::uint64_t checked_multiply(std::uint64_t a, std::uint64_t b) {
  std::uint64_t product = 0;
  if (__builtin_mul_overflow(a, b, &product)) {
    throw ImpossibleParameters(
        "these parameters are too large, a count exceeds 64 bits; give smaller ones");
  }
  return product;
}

/// ⌈a / b⌉ for b ≥ 1.
[[nodiscard]] constexpr std::uint64_t ceil_div(std::uint64_t a, std::uint64_t b) {
  return a / b + (a % b != 0 ? 1 : 0);
}

/// C(n, r), 0 when r > n. Exact whenever the result fits, whatever the intermediate products.
/// @throws ImpossibleParameters if the result does not fit in 64 bits. O(r).
[[nodiscard]] std::uint64_t binomial(std::uint64_t n, std::uint64_t r);

}  // namespace changeover
