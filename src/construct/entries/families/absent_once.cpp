// Minimum designs of strength t ≥ 3 for small v: every element is absent once.
//
// With d = v − k, p = ⌈d/m⌉ and mp = d + r no design has fewer than tp + 1 blocks ("end to end" in
// bounds/lower_bound.hpp). Let tp + 1 blocks follow each other in a circle, and take m copies of
// each i modulo tp + 1: copy 0, …, m−r−1 of i is absent from the p blocks i, …, i+p−1, the others
// from the p − 1 blocks i, …, i+p−2. In each step one element of each copy leaves and one comes
// back, so m do, and (m−r)p + r(p−1) = d are absent from each block. However many of them are in
// every block: t elements are absent from at most tp blocks, so some block has them all. Proof and
// what is not known: docs/theorems.md, Theorem 7.
//
// Strength 2 is served by small-v, which reaches further.
#include <fmt/format.h>

#include "bounds/counting_bound.hpp"
#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"
#include "core/checked.hpp"

namespace changeover::absent_once_entry {
namespace {

// d = v − k = mp − r; the circle has tp + 1 blocks.
struct Shape {
  std::uint64_t m, p, r, b;

  [[nodiscard]] std::uint64_t elements() const { return m * b; }  // that are absent at all
  // How many blocks miss an element of that copy.
  [[nodiscard]] std::uint64_t absence(std::uint64_t copy) const { return copy < m - r ? p : p - 1; }
};

std::optional<Shape> shape_of(const Parameters& p) {
  Parameters pairs = p;
  pairs.strength = 2;
  if (p.strength < 3 || p.strength > max_strength || !asks_for_pairs(pairs, p.change) ||
      p.v - p.k < p.change) {
    return std::nullopt;
  }
  const std::uint64_t reach = ceil_div(p.v - p.k, p.change);
  const Shape shape{p.change, reach, p.change * reach - (p.v - p.k), p.strength * reach + 1};
  return shape.b <= p.v / shape.m ? std::optional(shape) : std::nullopt;
}

constexpr Description description{
    .name = "absent-once",
    .summary = "every element is absent from at most one run of blocks, of p or p-1",
    .preconditions = "strength t >= 3, p = ceil((v-k)/m), v-k >= m, v >= m(tp+1)",
    .guarantee = "a minimum design of tp+1 blocks, by the end-to-end bound",
};

class AbsentOnce final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    const auto shape = shape_of(p);
    if (!shape) {
      return std::nullopt;
    }
    return Promise{.b = shape->b, .economical = shape->b == counting_bound(p)};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    const Shape shape = *shape_of(p);
    return numbered(p, shape.b, [shape](std::uint64_t number, std::span<Element> block) {
      std::size_t filled = 0;
      std::uint64_t element = 0;
      for (std::uint64_t i = 0; i < shape.b; ++i) {
        for (std::uint64_t copy = 0; copy < shape.m; ++copy, ++element) {
          if ((number + shape.b - i) % shape.b >= shape.absence(copy)) {
            block[filled++] = static_cast<Element>(element);
          }
        }
      }
      while (filled < block.size()) {
        block[filled++] = static_cast<Element>(element++);
      }
    });
  }

  std::string explanation(const Parameters& p) const override {
    const Shape shape = *shape_of(p);
    const auto runs = [](std::uint64_t length) {
      return length == 1 ? std::string("from block i only")
                         : fmt::format("from the {} blocks from block i on", length);
    };
    std::string text;
    if (shape.m == 1) {
      text = fmt::format("Of {} blocks in a circle element i is absent {}", shape.b, runs(shape.p));
    } else if (shape.r == 0) {
      text = fmt::format("Of {} blocks in a circle the {} elements {}i, … are absent {}", shape.b,
                         shape.m, shape.m, runs(shape.p));
    } else {
      text = fmt::format(
          "Of {} blocks in a circle the {} elements {}i, … are absent {}, the last {} of them one "
          "block less",
          shape.b, shape.m, shape.m, runs(shape.p), shape.r);
    }
    const std::uint64_t fixed = p.v - shape.elements();
    return fmt::format(
        "{}{}. Any {} are absent from at most {} blocks, so some block has them all.", text,
        fixed == 0 ? "" : fmt::format("; {} more are in every block", fixed), p.strength,
        p.strength * shape.p);
  }
};

}  // namespace

const Construction& construction() { return only<AbsentOnce>(); }

}  // namespace changeover::absent_once_entry
