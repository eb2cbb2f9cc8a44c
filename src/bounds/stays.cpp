#include "bounds/stays.hpp"

#include <algorithm>

#include "bounds/short_stays.hpp"
#include "core/checked.hpp"

namespace changeover {

std::uint64_t most_meetings(std::uint64_t s, std::uint64_t strength) {
  return s < strength ? s : checked_add(checked_multiply(s, s - 1), 1);
}

std::uint64_t most_stays_short(std::uint64_t s, std::uint64_t k) {
  const std::uint64_t by_points = checked_multiply(most_meetings(s, 2), k);
  const std::uint64_t by_pairs =
      checked_multiply(s, checked_multiply(checked_add(s, 2), k) - (s + 1)) / 2;
  return std::min(by_points, by_pairs);
}

Introductions least_introductions(std::uint64_t v, std::uint64_t k, std::uint64_t strength) {
  const auto at = [&](std::uint64_t s) {
    const std::uint64_t all = checked_multiply(checked_add(s, 1), v);
    const std::uint64_t together = checked_multiply(most_meetings(s, strength), k);
    return Introductions{all > together ? all - together : 0, s};
  };
  // From s to s + 1 the sum grows by v − k while s + 1 < t, and by v − 2sk from s = t on: the best
  // s is t − 1, or the first s ≥ t with v ≤ 2sk.
  const Introductions few = at(strength - 1);
  const Introductions many = at(std::max(strength, ceil_div(v, checked_multiply(2, k))));
  return many.count > few.count ? many : few;
}

}  // namespace changeover
