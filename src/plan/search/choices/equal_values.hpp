// How few tests there are of parameters that have equally many values: docs/theorems.md,
// Theorem 21.
#pragma once

#include <cstdint>

namespace changeover {

/// At least so many tests show all pairs of k parameters of g values each, no two of which are
/// of one parameter; g from 2 to 100, k to 10,000. It is g² if nothing better is known.
[[nodiscard]] std::uint64_t least_tests_of_equal(std::uint64_t k, std::uint64_t g);

}  // namespace changeover
