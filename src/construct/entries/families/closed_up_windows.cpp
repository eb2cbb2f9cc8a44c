// The tight circular SCCD(4k−3,k) with r elements taken out and not one block lost: the minimum
// linear SCCD(v,k) for 3k ≤ v ≤ 4k−5, with 3v − 4k + 1 blocks, k ≥ 5 [docs/theorems.md, Theorem 6].
//
// With K = k−1 the elements are r, …, 4K, r = 4k−3−v, 2 ≤ r ≤ K−2, and W_j = {j, …, j+K−1}. The
// window slides from W_r to W_{3K+1}; in the tight design W_j is met by j+2K and j+K. Where an
// element would have to come back for one partner only, it comes early or stays longer instead: 3K
// at W_{K+1}, 4K beside 2K, and the ends are gone through with a queue. Y_s = K+s, S_s = s, L_s =
// 3K+1+s. Element x is number x − r.
#include <fmt/format.h>

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"
#include "construct/tools/swaps.hpp"

namespace changeover::closed_up_windows_entry {
namespace {

class ClosedUp final : public ShortPlan {
 public:
  ClosedUp(std::uint64_t k, std::uint64_t r) : big_(k - 1), r_(r) {}

  [[nodiscard]] Block start() const override {
    Block block;
    for (std::uint64_t x = r_; x <= big_; ++x) {
      block.push_back(static_cast<Element>(x - r_));
    }
    for (std::uint64_t x = 2 * big_; x < 2 * big_ + r_; ++x) {
      block.push_back(static_cast<Element>(x - r_));
    }
    return block;
  }

  // It has fewer than 8k steps.
  void add_all(std::vector<Swap>& swaps) const override {
    const auto step = [&](std::uint64_t leaves, std::uint64_t enters) {
      swaps.push_back({.leaves = leaves - r_, .enters = enters - r_});
    };
    const std::uint64_t K = big_;
    begin(step);
    for (std::uint64_t j = r_ + 1; j + 2 <= K; ++j) {
      step(j - 1, j + 2 * K);
      step(j + 2 * K, j + K);
    }
    // 3K visits W_{K−1}, W_K and W_{K+1}.
    step(K - 2, 3 * K - 1);
    step(3 * K - 1, 3 * K);
    step(K - 1, 2 * K - 1);
    step(K, 2 * K);
    step(3 * K, 2 * K + 1);
    for (std::uint64_t j = K + 2; j < 2 * K; ++j) {
      step(j - 1, j + 2 * K);
      step(j + 2 * K, j + K);
    }
    // L_0 comes a step early, to meet 2K, and stays to the end.
    step(2 * K - 1, 4 * K);
    step(4 * K, 3 * K + 1);
    step(2 * K, 3 * K);
    for (std::uint64_t j = 2 * K + 2; j <= 3 * K; ++j) {
      const std::uint64_t s = j - 2 * K - 1;
      std::uint64_t out = j - 1;
      if (is_small(s)) {
        step(out, s);
        out = s;
      }
      step(out, j + K);
    }
    end(step);
  }

 private:
  [[nodiscard]] bool is_small(std::uint64_t s) const { return r_ <= s && s + 2 <= big_; }

  template <typename Step>
  void begin(const Step& step) const {
    for (std::uint64_t i = 1; i < r_; ++i) {
      step(2 * big_ + i - 1, big_ + i);
    }
    step(2 * big_ + r_ - 1, 2 * big_ + r_);
    step(2 * big_ + r_, big_ + r_);
  }

  // Y_s comes with S_s, and who is done with all goes.
  template <typename Step>
  void end(const Step& step) const {
    const std::uint64_t K = big_;
    step(3 * K, K);
    step(K, K + 1);
    step(K + 1, K - 1);
    std::deque<std::uint64_t> done{3 * K + 2};
    const auto come = [&](std::uint64_t x) {
      step(done.front(), x);
      done.pop_front();
    };
    for (std::uint64_t s = 2; s < K; ++s) {
      come(K + s);
      done.push_back(K + s);
      if (is_small(s)) {
        come(s);
      }
      done.push_back(3 * K + 1 + s);
    }
  }

  std::uint64_t big_;  // K
  std::uint64_t r_;
};

constexpr Description description{
    .name = "closed-up-windows",
    .summary =
        "a tight circular design without some neighbours, both ends reworked until no block is "
        "lost",
    .preconditions = "linear, m = 1, k >= 5, 3k <= v <= 4k-5",
    .guarantee = "b = 3v-4k+1, minimum",
    .place = "docs/theorems.md, Theorem 6",
};

class ClosedUpWindows final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    if (!asks_for_pairs(p, 1) || p.kind != Kind::linear || p.k < 5 || p.v < 3 * p.k ||
        p.v + 5 > 4 * p.k) {
      return std::nullopt;
    }
    return Promise{.b = 3 * p.v - 4 * p.k + 1};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    return std::make_unique<SwapSource>(p, 3 * p.v - 4 * p.k + 1,
                                        std::make_unique<ClosedUp>(p.k, 4 * p.k - 3 - p.v));
  }

  std::string explanation(const Parameters& p) const override {
    return fmt::format(
        "A window of {} elements slides once over Z_{} without 0,...,{}; visitors stay where "
        "windows overlap, and the end is gone through with a queue.",
        p.k - 1, 4 * p.k - 3, 4 * p.k - 4 - p.v);
  }
};

}  // namespace

const Construction& construction() { return only<ClosedUpWindows>(); }

}  // namespace changeover::closed_up_windows_entry
