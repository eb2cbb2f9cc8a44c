// What a cyclic list leaves, a circulant graph, as classes of pairs that hold each element
// [docs/theorems.md, Theorem 33].
//
// A difference d makes g = gcd(d, w) cycles of L = w/g elements u_0, u_1 = u_0 + d, … If L is even,
// every other edge of each is in one class. If L is odd, the edge {u_{L−1}, u_0} is in neither. If
// w/2 is left, too, such edges are a separate class, with the pairs {x, x+w/2} for all other x:
// colours of a prism, and all classes are 1-factors. Else they come with the first class of d,
// which lacks u_{L−1}, and pairs of the elements 0, …, g−1, which the second lacks, with that.
//
// Two pairs of a class that follow each other are disjoint. Each pair is computed in O(δ).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

class LeaveFactors {
 public:
  using Pair = std::array<Element, 2>;

  /// The pairs of Z_w with these differences, below w/2, and with w/2 too if `half`; then w must be
  /// even. nullopt if a cycle without w/2 has three elements, or if there is no room for the edges
  /// left over.
  [[nodiscard]] static std::optional<LeaveFactors> of(std::uint64_t w,
                                                      const std::vector<std::uint64_t>& differences,
                                                      bool half);

  /// 2δ, or 2δ+1 with w/2.
  [[nodiscard]] std::size_t size() const { return classes_.size(); }
  /// How many pairs class i has.
  [[nodiscard]] std::uint64_t count(std::size_t i) const { return classes_[i].count; }
  /// Pair number j of class i. For odd w the first class begins with {0, 1}, and the last one ends
  /// with it if there are four classes or more.
  [[nodiscard]] Pair pair(std::size_t i, std::uint64_t j) const;

 private:
  enum class Kind : std::uint8_t { rungs, even, odd, prism };
  struct Class {
    Kind kind = Kind::rungs;
    std::size_t which = 0;  // difference
    std::uint64_t count = 0;
    bool second = false;  // of a prism
    bool reversed = false;
  };
  struct Cycles {
    std::uint64_t difference = 0;
    std::uint64_t cycles = 0;
    std::uint64_t length = 0;
    std::vector<std::uint64_t> starts;  // u_0 of each cycle below w/2 of a prism
  };

  LeaveFactors(std::uint64_t w, const std::vector<std::uint64_t>& differences);
  bool add_prism(std::size_t which);
  void order_odd();
  [[nodiscard]] Element at(const Cycles& cycles, std::uint64_t start, std::uint64_t i) const;
  [[nodiscard]] Pair edge(const Cycles& cycles, std::uint64_t start, std::uint64_t i) const;
  [[nodiscard]] Pair rung_or_left_over(std::uint64_t j) const;
  [[nodiscard]] Pair odd_second(const Cycles& cycles, std::uint64_t j) const;
  [[nodiscard]] Pair prism(const Cycles& cycles, bool second, std::uint64_t j) const;

  std::uint64_t w_;
  std::vector<Cycles> cycles_;
  std::vector<Class> classes_;
  std::vector<Pair> left_over_;          // of even w
  std::vector<std::uint64_t> no_rungs_;  // x < w/2 where these edges are, increasing
};

}  // namespace changeover
