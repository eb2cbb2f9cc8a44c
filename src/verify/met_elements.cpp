#include "verify/met_elements.hpp"

#include <bit>
#include <optional>

#include "changeover/core/error.hpp"

namespace changeover {
namespace {

// How many elements of a range are present, as they come and go.
class Present {
 public:
  explicit Present(std::size_t v) : there_(v, false), sums_(v + 1, 0) {}

  void flip(Element x) {
    there_[x] = !there_[x];
    const std::uint32_t change = there_[x] ? 1U : ~std::uint32_t{0};
    for (std::size_t i = x + std::size_t{1}; i < sums_.size(); i += i & (~i + 1)) {
      sums_[i] += change;
    }
  }

  [[nodiscard]] bool has(Element x) const { return there_[x]; }
  [[nodiscard]] std::uint64_t in(ElementRange range) const {
    return below(range.last + std::size_t{1}) - below(range.first);
  }

 private:
  [[nodiscard]] std::uint64_t below(std::size_t end) const {
    std::uint64_t sum = 0;
    for (std::size_t i = end; i > 0; i -= i & (~i + 1)) {
      sum += sums_[i];
    }
    return sum;
  }

  std::vector<bool> there_;
  std::vector<std::uint32_t> sums_;  // a Fenwick tree
};

}  // namespace

void join(std::vector<ElementRange>& ranges) {
  std::ranges::sort(ranges);
  std::size_t kept = 0;
  for (const ElementRange& range : ranges) {
    if (kept > 0 && range.first <= std::uint64_t{ranges[kept - 1].last} + 1) {
      ranges[kept - 1].last = std::max(ranges[kept - 1].last, range.last);
    } else {
      ranges[kept++] = range;
    }
  }
  ranges.resize(kept);
}

void MetElements::wait(std::vector<ElementRange>& ranges, ElementRange others) {
  constexpr std::uint64_t most_ranges = std::uint64_t{1} << 27;  // 1 GiB
  constexpr std::size_t few = 8;
  ranges.push_back(others);
  ++ranges_;
  if (ranges.size() >= few && std::has_single_bit(ranges.size())) {
    const std::size_t before = ranges.size();
    join(ranges);
    ranges_ -= before - ranges.size();
  }
  if (ranges_ > most_ranges) {
    throw MissingResource(
        "verification by fans takes too much memory here: elements meet in too many separate "
        "ranges; give smaller parameters");
  }
}

void MetElements::reach_further(Waiting::iterator waiting) {
  Element& reach = reach_[waiting->first];
  std::vector<ElementRange>& ranges = waiting->second;
  const std::size_t before = ranges.size();
  for (bool further = true; further;) {
    further = false;
    std::erase_if(ranges, [&](const ElementRange& range) {
      const bool touches = range.first <= reach;
      if (touches && range.last >= reach) {
        reach = range.last + 1;
        further = true;
      }
      return touches;
    });
  }
  ranges_ -= before - ranges.size();
  if (ranges.empty()) {
    smaller_.erase(waiting);
  }
}

// Element by element: those in its list of smaller ones are known to have met, and of the others
// those in whose lists of larger ones it is.
MetElements::Missing MetElements::missing(std::size_t examples) {
  struct Change {
    std::uint64_t at;  // from this element on
    Element x;         // is present, or no longer
  };
  std::vector<Change> changes;
  for (auto& [x, ranges] : larger_) {
    join(ranges);
    for (const ElementRange& range : ranges) {
      changes.push_back({range.first, x});
      changes.push_back({std::uint64_t{range.last} + 1, x});
    }
  }
  std::ranges::sort(changes, {}, &Change::at);
  std::optional<Present> present;
  if (!changes.empty()) {
    present.emplace(reach_.size());
  }
  Missing missing;
  const auto gap = [&](Element y, ElementRange range) {
    const std::uint64_t size = std::uint64_t{range.last} - range.first + 1;
    const std::uint64_t open = size - (present ? present->in(range) : 0);
    missing.pairs += open;
    for (Element x = range.first; open > 0 && x <= range.last && missing.examples.size() < examples;
         ++x) {
      if (!present || !present->has(x)) {
        missing.examples.emplace_back(x, y);
      }
    }
  };
  auto change = changes.begin();
  for (Element y = 0; y < reach_.size(); ++y) {
    for (; change != changes.end() && change->at == y; ++change) {
      present->flip(change->x);
    }
    Element from = reach_[y];
    if (const auto waiting = smaller_.find(y); waiting != smaller_.end()) {
      join(waiting->second);
      for (const ElementRange& range : waiting->second) {
        if (range.first > from) {
          gap(y, {from, range.first - 1});
        }
        from = std::max(from, range.last + 1);
      }
    }
    if (from < y) {
      gap(y, {from, y - 1});
    }
  }
  return missing;
}

}  // namespace changeover
