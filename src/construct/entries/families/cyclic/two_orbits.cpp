// Tight circular DCCD((2k−3)(4j+1)+1, k) for every even k and j ≥ 2, developed over two orbits of
// Z_n [docs/theorems.md, Theorem 31].
//
// With h = (k−2)/2, P = 4h+1 and n = 2jP+2h+1 all base blocks hold A = {0, …, h−1} of both orbits.
// The one with the points h of both leads on to A + 1. The others hold two *places* each: points H
// iP+h or B iP+2h of an orbit. The pairs of places are such that the differences of their indices i
// are 1, …, j within each orbit and ±1, …, ±j between the two, each once.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "construct/entries/families/cyclic/orbit_family.hpp"
#include "construct/entry.hpp"
#include "construct/tools/cyclic.hpp"

namespace changeover::two_orbits_entry {
namespace {

enum class Row : std::uint8_t { h, b };
enum class Orbits : std::uint8_t { first, second, both };

// Pairs of places of one row: (first + i·step, second + i·other_step) for 0 ≤ i < count. With
// Orbits::both the second place is in the other orbit.
struct Run {
  Row row;
  Orbits orbits;
  std::int64_t count;
  std::int64_t first;
  std::int64_t step;
  std::int64_t second;
  std::int64_t other_step;
};

class Pairing {
 public:
  explicit Pairing(std::int64_t j) {
    if (j % 2 == 0) {
      even(j);
    } else {
      odd(j);
    }
  }

  [[nodiscard]] const std::vector<Run>& runs() const { return runs_; }

 private:
  void add(const Run& run) {
    if (run.count > 0) {
      runs_.push_back(run);
    }
  }

  // `count` pairs, one inside the other, the outermost first.
  void nested(Row row, Orbits orbits, std::int64_t count, std::int64_t first, std::int64_t second) {
    add({row, orbits, count, first, 1, second, -1});
  }
  void nested_in_each(Row row, std::int64_t count, std::int64_t first, std::int64_t second) {
    nested(row, Orbits::first, count, first, second);
    nested(row, Orbits::second, count, first, second);
  }

  // Differences of one parity in each row.
  void even(std::int64_t j) {
    nested_in_each(Row::h, j / 2, 1, j);
    nested_in_each(Row::b, j / 2, -j, 0);
    nested(Row::h, Orbits::both, j, -j, -1);
    nested(Row::b, Orbits::both, j / 2 - 1, 1, j - 1);
    nested(Row::b, Orbits::both, j / 2 - 1, j / 2 + 1, j / 2 - 1);
    nested(Row::b, Orbits::both, 1, -j / 2, j / 2);
    nested(Row::b, Orbits::both, 1, j / 2, -j / 2);
  }

  // H within the orbits, B between them.
  void odd(std::int64_t j) {
    const std::int64_t s = j / 4;
    if (j % 4 == 3) {
      nested_in_each(Row::h, 1, -(2 * s + 2), 2 * s + 1);
      nested_in_each(Row::h, s, 2, 4 * s + 3);
      nested_in_each(Row::h, std::min<std::int64_t>(s, 1), 1, 2 * s + 2);
      nested_in_each(Row::h, s - 1, s + 2, 3 * s + 1);
      nested_in_each(Row::h, 1, 3 * s + 2, 3 * s + 3);
      nested_in_each(Row::h, 2 * s + 1, -j, -1);
      doubled(j, j, 1, 2);
      doubled(j, j, j + 1, 1);
      return;
    }
    if (s == 1) {
      nested_in_each(Row::h, 1, 1, 6);
      nested_in_each(Row::h, 2, -5, -2);
      nested_in_each(Row::h, 1, -1, 3);
      nested_in_each(Row::h, 1, 2, 4);
    } else {
      nested_in_each(Row::h, 1, -(2 * s + 1), 2 * s);
      nested_in_each(Row::h, s - 2, 1, 4 * s);
      nested_in_each(Row::h, 1, 2 * s - 1, 4 * s + 2);
      nested_in_each(Row::h, s, s - 1, 3 * s);
      nested_in_each(Row::h, 1, 3 * s + 1, 3 * s + 2);
      nested_in_each(Row::h, 2 * s, -j, -1);
    }
    doubled(j, 2 * s, 1, 2);
    doubled(j, 1, 2 * s + 1, 1);
    doubled(j, 2 * s + 1, 2 * s + 2, 4 * s + 3);
    doubled(j, 2 * s, 4 * s + 3, 3);
    doubled(j, 2 * s - 1, 6 * s + 3, 4 * s + 4);
    doubled(j, 1, 2 * j + 1, 4 * s + 2);
  }

  // Indices of B counted from 1: from, from+1, … of one orbit with to, to+2, … of the other.
  void doubled(std::int64_t j, std::int64_t count, std::int64_t from, std::int64_t to) {
    add({Row::b, Orbits::both, count, from - j - 1, 1, to - j - 1, 2});
  }

  std::vector<Run> runs_;
};

class TwoOrbits {
 public:
  TwoOrbits(std::uint64_t h, std::uint64_t j)
      : h_(h),
        j_(j),
        n_(2 * j * (4 * h + 1) + 2 * h + 1),
        runs_(Pairing(static_cast<std::int64_t>(j)).runs()) {}

  [[nodiscard]] std::uint64_t n() const { return n_; }
  [[nodiscard]] std::uint64_t h() const { return h_; }
  [[nodiscard]] std::uint64_t j() const { return j_; }
  [[nodiscard]] std::uint64_t base_blocks() const { return 4 * j_ + 1; }
  [[nodiscard]] std::uint64_t blocks() const { return n_ * base_blocks(); }

