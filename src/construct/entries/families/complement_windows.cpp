// Minimum m-change covering designs with v = k+m: the elements outside the blocks, in windows.
//
// What is outside a block has m elements, and consecutive blocks have nothing outside in common.
// Two elements never meet iff one is outside all odd blocks and the other outside all even ones. So
// let the set outside the odd blocks move: from {0, …, m−1} by k−m elements, or as many as are
// left, to {m, …, 2m−1}, in ⌈m/(k−m)⌉ moves. An even block has outside any m elements that its
// neighbours have not. Proof, also that no design has fewer blocks: docs/theorems.md, Theorem 39.
//
// For 2m ≤ k these are three blocks, which small-v serves.
#include <fmt/format.h>

#include <algorithm>

#include "bounds/counting_bound.hpp"
#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"
#include "core/checked.hpp"

namespace changeover::complement_windows_entry {
namespace {

std::uint64_t moves_of(const Parameters& p) { return ceil_div(p.change, p.k - p.change); }

// The first element of the window outside the odd block `number`, from 0: 0, 2, 4, ….
std::uint64_t window(const Parameters& p, std::uint64_t number) {
  return std::min(number / 2 * (p.k - p.change), p.change);
}

constexpr Description description{
    .name = "complement-windows",
    .summary = "what is outside every second block is a window that moves by k-m elements",
    .preconditions = "v = k+m, k/2 < m < k",
    .guarantee = "a minimum design of 2*ceil(m/(k-m)) + 1 blocks, linear and circular",
    .place = "docs/theorems.md, Theorem 39",
};

class ComplementWindows final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    if (!asks_for_pairs(p, p.change) || p.change >= p.k || 2 * p.change <= p.k ||
        p.v != p.k + p.change) {
      return std::nullopt;
    }
    const std::uint64_t b = 2 * moves_of(p) + 1;
    return Promise{.b = b, .economical = b == counting_bound(p)};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    return numbered(p, 2 * moves_of(p) + 1, [p](std::uint64_t number, std::span<Element> block) {
      const std::uint64_t from = window(p, number);
      // Of an even block the window before and the one after are inside.
      const std::uint64_t end = window(p, number + 1) + p.change;
      const bool is_window_outside = number % 2 == 0;
      std::size_t filled = 0;
      if (!is_window_outside) {
        for (std::uint64_t x = from; x < end; ++x) {
          block[filled++] = static_cast<Element>(x);
        }
      }
      for (std::uint64_t x = 0; filled < block.size(); ++x) {
        if (x < from || x >= end) {
          block[filled++] = static_cast<Element>(x);
        }
      }
    });
  }

  std::string explanation(const Parameters& p) const override {
    return fmt::format(
        "Outside each block are {0} elements, and no element is outside two consecutive ones. "
        "Outside blocks 1, 3, 5, … are {{0, …, {1}}}, then the same moved up by {2} a time, and "
        "{{{0}, …, {3}}} at the last, which has nothing in common with the first. So no element is "
        "outside all of these blocks, and every two elements meet.",
        p.change, p.change - 1, p.k - p.change, 2 * p.change - 1);
  }
};

}  // namespace

const Construction& construction() { return only<ComplementWindows>(); }

}  // namespace changeover::complement_windows_entry
