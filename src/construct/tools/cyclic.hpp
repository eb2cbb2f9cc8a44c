// Base blocks of the tight circular DCCD(c(4k−6)+1, k, c²(4k−6)+c) for every c ≥ 1 and k ≥ 3, and
// what the cyclic families have in common. Statement and proof: docs/theorems.md, Theorem 1.
//
// With n = k−2, N = 2k−3 and v = 2cN+1 put A = {0, …, n−1} ⊂ Z_v, x_p = pN+n and x̄_p = −pN−1 for
// −(c−1) ≤ p ≤ c. The 2c numbers p, written as *positions* z = p+c ∈ {1, …, 2c}, are split into c
// pairs: c−1 *ordinary* ones whose differences are 1, …, c−1, once each, and a *special* one with
// z+z′ ∈ {3c−1, 3c}. An ordinary pair makes the base block A ∪ {x_p, x_q}, the special one A ∪
// {x_p, x̄_q}. The base block that contains x_0 = k−2 comes last, so that A+1 is kept on the way to
// the next round.
//
//     special_pair(6);                       // {5, 12}, 5 + 12 = 3·6 − 1
//     ordinary_pair(6, 0);                   // {1, 2}; then {3, 6}, {4, 9}, {7, 11}, {8, 10}
//     double_change_points(2, 4, 0);         // {10, 18}; then {2, 7}, beside {0, 1} over Z_21
//
// Every pair has a closed form that depends on c modulo 4, so the i-th costs O(1).
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/core/developed.hpp"

namespace changeover {

/// Two positions of {1, …, 2c}, first < second.
struct PositionPair {
  std::uint64_t first = 0;
  std::uint64_t second = 0;

  auto operator<=>(const PositionPair&) const = default;
};

/// The ordinary pair number i, 0 ≤ i < c−1, for c ≥ 2. O(1).
[[nodiscard]] PositionPair ordinary_pair(std::uint64_t c, std::uint64_t i);

/// The special pair, for c ≥ 1; position c, that is p = 0, is its first if it is in it. O(1).
[[nodiscard]] PositionPair special_pair(std::uint64_t c);

/// The number of the pair with position c, the special one counted as number c−1. O(1).
[[nodiscard]] std::uint64_t link_pair(std::uint64_t c);

/// The two elements besides A of base block i, 0 ≤ i < c, the smaller first, in the order in which
/// the base blocks are developed. v = c(4k−6)+1 must be below 2³². O(1).
[[nodiscard]] std::array<Element, 2> double_change_points(std::uint64_t c, std::uint64_t k,
                                                          std::uint64_t i);

/// The element besides {0, …, k−2} of base block i, 0 ≤ i < c: 2(k−1), 3(k−1), …, c(k−1), k−1.
/// O(1).
[[nodiscard]] Element single_change_point(std::uint64_t c, std::uint64_t k, std::uint64_t i);

/// The largest v for which interval_expansion_set() is offered: its v numbers are all written down.
inline constexpr std::uint64_t max_elements_of_interval_expansion = std::uint64_t{1} << 20;

/// Whether {0, …, n−1} has translates that partition Z_v, n | v, with v small enough to list them.
[[nodiscard]] bool has_interval_expansion_set(std::uint64_t v, std::uint64_t n);

/// For c base blocks that contain A = {0, …, n−1}, the last one n too, whose development has the
/// unchanged subset A + ⌊p/c⌋ at each position p: the expansion set A+n, A+2n, …, A+v, at the
/// positions cn, 2cn, …, cv. n must divide v. O(v).
[[nodiscard]] std::vector<UnchangedSubset> interval_expansion_set(std::uint64_t c, std::uint64_t v,
                                                                  std::uint64_t n);

/// "Develop the base blocks {0,1,10,18}, {0,1,2,7} over Z_21.": all of them if there are at most
/// six, else the first three and the last. The interval is {0, …, length−1}.
[[nodiscard]] std::string explain_development(const Parameters& parameters, std::uint64_t length,
                                              std::uint64_t base_blocks,
                                              const IntervalDevelopedSource::Points& points);

/// The most points that interval_base_blocks() of a cyclic construction lists: 256 MiB.
inline constexpr std::uint64_t max_listed_points = std::uint64_t{1} << 26;

/// The most elements, c·k, of base blocks that are written out: 64 MiB.
inline constexpr std::uint64_t max_written_out_elements = std::uint64_t{1} << 24;

}  // namespace changeover
