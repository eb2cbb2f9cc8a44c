// Linear SCCD(6K+1+w, k), K = k−1, for 3 ≤ w ≤ K−2: 18K + 7w blocks, two fewer than
// visited-windows and one fewer than chained-windows [docs/theorems.md, Theorem 11].
//
// The list begins with window 2 and ends with window 0 and the new elements x_1, …, x_w. There is a
// table of steps for the windows iK−1, …, iK+3; with all from_x(4) the steps are the usual ones,
// j+2K, j+3K, j+K.
#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "construct/entries/families/three_windows.hpp"
#include "construct/entry.hpp"

namespace changeover::chained_three_windows_entry {
namespace {

using namespace three_windows;

const std::vector<Leg>& two_blocks_fewer() {
  static const std::vector<Leg> legs{
      {h(0), {{h(0), d(0)}, {h(2), h(3)}}, h(3)},
      {f(1), {e(4), f(4), {f(1), f(3)}, {f(4), f(2)}}, f(3)},
      {e(1), {e(3), e(2)}},
      {g(1), {g(3), g(4), x(1), x(2), x(3), from_x(4), g(2)}},
      {h(1), {{h(1), h(4)}, {g(1), h(2)}, {h(4), h(3)}}, h(3)},
      {f(2), {e(4), f(5), f(4)}},
      {e(2), {{f(2), e(5)}, {e(5), e(3)}, {f(4), f(3)}}},
      {g(2), {x(3), g(5), x(1), x(2), from_x(4), g(4), {g(2), g(3)}}},
      {h(2), {{h(2), h(5)}, {g(4), h(4)}, {h(5), h(3)}}, h(4)},
      {f(3), {f(5), f(6), e(5), e(4)}},
      {e(3), {{f(3), e(6)}, {e(3), f(4)}}, e(6)},
      {g(3),
       {g(5), {g(3), e(0)}, {g(5), x(1)}, {e(0), h(0)}, {x(1), x(3)}, from_x(4), x(2), h(5), g(4)},
       h(0)},
      {h(3), {g(0), {h(3), h(4)}}, g(0)},
      {d(3), {d(5), d(4)}},
      {e(4), {e(5), {e(4), f(1)}}, f(1)},
      {g(4), {e(6), e(0), e(1), x(1), x(2), x(3), from_x(4), g(5)}},
      {h(4), {h(0), h(1), {h(4), h(5)}, {h(1), g(0)}, g(1)}, g(1)},
      {d(4), {d(5)}},
      {e(5), {f(2), {e(5), e(6)}}, f(2)},
      {g(5), {x(3), f(1), e(2), x(1), from_x(4), x(2), e(1), {g(5), g(2)}, {g(2), e(0)}}, e(1)},
      {h(5), {h(2), {h(5), g(0)}}, h(2)},
      {d(5), {h(1), g(1), h(0)}},
      {e(6), {f(3), {e(6), f(1)}, {f(3), f(2)}, e(2), e(3), g(2), {g(0), g(3)}, {g(2), x(2)}}},
  };
  return legs;
}

class TwoBlocksFewer final : public ThreeWindows {
 public:
  TwoBlocksFewer(std::uint64_t k, std::uint64_t w) : ThreeWindows(k, w, 2) {}

  // 2, 4, …, K+2 and 2K+2.
  [[nodiscard]] Block start() const override {
    Block block{2};
    for (std::uint64_t y = 4; y <= big() + 2; ++y) {
      block.push_back(static_cast<Element>(y));
    }
    block.push_back(static_cast<Element>(2 * big() + 2));
    return block;
  }

 protected:
  [[nodiscard]] const std::vector<Leg>& table() const override { return two_blocks_fewer(); }

  // 5, …, w+1 leave for x_4, …, x_w and come back when 1 and K have come.
  void end(std::vector<Swap>& swaps) const override {
    for (std::uint64_t i = 4; i <= added(); ++i) {
      swaps.push_back({.leaves = i + 1, .enters = number_of_x(i)});
    }
    swaps.push_back({.leaves = 2, .enters = number_of_x(3)});
    swaps.push_back({.leaves = 0, .enters = number_of_x(1)});
    swaps.push_back({.leaves = 3, .enters = 1});
    swaps.push_back({.leaves = 4, .enters = big()});
    for (std::uint64_t i = 4; i <= added(); ++i) {
      swaps.push_back({.leaves = number_of_x(i == 4 ? 2 : i - 1), .enters = i + 1});
    }
  }
};

std::optional<std::uint64_t> added_of(const Parameters& p) {
  if (!asks_for_pairs(p, 1) || p.kind != Kind::linear || p.k < 6) {
    return std::nullopt;
  }
  const std::uint64_t u = 6 * (p.k - 1) + 1;
  return u + 3 <= p.v && p.v <= u + p.k - 3 ? std::optional(p.v - u) : std::nullopt;
}

std::uint64_t blocks_of(const Parameters& p, std::uint64_t w) { return 18 * (p.k - 1) + 7 * w; }

constexpr Description description{
    .name = "chained-three-windows",
    .summary = "three windows slide over a cycle, and some visitors stay while they move",
    .preconditions = "linear, m = 1, v = 6k-5+w, 3 <= w <= k-3",
    .guarantee = "b = 18(k-1) + 7w",
    .place = "docs/theorems.md, Theorem 11",
};

class ChainedThreeWindows final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    const auto w = added_of(p);
    return w ? std::optional(Promise{.b = blocks_of(p, *w)}) : std::nullopt;
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    const std::uint64_t w = added_of(p).value();
    return std::make_unique<SwapSource>(p, blocks_of(p, w),
                                        std::make_unique<TwoBlocksFewer>(p.k, w));
  }

  std::string explanation(const Parameters& p) const override {
    const std::uint64_t w = added_of(p).value();
    return fmt::format(
        "A window of {} elements slides over Z_{} from 2 to 0, visitors stay near the multiples of "
        "{} while it moves, and {} new elements visit it five times and come at its end.",
        p.k - 1, p.v - w, p.k - 1, w);
  }
};

}  // namespace

const Construction& construction() { return only<ChainedThreeWindows>(); }

}  // namespace changeover::chained_three_windows_entry
