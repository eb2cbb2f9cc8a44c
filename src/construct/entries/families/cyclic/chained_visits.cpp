// Linear SCCD(2cK+1−r, k), K = k−1, for c ≥ 3 and 2 ≤ r < K, and for c ≥ 5 and r = K: one block
// fewer than even-visits has; and its unions [docs/theorems.md, Theorem 12].
//
// In even-visits the list begins with window J+1, J = K+r−1, and ends with window J and its
// visitors J+(2c−2)K, …, J+2K. Here J+2K is in the first block, beside a visitor of window J+1, and
// the others come with window J−1, the first in place of J+K−1. That spares two steps and costs one
// block at the beginning. It parts some pairs. By *chains*, windows that move while a visitor
// stays, and by visitors that come a window or two early or late, the lack of a pair is passed on
// from window to window, to a pair that meets at one of the ends.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "construct/entries/families/chains.hpp"
#include "construct/entries/families/cyclic/even_visits.hpp"
#include "core/words.hpp"

namespace changeover::chained_visits_entry {
namespace {

using chains::Leg;
using chains::Place;
using chains::Step;

// Places count from J.
struct Changes {
  int from;                    // J+from, …, J+to are in the first block,
  int to;                      // to is counted from K
  std::vector<Place> besides;  // and these
  std::vector<Step> opening;   // up to the first step of window J+2
  std::vector<Leg> legs;
};

// In Z_u J+6K is J−1, and J+5K+2 is r.
const Changes three_windows{
    .from = 3,
    .to = 0,
    .besides = {{0, 1}, {2, 0}, {4, 1}},
    .opening = {{{0, 1}, {0, 2}}, {{2, 0}, {1, 1}}, {{4, 1}, {2, 1}}},
    .legs =
        {
            {{0, 2}, {{{2, 1}, {4, 2}}, {{4, 2}, {2, 2}}, {{2, 2}, {1, 2}}}},
            {{1, 0}, {{{1, -1}, {3, 0}}, {{1, 0}, {2, 0}}, {{3, 0}, {5, 2}}}},
            {{1, 1}, {{{1, 1}, {2, 1}}, {{5, 2}, {3, 1}}}},
            {{1, 2}, {{{3, 1}, {3, 2}}, {{3, 2}, {2, 2}}}},
            {{2, 0}, {{{2, -1}, {4, 0}}, {{2, 0}, {3, 0}}}},
            {{2, 1}, {{{4, 0}, {4, 1}}, {{4, 1}, {0, 1}}}},
            {{2, 2}, {{{2, 1}, {3, 1}}, {{0, 1}, {4, 2}}, {{4, 2}, {3, 2}}}},
            {{3, 0}, {{{3, -1}, {1, -1}}, {{3, 0}, {4, 0}}}},
            {{3, 1}, {{{1, -1}, {1, 0}}, {{1, 0}, {1, 1}}, {{1, 1}, {4, 1}}}},
            {{3, 2}, {{{3, 1}, {5, 2}}, {{5, 2}, {4, 2}}}},
            {{4, 1}, {{{4, 0}, {0, 0}}}},
            {{4, 2}, {{{4, 1}, {2, 0}}, {{2, 0}, {2, 1}}, {{2, 1}, {0, 1}}, {{0, 1}, {5, 2}}}},
            {{5, 2}, {{{1, 0}, {3, 1}}, {{3, 1}, {0, 1}}, {{5, 2}, {1, 1}}}, Place{1, 1}},
            {{6, 0}, {{{6, -1}, {4, -1}}, {{4, -1}, {2, -1}}, {{2, -1}, {4, 0}}}},
        },
};

// In Z_u J+8K is J−1, and J+7K+2 is r.
const Changes four_windows{
    .from = 2,
    .to = 0,
    .besides = {{2, 0}, {6, 1}},
    .opening = {{{6, 1}, {0, 1}}, {{2, 0}, {4, 1}}, {{4, 1}, {2, 1}}, {{2, 1}, {1, 1}}},
    .legs =
        {
            {{1, 0}, {{{1, -1}, {5, 0}}, {{5, 0}, {3, 0}}, {{1, 0}, {2, 0}}}, Place{3, 0}},
            {{2, 0}, {{{2, -1}, {4, 0}}, {{4, 0}, {6, 0}}, {{2, 0}, {3, 0}}}, Place{6, 0}},
            {{3, 0}, {{{3, -1}, {5, 0}}, {{5, 0}, {4, 0}}, {{3, 0}, {1, -1}}}, Place{1, -1}},
            {{4, 0}, {{{4, -1}, {2, -1}}, {{2, -1}, {5, 0}}, {{4, 0}, {6, 0}}}, Place{6, 0}},
            {{5, 0}, {{{5, -1}, {3, -1}}, {{3, -1}, {1, -1}}, {{5, 0}, {3, 0}}, {{3, 0}, {6, 0}}}},
            {{5, 1}, {{{1, -1}, {1, 0}}, {{1, 0}, {6, 1}}}},
            {{6, 1}, {{{6, 0}, {4, 0}}, {{4, 0}, {0, 1}}, {{0, 1}, {0, 0}}}},
            {{6, 2}, {{{6, 1}, {4, 1}}, {{4, 1}, {2, 1}}, {{2, 1}, {2, 0}}, {{2, 0}, {7, 2}}}},
            {{8, 0},
             {{{8, -1}, {6, -1}},
              {{6, -1}, {4, -1}},
              {{4, -1}, {2, -1}},
              {{2, -1}, {6, 0}},
              {{8, 0}, {4, 0}}}},
        },
};

// c ≥ 5.
Changes many_windows(std::uint64_t c) {
  const std::uint64_t n = 2 * c;
  const auto e = [](std::uint64_t i) { return Place{i, 0}; };
  const auto f = [](std::uint64_t i) { return Place{i, -1}; };
  const auto g = [](std::uint64_t i) { return Place{i, 1}; };
  Changes changes{.from = 1, .to = -1, .besides = {e(2), g(n - 2)}, .opening = {}, .legs = {}};
  Leg late{
      .window = g(n - 2), .steps = {e(n - 4), e(0), {g(n - 2), e(2)}}, .leaves_next = e(n - 6)};
  for (std::uint64_t i = 4; i <= n - 6; i += 2) {
    changes.opening.push_back({e(i - 2), e(i)});
    late.steps.push_back(e(i));
  }
  changes.opening.push_back({e(n - 6), e(1)});
  changes.opening.push_back({g(n - 2), g(n - 4)});
  for (std::uint64_t i = n - 6; i >= 2; i -= 2) {
    changes.opening.push_back(g(i));
  }
  changes.opening.push_back(g(1));
  using Absent = std::vector<Place>;
  changes.legs = {
      {f(1), {e(n - 3), e(n - 5), f(2), {f(1), f(3)}}, f(3), Absent{f(3), f(2)}},
      {e(1), {}, {}, Absent{e(n - 3), e(n - 5)}},
      {f(2), {e(n - 6), {f(2), f(3)}}, e(n - 6), Absent{f(3)}},
      {e(2), {}, {}, Absent{e(n - 6)}},
      {e(n - 6), {{e(n - 6), f(2)}}, f(2), Absent{f(2)}},
      {e(n - 5), {{e(n - 5), f(1)}}, f(1), Absent{f(1)}},
      {e(n - 4), {{e(n - 4), e(n - 2)}, f(2)}, f(2), Absent{f(2), e(n - 2)}},
      {e(n - 3), {{e(n - 3), f(1)}, {f(3), e(n - 2)}}, f(1), Absent{f(1), e(n - 2)}},
      std::move(late),
      {f(0), {{f(0), e(n - 4)}, {f(2), e(n - 2)}}, {}, Absent{f(1)}},
  };
  return changes;
}

Changes changes_for(std::uint64_t c) {
  return c == 3 ? three_windows : c == 4 ? four_windows : many_windows(c);
}

class ChainedVisits final : public EvenVisits {
 public:
  ChainedVisits(std::uint64_t k, const Deletion& deletion)
      : EvenVisits(k, deletion, Kind::linear), changes_(changes_for(deletion.c)) {}

