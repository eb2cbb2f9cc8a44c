// Which pairs have met, where elements mostly meet smaller ones in their order.
#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

/// The elements from `first` to `last`.
struct ElementRange {
  Element first = 0;
  Element last = 0;

  auto operator<=>(const ElementRange&) const = default;
};

/// Sorts ranges and joins those that overlap or touch.
void join(std::vector<ElementRange>& ranges);

/// For each element, the smaller and the larger ones that it has met in ranges. A pair may be in
/// one list, in the other, or in both. Four bytes an element, and eight for each range that does
/// not begin at 0.
class MetElements {
 public:
  explicit MetElements(std::uint64_t v) : reach_(static_cast<std::size_t>(v), 0) {}

  /// x meets these elements, and is none of them. @throws MissingResource if there are too many
  /// ranges.
  void meet(Element x, ElementRange others) {
    if (others.first > x) {
      if (others.first == others.last) {
        meet_smaller(others.first, {x, x});
      } else {
        wait(larger_[x], others);
      }
    } else {
      meet_smaller(x, others);
    }
  }

  /// Pairs that have not met: their number, and the first few of them.
  struct Missing {
    std::uint64_t pairs = 0;
    std::vector<std::pair<Element, Element>> examples;
  };
  [[nodiscard]] Missing missing(std::size_t examples);

 private:
  void meet_smaller(Element x, ElementRange others) {
    Element& reach = reach_[x];
    if (others.first > reach) {
      wait(smaller_[x], others);
    } else if (others.last >= reach) {
      reach = others.last + 1;
      if (const auto waiting = smaller_.find(x); waiting != smaller_.end()) {
        reach_further(waiting);
      }
    }
  }

  using Waiting = std::unordered_map<Element, std::vector<ElementRange>>;
  void wait(std::vector<ElementRange>& ranges, ElementRange others);
  void reach_further(Waiting::iterator waiting);

  std::vector<Element> reach_;  // x has met 0, …, reach − 1
  Waiting smaller_;             // further ranges of smaller elements
  Waiting larger_;
  std::uint64_t ranges_ = 0;  // in both
};

}  // namespace changeover
