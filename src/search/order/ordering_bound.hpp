// Lower bounds for order_for_least_change.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/run/control.hpp"
#include "changeover/search/local_search.hpp"

namespace changeover {

// How many elements two blocks have in common, by bit sets.

class Overlaps {
 public:
  /// @throws BadInput if a block is not distinct elements below v; MissingResource if the bit sets
  /// would need more than 4 GiB.
  Overlaps(std::span<const Block> blocks, std::uint64_t v);

  [[nodiscard]] std::size_t count() const { return sizes_.size(); }
  [[nodiscard]] std::uint32_t size(std::size_t i) const { return sizes_[i]; }
  [[nodiscard]] std::size_t words() const { return words_; }

  /// |A ∩ B|.
  [[nodiscard]] std::uint32_t operator()(std::size_t i, std::size_t j) const {
    const std::uint64_t* a = bits_.data() + i * words_;
    const std::uint64_t* b = bits_.data() + j * words_;
    int common = 0;
    for (std::size_t w = 0; w < words_; ++w) {
      common += std::popcount(a[w] & b[w]);
    }
    return static_cast<std::uint32_t>(common);
  }

 private:
  std::size_t words_;
  std::vector<std::uint64_t> bits_;
  std::vector<std::uint32_t> sizes_;
};

/// A lower bound on the number of introduced elements of any order: the larger of the number of
/// distinct elements that must be introduced, and the spanning tree bound with multipliers. It
/// takes as many rounds as `effort` overlaps allow, and at least one, even if that needs up to ten
/// times as many. `cost` is the cost of some order, and sets the step size. The scope of this
/// thread can stop a round; the result is then the best bound so far.
[[nodiscard]] std::uint64_t order_lower_bound(std::span<const Block> blocks,
                                              const Overlaps& overlaps,
                                              const LeastChangeWanted& wanted, std::uint64_t cost,
                                              std::uint64_t effort, RunControl& control);

}  // namespace changeover