  [[nodiscard]] Block start() const override {
    Block block;
    for (auto y = changes_.from; y <= changes_.to + static_cast<int>(numbers().big); ++y) {
      block.push_back(static_cast<Element>(at({0, y})));
    }
    for (const Place& each : changes_.besides) {
      block.push_back(static_cast<Element>(at(each)));
    }
    return block;
  }

  // The opening, then the steps of windows J+2, …, u−1, 0, …, J−1.
  bool leg(std::uint64_t index, std::vector<Swap>& swaps) const override {
    const auto number_of = [this](const Place& place) { return at(place); };
    if (index == 0) {
      chains::add(changes_.opening, {}, number_of, swaps);
      return true;
    }
    if (index + 1 == numbers().u) {
      return false;
    }
    const std::uint64_t j = window(index + 1);
    std::vector<Swap> usual = swaps_of(j);
    const Leg* const before = changed_at(window(index));
    if (before != nullptr && before->leaves_next) {
      usual.front().leaves = at(*before->leaves_next);
    }
    const Leg* const changed = changed_at(j);
    if (changed == nullptr) {
      swaps.insert(swaps.end(), usual.begin(), usual.end());
      return true;
    }
    std::uint64_t out = usual.front().leaves;
    if (changed->absent) {
      const auto is_absent = [&](const Swap& each) {
        return std::ranges::any_of(*changed->absent,
                                   [&](const Place& x) { return at(x) == each.enters; });
      };
      std::erase_if(usual, is_absent);
      for (const Swap& each : usual) {
        swaps.push_back({.leaves = std::exchange(out, each.enters), .enters = each.enters});
      }
    }
    chains::add(changed->steps, out, number_of, swaps);
    return true;
  }

