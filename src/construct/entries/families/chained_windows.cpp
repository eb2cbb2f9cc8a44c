// Linear SCCD(4k−3+w, k) for 2 ≤ w ≤ k−3 and k ≥ 6, one block fewer than visited-windows has:
// 8(k−1) + 5w, and yet one fewer for k ≥ 7 and w ≥ 3 [docs/theorems.md, Theorem 11].
//
// With K = k−1 and W_j = {j, …, j+K−1} over Z_u, u = 4K+1, the tight design is W_j + (j+2K), W_j +
// (j+K). In two *chains*, j = K, 2K, 3K and j = K+1, 2K+1, 3K+1, the visitor j+2K stays while the
// window moves, so that j never meets j+K but j+K meets j+2K. What the chains lose at their
// beginning is in the first blocks; what they gain at their end saves K−1 and K from coming back
// there. The new elements x_1, …, x_w meet 0, …, K−1, 2K and each other in the first blocks, and
// visit W_K, W_{2K+1} and W_{3K+1}.
//
// For the last saving x_w does not meet K−2 in the first blocks. It comes while the window moves to
// W_{2K+1} and to W_{3K}, there beside the visitor K−2. Then 3K−1 misses 4K−1, which visits W_{2K}
// instead of W_{2K−1}; and 2K−1, which it misses there, is with it in the last block, for which 1
// leaves early.
//
// Circular ones for 2 ≤ w ≤ k−2 and k ≥ 4 have 8(k−1) + 5w + 1 blocks, one fewer than
// visited-windows. There is the first chain only. Before the window moves to W_0 the new elements
// come for −1, 2K−1 and w−2 of 1, 2, …, one more of these makes room for 2K, and all come back for
// the new elements and 0, together with K−1 and K. x_1, which does not meet K−1 then, visits
// W_{K−1} instead of W_K.
//
// Linear ones for v = 6k−5+w, 2 ≤ w ≤ k−3 and k ≥ 5 have 18(k−1) + 7w + 1 blocks, one fewer than
// visited-windows: u = 6K+1, visitors j+2K and j+3K. The chain is j = 2K, 3K. There 4K and 5K stay,
// so that 2K misses 3K, which it meets in the last block; and 6K comes one window late for W_{3K},
// and for 4K at j = 4K, beside K−1, which x_1 meets there.
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "construct/entries/families/three_windows.hpp"
#include "construct/entry.hpp"
#include "construct/tools/swaps.hpp"

namespace changeover::chained_windows_entry {
namespace {

using namespace three_windows;

bool spares_a_block(std::uint64_t k, std::uint64_t w) { return k >= 7 && w >= 3; }

class Chained final : public SwapPlan {
 public:
  Chained(std::uint64_t k, std::uint64_t w)
      : big_(k - 1), u_(4 * big_ + 1), w_(w), spares_(spares_a_block(k, w)) {}

  // 0, 2K, the x, and as many of K−1, K−2, … as there is room for.
  [[nodiscard]] Block start() const override {
    Block block{0, static_cast<Element>(2 * big_)};
    for (std::uint64_t i = 1; i <= w_; ++i) {
      block.push_back(static_cast<Element>(x(i)));
    }
    for (std::uint64_t y = lowest(); y < big_; ++y) {
      if (!is_late(y)) {
        block.push_back(static_cast<Element>(y));
      }
    }
    return block;
  }

