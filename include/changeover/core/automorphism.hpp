// Permutations that designs are developed under: cycles of one length, and fixed points.
//
//     const Automorphism pi{.n = 7, .cycles = 4, .fixed = 1};   // (0 … 6)(7 … 13)(14 … 20)(21 … 27)(28)
//     pi.v();                                                   // 29
//     pi.image(6, 1);                                           // 0
//     pi.image(block, 3);                                       // π³ of each element
//
// Element on + r is the residue r of cycle o; the last f elements are fixed. π adds 1 to every residue: with one
// cycle and no fixed point it is x ↦ x + 1 over Z_v. Any permutation with such cycles is π with other names
// for the elements; π^u, for a unit u of Z_n, with those of renamed().
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <optional>
#include <span>

#include "changeover/core/block.hpp"

namespace changeover {

/// π: v = sn + f, and order n.
struct Automorphism {
  std::uint64_t n = 1;       ///< length of the cycles, at least 1
  std::uint64_t cycles = 0;  ///< s
  std::uint64_t fixed = 0;   ///< f

  /// With n-cycles and so many fixed points on v elements; nullopt unless n ≥ 1 divides v − fixed ≥ 0.
  [[nodiscard]] static std::optional<Automorphism> on(std::uint64_t v, std::uint64_t n,
                                                      std::uint64_t fixed = 0) {
    if (n == 0 || fixed > v || (v - fixed) % n != 0) {
      return std::nullopt;
    }
    return Automorphism{n, (v - fixed) / n, fixed};
  }

  [[nodiscard]] std::uint64_t v() const { return moved() + fixed; }

  /// The elements below this number are in cycles.
  [[nodiscard]] std::uint64_t moved() const { return n * cycles; }
  [[nodiscard]] bool moves(Element x) const { return x < moved(); }

  /// The cycle of x, from 0; s + i for the i-th fixed point.
  [[nodiscard]] std::uint64_t cycle(Element x) const {
    return moves(x) ? x / n : cycles + (x - moved());
  }

  /// The place of x in its cycle, which it must have.
  [[nodiscard]] std::uint64_t residue(Element x) const { return cycles == 1 ? x : x % n; }

  /// π^power(x), power ≤ n; the power n − 1 is the inverse.
  [[nodiscard]] Element image(Element x, std::uint64_t power) const {
    if (!moves(x)) {
      return x;
    }
    const std::uint64_t sum = residue(x) + power;
    return static_cast<Element>(x + power - (sum >= n ? n : 0));
  }

  /// The same for each element of a block, in its place.
  void image(std::span<const Element> block, std::uint64_t power, std::span<Element> to) const {
    std::transform(block.begin(), block.end(), to.begin(),
                   [&](Element x) { return image(x, power); });
  }
  [[nodiscard]] Block image(const Block& block, std::uint64_t power) const {
    Block result(block.size());
    image(block, power, result);
    return result;
  }

  /// Residue r becomes ur, u < n: so called, π is π^u.
  [[nodiscard]] Element renamed(Element x, std::uint64_t unit) const {
    return moves(x) ? static_cast<Element>(x - residue(x) + residue(x) * unit % n) : x;
  }

  /// The least s ≥ 1 such that π^s{x,y} meets {x,y}, x ≠ y.
  [[nodiscard]] std::uint64_t meets_itself(Element x, Element y) const {
    if (!moves(x) || !moves(y)) {
      return 1;
    }
    const std::uint64_t apart = x > y ? x - y : y - x;
    return cycle(x) == cycle(y) ? std::min(apart, n - apart) : n;
  }

  /// The number of orbits of the pairs of elements. @throws ImpossibleParameters if it exceeds 64 bits.
  [[nodiscard]] std::uint64_t pair_orbits() const;

  auto operator<=>(const Automorphism&) const = default;
};

}  // namespace changeover
