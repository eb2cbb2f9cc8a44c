// Short linear m-change designs on t groups of n = k−m elements each of which is an unchanged
// subset, at its own position [docs/theorems.md, Theorems 33 and 34].
//
//     HeldList list(4, 2, 3);   // m = 2: 0123 2345 0145
//     list.position(1);         // of the group {2,3}: 1
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

/// A list for m = 2 or 3, k > m, k ≥ 4 and t ≥ 1. The lists stay as they are, for recipes name only
/// k, v and the kind: a better one needs an argument of the recipe. Where none was found groups
/// come one after another, held beside m-sets of the later ones, until a list is known for those
/// that are left; the blocks from one group to the next are left to be filled in. It has no blocks
/// for t = 1. O(t) memory, or that of a list that was found.
class HeldList {
 public:
  HeldList(std::uint64_t k, std::uint64_t change, std::uint64_t t);

  [[nodiscard]] std::uint64_t size() const { return first_blocks_ + found_.size(); }
  /// Block i, 0 ≤ i < size(). Elements from nt on, of which there are at most two, stand for any
  /// others; only lists for m = 3 have such. O(k), and O(log t).
  void write(std::uint64_t i, std::span<Element> block) const;
  /// Where group i, {in, …, in+n−1}, is kept: before block 0, …, after the last. They do not
  /// decrease.
  [[nodiscard]] std::uint64_t position(std::uint64_t group) const {
    return positions_[static_cast<std::size_t>(group)];
  }
  /// Whether blocks may have to be filled in before block i ≥ 1. O(log t).
  [[nodiscard]] bool is_seam(std::uint64_t i) const;

 private:
  [[nodiscard]] std::uint64_t later(std::uint64_t group) const { return n_ * (t_ - group - 1); }

  std::uint64_t n_, m_, t_;
  std::uint64_t first_blocks_ = 0;     // of groups that come one after another
  std::vector<std::uint64_t> starts_;  // the first block of each of these groups
  std::vector<Block> found_;           // for those that are left
  std::vector<std::uint64_t> positions_;
};

}  // namespace changeover
