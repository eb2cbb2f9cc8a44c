// Internal: items that may leave memory. The one that is needed last goes first (Belady's rule).
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

class IdleItems {
 public:
  static constexpr std::size_t never = ~std::size_t{0};  // needed

  explicit IdleItems(std::uint64_t items) : needed_(static_cast<std::size_t>(items), never) {}

  void add(Element x, std::size_t needed) {
    needed_[x] = needed;
    idle_.emplace(needed, x);
  }
  /// Whether it was idle.
  bool erase(Element x) { return idle_.erase({needed_[x], x}) > 0; }
  Element take_last() {
    const Element x = idle_.rbegin()->second;
    idle_.erase(std::prev(idle_.end()));
    return x;
  }

 private:
  std::vector<std::size_t> needed_;
  std::set<std::pair<std::size_t, Element>> idle_;
};

}  // namespace changeover
