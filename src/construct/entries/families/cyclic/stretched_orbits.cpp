// Tight circular SCCD(gn, k), k−1 = gh, developed over g orbits of Z_n from a list that was found
// for one n and stretched to this one [docs/theorems.md, Theorem 30].
//
// A = {0, …, h−1} × {0, …, g−1}. A list for Z_n covers the differences 1, …, N of each orbit and
// −N, …, N of each two of them once, N = (n−1)/2, as integers. A point (t, i) that passes while A
// is there covers t−h+1, …, t within orbit i and, with each other orbit, as many differences at
// one end: so the points (N+h, 0), …, (N+h, g−1) make of it a list for Z_{n+2h}.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "construct/entries/families/cyclic/orbit_family.hpp"
#include "construct/entry.hpp"
#include "construct/tools/cyclic.hpp"
#include "construct/tools/stretched_lists.hpp"

namespace changeover::stretched_orbits_entry {
namespace {

// A list, stretched to Z_n: the points that pass while A is there, then the blocks of the list.
class Stretched {
 public:
  Stretched(const StretchedList& list, std::uint64_t n)
      : list_(&list), n_(n), passing_((n - list.n) / (2 * list.h) * list.g) {}

  [[nodiscard]] std::uint64_t n() const { return n_; }
  [[nodiscard]] const StretchedList& list() const { return *list_; }
  [[nodiscard]] std::uint64_t passing() const { return passing_; }
  [[nodiscard]] std::uint64_t base_blocks() const { return passing_ + list_->blocks.size(); }
  [[nodiscard]] std::uint64_t blocks() const { return n_ * base_blocks(); }

  void write(std::uint64_t number, std::span<Element> block) const {
    const std::uint64_t power = number / base_blocks();
    const std::uint64_t which = number % base_blocks();
    if (which >= passing_) {
      std::ranges::transform(list_->blocks[static_cast<std::size_t>(which - passing_)],
                             block.begin(),
                             [&](const OrbitPoint& point) { return element(point, power); });
      return;
    }
    hold(power, block);
    const std::uint64_t farthest = (list_->n - 1) / 2 + list_->h * (1 + which / list_->g);
    block.back() = element({static_cast<std::int64_t>(farthest), which % list_->g}, power);
  }

  // A + power, the first elements of `block`, in ascending order for h = 1.
  void hold(std::uint64_t power, std::span<Element> block) const {
    std::size_t filled = 0;
    for (std::uint64_t orbit = 0; orbit < list_->g; ++orbit) {
      for (std::uint64_t i = 0; i < list_->h; ++i) {
        block[filled++] = element({static_cast<std::int64_t>(i), orbit}, power);
      }
    }
  }

 private:
  [[nodiscard]] Element element(const OrbitPoint& point, std::uint64_t power) const {
    const auto n = static_cast<std::int64_t>(n_);
    const std::int64_t residue = (point.residue + static_cast<std::int64_t>(power)) % n;
    return static_cast<Element>(point.orbit * n_ +
                                static_cast<std::uint64_t>(residue < 0 ? residue + n : residue));
  }

  const StretchedList* list_;
  std::uint64_t n_;
  std::uint64_t passing_;
};

std::optional<Stretched> stretched_to(const Parameters& p) {
  if (!asks_for_pairs(p, 1) || p.kind != Kind::circular) {
    return std::nullopt;
  }
  for (const StretchedList& list : stretched_lists()) {
    const std::uint64_t n = p.v / list.g;
    if (list.k() == p.k && n * list.g == p.v && n >= list.n && (n - list.n) % (2 * list.h) == 0) {
      return Stretched(list, n);
    }
  }
  return std::nullopt;
}

// The translates of A, each once, partition the elements.
bool has_expansion_set(const Stretched& blocks, std::uint64_t v) {
  return blocks.list().h == 1 && v <= max_elements_of_interval_expansion;
}

constexpr Description description{
    .name = "stretched-orbits",
    .summary = "base blocks over g orbits of Z_n that were found for one n, stretched to others",
    .preconditions =
        "circular, m = 1, k = gh+1 with a list of this g and h; v = gn, n as in the "
        "list or 2h, 4h, ... more",
    .guarantee = "a tight circular SCCD(gn,k), with an expansion set if h = 1 and v <= 2^20",
    .place = "docs/theorems.md, Theorem 30",
};

class StretchedOrbits final : public Described<Family, description> {
 public:
  std::optional<std::vector<UnchangedSubset>> expansion_set(const Recipe& recipe,
                                                            const Registry&) const override {
    const Stretched blocks = *stretched_to(required(recipe));
    if (!has_expansion_set(blocks, recipe.parameters.v)) {
      return std::nullopt;
    }
    std::vector<UnchangedSubset> set;
    for (std::uint64_t power = 1; power <= blocks.n(); ++power) {
      Block kept(static_cast<std::size_t>(recipe.parameters.k - 1));
      blocks.hold(power % blocks.n(), kept);
      set.push_back({static_cast<std::size_t>(power * blocks.base_blocks()), std::move(kept)});
    }
    return set;
  }

  std::optional<OrbitBaseBlocks> orbit_base_blocks(const Recipe& recipe) const override {
    const Parameters& p = required(recipe);
    const Stretched blocks = *stretched_to(p);
    return written_base_blocks(p, blocks, {blocks.n(), blocks.list().g, 0});
  }

 protected:
  std::optional<Promise> promise(const Parameters& p) const override {
    const auto blocks = stretched_to(p);
    return blocks ? std::optional(
                        Promise{blocks->blocks(), true, true, has_expansion_set(*blocks, p.v)})
                  : std::nullopt;
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    const Stretched blocks = *stretched_to(p);
    return numbered(p, blocks.blocks(), [blocks](std::uint64_t number, std::span<Element> block) {
      blocks.write(number, block);
    });
  }

  std::string explanation(const Parameters& p) const override {
    const Stretched blocks = *stretched_to(p);
    const StretchedList& list = blocks.list();
    std::string text = fmt::format(
        "Develop {} base blocks over {} orbits of Z_{}: the {} that were found for Z_{}",
        blocks.base_blocks(), list.g, blocks.n(), list.blocks.size(), list.n);
    if (blocks.passing() > 0) {
      text += fmt::format(", and {} in which {{{}}} of each orbit {} kept and {} of each orbit {}",
                          blocks.passing(), first_elements(list.h), list.h == 1 ? "is" : "are",
                          passing_residues(blocks), blocks.passing() == list.g ? "passes" : "pass");
    }
    return text + '.';
  }

 private:
  static std::string passing_residues(const Stretched& blocks) {
    const std::uint64_t h = blocks.list().h;
    const std::uint64_t first = (blocks.list().n - 1) / 2 + h;
    const std::uint64_t last = (blocks.n() - 1) / 2;
    if (last == first) {
      return fmt::format("the residue {}", first);
    }
    return h == 1 ? fmt::format("the residues {} to {}", first, last)
                  : fmt::format("the residues {}, {}, … up to {}", first, first + h, last);
  }
};

}  // namespace

const Construction& construction() { return only<StretchedOrbits>(); }

}  // namespace changeover::stretched_orbits_entry
