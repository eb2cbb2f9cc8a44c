#include "bounds/special_bounds.hpp"

#include <fmt/format.h>

#include <string>

#include "core/checked.hpp"
#include "core/words.hpp"

namespace changeover {

std::optional<Bound> returning(const Parameters& p) {
  const std::uint64_t reach = checked_add(checked_multiply(2, p.change), p.k);
  if (p.v >= reach || p.v < p.k + p.change) {
    return std::nullopt;
  }
  const std::uint64_t back = reach - p.v;
  const std::uint64_t there = p.k > 2 * p.change ? p.k - 2 * p.change : 0;
  const std::uint64_t first = binomial(p.k, p.strength);
  const std::uint64_t second = newly_covered_at_most(p);
  const std::uint64_t again = binomial(back + there, p.strength) - binomial(there, p.strength);
  const std::uint64_t all = binomial(p.v, p.strength);
  if (again == 0 || again >= second || all <= checked_add(first, second)) {
    return std::nullopt;
  }
  const std::uint64_t later = second - again;
  const std::uint64_t b = ceil_div(all - first - second, later) + 2;
  return Bound{
      b, "returning elements",
      fmt::format(
          "v < k + 2m, so from the third block on at least 2m+k-v = {} of the {} entering elements "
          "were in the block before the last one, with {} or more that stayed: {} of the {} {} are "
          "not new (docs/theorems.md, Theorem 36), so {} + {} + {}(b-2) >= {}: b >= {}",
          back, p.change, there, again, second,
          p.strength == 2 ? "pairs" : fmt::format("{}-subsets", p.strength), first, second, later,
          all, b)};
}

std::optional<Bound> steiner_system(const Parameters& p) {
  if (p.strength != 2 || p.v == p.k || p.change + 1 < p.k) {
    return std::nullopt;
  }
  const std::uint64_t all = binomial(p.v, 2);
  const std::uint64_t each = binomial(p.k, 2);
  if (all % each != 0) {
    return std::nullopt;
  }
  const std::uint64_t b = all / each;
  const std::uint64_t square = checked_multiply(p.k, p.k);
  std::string reason;
  if (b < p.v) {
    reason = fmt::format(
        "a Steiner system with more than one block has at least v = {} of them "
        "(Fisher's inequality)",
        p.v);
  } else if (p.change == p.k && p.v == square - p.k + 1) {
    reason = "a projective plane, where any two blocks meet, but consecutive blocks must not";
  } else if (p.change == p.k && p.v == square) {
    reason = fmt::format(
        "an affine plane, where disjoint blocks are parallel, so the list would "
        "stay among {} parallel ones",
        p.k);
  } else {
    return std::nullopt;
  }
  return Bound{b + 1, "Steiner system",
               fmt::format("with C({0},2) / C({1},2) = {2} every pair is in one block only: {3} "
                           "(docs/theorems.md, Theorem 37): b >= {4}",
                           p.v, p.k, count_of(b, "block"), reason, b + 1)};
}

}  // namespace changeover
