// The minimum linear DCCD(v,k) for v even, k odd and 3k−1 ≤ v ≤ 4k−12: closed-up-windows with two
// copies of every element but four [docs/theorems.md, Theorem 6].
//
// Let k = 2K+1, and let r be as for the SCCD(4K+1−r, K+1): its elements are r, …, 4K. Those that
// are r modulo K stay single: r, K+r, 2K+r, 3K+r; each window W_j of K elements has one of them, so
// W_j and a visitor make 2K+1 elements. Where a single one visits and the next step brings a single
// one too, both come in one step.
#include <fmt/format.h>

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"
#include "construct/tools/swaps.hpp"

namespace changeover::doubled_closed_up_windows_entry {
namespace {

using Numbers = std::vector<std::uint64_t>;

class Doubled final : public ShortPlan {
 public:
  Doubled(std::uint64_t big, std::uint64_t r) : big_(big), r_(r) {}

  [[nodiscard]] Block start() const override {
    Block block;
    const auto add = [&](std::uint64_t x) {
      for (const std::uint64_t copy : copies({x})) {
        block.push_back(static_cast<Element>(copy));
      }
    };
    for (std::uint64_t x = r_; x <= big_; ++x) {
      add(x);
    }
    for (std::uint64_t x = 2 * big_; x < 2 * big_ + r_; ++x) {
      add(x);
    }
    return block;
  }

  // It has fewer than 8k swaps.
  void add_all(std::vector<Swap>& swaps) const override {
    const auto step = [&](const Numbers& leave, const Numbers& enter) {
      exchange(copies(leave), copies(enter), swaps);
    };
    const std::uint64_t K = big_;
    const std::uint64_t r = r_;
    for (std::uint64_t i = 1; i < r; ++i) {
      step({2 * K + i - 1}, {K + i});
    }
    step({2 * K + r - 1}, {2 * K + r, K + r});
    Numbers before{r, 2 * K + r};
    for (std::uint64_t j = r + 1; j + 1 < K; ++j) {
      step(before, {j + 2 * K});
      step({j + 2 * K}, {j + K});
      before = {j};
    }
    step(before, {3 * K - 1});
    step({3 * K - 1}, {3 * K});
    step({K - 1}, {2 * K - 1});
    step({K}, {2 * K});
    step({3 * K}, {2 * K + 1});
    before = {K + 1};
    for (std::uint64_t j = K + 2; j < 2 * K; ++j) {
      if (j == K + r) {
        step(before, {j + 2 * K, j + K});
        before = {j, j + 2 * K};
      } else {
        step(before, {j + 2 * K});
        step({j + 2 * K}, {j + K});
        before = {j};
      }
    }
    step(before, {4 * K});
    step({4 * K}, {3 * K + 1});
    step({2 * K}, {3 * K});
    before = {2 * K + 1};
    for (std::uint64_t j = 2 * K + 2; j <= 3 * K; ++j) {
      const std::uint64_t s = j - 2 * K - 1;
      if (j == 2 * K + r) {
        step(before, {j + K, r});
        before = {j, r};
        continue;
      }
      if (r < s && s + 2 <= K) {
        step(before, {s});
        before = {s};
      }
      step(before, {j + K});
      before = {j};
    }
    end(swaps);
  }

 private:
  [[nodiscard]] bool is_single(std::uint64_t x) const { return x % big_ == r_ % big_; }

  // The numbers of the copies of these elements.
  [[nodiscard]] Numbers copies(const Numbers& elements) const {
    Numbers all;
    for (const std::uint64_t x : elements) {
      const std::uint64_t singles_before = (x - r_ + big_ - 1) / big_;
      const std::uint64_t first = 2 * (x - r_) - singles_before;
      all.push_back(first);
      if (!is_single(x)) {
        all.push_back(first + 1);
      }
    }
    return all;
  }

  static void exchange(const Numbers& leave, const Numbers& enter, std::vector<Swap>& swaps) {
    for (std::size_t i = 0; i < leave.size(); ++i) {
      swaps.push_back({.leaves = leave[i], .enters = enter[i]});
    }
  }

  // As in closed-up-windows, with a queue of copies, two at a time.
  void end(std::vector<Swap>& swaps) const {
    const std::uint64_t K = big_;
    exchange(copies({3 * K}), copies({K}), swaps);
    exchange(copies({K}), copies({K + 1}), swaps);
    exchange(copies({K + 1}), copies({K - 1}), swaps);
    std::deque<std::uint64_t> done;
    const auto join = [&](std::uint64_t x) {
      for (const std::uint64_t copy : copies({x})) {
        done.push_back(copy);
      }
    };
    const auto come = [&](const Numbers& elements) {
      const Numbers enter = copies(elements);
      const Numbers leave{done[0], done[1]};
      done.erase(done.begin(), done.begin() + 2);
      exchange(leave, enter, swaps);
    };
    join(3 * K + 2);
    for (std::uint64_t s = 2; s < K; ++s) {
      if (s == r_) {
        come({K + s, s});
        join(K + s);
      } else {
        come({K + s});
        join(K + s);
        if (r_ < s && s + 2 <= K) {
          come({s});
        }
      }
      join(3 * K + 1 + s);
    }
  }

  std::uint64_t big_;  // K
  std::uint64_t r_;
};

constexpr Description description{
    .name = "doubled-closed-up-windows",
    .summary = "closed-up-windows with two copies of every element but four",
    .preconditions = "linear, m = 2, k >= 11 odd, v even, 3k-1 <= v <= 4k-12",
    .guarantee = "b = (3v-4k)/2+1, minimum",
    .place = "docs/theorems.md, Theorem 6",
};

// r; nullopt if p is not served.
std::optional<std::uint64_t> neighbours(const Parameters& p) {
  if (!asks_for_pairs(p, 2) || p.kind != Kind::linear || p.k % 2 == 0 || p.v % 2 != 0 || p.k < 11 ||
      p.v + 1 < 3 * p.k || p.v + 12 > 4 * p.k) {
    return std::nullopt;
  }
  return (4 * p.k - 6 - p.v) / 2;
}

class DoubledClosedUpWindows final : public Described<Family, description> {
  static std::uint64_t blocks_in(const Parameters& p) { return (3 * p.v - 4 * p.k) / 2 + 1; }

  std::optional<Promise> promise(const Parameters& p) const override {
    return neighbours(p) ? std::optional(Promise{.b = blocks_in(p)}) : std::nullopt;
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    return std::make_unique<SwapSource>(p, blocks_in(p),
                                        std::make_unique<Doubled>((p.k - 1) / 2, *neighbours(p)));
  }

  std::string explanation(const Parameters& p) const override {
    const std::uint64_t big = (p.k - 1) / 2;
    const std::uint64_t r = *neighbours(p);
    return fmt::format(
        "The SCCD({},{}) of closed-up-windows with two copies of every element; only {}, {}, {} "
        "and {} of its numbers stay single, and come two at a time where they meet.",
        4 * big + 1 - r, big + 1, r, big + r, 2 * big + r, 3 * big + r);
  }
};

}  // namespace

const Construction& construction() { return only<DoubledClosedUpWindows>(); }

}  // namespace changeover::doubled_closed_up_windows_entry
