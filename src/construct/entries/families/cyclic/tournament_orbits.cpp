// Tight circular DCCD((2k−3)n, k), n odd, developed over 2k−3 orbits of Z_n from a list that was
// found once for all n [docs/theorems.md, Theorem 32, without its fixed point].
//
// A regular tournament on the orbits: each beats k−2 others. While a point of each of those is
// kept, the pairs centre ± x of the orbit pass, x large. They cover the differences ±2x within the
// orbit and ± x to each that it beats. The list covers what is left: some small differences.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "construct/entries/families/cyclic/orbit_family.hpp"
#include "construct/entry.hpp"
#include "construct/tools/cyclic.hpp"
#include "construct/tools/tournament_lists.hpp"

namespace changeover::tournament_orbits_entry {
namespace {

class Tournament {
 public:
  Tournament(const TournamentList& list, std::uint64_t n)
      : list_(&list), n_(n), unit_(inverse(list.shift, n)) {
    const std::uint64_t farthest = (n - 1) / 2;
    for (std::uint64_t i = 0; i < list.blocks.size(); ++i) {
      for (const Passage& passage : list.passages) {
        if (passage.before == i) {
          parts_.push_back(
              {farthest + 1 - static_cast<std::uint64_t>(passage.from), kept_before(i), &passage});
        }
      }
      parts_.push_back({1, list.blocks[i], nullptr});
    }
    for (const Part& part : parts_) {
      base_blocks_ += part.count;
    }
  }

  [[nodiscard]] std::uint64_t n() const { return n_; }
  [[nodiscard]] const TournamentList& list() const { return *list_; }
  [[nodiscard]] std::uint64_t base_blocks() const { return base_blocks_; }
  [[nodiscard]] std::uint64_t blocks() const { return n_ * base_blocks_; }

  void write(std::uint64_t number, std::span<Element> block) const {
    const std::uint64_t power = number / base_blocks_;
    std::uint64_t which = number % base_blocks_;
    auto part = parts_.begin();
    for (; which >= part->count; ++part) {
      which -= part->count;
    }
    const auto rest =
        std::ranges::transform(part->points, block.begin(), [&](const OrbitPoint& point) {
          return element(point, power);
        }).out;
    if (part->passage != nullptr) {
      const auto& [orbit, before, centre, from] = *part->passage;
      const std::int64_t x = from + static_cast<std::int64_t>(which);
      *rest = element({centre + x, orbit}, power);
      *std::next(rest) = element({centre - x, orbit}, power);
    }
  }

 private:
  // Blocks of the list: one that is in it, or those of a passage, which hold `points` and two more.
  struct Part {
    std::uint64_t count;
    OrbitBlock points;
    const Passage* passage;
  };

  // What block number i of the list has in common with the one before it.
  [[nodiscard]] OrbitBlock kept_before(std::uint64_t i) const {
    const auto& blocks = list_->blocks;
    OrbitBlock before = i == 0 ? blocks.back() : blocks[i - 1];
    for (OrbitPoint& point : before) {
      point.residue -= i == 0 ? list_->shift : 0;
    }
    OrbitBlock kept;
    std::ranges::copy_if(blocks[i], std::back_inserter(kept), [&](const OrbitPoint& point) {
      return std::ranges::find(before, point) != before.end();
    });
    return kept;
  }

  // The inverse of ± a power of 2 modulo an odd n.
  static std::uint64_t inverse(std::int64_t shift, std::uint64_t n) {
    std::uint64_t result = 1;
    for (std::int64_t left = shift < 0 ? -shift : shift; left > 1; left /= 2) {
      result = result % 2 == 0 ? result / 2 : (result + n) / 2;
    }
    return shift < 0 ? n - result : result;
  }

  // Residues are multiplied by the inverse of the shift, so that a round later they are 1 more.
  [[nodiscard]] Element element(const OrbitPoint& point, std::uint64_t power) const {
    const auto n = static_cast<std::int64_t>(n_);
    const std::int64_t residue = (point.residue % n + n) % n;
    return static_cast<Element>(point.orbit * n_ +
                                (static_cast<std::uint64_t>(residue) * unit_ + power) % n_);
  }

  const TournamentList* list_;
  std::uint64_t n_;
  std::uint64_t unit_;
  std::vector<Part> parts_;
  std::uint64_t base_blocks_ = 0;
};

std::optional<Tournament> tournament(const Parameters& p) {
  if (!asks_for_pairs(p, 2) || p.kind != Kind::circular) {
    return std::nullopt;
  }
  for (const TournamentList& list : tournament_lists()) {
    if (list.k == p.k && p.v % list.orbits() == 0) {
      const std::uint64_t n = p.v / list.orbits();
      if (n % 2 == 1 && n >= list.least) {
        return Tournament(list, n);
      }
    }
  }
  return std::nullopt;
}

constexpr Description description{
    .name = "tournament-orbits",
    .summary = "base blocks over 2k-3 orbits of Z_n: a list, and opposite points that pass",
    .preconditions = "circular, m = 2, k = 4, v = 10c+5 with c >= 2",
    .guarantee = "a tight circular DCCD(v,4)",
    .place = "docs/theorems.md, Theorem 32",
};

class TournamentOrbits final : public Described<Family, description> {
 public:
  std::optional<OrbitBaseBlocks> orbit_base_blocks(const Recipe& recipe) const override {
    const Parameters& p = required(recipe);
    const Tournament blocks = *tournament(p);
    return written_base_blocks(p, blocks, {blocks.n(), blocks.list().orbits(), 0});
  }

 protected:
  std::optional<Promise> promise(const Parameters& p) const override {
    const auto blocks = tournament(p);
    return blocks ? std::optional(Promise{blocks->blocks(), true, true, false}) : std::nullopt;
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    const Tournament blocks = *tournament(p);
    return numbered(p, blocks.blocks(), [blocks](std::uint64_t number, std::span<Element> block) {
      blocks.write(number, block);
    });
  }

  std::string explanation(const Parameters& p) const override {
    const Tournament blocks = *tournament(p);
    const TournamentList& list = blocks.list();
    return fmt::format(
        "Develop {} base blocks over {} orbits of Z_{}: {} that were found once for all n, and "
        "{} in which two opposite points of one orbit pass.",
        blocks.base_blocks(), list.orbits(), blocks.n(), list.blocks.size(),
        blocks.base_blocks() - list.blocks.size());
  }
};

}  // namespace

const Construction& construction() { return only<TournamentOrbits>(); }

}  // namespace changeover::tournament_orbits_entry
