#include "verify/met_elements.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"

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

void MetElements::wait(Ranges& ranges, ElementRange others) {
  constexpr std::uint64_t most_ranges = std::uint64_t{1} << 25;  // about 3 GiB
  ranges_ -= ranges.size();
  auto next = ranges.upper_bound(others.first);
  if (next != ranges.begin()) {
    const auto before = std::prev(next);
    if (std::uint64_t{before->second} + 1 >= others.first) {
      others = {before->first, std::max(before->second, others.last)};
      ranges.erase(before);
    }
  }
  while (next != ranges.end() && next->first <= std::uint64_t{others.last} + 1) {
    others.last = std::max(others.last, next->second);
    next = ranges.erase(next);
  }
  ranges.emplace_hint(next, others.first, others.last);
  ranges_ += ranges.size();
  if (ranges_ > most_ranges) {
    throw MissingResource(
        "verification by fans takes too much memory here: elements meet in too many separate "
        "ranges; give smaller parameters");
  }
}

void MetElements::reach_further(Element& reach, Ranges& ranges) {
  while (!ranges.empty() && ranges.begin()->first <= reach) {
    reach = std::max(reach, ranges.begin()->second + 1);
    ranges.erase(ranges.begin());
    --ranges_;
  }
}

// Element by element: those in its list of smaller ones are known to have met, and of the others
// those in whose lists of larger ones it is.
MetElements::Missing MetElements::missing(std::size_t examples) const {
  struct Change {
    std::uint64_t at;  // from this element on
    Element x;         // is present, or no longer
  };
  std::vector<Change> changes;
  for (const auto& [x, ranges] : larger_) {
    for (const auto& [first, last] : ranges) {
      changes.push_back({first, x});
      changes.push_back({std::uint64_t{last} + 1, x});
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
  constexpr Element elements_between_looks = 1U << 16U;
  for (Element y = 0; y < reach_.size(); ++y) {
    if (y % elements_between_looks == 0) {
      stop_if_asked();
    }
    for (; change != changes.end() && change->at == y; ++change) {
      present->flip(change->x);
    }
    Element from = reach_[y];
    if (const auto waiting = smaller_.find(y); waiting != smaller_.end()) {
      for (const auto& [first, last] : waiting->second) {
        gap(y, {from, first - 1});  // it does not touch what is before it
        from = last + 1;
      }
    }
    if (from < y) {
      gap(y, {from, y - 1});
    }
  }
  return missing;
}

}  // namespace changeover
