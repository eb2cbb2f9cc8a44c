#include "core/checked.hpp"

#include <algorithm>
#include <numeric>

namespace changeover {

std::uint64_t binomial(std::uint64_t n, std::uint64_t r) {
  if (r > n) {
    return 0;
  }
  r = std::min(r, n - r);
  std::uint64_t result = 1;
  for (std::uint64_t i = 1; i <= r; ++i) {
    // result · (n−r+i) / i is an integer; dividing first keeps every intermediate value below it.
    std::uint64_t factor = n - r + i;
    std::uint64_t divisor = i;
    const std::uint64_t g = std::gcd(result, divisor);
    result /= g;
    divisor /= g;
    result = checked_multiply(result, factor / divisor);
  }
  return result;
}

}  // namespace changeover
