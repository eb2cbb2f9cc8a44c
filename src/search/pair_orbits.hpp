// The orbits of pairs of elements under π, which have to be covered.
//
//     PairOrbits orbits(pi);
//     orbits.of(x, y);                 // 0 … orbits.count() − 1, the same for {π(x), π(y)}
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "changeover/core/developed.hpp"
#include "changeover/run/control.hpp"

namespace changeover {

/// Numbers the orbits of the C(v,2) pairs. 4v² bytes and 4 per orbit.
class PairOrbits {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  /// v ≤ 65,536. The scope of this thread can stop it. O(v²).
  explicit PairOrbits(const Automorphism& pi)
      : v_(static_cast<std::size_t>(pi.v())), numbers_(v_ * v_, none) {
    for (Element y = 1; y < v_; ++y) {
      stop_if_asked();
      for (Element x = 0; x < y; ++x) {
        if (of(x, y) != none) {
          continue;
        }
        const auto number = static_cast<std::uint32_t>(count());
        representatives_.emplace_back(x, y);
        Element a = x;
        Element b = y;
        do {
          numbers_[a * v_ + b] = numbers_[b * v_ + a] = number;
          a = pi.image(a, 1);
          b = pi.image(b, 1);
        } while (of(a, b) == none);
      }
    }
  }

  [[nodiscard]] std::size_t count() const { return representatives_.size(); }
  /// The number of the orbit of {x,y}; `none` if x = y.
  [[nodiscard]] std::uint32_t of(Element x, Element y) const { return row(x)[y]; }
  /// of(x, 0), …, of(x, v−1).
  [[nodiscard]] const std::uint32_t* row(Element x) const { return numbers_.data() + x * v_; }
  /// The pair of an orbit that is first by its larger element, then by the other one.
  [[nodiscard]] std::pair<Element, Element> representative(std::size_t orbit) const {
    return representatives_[orbit];
  }

 private:
  std::size_t v_;
  std::vector<std::uint32_t> numbers_;                                    // v rows of v
  std::vector<std::pair<std::uint16_t, std::uint16_t>> representatives_;  // by orbit
};

}  // namespace changeover
