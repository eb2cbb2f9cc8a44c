// A set of t-subsets of {0, …, v−1} for t ≤ 4, one bit each; for strengths above 2.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/parameters.hpp"
#include "core/bit_scan.hpp"
#include "core/checked.hpp"
#include "verify/element_bits.hpp"

namespace changeover {

/// t-subsets by their place in colexicographic order: a < b < c has place C(a,1) + C(b,2) + C(c,3).
class SubsetSet {
 public:
  explicit SubsetSet(const Parameters& p)
      : v_(p.v),
        t_(p.strength),
        words_(static_cast<std::size_t>(ceil_div(binomial(v_, t_), 64)), 0) {
    for (std::uint32_t i = 1; i <= t_; ++i) {
      auto& column = binomials_[i];
      column.resize(static_cast<std::size_t>(v_) + 1);
      for (std::uint64_t n = 0; n <= v_; ++n) {
        column[static_cast<std::size_t>(n)] = binomial(n, i);
      }
    }
  }

  /// Adds the t-subsets of `block` that contain an element at or after place `introduced_from`.
  void insert_new(std::span<const Element> block, std::size_t introduced_from) {
    if (ElementBits::pay(block.size() - introduced_from, v_)) {
      bits_.assign(block, introduced_from, v_);
      sorted_.assign(block.begin(), block.end());
      std::sort(sorted_.begin(), sorted_.end());
      insert_rows(sorted_, t_, 0, false, v_);
      return;
    }
    for (std::size_t i = introduced_from; i < block.size(); ++i) {
      chosen_[0] = block[i];
      choose(block.first(i), 1);
    }
  }

  [[nodiscard]] std::uint64_t size() const { return count_bits(words_); }

  /// Calls visit(subset), increasing, for up to `limit` subsets that are not in the set.
  template <typename Visit>
  void for_each_missing(std::uint64_t limit, Visit&& visit) const {
    scan(~std::uint64_t{0}, limit, visit);
  }

  /// The same for the subsets that are in the set.
  template <typename Visit>
  void for_each(std::uint64_t limit, Visit&& visit) const {
    scan(0, limit, visit);
  }

 private:
  // Visits the subsets whose bit is set after an exclusive or with `flip`.
  template <typename Visit>
  void scan(std::uint64_t flip, std::uint64_t limit, Visit&& visit) const {
    const std::uint64_t end = binomial(v_, t_);
    for (std::uint64_t place = next_bit(words_, 0, flip); place < end && limit > 0;
         place = next_bit(words_, place + 1, flip), --limit) {
      const std::array<Element, max_strength> subset = subset_at(place);
      visit(std::span<const Element>(subset).first(t_));
    }
  }

  // Chooses `left` − 1 more members from `from`, the largest first, and takes all smallest members
  // below `above` at once: their places follow each other from `place` on.
  void insert_rows(std::span<const Element> from, std::uint32_t left, std::uint64_t place,
                   bool has_introduced, std::uint64_t above) {
    if (left == 1) {
      or_bits(words_, place, bits_.completing(has_introduced), above);
      return;
    }
    // A member that has fewer than left − 1 elements below it in the block completes nothing.
    for (std::size_t i = left - 1; i < from.size(); ++i) {
      insert_rows(from.first(i), left - 1, place + binomials_[left][from[i]],
                  has_introduced || bits_.is_introduced(from[i]), from[i]);
    }
  }

  void choose(std::span<const Element> from, std::uint32_t have) {
    if (have == t_) {
      std::array<Element, max_strength> sorted = chosen_;
      // By insertion: so few, and gcc 14 warns that std::sort could leave the array.
      for (auto next = sorted.begin(); next != sorted.begin() + t_; ++next) {
        std::rotate(std::upper_bound(sorted.begin(), next, *next), next, next + 1);
      }
      std::uint64_t place = 0;
      for (std::uint32_t i = 0; i < t_; ++i) {
        place += binomials_[i + 1][sorted[i]];
      }
      words_[static_cast<std::size_t>(place / 64)] |= std::uint64_t{1} << (place % 64);
      return;
    }
    for (std::size_t i = 0; i < from.size(); ++i) {
      chosen_[have] = from[i];
      choose(from.first(i), have + 1);
    }
  }

  [[nodiscard]] std::array<Element, max_strength> subset_at(std::uint64_t place) const {
    std::array<Element, max_strength> subset{};
    for (std::uint32_t i = t_; i >= 1; --i) {
      const auto& column = binomials_[i];
      const auto above = std::upper_bound(column.begin(), column.end(), place);
      const auto element = static_cast<std::size_t>(above - column.begin()) - 1;
      subset[i - 1] = static_cast<Element>(element);
      place -= column[element];
    }
    return subset;
  }

  std::uint64_t v_;
  std::uint32_t t_;
  std::vector<std::uint64_t> words_;
  std::array<std::vector<std::uint64_t>, max_strength + 1> binomials_;
  std::array<Element, max_strength> chosen_{};
  ElementBits bits_;
  Block sorted_;
};

}  // namespace changeover
