// Lines through groups: rings of g elements in which the first m differ by units.
//
// Let c_0, …, c_{m−1} be elements of a ring of g elements, c_j − c_i a unit for i ≠ j. A line has
// a + c_i·d in group i, i = 0, …, m−1. For each *slope* d the lines of all a of the ring are a
// partition, and two elements of different groups determine d and a: each such pair is on one line.
//
//     Slopes slopes(4, 3);      // the field of 4 elements: m = 3 takes no 2, but 4, 8, …
//     slopes.at(2, 3, 1);       // 1 + c_2·3
//
// It is the ring of integers modulo g if that will do, and else a product of those modulo prime
// powers and of polynomials modulo one of them.
#pragma once

#include <cstdint>
#include <vector>

namespace changeover {

class Slopes {
 public:
  /// Whether there is such a ring: for each prime, its largest power that divides g is m or more.
  [[nodiscard]] static bool known(std::uint64_t g, std::uint64_t m);

  /// g must be known().
  Slopes(std::uint64_t g, std::uint64_t m);

  /// a + c_i·d, of numbers below g; i < m.
  [[nodiscard]] std::uint64_t at(std::uint64_t i, std::uint64_t d, std::uint64_t a) const;

 private:
  // Polynomials below a degree, modulo a monic one of that degree; numbers are their digits.
  struct Factor {
    std::uint64_t size;      // of this ring
    std::uint64_t base;      // of the digits, from the constant term on
    std::uint64_t tail = 0;  // the polynomial less its leading term

    [[nodiscard]] std::uint64_t plus(std::uint64_t x, std::uint64_t y, std::uint64_t times) const;
    [[nodiscard]] std::uint64_t product(std::uint64_t x, std::uint64_t y) const;
    [[nodiscard]] bool separates(std::uint64_t m) const;
  };

  std::vector<Factor> factors_;
};

}  // namespace changeover
