// Minimum k-change covering designs with v = 2k+1, blocks that are all new at each step: a core of
// k−1 elements and a ring of k+2.
//
// The blocks are, in turn, the core with one element of the ring, and the ring without two
// neighbours: core + x_1, ring − x_1 − x_2, core + x_2, and so on to core + x_{k+2}; a circular
// design ends with ring − x_{k+2} − x_1. Proof, also that no design has fewer blocks:
// docs/theorems.md, Theorem 40.
#include <fmt/format.h>

#include "bounds/counting_bound.hpp"
#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"

namespace changeover::core_and_ring_entry {
namespace {

constexpr std::uint64_t least_k = 4;

std::uint64_t count_of_blocks(const Parameters& p) {
  return 2 * p.k + (p.kind == Kind::circular ? 4 : 3);
}

constexpr Description description{
    .name = "core-and-ring",
    .summary = "a core with one element of a ring, and the ring without two neighbours, in turn",
    .preconditions = "m = k >= 4, v = 2k+1",
    .guarantee = "a minimum design of 2k+3 blocks, linear, or 2k+4, circular",
    .place = "docs/theorems.md, Theorem 40",
};

class CoreAndRing final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    if (!asks_for_pairs(p, p.k) || p.k < least_k || p.v != 2 * p.k + 1) {
      return std::nullopt;
    }
    const std::uint64_t b = count_of_blocks(p);
    return Promise{.b = b, .economical = b == counting_bound(p)};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    return numbered(p, count_of_blocks(p), [p](std::uint64_t number, std::span<Element> block) {
      const std::uint64_t ring = p.k + 2;  // its elements are 0, …, k+1, the core is above
      const std::uint64_t x = number / 2;
      const std::uint64_t next = (x + 1) % ring;
      std::size_t filled = 0;
      if (number % 2 == 0) {
        block[filled++] = static_cast<Element>(x);
        for (std::uint64_t y = ring; y < p.v; ++y) {
          block[filled++] = static_cast<Element>(y);
        }
        return;
      }
      for (std::uint64_t y = 0; y < ring; ++y) {
        if (y != x && y != next) {
          block[filled++] = static_cast<Element>(y);
        }
      }
    });
  }

  std::string explanation(const Parameters& p) const override {
    return fmt::format(
        "The core is {{{0}, …, {1}}}, the ring 0, …, {2}. The blocks are, in turn, the core with x "
        "and the ring without x and the element after x, for x = 0, …, {2}{3}. Two elements of the "
        "ring meet where it lacks two others; that takes k >= 4.",
        p.k + 2, p.v - 1, p.k + 1,
        p.kind == Kind::circular ? ", where 0 comes after the last"
                                 : "; the last block is of the core");
  }
};

}  // namespace

const Construction& construction() { return only<CoreAndRing>(); }

}  // namespace changeover::core_and_ring_entry
