#include "construct/tools/leave/leave_factors.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace changeover {

LeaveFactors::LeaveFactors(std::uint64_t w, const std::vector<std::uint64_t>& differences) : w_(w) {
  for (const std::uint64_t d : differences) {
    const std::uint64_t g = std::gcd(d, w);
    cycles_.push_back({d, g, w / g, {}});
  }
}

std::optional<LeaveFactors> LeaveFactors::of(std::uint64_t w,
                                             const std::vector<std::uint64_t>& differences,
                                             bool half) {
  LeaveFactors factors(w, differences);
  if (half) {
    factors.classes_.push_back({Kind::rungs, 0, w / 2});
  }
  for (std::size_t i = 0; i < differences.size(); ++i) {
    const Cycles& of = factors.cycles_[i];
    if (of.length % 2 == 0) {
      factors.classes_.push_back({Kind::even, i, w / 2});
      factors.classes_.push_back({Kind::even, i, w / 2, true});
    } else if (half) {
      if (!factors.add_prism(i)) {
        return std::nullopt;
      }
    } else {
      if (of.length < 5) {
        return std::nullopt;
      }
      factors.classes_.push_back({Kind::odd, i, (w + of.cycles) / 2});
      factors.classes_.push_back({Kind::odd, i, (w + of.cycles % 2) / 2, true});
    }
  }
  if (w % 2 == 1) {
    factors.order_odd();
  }
  return factors;
}

// Colours the prisms of cycles of an odd length and their translates by w/2. Their edges left over
// take no element that has one.
bool LeaveFactors::add_prism(std::size_t which) {
  Cycles& of = cycles_[which];
  const std::uint64_t half = w_ / 2;
  const auto is_taken = [&](std::uint64_t x) {
    return std::ranges::binary_search(no_rungs_, x % half);
  };
  for (std::uint64_t r = 0; r < of.cycles / 2; ++r) {
    std::uint64_t start = r;
    std::uint64_t tried = 0;
    while (is_taken(start) || is_taken(start + w_ - of.difference)) {
      start = (start + of.difference) % w_;
      if (++tried == of.length) {
        return false;
      }
    }
    of.starts.push_back(start);
    for (const std::uint64_t h : {std::uint64_t{0}, half}) {
      left_over_.push_back(edge(of, start + h, of.length - 1));
    }
    for (const std::uint64_t x : {start, start + w_ - of.difference}) {
      no_rungs_.insert(std::ranges::upper_bound(no_rungs_, x % half), x % half);
    }
  }
  classes_.push_back({Kind::prism, which, half});
  classes_.push_back({Kind::prism, which, half, true});
  return true;
}

// The second class of the first difference first, that of the next one last.
void LeaveFactors::order_odd() {
  const auto is_second_of = [](std::size_t which) {
    return [which](const Class& c) { return c.second && c.which == which; };
  };
  std::ranges::stable_partition(classes_, is_second_of(0));
  if (classes_.size() >= 4) {
    std::ranges::stable_partition(classes_, std::not_fn(is_second_of(1)));
    classes_.back().reversed = true;
  }
}

Element LeaveFactors::at(const Cycles& cycles, std::uint64_t start, std::uint64_t i) const {
  return static_cast<Element>((start + i % cycles.length * cycles.difference) % w_);
}

LeaveFactors::Pair LeaveFactors::edge(const Cycles& cycles, std::uint64_t start,
                                      std::uint64_t i) const {
  return {at(cycles, start, i), at(cycles, start, i + 1)};
}

LeaveFactors::Pair LeaveFactors::rung_or_left_over(std::uint64_t j) const {
  const std::uint64_t half = w_ / 2;
  const std::uint64_t rungs = half - no_rungs_.size();
  if (j >= rungs) {
    return left_over_[static_cast<std::size_t>(j - rungs)];
  }
  for (const std::uint64_t x : no_rungs_) {
    j += x <= j ? 1U : 0U;
  }
  return {static_cast<Element>(j), static_cast<Element>(j + half)};
}

LeaveFactors::Pair LeaveFactors::odd_second(const Cycles& cycles, std::uint64_t j) const {
  const std::uint64_t g = cycles.cycles;
  const std::uint64_t more = (g - 1) / 2;
  if (j == 0) {
    return {0, 1};
  }
  if (j >= 2 && j < 2 + more) {
    const std::uint64_t x = 2 * (j - 1);
    return {static_cast<Element>(x), static_cast<Element>(x + 1 == g ? 0 : x + 1)};
  }
  const std::uint64_t number = j == 1 ? 0 : j - 1 - more;
  const std::uint64_t in_each = (cycles.length - 1) / 2;
  return edge(cycles, number / in_each, 2 * (number % in_each) + 1);
}

// For each cycle below: its edges, those of its translate, and the pair of both where one lacks.
LeaveFactors::Pair LeaveFactors::prism(const Cycles& cycles, bool second, std::uint64_t j) const {
  const std::uint64_t half = w_ / 2;
  const std::uint64_t start = cycles.starts[static_cast<std::size_t>(j / cycles.length)];
  const std::uint64_t in_each = (cycles.length - 1) / 2;
  const std::uint64_t i = j % cycles.length;
  if (i == cycles.length - 1) {
    const Element x = second ? at(cycles, start, 0) : at(cycles, start, cycles.length - 1);
    return {x, static_cast<Element>((x + half) % w_)};
  }
  return edge(cycles, start + (i < in_each ? 0 : half), 2 * (i % in_each) + (second ? 1 : 0));
}

LeaveFactors::Pair LeaveFactors::pair(std::size_t i, std::uint64_t j) const {
  const Class& of = classes_[i];
  if (of.kind == Kind::rungs) {
    return rung_or_left_over(j);
  }
  const Cycles& cycles = cycles_[of.which];
  if (of.kind == Kind::prism) {
    return prism(cycles, of.second, j);
  }
  if (of.kind == Kind::odd && of.second) {
    return odd_second(cycles, of.reversed ? of.count - 1 - j : j);
  }
  const std::uint64_t in_each = (cycles.length + 1) / 2;
  return edge(cycles, j / in_each, 2 * (j % in_each) + (of.second ? 1 : 0));
}

}  // namespace changeover
