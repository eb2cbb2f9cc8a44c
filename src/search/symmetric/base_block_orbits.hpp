// The orbits of pairs of elements under π: what has to be covered once each.
//
//     PairOrbits orbits(shape);
//     orbits.of(x, y);                 // 0 … orbits.count() − 1, the same for {π(x), π(y)}
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/search/base_block_shape.hpp"

namespace changeover {

/// Orbits of the C(v,2) pairs, by number. 4v² bytes.
class PairOrbits {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  /// O(v²).
  explicit PairOrbits(const BaseBlockShape& shape)
      : shape_(shape),
        v_(static_cast<std::size_t>(shape.v())),
        numbers_(v_ * v_, none),
        image_(v_) {
    for (std::size_t x = 0; x < v_; ++x) {
      image_[x] = moved(static_cast<Element>(x), 1);
    }
    for (Element y = 1; y < v_; ++y) {
      for (Element x = 0; x < y; ++x) {
        if (numbers_[x * v_ + y] != none) {
          continue;
        }
        const auto number = static_cast<std::uint32_t>(representatives_.size());
        representatives_.emplace_back(x, y);
        Element a = x;
        Element b = y;
        do {
          numbers_[a * v_ + b] = numbers_[b * v_ + a] = number;
          a = image_[a];
          b = image_[b];
        } while (numbers_[a * v_ + b] == none);
      }
    }
  }

  [[nodiscard]] std::size_t count() const { return representatives_.size(); }
  /// The number of the orbit of {x,y}; `none` if x = y.
  [[nodiscard]] std::uint32_t of(Element x, Element y) const { return numbers_[x * v_ + y]; }
  /// of(x, 0), …, of(x, v−1).
  [[nodiscard]] const std::uint32_t* row(Element x) const { return numbers_.data() + x * v_; }
  /// The pair of an orbit that comes first by its larger element, then by the other one.
  [[nodiscard]] std::pair<Element, Element> representative(std::size_t orbit) const {
    return representatives_[orbit];
  }

  /// π^power(x).
  [[nodiscard]] Element moved(Element x, std::uint64_t power) const {
    if (x >= v_ - shape_.fixed) {
      return x;
    }
    const std::uint64_t residue = x % shape_.n;
    return static_cast<Element>(x - residue + (residue + power) % shape_.n);
  }

  /// The cycle of x; s + i for the i-th fixed point.
  [[nodiscard]] std::uint64_t cycle(Element x) const {
    const std::uint64_t moving = v_ - shape_.fixed;
    return x < moving ? x / shape_.n : shape_.cycles + (x - moving);
  }

  [[nodiscard]] const BaseBlockShape& shape() const { return shape_; }
  [[nodiscard]] std::size_t v() const { return v_; }

 private:
  BaseBlockShape shape_;
  std::size_t v_;
  std::vector<std::uint32_t> numbers_;
  std::vector<Element> image_;
  std::vector<std::pair<Element, Element>> representatives_;
};

}  // namespace changeover