  // The blocks before W_2 + (2K+2), then those with W_j for j = 2, …, 4K.
  bool leg(std::uint64_t index, std::vector<Swap>& swaps) const override {
    if (index == 0) {
      begin(swaps);
      return true;
    }
    const std::uint64_t j = index + 1;
    if (j > 4 * big_ || (spares_ && j == 4 * big_)) {
      return false;
    }
    std::uint64_t out = leaving_before(j);
    const auto visit = [&](std::uint64_t y) {
      swaps.push_back({.leaves = out, .enters = y});
      out = y;
    };
    // j goes for one that comes, and then j+K comes for one that leaves.
    const auto slide = [&](std::uint64_t comes, std::uint64_t leaves) {
      swaps.push_back({.leaves = j, .enters = comes});
      swaps.push_back({.leaves = leaves, .enters = j + big_});
    };
    if (j == big_ || j == 2 * big_ + 1 || j == 3 * big_ + 1) {
      for (std::uint64_t i = 1; i <= w_; ++i) {
        if (!spares_ || i < w_ || j == big_) {
          visit(x(i));
        }
      }
    }
    if (spares_ && j == 2 * big_ - 1) {
      visit(j + big_);
      swaps.push_back({.leaves = j, .enters = j + 2 * big_});
      return true;
    }
    visit((j + 2 * big_) % u_);
    if (spares_ && j == 2 * big_) {
      slide(x(w_), x(w_));
    } else if (spares_ && j == 3 * big_ - 1) {
      slide(x(w_), late());
    } else if (spares_ && j == 4 * big_ - 1) {
      visit(2 * big_ - 1);
      swaps.push_back({.leaves = 1, .enters = late()});
    } else if (in_chain(j)) {
      swaps.push_back({.leaves = j, .enters = (j + big_) % u_});
    } else if (j < 4 * big_) {
      visit((j + big_) % u_);
    }
    return true;
  }

 private:
  [[nodiscard]] std::uint64_t x(std::uint64_t i) const { return u_ + i - 1; }
  // Those of 2, …, K−1 from here on are in the first block, but for the late one.
  [[nodiscard]] std::uint64_t lowest() const { return spares_ ? w_ : w_ + 1; }
  // Who comes into the first blocks for x_w.
  [[nodiscard]] std::uint64_t late() const { return big_ - 2; }
  [[nodiscard]] bool is_late(std::uint64_t y) const { return spares_ && y == late(); }
  // Whether the visitor j+2K stays while j leaves for j+K; 1 leaves in begin().
  [[nodiscard]] bool in_chain(std::uint64_t j) const {
    return j < 3 * big_ + 2 && (j % big_ <= 1) && j > 0;
  }
  // Who makes room when the window moves to W_j: j−1, or if that has left the visitor.
  [[nodiscard]] std::uint64_t leaving_before(std::uint64_t j) const {
    if (spares_ && j == 3 * big_) {
      return x(w_);
    }
    return in_chain(j - 1) || (spares_ && j == 2 * big_) ? (j - 1 + 2 * big_) % u_ : j - 1;
  }

  void begin(std::vector<Swap>& swaps) const {
    const auto step = [&](std::uint64_t leaves, std::uint64_t enters) {
      swaps.push_back({.leaves = leaves, .enters = enters});
    };
    // 2, 3, … come, one at a time, and go but for the last; so all of 2, …, K−1 but the late one
    // meet 2K and all x.
    std::vector<std::uint64_t> gone;
    std::uint64_t out = is_late(lowest()) ? big_ - 1 : lowest();
    for (std::uint64_t y = 2; y < lowest(); ++y) {
      step(out, y);
      gone.push_back(out);
      out = y;
    }
    step(0, 1);
    if (spares_) {
      step(x(w_), late());
    }
    step(x(1), big_);
    step(2 * big_, 2 * big_ + 1);
    step(x(2), big_ + 1);
    for (std::size_t i = 0; i + 1 < gone.size(); ++i) {
      step(x(i + 3), gone[i]);
    }
    step(1, gone.back());
  }

  std::uint64_t big_;  // K
  std::uint64_t u_;
  std::uint64_t w_;
  bool spares_;
};

class Ring final : public SwapPlan {
 public:
  Ring(std::uint64_t k, std::uint64_t w) : big_(k - 1), u_(4 * big_ + 1), w_(w) {}

