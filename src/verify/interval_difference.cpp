#include "changeover/verify/difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "changeover/core/error.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

// The interval {first, …, first+length−1} of Z_v.
struct Interval {
  std::uint64_t first = 0;
  std::uint64_t length = 0;
};

// Differences up to sign: a collection of intervals in 1, …, ⌊v/2⌋, with repetition.
class DifferenceIntervals {
 public:
  DifferenceIntervals(std::uint64_t v, std::size_t expected) : v_(v) {
    intervals_.reserve(expected);
  }

  // The pairs {x, y}, y in `kept`; x is not in it.
  void add_pairs(Element x, const Interval& kept) {
    if (kept.length > 0) {
      // x − y falls by one as y runs through the interval, and stays in 1, …, v−1.
      const std::uint64_t greatest = x >= kept.first ? x - kept.first : x + v_ - kept.first;
      add_range(greatest - kept.length + 1, greatest);
    }
  }

  // The pair {x, y}, x ≠ y.
  void add_pair(Element x, Element y) {
    const std::uint64_t d = x < y ? y - x : x - y;
    add_range(d, d);
  }

  // How many pairs were added.
  [[nodiscard]] std::uint64_t pairs() const { return pairs_; }

  // Calls visit(low, high) for every interval [low, high], in increasing order of low.
  template <typename Visit>
  void for_each_sorted(Visit&& visit) {
    std::sort(intervals_.begin(), intervals_.end());
    for (const std::uint64_t packed : intervals_) {
      visit(packed >> 32, packed & 0xffff'ffff);
    }
  }

 private:
  // 1 ≤ low ≤ high ≤ v−1; what lies beyond ⌊v/2⌋ is folded back by d ↦ v − d.
  void add_range(std::uint64_t low, std::uint64_t high) {
    const std::uint64_t half = v_ / 2;
    if (low <= half) {
      intervals_.push_back(low << 32 | std::min(high, half));
    }
    if (high > half) {
      intervals_.push_back((v_ - high) << 32 | (v_ - std::max(low, half + 1)));
    }
    pairs_ += high - low + 1;
  }

  std::uint64_t v_;
  std::uint64_t pairs_ = 0;
  std::vector<std::uint64_t> intervals_;  // low end in the upper half, high end in the lower
};

// The points of base block i in increasing order, all of them distinct and outside the interval.
void read_points(const IntervalBaseBlocks& base, std::size_t i, Block& points) {
  const std::span<const Element> given = base.points_of(i);
  points.assign(given.begin(), given.end());
  std::sort(points.begin(), points.end());
  const auto twin = std::adjacent_find(points.begin(), points.end());
  if (twin != points.end()) {
    throw BadInput(fmt::format("base block {} repeats the element {}", i + 1, *twin));
  }
  for (const Element x : points) {
    const std::uint64_t from_start =
        x >= base.start ? x - base.start : x + base.parameters.v - base.start;
    if (from_start < base.length) {
      throw BadInput(
          fmt::format("base block {}: the point {} is in the interval from {} of {} elements",
                      i + 1, x, base.start, base.length));
    }
  }
}

// What changes in one step: the new block keeps `interval` and `kept`, and introduces `introduced`.
struct Step {
  Interval interval;
  Block kept;
  Block introduced;
};

// From base block i−1 to base block i: both hold A.
void step_inside(const IntervalBaseBlocks& base, const Block& previous, const Block& points,
                 Step& step) {
  step.interval = {base.start, base.length};
  step.kept.clear();
  step.introduced.clear();
  std::set_intersection(points.begin(), points.end(), previous.begin(), previous.end(),
                        std::back_inserter(step.kept));
  std::set_difference(points.begin(), points.end(), previous.begin(), previous.end(),
                      std::back_inserter(step.introduced));
}

// From the last base block, shifted by −1, to the first: an element y of the first is kept if y + 1
// is in the last base block, that is in A or among its points. Needs k < v, so that a+n is not in
// A.
void step_of_link(const IntervalBaseBlocks& base, const Block& last, const Block& points,
                  Step& step) {
  const std::uint64_t v = base.parameters.v;
  const auto successor_is_a_point = [&](std::uint64_t y) {
    return std::binary_search(last.begin(), last.end(),
                              static_cast<Element>(y + 1 == v ? 0 : y + 1));
  };
  step.interval = {base.start, base.length};
  step.kept.clear();
  step.introduced.clear();
  if (base.length > 0) {
    const std::uint64_t end = (base.start + base.length - 1) % v;
    if (!successor_is_a_point(end)) {
      step.introduced.push_back(static_cast<Element>(end));
      --step.interval.length;
    }
  }
  for (const Element y : points) {
    const bool before_interval = base.length > 0 && (y + std::uint64_t{1}) % v == base.start;
    (before_interval || successor_is_a_point(y) ? step.kept : step.introduced).push_back(y);
  }
}

void add_newly_covered(const Step& step, DifferenceIntervals& differences) {
  for (std::size_t i = 0; i < step.introduced.size(); ++i) {
    const Element x = step.introduced[i];
    differences.add_pairs(x, step.interval);
    for (const Element y : step.kept) {
      differences.add_pair(x, y);
    }
    for (std::size_t j = 0; j < i; ++j) {
      differences.add_pair(x, step.introduced[j]);
    }
  }
}

}  // namespace

