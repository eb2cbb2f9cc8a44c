#include "search/enumerate/enumeration_case.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/search/enumeration.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

void check_supported(const Parameters& p, std::uint64_t b) {
  check(p);
  if (p.strength != 2) {
    throw ImpossibleParameters("enumeration supports strength 2 only; give strength 2");
  }
  if (p.v > max_enumeration_elements) {
    throw ImpossibleParameters(
        fmt::format("enumeration supports at most {} elements, not {}; give fewer",
                    max_enumeration_elements, p.v));
  }
  if (b > max_enumeration_blocks) {
    throw ImpossibleParameters(fmt::format(
        "enumeration supports at most {} blocks, not {}; give fewer", max_enumeration_blocks, b));
  }
}

// Covered pairs, counted with repetition, less the number of pairs.
std::int64_t excess(const Parameters& p, std::uint64_t b) {
  const std::uint64_t each = newly_covered_at_most(p);
  const std::uint64_t covered =
      p.kind == Kind::circular ? b * each : binomial(p.k, 2) + (b - 1) * each;
  return static_cast<std::int64_t>(covered) - static_cast<std::int64_t>(binomial(p.v, 2));
}

}  // namespace

std::vector<EnumerationCase> enumeration_cases(const Parameters& p, std::uint64_t b,
                                               bool one_rotation) {
  check_supported(p, b);
  std::vector<EnumerationCase> cases;
  const bool circular = p.kind == Kind::circular;
  // With two blocks, an element that left and one that was introduced never meet.
  if (b < 3 || p.v < p.k + p.change) {
    return cases;
  }
  // With at most one fixed element every pair is newly covered. If f ≥ 2 are removed, the others
  // form a design without fixed elements.
  const std::uint64_t most_fixed =
      circular ? p.k - std::min(p.k, std::max<std::uint64_t>(p.change, 2)) : 0;
  for (std::uint64_t f = 0; f <= most_fixed; f = f == 0 ? 2 : f + 1) {
    Parameters rest = p;
    rest.v -= f;
    rest.k -= f;
    const EnumerationCase base{.v = rest.v,
                               .k = rest.k,
                               .change = rest.change,
                               .b = b,
                               .circular = circular,
                               .excess = excess(rest, b),
                               .fixed = f,
                               .longest_run = 0};
    if (base.excess < 0) {
      continue;
    }
    if (!circular || !one_rotation) {
      cases.push_back(base);
      continue;
    }
    // Runs of limited length take at least (k−1)·b of the places, and m·b of them begin.
    for (std::size_t run = ceil_div(rest.k - 1, rest.change); run < b; ++run) {
      cases.push_back(base);
      cases.back().longest_run = run;
    }
  }
  return cases;
}

}  // namespace changeover
