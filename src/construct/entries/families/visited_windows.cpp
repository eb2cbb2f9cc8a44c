// A window slides over Z_u, u = 2c(k−1)+1, and is visited: single-change designs for every v
// between two tight circular ones. With K = k−1 and W_j = {j, …, j+K−1} the tight circular
// SCCD(u,k) is W_j + (j+pK) for p = c, …, 1 and all j. New elements x_1, …, x_w meet each other and
// 0, …, K at the start, and visit the windows W_{1+K}, W_{1+2K}, …, W_{1+(2c−1)K}, which hold all
// others.
//
//   v = u + w, 1 ≤ w ≤ K      c·u + (2c+1)w − 1 blocks;
//   v = u + w, K < w < 2K     w − K more: the x that do not fit go round among themselves;
//   v = 3k − 1                5k − 2 blocks (c = 1): K elements x and one, y, that visits W_K and
//                             stands in for 0 and 2K at the ends.
//
// Those are linear. The first two become circular by one block more, W_0 + K.
//
// For c = 1 and w ≤ K, and for v = 3k−1, these are 3v − 4k + 1 blocks: minimum [docs/theorems.md,
// Theorem 6].
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"
#include "construct/tools/swaps.hpp"
#include "core/checked.hpp"

namespace changeover::visited_windows_entry {
namespace {

// Appends the steps from one window to the next: `out` leaves for the first visitor, each visitor
// for the next.
void visit(std::uint64_t& out, std::uint64_t visitor, std::vector<Swap>& swaps) {
  swaps.push_back({.leaves = out, .enters = visitor});
  out = visitor;
}

class Windows final : public SwapPlan {
 public:
  Windows(std::uint64_t c, const Parameters& p, std::uint64_t w)
      : c_(c),
        big_(p.k - 1),
        u_(2 * c * big_ + 1),
        w_(w),
        first_(std::min(w, big_)),
        circular_(p.kind == Kind::circular) {}

  [[nodiscard]] Block start() const override {
    Block block{0};
    for (std::uint64_t i = 2; i <= big_; ++i) {
      block.push_back(static_cast<Element>(i));
    }
    block.push_back(static_cast<Element>(x(1)));
    return block;
  }

  bool leg(std::uint64_t index, std::vector<Swap>& swaps) const override {
    const std::uint64_t last = 2 * c_ * big_;
    if (index == 0) {
      load(swaps);
      return true;
    }
    if (index <= last) {
      slide(index, swaps);
      return true;
    }
    if (index == last + 1) {
      std::uint64_t out = last;
      for (std::uint64_t p = 2; p <= c_; ++p) {
        visit(out, p * big_, swaps);
      }
      if (circular_) {
        visit(out, big_, swaps);
      }
      return true;
    }
    return false;
  }

 private:
  [[nodiscard]] std::uint64_t x(std::uint64_t i) const { return u_ + i - 1; }

  // The element that is in the block beside 1, …, K when the window begins to slide.
  [[nodiscard]] std::uint64_t beside() const { return w_ <= big_ ? x(w_) : x(w_ - 1); }

  // All x come in for 2, …, K, meet, and go out again; 1 comes for 0.
  void load(std::vector<Swap>& swaps) const {
    for (std::uint64_t i = 1; i < first_; ++i) {
      swaps.push_back({.leaves = i + 1, .enters = x(i + 1)});
    }
    // If there are more than K, then hold x_1, …, x_{K−d−1} and let the other 2d+1 go round in d+1
    // places: every two of them meet. It ends with x_1, …, x_{K−1} and x_w inside.
    const std::uint64_t d = w_ - first_;
    const std::uint64_t ring = 2 * d + 1;
    const auto in_ring = [&](std::uint64_t i) { return x(big_ - d + i % ring); };
    for (std::uint64_t t = 0; t < 2 * d; ++t) {
      swaps.push_back({.leaves = in_ring(t), .enters = in_ring(t + d + 1)});
    }
    swaps.push_back({.leaves = 0, .enters = 1});
    for (std::uint64_t i = 1; i < first_; ++i) {
      swaps.push_back({.leaves = x(i), .enters = i + 1});
    }
    std::uint64_t out = x(w_);
    for (std::uint64_t i = first_; i < w_; ++i) {
      visit(out, x(i), swaps);
    }
  }

  void slide(std::uint64_t j, std::vector<Swap>& swaps) const {
    std::uint64_t out = j == 1 ? beside() : j - 1;
    for (std::uint64_t p = 2; p <= c_; ++p) {
      visit(out, (j + p * big_) % u_, swaps);
    }
    if (j > big_ && (j - 1) % big_ == 0) {
      for (std::uint64_t i = 1; i <= w_; ++i) {
        visit(out, x(i), swaps);
      }
    }
    visit(out, (j + big_) % u_, swaps);
  }

  std::uint64_t c_;
  std::uint64_t big_;  // K
  std::uint64_t u_;
  std::uint64_t w_;
  std::uint64_t first_;
  bool circular_;
};

// v = 3k − 1: elements 0, …, 2K of Z_{2K+1}, x_0, …, x_{K−1}, y.
class WindowsAndOne final : public SwapPlan {
 public:
  explicit WindowsAndOne(std::uint64_t k) : big_(k - 1) {}