DifferenceVerdict verify_differences(const IntervalBaseBlocks& base) {
  const Parameters& p = base.parameters;
  check_shape(base);
  if (p.strength != 2) {
    throw ImpossibleParameters("differences certify pairs only: use strength 2");
  }
  const std::size_t c = base.base_block_count();
  const auto each = static_cast<std::size_t>(base.points_per_block());
  DifferenceVerdict verdict;
  verdict.b = base.block_count();

  Block previous;
  Block points;
  if (p.k == p.v) {  // every block is Z_v: nothing ever changes, everything occurs
    for (std::size_t i = 0; i < c; ++i) {
      read_points(base, i, points);
    }
    verdict.bad_steps = c;
    verdict.first_bad_step = 1;
    return verdict;
  }

  // A base block of m points that are all new: m intervals and m(m−1)/2 single differences.
  DifferenceIntervals differences(p.v, c * (each <= 4 ? each * (each + 1) / 2 : each));
  Step step;
  read_points(base, c - 1, previous);
  for (std::size_t i = 0; i < c; ++i) {
    read_points(base, i, points);
    (i == 0 ? step_of_link : step_inside)(base, previous, points, step);
    if (step.introduced.size() != p.change) {
      ++verdict.bad_steps;
      // The step into B_0 is the link, the last step of a round.
      const std::uint64_t number = i == 0 ? c : i;
      verdict.first_bad_step = std::min(verdict.first_bad_step.value_or(number), number);
    }
    add_newly_covered(step, differences);
    previous.swap(points);
  }

  // No element is in every translate of a base block, so a pair that occurs is newly covered
  // somewhere.
  const std::uint64_t half = p.v / 2;
  std::uint64_t covered_to = 0;
  const auto gap_up_to = [&](std::uint64_t end) {
    for (std::uint64_t d = covered_to + 1;
         d <= end && verdict.uncovered_examples.size() < DifferenceVerdict::most_examples; ++d) {
      verdict.uncovered_examples.push_back(d);
    }
    verdict.uncovered += end > covered_to ? end - covered_to : 0;
  };
  differences.for_each_sorted([&](std::uint64_t low, std::uint64_t high) {
    gap_up_to(low - 1);
    covered_to = std::max(covered_to, high);
  });
  gap_up_to(half);

  // A difference d stands for v pairs, except that d = v/2 stands for v/2.
  const std::uint64_t distinct = half - verdict.uncovered;
  const bool short_orbit = p.v % 2 == 0 && covered_to == half;
  verdict.excess =
      checked_add(checked_multiply(differences.pairs() - distinct, p.v), short_orbit ? p.v / 2 : 0);
  verdict.tight = verdict.valid() && verdict.excess == 0;
  return verdict;
}

}  // namespace changeover
