// A linear SCCD(4k−3, k) with 8k−7 blocks: the tight circular design of two windows, chained where
// a window moves while its visitor stays [docs/theorems.md, Theorem 11].
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"
#include "construct/tools/swaps.hpp"

namespace changeover::chained_cyclic_entry {
namespace {

class Chained final : public ShortPlan {
 public:
  explicit Chained(std::uint64_t k) : big_(k - 1) {}

  [[nodiscard]] Block start() const override {
    Block block;
    for (std::uint64_t x = 0; x <= big_; ++x) {
      if (x != big_ - 2) {
        block.push_back(static_cast<Element>(x));
      }
    }
    block.push_back(static_cast<Element>(2 * big_));
    return block;
  }

  // It has 8k−8 swaps.
  void add_all(std::vector<Swap>& swaps) const override {
    const std::uint64_t K = big_;
    const auto step = [&](std::uint64_t leaves, std::uint64_t enters) {
      swaps.push_back({.leaves = leaves % (4 * K + 1), .enters = enters % (4 * K + 1)});
    };
    step(0, K - 2);
    step(2 * K, 2 * K + 1);
    step(2 * K + 1, K + 1);
    for (std::uint64_t j = 2; j <= 3 * K; ++j) {
      const bool window_is_here = (j - 1) % K == 0;  // the visitor before stayed for it
      step(window_is_here ? j - 1 + 2 * K : j - 1, j + 2 * K);
      step(j % K == 0 ? j : j + 2 * K, j + K);
    }
    step(K - 1, K);
    step(K, 0);
    for (std::uint64_t s = 1; s < K; ++s) {
      step(3 * K + s, K + s);
      if (s + 1 < K) {
        step(K + s, s);
      }
    }
  }

 private:
  std::uint64_t big_;  // K
};

constexpr Description description{
    .name = "chained-cyclic",
    .summary = "the tight circular design of two windows, linear with one block fewer",
    .preconditions = "linear, m = 1, k >= 4, v = 4k-3",
    .guarantee = "b = 8k-7",
    .place = "docs/theorems.md, Theorem 11",
};

class ChainedCyclic final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    if (!asks_for_pairs(p, 1) || p.kind != Kind::linear || p.k < 4 || p.v + 3 != 4 * p.k) {
      return std::nullopt;
    }
    return Promise{.b = 8 * p.k - 7};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    return std::make_unique<SwapSource>(p, 8 * p.k - 7, std::make_unique<Chained>(p.k));
  }

  std::string explanation(const Parameters& p) const override {
    return fmt::format(
        "A window of {} elements slides over Z_{}; at {}, {} and {} it moves while its visitor "
        "stays, and in the end it shrinks while the first elements return.",
        p.k - 1, p.v, p.k - 1, 2 * (p.k - 1), 3 * (p.k - 1));
  }
};

}  // namespace

const Construction& construction() { return only<ChainedCyclic>(); }

}  // namespace changeover::chained_cyclic_entry
