// Binary search for the least number that is large enough.
//
//     least_number(0, room, [&](std::uint64_t n) { return binomial(n, 2) >= pairs; });
#pragma once

#include <cstdint>

namespace changeover {

/// The least number from `low` on for which `is_enough` is true, as it is for all larger ones;
/// `high`, which is not asked for, if there is none below; `low` if high < low. O(log(high − low))
/// calls.
template <typename IsEnough>
[[nodiscard]] std::uint64_t least_number(std::uint64_t low, std::uint64_t high,
                                         IsEnough&& is_enough) {
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    is_enough(middle) ? high = middle : low = middle + 1;
  }
  return low;
}

}  // namespace changeover