 private:
  // Window J+by.
  [[nodiscard]] std::uint64_t window(std::uint64_t by) const {
    return (numbers().big + numbers().r - 1 + by) % numbers().u;
  }
  [[nodiscard]] std::uint64_t in_cycle(const Place& place) const {
    return window(place.windows * numbers().big + numbers().u +
                  static_cast<std::uint64_t>(static_cast<std::int64_t>(place.by)));
  }
  [[nodiscard]] std::uint64_t at(const Place& place) const { return number(in_cycle(place)); }

  [[nodiscard]] const Leg* changed_at(std::uint64_t j) const {
    const auto found = std::ranges::find(changes_.legs, j,
                                         [this](const Leg& leg) { return in_cycle(leg.window); });
    return found == changes_.legs.end() ? nullptr : &*found;
  }

  Changes changes_;
};

constexpr Description description{
    .name = "chained-visits",
    .summary = "even-visits with one block fewer, by visitors that stay while windows move",
    .preconditions =
        "v = 2cK+1-r, linear, c > 2, K = k-m > 2 (> 3 if c = 3), 1 < r < K (<= K if c > 4), "
        "K >= 2m if m > 1",
    .guarantee = "b = c(2cK+1) - (2c-1)r - 2; the m-th part of it if m > 1",
    .place = "docs/theorems.md, Theorem 12",
};

class ChainedVisitsFamily final : public WithoutNeighbours {
 public:
  ChainedVisitsFamily() : WithoutNeighbours(description, true) {}

 protected:
  bool serves(std::uint64_t k, const Deletion& deletion, Kind kind) const override {
    const auto [c, r] = deletion;
    return kind == Kind::linear && 2 <= r && r + (c < 5 ? 1 : 0) < k && k >= (c == 3 ? 5U : 4U) &&
           c >= 3;
  }
  // A linear list has one block fewer in any case.
  std::uint64_t saved(const Deletion& deletion) const override {
    return (2 * deletion.c - 1) * deletion.r + 1;
  }
  std::unique_ptr<SwapPlan> steps(std::uint64_t k, const Deletion& deletion,
                                  Kind /*kind*/) const override {
    return std::make_unique<ChainedVisits>(k, deletion);
  }
  std::string explanation(const Parameters& p, const Deletion& deletion) const override {
    return fmt::format(
        "In the tight circular SCCD({},{}) of {} windows, visited at even distances, leave out {}; "
        "in place of each, another element stays once and visits no more. Chains, windows that "
        "move while a visitor stays, spare one block more where the list begins and ends.",
        p.v + deletion.r, p.k, deletion.c, count_of(deletion.r, "neighbour"));
  }
};

}  // namespace

const Construction& construction() { return only<ChainedVisitsFamily>(); }

}  // namespace changeover::chained_visits_entry
