// Which pairs have met, where elements mostly meet smaller ones in their order.
#pragma once

#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "changeover/core/block.hpp"

namespace changeover {

/// The elements from `first` to `last`.
struct ElementRange {
  Element first = 0;
  Element last = 0;
};

/// For each element, the smaller and the larger ones that it has met in ranges. A pair may be in
/// one list, in the other, or in both. Four bytes an element, and some 100 for each range that does
/// not begin at 0.
class MetElements {
 public:
  explicit MetElements(std::uint64_t v) : reach_(static_cast<std::size_t>(v), 0) {}

  /// x meets these elements, and is none of them. O(log n) for n ranges of x, on average over
  /// calls. @throws MissingResource if there are too many ranges.
  void meet(Element x, ElementRange others) {
    if (others.first < x) {
      meet_smaller(x, others);
    } else if (others.first == others.last) {
      meet_smaller(others.first, {x, x});
    } else {
      wait(larger_[x], others);
    }
  }

  /// Pairs that have not met: their number, and the first few of them.
  struct Missing {
    std::uint64_t pairs = 0;
    std::vector<std::pair<Element, Element>> examples;
  };
  /// O((v + n) log v) time for n ranges of larger elements, and then 32 bytes for each of them and
  /// four an element.
  [[nodiscard]] Missing missing(std::size_t examples) const;

 private:
  /// From its first element to its last; none overlap or touch.
  using Ranges = std::map<Element, Element>;

  void meet_smaller(Element x, ElementRange others) {
    Element& reach = reach_[x];
    if (others.first > reach) {
      wait(smaller_[x], others);
    } else if (others.last >= reach) {
      reach = others.last + 1;
      if (const auto waiting = smaller_.find(x); waiting != smaller_.end()) {
        reach_further(reach, waiting->second);
        if (waiting->second.empty()) {
          smaller_.erase(waiting);
        }
      }
    }
  }

  void wait(Ranges& ranges, ElementRange others);
  void reach_further(Element& reach, Ranges& ranges);

  std::vector<Element> reach_;                   // x has met 0, …, reach − 1
  std::unordered_map<Element, Ranges> smaller_;  // further ranges of smaller elements
  std::unordered_map<Element, Ranges> larger_;
  std::uint64_t ranges_ = 0;  // in both
};

}  // namespace changeover
