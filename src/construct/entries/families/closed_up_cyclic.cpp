// The tight circular SCCD(2cK+1, k), K = k−1, cut open, without r of its elements, closed up: a linear SCCD(2cK+1−r, k).
//
// With u = 2cK+1 and W_j = {j, …, j+K−1} over Z_u the tight design is W_j + (j+pK), p = c, …, 1, for j = 0, …, u−1.
// Cut at 0, an element below K has c+1 stays and any other has c; so without 0, …, r−1, closed up
// (construct/tools/close_up.hpp), there are at most cu − (c+1)r blocks if r ≤ K. Where an element's next stay comes while it is still
// there, a block more is saved: that happens r−K times if r > K, and never otherwise, so that cu − (c+1)r is the number for all
// r < 2K. This count was checked for every k and c that is served.
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>

#include "changeover/construct/registry.hpp"
#include "changeover/core/design.hpp"
#include "construct/entry.hpp"
#include "construct/tools/close_up.hpp"

namespace changeover {
namespace {

// The count was checked up to these.
constexpr std::uint64_t largest_k = 48;
constexpr std::uint64_t largest_c = 6;

struct Deletion {
  std::uint64_t c = 0;
  std::uint64_t r = 0;
};

std::optional<Deletion> deletion_of(const Parameters& p) {
  if (!asks_for_pairs(p, 1) || p.kind != Kind::linear || p.k < 3 || p.k > largest_k ||
      p.v <= 2 * p.k) {
    return std::nullopt;
  }
  const std::uint64_t around = 2 * (p.k - 1);
  const Deletion deletion{(p.v - 2) / around + 1, around - 1 - (p.v - 2) % around};
  return deletion.c < 2 || deletion.c > largest_c || deletion.r == 0 ? std::nullopt
                                                                     : std::optional(deletion);
}

std::uint64_t order_of(const Parameters& p, const Deletion& deletion) {
  return 2 * deletion.c * (p.k - 1) + 1;
}

Design tight(const Parameters& p, const Deletion& deletion) {
  const std::uint64_t window = p.k - 1;
  Parameters large = p;
  const std::uint64_t u = large.v = order_of(p, deletion);
  Design design(large);
  design.reserve(static_cast<std::size_t>(deletion.c * u));
  Block block(static_cast<std::size_t>(p.k));
  for (std::uint64_t j = 0; j < u; ++j) {
    for (std::uint64_t i = 0; i < window; ++i) {
      block[static_cast<std::size_t>(i)] = static_cast<Element>((j + i) % u);
    }
    for (std::uint64_t times = deletion.c; times > 0; --times) {
      block.back() = static_cast<Element>((j + times * window) % u);
      design.append(block);
    }
  }
  return design;
}

constexpr Description description{
    .name = "closed-up-cyclic",
    .summary =
        "a tight circular single-change design, cut open, without some neighbours, closed up",
    .preconditions = "linear, m = 1, 3 <= k <= 48, v = 2c(k-1)+1-r, 2 <= c <= 6, 1 <= r < 2(k-1)",
    .guarantee = "b = c(2c(k-1)+1) - (c+1)r",
    .place = "src/construct/tools/close_up.hpp",
};

class ClosedUpCyclic final : public Family {
 public:
  ClosedUpCyclic() : Family(description) {}

 protected:
  std::optional<Promise> promise(const Parameters& p) const override {
    const auto deletion = deletion_of(p);
    if (!deletion) {
      return std::nullopt;
    }
    return Promise{.b = deletion->c * order_of(p, *deletion) - (deletion->c + 1) * deletion->r};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    const Deletion deletion = deletion_of(p).value();
    const auto design = closed_up(tight(p, deletion), 0, deletion.r);
    return std::make_unique<BlockListSource>(p, design.value().blocks());
  }

  std::string explanation(const Parameters& p) const override {
    const Deletion deletion = deletion_of(p).value();
    return fmt::format(
        "Cut the tight circular SCCD({},{}) of {} windows open, delete {} of its elements, and let each stay begin as "
        "soon as another one has ended.",
        order_of(p, deletion), p.k, deletion.c, deletion.r);
  }
};

}  // namespace

const Construction& closed_up_cyclic_construction() { return only<ClosedUpCyclic>(); }

}  // namespace changeover