  // W_1 + (2K+1).
  [[nodiscard]] Block start() const override {
    Block block;
    for (std::uint64_t y = 1; y <= big_; ++y) {
      block.push_back(static_cast<Element>(y));
    }
    block.push_back(static_cast<Element>(2 * big_ + 1));
    return block;
  }

  // The other blocks with W_j for j = 1, …, 4K, and those that lead back.
  bool leg(std::uint64_t index, std::vector<Swap>& swaps) const override {
    const std::uint64_t j = index + 1;
    if (j > 4 * big_) {
      if (j == u_) {
        close(swaps);
      }
      return j == u_;
    }
    std::uint64_t out = in_chain(j - 1) ? (j - 1 + 2 * big_) % u_ : j - 1;
    const auto visit = [&](std::uint64_t y) {
      swaps.push_back({.leaves = out, .enters = y});
      out = y;
    };
    if (j == big_ - 1) {
      visit(x(1));
    }
    if (j == big_ || j == 2 * big_ + 1 || j == 3 * big_ + 1) {
      for (std::uint64_t i = j == big_ ? 2 : 1; i <= w_; ++i) {
        visit(x(i));
      }
    }
    if (j > 1) {
      visit((j + 2 * big_) % u_);
    } else {
      out = 2 * big_ + 1;
    }
    if (in_chain(j)) {
      swaps.push_back({.leaves = j, .enters = (j + big_) % u_});
    } else if (j < 4 * big_) {
      visit((j + big_) % u_);
    }
    return true;
  }

 private:
  [[nodiscard]] std::uint64_t x(std::uint64_t i) const { return u_ + i - 1; }
  // Whether the visitor j+2K stays while j leaves for j+K.
  [[nodiscard]] bool in_chain(std::uint64_t j) const {
    return j == big_ || j == 2 * big_ || j == 3 * big_;
  }

  void close(std::vector<Swap>& swaps) const {
    const auto step = [&](std::uint64_t leaves, std::uint64_t enters) {
      swaps.push_back({.leaves = leaves, .enters = enters});
    };
    step(4 * big_, x(1));
    step(2 * big_ - 1, x(2));
    for (std::uint64_t y = 1; y + 1 < w_; ++y) {
      step(y, x(y + 2));
    }
    step(w_ - 1, 2 * big_);
    step(x(1), big_ - 1);
    for (std::uint64_t y = 1; y + 1 < w_; ++y) {
      step(x(y + 1), y);
    }
    step(x(w_), big_);
    step(0, w_ - 1);
  }

  std::uint64_t big_;  // K
  std::uint64_t u_;
  std::uint64_t w_;
};

// What leaves before window 1 is x_w.
const std::vector<Leg>& one_block_fewer() {
  static const std::vector<Leg> legs{
      {e(0), {}, last_x},
      {g(1), {g(3), g(4), from_x(1), g(2)}},
      {e(2), {e(5), e(4), {e(2), e(3)}}, e(4)},
      {g(2), {g(4), g(5), from_x(1), g(3)}},
      {e(3), {e(5), {e(3), e(4)}}, e(5)},
      {g(3), {g(5), e(0), e(6), from_x(1), g(4)}},
      {e(4), {f(1), {e(4), e(6)}, {e(6), x(1)}, {f(1), e(5)}}, x(1)},
      {g(4), {e(0), e(1), from_x(2), g(5)}},
      {g(5), {e(1), e(2), from_x(1), e(0)}},
      {e(6), {f(2), f(3), e(3), {e(6), e(2)}, {g(0), f(1)}}},
  };
  return legs;
}

class OfThree final : public ThreeWindows {
 public:
  OfThree(std::uint64_t k, std::uint64_t w) : ThreeWindows(k, w, 1) {}

  // 0, 2, …, K but K−1, x_1 and x_2.
  [[nodiscard]] Block start() const override {
    Block block{0};
    for (std::uint64_t y = 2; y <= big(); ++y) {
      if (y + 1 != big()) {
        block.push_back(static_cast<Element>(y));
      }
    }
    block.push_back(static_cast<Element>(number_of_x(1)));
    block.push_back(static_cast<Element>(number_of_x(2)));
    return block;
  }

