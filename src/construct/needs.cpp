#include "construct/needs.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include "bounds/counting_bound.hpp"
#include "changeover/bounds/lower_bound.hpp"
#include "changeover/run/scope.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

class Spreading {
 public:
  explicit Spreading(const PlanRange& limits) : limits_(limits) {}

  Needs run(const Needs& goals) {
    for (const auto& [p, b] : goals) {
      ask(p, b);
    }
    while (!open_.empty()) {
      stop_if_asked();
      const auto [b, p] = open_.top();
      open_.pop();
      if (spread_.at(p) == b) {  // otherwise it is there with more blocks
        backwards(p, b);
      }
    }
    return std::move(needs_);
  }

 private:
  // Takes what a design with so many blocks of p may come from.
  void ask(const Parameters& p, std::uint64_t b) {
    if (!note(p, b)) {
      return;
    }
    const auto [place, is_new] = spread_.try_emplace(p, b);
    if (is_new || place->second < b) {
      place->second = b;
      open_.emplace(b, p);
    }
  }

  // Whether there can be such a design; it is needed then.
  bool note(const Parameters& p, std::uint64_t b) {
    if (p.k < limits_.k_from || p.k > limits_.k_to || p.v < limits_.v_from || p.v > limits_.v_to ||
        p.change > p.k || p.v <= p.k || least(p) > b) {
      return false;
    }
    std::uint64_t& known = needs_[p];
    known = std::max(known, b);
    return true;
  }

  std::uint64_t least(const Parameters& p) {
    const auto [place, is_new] = least_.try_emplace(p, 0);
    if (is_new) {
      place->second =
          impossibility(p) ? std::numeric_limits<std::uint64_t>::max() : lower_bound(p).blocks;
    }
    return place->second;
  }

  void backwards(const Parameters& p, std::uint64_t b) {
    const auto with = [&p](std::uint64_t v, std::uint64_t k) {
      Parameters result = p;
      result.v = v;
      result.k = k;
      return result;
    };
    if (p.kind == Kind::linear) {
      Parameters circular = p;
      circular.kind = Kind::circular;
      ask(circular, b + p.k / 4 + 2);  // blocks that need not stay after a cut
    }
    ask(with(p.v - 1, p.k - 1), b);         // fix
    (void)note(with(p.v + 1, p.k + 1), b);  // unfix
    ask(with(p.v + 1, p.k), b);             // truncate
    if (p.change == 1 && p.kind == Kind::linear) {
      // Close up, again and again, each time with about as many blocks fewer as an element has stays. What these
      // come from is not asked: partial expansion would lead back and gain.
      std::uint64_t more = b;
      for (std::uint64_t v = p.v; v < limits_.v_to; ++v) {
        more += ceil_div(v, p.k - 1);
        Parameters larger = with(v + 1, p.k);
        (void)note(larger, more);
        larger.kind = Kind::circular;
        (void)note(larger, more);
      }
    }
    constexpr std::uint64_t any = std::numeric_limits<std::uint32_t>::max();
    for (std::uint64_t w = 1; p.change < p.k && p.v > p.k + w; ++w) {
      const Parameters smaller = with(p.v - w, p.k);
      if (new_elements_fit(smaller, w)) {
        const auto added = partial_expansion_count(smaller, 0, smallest_cover(smaller, any), w);
        if (added && *added < b && counting_bound(smaller) <= b - *added) {
          ask(smaller, b - *added);
        }
      }
    }
  }

  PlanRange limits_;
  Needs needs_, spread_, least_;
  std::priority_queue<std::pair<std::uint64_t, Parameters>> open_;  // most blocks first
};

}  // namespace

CoverPositions smallest_cover(const Parameters& p, std::uint64_t available) {
  CoverPositions cover{{}, available};
  cover.positions.resize(static_cast<std::size_t>(ceil_div(p.v, p.k - p.change)));
  return cover;
}

Needs spread(const Needs& goals, const PlanRange& limits) { return Spreading(limits).run(goals); }

PlanRange narrowed(PlanRange limits, Needs needs) {
  const auto extent = [&needs](const auto& of) {
    const auto [least, most] = std::minmax_element(
        needs.begin(), needs.end(),
        [&of](const auto& a, const auto& b) { return of(a.first) < of(b.first); });
    return std::pair(of(least->first), of(most->first));
  };
  if (!needs.empty()) {
    std::tie(limits.v_from, limits.v_to) = extent([](const Parameters& p) { return p.v; });
    std::tie(limits.k_from, limits.k_to) = extent([](const Parameters& p) { return p.k; });
  }
  limits.only = std::make_shared<const Needs>(std::move(needs));
  return limits;
}

}  // namespace changeover
