// Minimum circular SCCD(v,k) for 2k+1 ≤ v ≤ 3k−3: 3v − 4k + 1 blocks, which no linear one goes
// below either [docs/theorems.md, Theorems 5 and 8].
//
// K = k−1, w = v−2K−1, so 2 ≤ w ≤ K−1, and N = 2K+2−w. There are N *runners*, who stay once each
// and go round in a circle, N, N+1, … being 0, 1, … again, and 2w−1 *carriers* t_0, t_1, …, indices
// modulo 2w−1, who stay twice. On one part of the circle the block holds K+1 runners, and carriers
// visit; on the other w−1 carriers are there, who are relieved one by one until each two of them
// have met. Runner i is element i, t_i is N+i.
#include <fmt/format.h>

#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"
#include "construct/tools/swaps.hpp"

namespace changeover::relayed_windows_entry {
namespace {

class Relay final : public ShortPlan {
 public:
  Relay(std::uint64_t k, std::uint64_t w) : big_(k - 1), w_(w), runners_(2 * k - w) {}

  [[nodiscard]] Block start() const override {
    Block block(static_cast<std::size_t>(big_ + 1));
    std::iota(block.begin(), block.end(), Element{0});
    return block;
  }

  // It has fewer than 5k steps.
  void add_all(std::vector<Swap>& swaps) const override {
    Course course{*this, swaps};
    course.visits();
    course.slide_to(big_ + 1 - w_);
    for (std::uint64_t i = 0; i + 1 < w_; ++i) {
      course.runner_for(i);
    }
    course.relieve(1, w_ - 1);
    course.relieve(w_, 2 * w_ - 2);
    course.relieve(2 * w_ - 1, 2 * w_ - 1);
    course.slide_to(runners_);
    for (std::uint64_t i = 0; i + 1 < w_; ++i) {
      course.carrier_for_runner(i);
    }
    swaps.pop_back();  // it leads back to the first block
  }

 private:
  // The runners first, …, next−1 are in the block.
  struct Course {
    const Relay& relay;
    std::vector<Swap>& swaps;
    std::uint64_t first = 0;
    std::uint64_t next = relay.big_ + 1;

    [[nodiscard]] std::uint64_t runner(std::uint64_t i) const { return i % relay.runners_; }
    [[nodiscard]] std::uint64_t carrier(std::uint64_t i) const {
      return relay.runners_ + i % (2 * relay.w_ - 1);
    }
    void runner_for(std::uint64_t i) { swaps.push_back({runner(first++), carrier(i)}); }
    void carrier_for_runner(std::uint64_t i) { swaps.push_back({carrier(i), runner(next++)}); }
    void slide_to(std::uint64_t end) {
      while (first < end) {
        swaps.push_back({runner(first++), runner(next++)});
      }
    }
    void visits() {
      const std::uint64_t last = 2 * relay.w_ - 2;
      runner_for(relay.w_ - 1);
      for (std::uint64_t i = relay.w_; i < last; ++i) {
        swaps.push_back({carrier(i - 1), carrier(i)});
      }
      carrier_for_runner(last - 1);
      runner_for(last);
      carrier_for_runner(last);
    }
    // Relief e: t_{w−2+e} comes, t_{e−1} goes. These follow on each other without a runner moving.
    void relieve(std::uint64_t from, std::uint64_t to) {
      runner_for(relay.w_ - 2 + from);
      for (std::uint64_t e = from + 1; e <= to; ++e) {
        swaps.push_back({carrier(e - 2), carrier(relay.w_ - 2 + e)});
      }
      carrier_for_runner(to - 1);
    }
  };

  std::uint64_t big_;  // K
  std::uint64_t w_;
  std::uint64_t runners_;  // N
};

constexpr Description description{
    .name = "relayed-windows",
    .summary =
        "a window goes round; on half of the way visitors hold places and relieve each other",
    .preconditions = "circular, m = 1, 2k+1 <= v <= 3k-3",
    .guarantee = "b = 3v-4k+1, minimum",
    .place = "docs/theorems.md, Theorem 8",
};

class RelayedWindows final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    if (!asks_for_pairs(p, 1) || p.kind != Kind::circular || p.v <= 2 * p.k || p.v + 3 > 3 * p.k) {
      return std::nullopt;
    }
    return Promise{.b = 3 * p.v - 4 * p.k + 1};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    return std::make_unique<SwapSource>(p, 3 * p.v - 4 * p.k + 1,
                                        std::make_unique<Relay>(p.k, p.v - 2 * p.k + 1));
  }

  std::string explanation(const Parameters& p) const override {
    const std::uint64_t w = p.v - 2 * p.k + 1;
    return fmt::format(
        "A window slides round over {} elements, which stay once each; on the second half of the "
        "way {} of the {} others hold places beside it and relieve each other until each two have "
        "met.",
        2 * p.k - w, w - 1, 2 * w - 1);
  }
};

}  // namespace

const Construction& construction() { return only<RelayedWindows>(); }

}  // namespace changeover::relayed_windows_entry