 protected:
  [[nodiscard]] const std::vector<Leg>& table() const override { return one_block_fewer(); }

  void begin(std::vector<Swap>& swaps) const override {
    for (std::uint64_t i = 3; i <= added(); ++i) {
      swaps.push_back({.leaves = i, .enters = number_of_x(i)});
    }
    swaps.push_back({.leaves = 0, .enters = 1});
    swaps.push_back({.leaves = number_of_x(1), .enters = big() - 1});
    for (std::uint64_t i = 2; i < added(); ++i) {
      swaps.push_back({.leaves = number_of_x(i), .enters = i + 1});
    }
  }
};

/// v = 2cK+1+w.
struct Shape {
  std::uint64_t c = 0;
  std::uint64_t w = 0;
};

std::optional<Shape> shape_of(const Parameters& p) {
  if (!asks_for_pairs(p, 1) || p.k < 4) {
    return std::nullopt;
  }
  const std::uint64_t big = p.k - 1;
  const bool linear = p.kind == Kind::linear;
  for (std::uint64_t c = 2; c <= 3; ++c) {
    const std::uint64_t u = 2 * c * big + 1;
    const std::uint64_t most = linear ? big - 2 : big - 1;
    if (u + 2 <= p.v && p.v <= u + most && (!linear || p.k >= (c == 2 ? 6U : 5U)) &&
        (linear || c == 2)) {
      return Shape{c, p.v - u};
    }
  }
  return std::nullopt;
}

std::uint64_t blocks_of(const Parameters& p, const Shape& shape) {
  if (shape.c == 3) {
    return 18 * (p.k - 1) + 7 * shape.w + 1;
  }
  const std::uint64_t b = 8 * (p.k - 1) + 5 * shape.w;
  return p.kind == Kind::circular ? b + 1 : b - (spares_a_block(p.k, shape.w) ? 1 : 0);
}

constexpr Description description{
    .name = "chained-windows",
    .summary = "a window slides over a cycle, and some visitors stay while it moves",
    .preconditions =
        "m = 1, w >= 2; linear, v = 4k-3+w or 6k-5+w, w <= k-3; or circular, v = 4k-3+w, w <= k-2",
    .guarantee =
        "b = 8(k-1) + 5w, 1 less if k >= 7 and w >= 3, or 18(k-1) + 7w + 1; circular 8(k-1) + 5w "
        "+ 1",
    .place = "docs/theorems.md, Theorem 11",
};

class ChainedWindows final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    const auto shape = shape_of(p);
    return shape ? std::optional(Promise{.b = blocks_of(p, *shape)}) : std::nullopt;
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    const Shape shape = shape_of(p).value();
    std::unique_ptr<SwapPlan> plan;
    if (shape.c == 3) {
      plan = std::make_unique<OfThree>(p.k, shape.w);
    } else if (p.kind == Kind::linear) {
      plan = std::make_unique<Chained>(p.k, shape.w);
    } else {
      plan = std::make_unique<Ring>(p.k, shape.w);
    }
    return std::make_unique<SwapSource>(p, blocks_of(p, shape), std::move(plan));
  }

  std::string explanation(const Parameters& p) const override {
    const Shape shape = shape_of(p).value();
    const bool two = shape.c == 2 && p.kind == Kind::linear;
    return fmt::format(
        "A window of {} elements slides over Z_{}, visitors stay in {} while it moves, and {} new "
        "elements meet its beginning and visit it {} times.",
        p.k - 1, p.v - shape.w, two ? "two chains" : "a chain", shape.w,
        shape.c == 2 ? "three" : "five");
  }
};

}  // namespace

const Construction& construction() { return only<ChainedWindows>(); }

}  // namespace changeover::chained_windows_entry
