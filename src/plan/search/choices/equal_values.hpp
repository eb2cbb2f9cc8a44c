// How few tests there are of parameters that have equally many values: docs/theorems.md,
// Theorem 21, and what others have found out by looking through all of them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace changeover {

/// At least so many tests show all pairs of k parameters of g values each, no two of which are
/// of one parameter; g from 2 to 100, k to 10,000. It is g² if nothing better is known.
[[nodiscard]] std::uint64_t least_tests_of_equal(std::uint64_t k, std::uint64_t g);

/// k parameters of g values each, all pairs of which must meet, have at least so many stays in all
/// in `tests` tests: (7) of choice_plan.hpp. Nothing if so many tests do not show all pairs.
/// `above`, if it is given: what is returned for fewer tests, from where to look down.
[[nodiscard]] std::optional<std::uint64_t> least_stays_of_equal(
    std::uint64_t k, std::uint64_t g, std::uint64_t tests,
    std::optional<std::uint64_t> above = std::nullopt);

/// So many tests are the fewest that show all pairs of so many parameters of so many values each.
struct FewestTests {
  std::uint64_t parameters = 0;
  std::uint64_t values = 0;
  std::uint64_t tests = 0;
};

/// Those that are more than the bounds of this program prove [IzquierdoTorres2018].
[[nodiscard]] std::span<const FewestTests> published_fewest_tests();

}  // namespace changeover
