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

/// The best list that is known, for k ≥ 4, t ≥ 1. If none was found it is one group after another,
/// held beside pairs of the later ones; there the blocks from one group to the next are left to be
/// filled in. It has no blocks for t = 1. O(t) memory, or that of a list that was found.
class HeldList {
 public:
  HeldList(std::uint64_t k, std::uint64_t t);

  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// Block i, 0 ≤ i < size(), of elements below nt. O(k), and O(log t).
  void write(std::uint64_t i, std::span<Element> block) const;
  /// Where group i, {in, …, in+n−1}, is kept: before block 0, …, after the last. They increase.
  [[nodiscard]] std::uint64_t position(std::uint64_t group) const {
    return positions_[static_cast<std::size_t>(group)];
  }
  /// Whether blocks are to be filled in between one group and the next.
  [[nodiscard]] bool is_one_after_another() const { return found_.empty(); }

 private:
  [[nodiscard]] std::uint64_t later(std::uint64_t group) const { return n_ * (t_ - group - 1); }

  std::uint64_t n_, t_, size_ = 0;
  std::vector<Block> found_;
  std::vector<std::uint64_t> positions_;
};

}  // namespace changeover
