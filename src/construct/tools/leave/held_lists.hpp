// Short linear double-change designs on t groups of n = k−2 elements each of which is an unchanged
// subset, at a position of its own [docs/theorems.md, Theorem 33].
//
//     HeldList list(4, 3);   // 0123 2345 0145
//     list.position(1);      // of the group {2,3}: 1
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

/// A list for k ≥ 4, t ≥ 1. The lists stay as they are, for recipes name only k, v and the kind: a
/// better one needs an argument of the recipe. Where none was found groups come one after
/// another, held beside pairs of the later ones, until a list is known for those that are left;
/// the blocks from one group to the next are left to be filled in. It has no blocks for t = 1.
/// O(t) memory, or that of a list that was found.
class HeldList {
 public:
  HeldList(std::uint64_t k, std::uint64_t t);

  [[nodiscard]] std::uint64_t size() const { return first_blocks_ + found_.size(); }
  /// Block i, 0 ≤ i < size(), of elements below nt. O(k), and O(log t).
  void write(std::uint64_t i, std::span<Element> block) const;
  /// Where group i, {in, …, in+n−1}, is kept: before block 0, …, after the last. They increase.
  [[nodiscard]] std::uint64_t position(std::uint64_t group) const {
    return positions_[static_cast<std::size_t>(group)];
  }
  /// After how many groups blocks are to be filled in; there neighbours differ in n elements.
  [[nodiscard]] std::uint64_t gaps() const { return found_.empty() ? t_ - 1 : first_groups_; }

 private:
  [[nodiscard]] std::uint64_t later(std::uint64_t group) const { return n_ * (t_ - group - 1); }

  std::uint64_t n_, t_;
  std::uint64_t first_groups_ = 0;  // that come one after another
  std::uint64_t first_blocks_ = 0;
  std::vector<Block> found_;  // for those that are left
  std::vector<std::uint64_t> positions_;
};

}  // namespace changeover
