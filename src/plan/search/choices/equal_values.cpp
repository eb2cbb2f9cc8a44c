#include "plan/search/choices/equal_values.hpp"

#include <algorithm>
#include <vector>

#include "core/checked.hpp"
#include "plan/job/pair_numbers.hpp"

namespace changeover {
namespace {

// C(n, k) where it is below 2³², else that.
std::uint64_t choose_small(std::uint64_t n, std::uint64_t k) {
  constexpr std::uint64_t large = std::uint64_t{1} << 32U;
  std::uint64_t value = 1;
  for (std::uint64_t i = 1; i <= k; ++i) {
    value = value * (n - k + i) / i;  // C(n−k+i, i), which grows with i
    if (value >= large) {
      return large;
    }
  }
  return value;
}

// A parameter by its two rarest values, which are in s and t tests.
struct Rarest {
  std::uint64_t unions = 0;      // C(s+t, s): 2 of that many, at most, are this parameter's
  std::uint64_t agreements = 0;  // pairs of tests with one value of it, at most
};

// (1): by the rarest values, the most pairs of tests with one value of a parameter, of all
// parameters; nothing if there can be no k parameters.
std::uint64_t most_agreements(std::uint64_t k, std::uint64_t g, std::uint64_t tests) {
  std::vector<Rarest> all;
  for (std::uint64_t s = g; s * g <= tests; ++s) {
    for (std::uint64_t t = s; s + (g - 1) * t <= tests; ++t) {
      const std::uint64_t often = tests - s - (g - 2) * t;
      all.push_back(
          {choose_small(s + t, s), choose_two(s) + (g - 2) * choose_two(t) + choose_two(often)});
    }
  }
  const auto fits = [&](const Rarest& each) { return 2 * k <= each.unions; };
  const auto share = [](const Rarest& each) { return 2.0 / static_cast<double>(each.unions); };
  double most = -1;
  for (const Rarest& a : all) {
    if (!fits(a)) {
      continue;
    }
    most = std::max(most, static_cast<double>(a.agreements));
    for (const Rarest& b : all) {
      if (!fits(b) && b.agreements > a.agreements) {  // some of these, as many as there can be
        const double part = (1.0 / static_cast<double>(k) - share(a)) / (share(b) - share(a));
        most = std::max(most, static_cast<double>(a.agreements) +
                                  part * static_cast<double>(b.agreements - a.agreements));
      }
    }
  }
  constexpr double rounding = 1 + 1e-9;
  return most < 0 ? 0 : static_cast<std::uint64_t>(most * rounding * static_cast<double>(k)) + 1;
}

// Whether the theorem leaves room for so many tests.
bool may_be(std::uint64_t k, std::uint64_t g, std::uint64_t tests) {
  const std::uint64_t most = most_agreements(k, g, tests);
  const std::uint64_t more = tests % g;
  const std::uint64_t least =
      k * (more * choose_two(tests / g + 1) + (g - more) * choose_two(tests / g));
  const std::uint64_t two_tests = choose_two(tests);
  // (2), twice: concave in the agreements, and linear between multiples of the pairs of tests.
  const auto holds = [&](std::uint64_t agreements) {
    const std::uint64_t each = agreements / two_tests;
    const std::uint64_t twice = two_tests * choose_two(each) + each * (agreements % two_tests);
    const std::uint64_t free = k * (g - 1) * (2 * tests - g * g);
    return (k - 1) * (2 * agreements) >= 4 * twice + (k - 1) * free;
  };
  for (std::uint64_t middle = ceil_div(least, two_tests) * two_tests; middle <= most;
       middle += two_tests) {
    if (holds(middle)) {
      return true;
    }
  }
  return most > 0 && (holds(std::min(least, most)) || holds(most));
}

}  // namespace

std::uint64_t least_tests_of_equal(std::uint64_t k, std::uint64_t g) {
  std::uint64_t tests = g * g;
  while (k >= 3 && !may_be(k, g, tests)) {
    ++tests;
  }
  return tests;
}

std::optional<std::uint64_t> least_stays_of_equal(std::uint64_t k, std::uint64_t g,
                                                  std::uint64_t tests,
                                                  std::optional<std::uint64_t> above) {
  const std::uint64_t steps = tests - 1;
  const auto is_enough = [&](std::uint64_t stays) {
    const std::uint64_t changes = stays - k;
    std::uint64_t both = 0;  // two parameters change in the same step
    if (steps > 0) {
      const std::uint64_t more = changes % steps;
      both = more * choose_two(changes / steps + 1) + (steps - more) * choose_two(changes / steps);
    }
    return (k - 1) * stays >= (g * g + 1) * choose_two(k) + both;
  };
  if (above) {
    std::uint64_t stays = *above;
    while (stays > k && is_enough(stays - 1)) {
      --stays;
    }
    return stays;
  }
  for (std::uint64_t stays = k; stays <= k * tests; ++stays) {
    if (is_enough(stays)) {
      return stays;
    }
  }
  return std::nullopt;
}

std::span<const FewestTests> published_fewest_tests() {
  static constexpr FewestTests all[] = {{11, 3, 15}, {7, 4, 21}, {5, 6, 39}};
  return all;
}

}  // namespace changeover
