// Numbers the t-subsets of {0, …, v−1}: {x₁ < x₂ < …} has rank ΣC(xᵢ,i), its place in
// colexicographic order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "changeover/core/block.hpp"
#include "core/checked.hpp"

namespace changeover {

class SubsetRanks {
 public:
  SubsetRanks(std::uint64_t v, std::uint32_t t) : v_(v), t_(t) {
    for (std::uint32_t r = 0; r <= t; ++r) {
      for (std::uint64_t n = 0; n <= v; ++n) {
        choose_.push_back(binomial(n, r));
      }
    }
  }

  /// C(n,r), n ≤ v and r ≤ t.
  [[nodiscard]] std::uint64_t choose(std::uint64_t n, std::uint32_t r) const {
    return choose_[static_cast<std::size_t>(r * (v_ + 1) + n)];
  }

  /// The rank of t increasing elements.
  [[nodiscard]] std::uint64_t rank(std::span<const Element> subset) const {
    std::uint64_t rank = 0;
    for (std::uint32_t i = 0; i < subset.size(); ++i) {
      rank += choose(subset[i], i + 1);
    }
    return rank;
  }

  /// Calls visit(rank) for each t-subset of some elements, in whatever order they are. O(C(k,t))
  template <typename Visit>
  void for_each_rank(std::span<const Element> elements, Visit&& visit) const {
    Block sorted(elements.begin(), elements.end());
    std::ranges::sort(sorted);
    descend(sorted, 0, 0, visit);
  }

  /// The subset of that rank, its elements decreasing.
  [[nodiscard]] Block subset(std::uint64_t rank) const {
    Block subset;
    std::uint64_t x = v_;
    for (std::uint32_t r = t_; r > 0; --r) {
      do {
        --x;
      } while (choose(x, r) > rank);
      subset.push_back(static_cast<Element>(x));
      rank -= choose(x, r);
    }
    return subset;
  }

 private:
  template <typename Visit>
  void descend(std::span<const Element> rest, std::uint32_t chosen, std::uint64_t rank,
               Visit& visit) const {
    if (chosen == t_) {
      visit(rank);
      return;
    }
    for (; !rest.empty(); rest = rest.subspan(1)) {
      descend(rest.subspan(1), chosen + 1, rank + choose(rest.front(), chosen + 1), visit);
    }
  }

  std::uint64_t v_;
  std::uint32_t t_;
  std::vector<std::uint64_t> choose_;  // t+1 rows of v+1
};

}  // namespace changeover