  [[nodiscard]] Block start() const override {
    Block block{0};
    for (std::uint64_t i = 2; i <= big_; ++i) {
      block.push_back(static_cast<Element>(i));
    }
    block.push_back(static_cast<Element>(x(0)));
    return block;
  }

  bool leg(std::uint64_t index, std::vector<Swap>& swaps) const override {
    const std::uint64_t y = x(big_);
    if (index == 0) {
      for (std::uint64_t i = 1; i < big_; ++i) {
        swaps.push_back({.leaves = i + 1, .enters = x(i)});
      }
      swaps.push_back({.leaves = 0, .enters = y});
      swaps.push_back({.leaves = y, .enters = 1});
      for (std::uint64_t i = 0; i + 1 < big_; ++i) {
        swaps.push_back({.leaves = x(i), .enters = i + 2});
      }
      return true;
    }
    if (index < 2 * big_) {
      std::uint64_t out = index == 1 ? x(big_ - 1) : index - 1;
      if (index == big_) {
        visit(out, y, swaps);
      }
      if (index == big_ + 1) {
        for (std::uint64_t i = 0; i < big_; ++i) {
          visit(out, x(i), swaps);
        }
      }
      visit(out, (index + big_) % (2 * big_ + 1), swaps);
      return true;
    }
    if (index == 2 * big_) {
      swaps.push_back({.leaves = 2 * big_ - 1, .enters = y});
      swaps.push_back({.leaves = 0, .enters = big_ - 1});
      return true;
    }
    return false;
  }

 private:
  [[nodiscard]] std::uint64_t x(std::uint64_t i) const { return 2 * big_ + 1 + i; }

  std::uint64_t big_;  // K
};

// c and w for v; nullopt if v lies in no gap.
struct Gap {
  std::uint64_t c = 0;
  std::uint64_t w = 0;
};

std::optional<Gap> gap_of(const Parameters& p) {
  const std::uint64_t big = p.k - 1;
  if (p.v <= 2 * big + 1) {
    return std::nullopt;
  }
  const Gap gap{(p.v - 1) / (2 * big), (p.v - 1) % (2 * big)};
  return gap.w == 0 ? std::nullopt : std::optional(gap);
}

bool is_windows_and_one(const Parameters& p) {
  return p.kind == Kind::linear && p.k >= 4 && p.v == 3 * p.k - 1;
}

std::uint64_t blocks_of(const Parameters& p, const Gap& gap) {
  if (is_windows_and_one(p)) {
    return 5 * p.k - 2;
  }
  const std::uint64_t u = 2 * gap.c * (p.k - 1) + 1;
  const std::uint64_t more = gap.w < p.k ? 0 : gap.w - (p.k - 1);
  const std::uint64_t less = p.kind == Kind::linear ? 1 : 0;
  return checked_add(checked_multiply(gap.c, u),
                     checked_multiply(2 * gap.c + 1, gap.w) + more - less);
}

constexpr Description description{
    .name = "visited-windows",
    .summary = "a window slides over a cycle; new elements visit windows that cover it",
    .preconditions = "m = 1, k >= 3, v = 2c(k-1)+1+w with c >= 1 and 1 <= w < 2(k-1)",
    .guarantee =
        "b = c(2c(k-1)+1) + (2c+1)w, +w-k+1 if w >= k; linear 1 less; "
        "minimum 3v-4k+1 if 2k<=v<3k, k>3",
    .place = "docs/theorems.md, Theorem 6",
};

class VisitedWindows final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    if (!asks_for_pairs(p, 1) || p.k < 3) {
      return std::nullopt;
    }
    const auto gap = gap_of(p);
    return gap ? std::optional(Promise{.b = blocks_of(p, *gap)}) : std::nullopt;
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    const Gap gap = gap_of(p).value();
    std::unique_ptr<SwapPlan> plan;
    if (is_windows_and_one(p)) {
      plan = std::make_unique<WindowsAndOne>(p.k);
    } else {
      plan = std::make_unique<Windows>(gap.c, p, gap.w);
    }
    return std::make_unique<SwapSource>(p, blocks_of(p, gap), std::move(plan));
  }

  std::string explanation(const Parameters& p) const override {
    const std::uint64_t u = 2 * gap_of(p).value().c * (p.k - 1) + 1;
    if (is_windows_and_one(p)) {
      return fmt::format(
          "A window of {0} elements slides over Z_{1}; {0} new elements meet its beginning, then "
          "visit one window, and one more visits another and stands in at both ends.",
          p.k - 1, u);
    }
    return fmt::format(
        "A window of {0} elements slides over Z_{1}; {2} 0,...,{0} at the start, then {3} windows "
        "that hold all others.",
        p.k - 1, u,
        p.v == u + 1 ? "a new element meets"
                     : fmt::format("{} new elements meet each other and", p.v - u),
        p.v == u + 1 ? "visits" : "visit");
  }
};

}  // namespace

const Construction& construction() { return only<VisitedWindows>(); }

}  // namespace changeover::visited_windows_entry
