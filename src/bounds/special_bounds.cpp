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
          "were in the block before the last one{}: {} of the {} {} are not new (docs/theorems.md, "
          "Theorem 36), so {} + {} + {}(b-2) >= {}: b >= {}",
          back, p.change, there == 0 ? "" : fmt::format(", with {} or more that stayed", there),
          again, second, p.strength == 2 ? "pairs" : fmt::format("{}-subsets", p.strength), first,
          second, later, all, b)};
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

std::optional<Bound> complements(const Parameters& p) {
  if (p.strength != 2 || p.change >= p.k || p.v != p.k + p.change) {
    return std::nullopt;
  }
  const std::uint64_t moves = ceil_div(p.change, p.k - p.change);
  const std::uint64_t b = 2 * moves + 1;
  return Bound{
      b, "complements",
      fmt::format(
          "v = k+m, so the sets of m = {0} elements outside consecutive blocks are disjoint, "
          "and from each block to the next but one at most k-m = {1} of them change. Blocks "
          "1, 3, 5, … or 2, 4, 6, … must have no element outside in common, or two elements "
          "never meet (docs/theorems.md, Theorem 39): b >= 2*ceil({0} / {1}) + 1 = {2}",
          p.change, p.k - p.change, b)};
}

std::optional<Bound> one_left_out(const Parameters& p) {
  constexpr std::uint64_t least_k = 4;
  if (p.strength != 2 || p.change != p.k || p.k < least_k || p.v != 2 * p.k + 1) {
    return std::nullopt;
  }
  const bool is_circular = p.kind == Kind::circular;
  const std::uint64_t b = 2 * p.k + (is_circular ? 4 : 3);
  return Bound{
      b, "one left out",
      fmt::format("each step leaves out one element, and only such an element goes from blocks 1, "
                  "3, 5, … to blocks 2, 4, 6, … or back; with fewer blocks two elements never meet "
                  "(docs/theorems.md, Theorem 40): b >= 2k + {} = {}",
                  is_circular ? 4 : 3, b)};
}

}  // namespace changeover