  void write(std::uint64_t number, std::span<Element> block) const {
    const std::uint64_t power = number / base_blocks();
    std::uint64_t which = number % base_blocks();
    hold(power, block);
    Element& one = block[2 * h_];
    Element& other = block[2 * h_ + 1];
    for (const Run& run : runs_) {
      if (which < static_cast<std::uint64_t>(run.count)) {
        const auto i = static_cast<std::int64_t>(which);
        one = element(place(run.row, run.first + i * run.step),
                      run.orbits == Orbits::second ? 1 : 0, power);
        other = element(place(run.row, run.second + i * run.other_step),
                        run.orbits == Orbits::first ? 0 : 1, power);
        return;
      }
      which -= static_cast<std::uint64_t>(run.count);
    }
    one = element(static_cast<std::int64_t>(h_), 0, power);
    other = element(static_cast<std::int64_t>(h_), 1, power);
  }

  // A + power, the first elements of `block`.
  void hold(std::uint64_t power, std::span<Element> block) const {
    for (std::uint64_t i = 0; i < 2 * h_; ++i) {
      block[i] = element(static_cast<std::int64_t>(i % h_), i / h_, power);
    }
  }

 private:
  [[nodiscard]] std::int64_t place(Row row, std::int64_t index) const {
    const auto h = static_cast<std::int64_t>(h_);
    return index * (4 * h + 1) + (row == Row::h ? h : 2 * h);
  }

  [[nodiscard]] Element element(std::int64_t residue, std::uint64_t orbit,
                                std::uint64_t power) const {
    const auto n = static_cast<std::int64_t>(n_);
    const std::int64_t moved = (residue + static_cast<std::int64_t>(power)) % n;
    return static_cast<Element>(orbit * n_ +
                                static_cast<std::uint64_t>(moved < 0 ? moved + n : moved));
  }

  std::uint64_t h_;
  std::uint64_t j_;
  std::uint64_t n_;
  std::vector<Run> runs_;
};

std::optional<TwoOrbits> two_orbits(const Parameters& p) {
  if (!asks_for_pairs(p, 2) || p.kind != Kind::circular || p.k % 2 != 0 || p.k < 4) {
    return std::nullopt;
  }
  const std::uint64_t new_pairs = 2 * p.k - 3;
  const std::uint64_t rounds = (p.v - 1) / new_pairs;
  constexpr std::uint64_t fewest = 9;  // j = 2
  if ((p.v - 1) % new_pairs != 0 || rounds % 4 != 1 || rounds < fewest) {
    return std::nullopt;
  }
  return TwoOrbits(p.k / 2 - 1, rounds / 4);
}

// A + h, A + 2h, … partition the elements.
bool has_expansion_set(const TwoOrbits& blocks) {
  return blocks.n() % blocks.h() == 0 && 2 * blocks.n() <= max_elements_of_interval_expansion;
}

constexpr Description description{
    .name = "two-orbits",
    .summary = "base blocks over two orbits of Z_n that all hold the same k-2 elements",
    .preconditions = "circular, m = 2, k even, v = (2k-3)(4j+1)+1 with j >= 2",
    .guarantee =
        "a tight circular DCCD(v,k), with an expansion set if (k-2)/2 divides 2j+1 and v <= 2^20",
    .place = "docs/theorems.md, Theorem 31",
};

class TwoOrbitsEntry final : public Described<Family, description> {
 public:
  std::optional<std::vector<UnchangedSubset>> expansion_set(const Recipe& recipe,
                                                            const Registry&) const override {
    const TwoOrbits blocks = *two_orbits(required(recipe));
    if (!has_expansion_set(blocks)) {
      return std::nullopt;
    }
    std::vector<UnchangedSubset> set;
    for (std::uint64_t power = blocks.h(); power <= blocks.n(); power += blocks.h()) {
      Block kept(static_cast<std::size_t>(recipe.parameters.k - 2));
      blocks.hold(power % blocks.n(), kept);
      std::ranges::sort(kept);
      set.push_back({static_cast<std::size_t>(power * blocks.base_blocks()), std::move(kept)});
    }
    return set;
  }

  std::optional<OrbitBaseBlocks> orbit_base_blocks(const Recipe& recipe) const override {
    const Parameters& p = required(recipe);
    const TwoOrbits blocks = *two_orbits(p);
    return written_base_blocks(p, blocks, {blocks.n(), 2, 0});
  }

 protected:
  std::optional<Promise> promise(const Parameters& p) const override {
    const auto blocks = two_orbits(p);
    return blocks ? std::optional(Promise{blocks->blocks(), true, true, has_expansion_set(*blocks)})
                  : std::nullopt;
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    const TwoOrbits blocks = *two_orbits(p);
    return numbered(p, blocks.blocks(), [blocks](std::uint64_t number, std::span<Element> block) {
      blocks.write(number, block);
    });
  }

  std::string explanation(const Parameters& p) const override {
    const TwoOrbits blocks = *two_orbits(p);
    return fmt::format(
        "Develop {} base blocks over two orbits of Z_{}. Each holds {{{}}} of both orbits and two "
        "more elements, the last block the residue {} of both.",
        blocks.base_blocks(), blocks.n(), first_elements(blocks.h()), blocks.h());
  }
};

}  // namespace

const Construction& construction() { return only<TwoOrbitsEntry>(); }

}  // namespace changeover::two_orbits_entry
