// The minimum 3-change (v,3), consecutive triples disjoint: the triples of triples-double-change in
// another order [docs/theorems.md, Theorem 19].
//
// The order is made as in Palmer's proof of Dirac's theorem [Palmer1997]: as long as consecutive
// triples a, b meet, take others c, d, one after the other, such that a and c, b and d are
// disjoint, and turn the list round from b to c. If each triple is disjoint from half of all or
// more, there are such c and d: so it is for v ≥ 20. Below, a turn that leads nowhere is taken now
// and then. Mostly two triples can be exchanged instead, which is faster.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"
#include "core/checked.hpp"
#include "run/random.hpp"

namespace changeover {

namespace triples_double_change_entry {
const Construction& construction();
}

namespace triples_triple_change_entry {
namespace {

constexpr std::uint64_t least_v = 10;      // below, a minimum covering has no such order
constexpr std::uint64_t largest_v = 2000;  // 0.7 million triples, which are held

using Triple = std::array<Element, 3>;

bool are_disjoint(const Triple& one, const Triple& other) {
  return std::ranges::none_of(
      one, [&](Element x) { return x == other[0] || x == other[1] || x == other[2]; });
}

class DisjointOrder {
 public:
  explicit DisjointOrder(std::vector<Triple> triples) : triples_(std::move(triples)) {
    for (std::size_t i = size(); i > 1; --i) {
      std::swap(triples_[i - 1], triples_[below(i)]);
    }
  }

  std::vector<Triple> run() {
    for (std::size_t i = 0, good = 0; good < size(); i = next(i)) {
      if (fits(i)) {
        ++good;
      } else {
        mend(i);
        good = 0;
      }
    }
    return std::move(triples_);
  }

 private:
  [[nodiscard]] std::size_t size() const { return triples_.size(); }
  [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  [[nodiscard]] std::size_t before(std::size_t i) const { return i == 0 ? size() - 1 : i - 1; }
  std::size_t below(std::size_t limit) { return random_.below(static_cast<std::uint32_t>(limit)); }
  [[nodiscard]] bool apart(std::size_t i, std::size_t j) const {
    return are_disjoint(triples_[i], triples_[j]);
  }
  [[nodiscard]] bool fits(std::size_t i) const { return apart(i, next(i)); }

  // The triple at i meets the one after it.
  void mend(std::size_t i) {
    constexpr int tries = 64;
    const std::size_t b = next(i);
    for (int attempt = 0; attempt < tries; ++attempt) {
      const std::size_t j = below(size());
      if (j == b || next(j) == b || next(b) == j) {
        continue;
      }
      std::swap(triples_[b], triples_[j]);
      if (fits(i) && fits(b) && fits(before(j)) && fits(j)) {
        return;
      }
      std::swap(triples_[b], triples_[j]);
    }
    for (std::size_t j = next(b); next(j) != i; j = next(j)) {
      if (apart(i, j) && apart(b, next(j))) {
        turn(b, j);
        return;
      }
    }
    turn(b, below(size()));
  }

  // From the one place on to the other, over the end of the list if need be.
  void turn(std::size_t from, std::size_t to) {
    const std::size_t length = (to + size() - from) % size() + 1;
    for (std::size_t i = 0; i < length / 2; ++i, from = next(from), to = before(to)) {
      std::swap(triples_[from], triples_[to]);
    }
  }

  std::vector<Triple> triples_;
  Random random_{1};
};

constexpr Description description{
    .name = "triples-triple-change",
    .summary = "a minimum covering by triples, ordered so that consecutive ones are disjoint",
    .preconditions = "m = 3, k = 3, 10 <= v <= 2000",
    .guarantee = "minimum, circular too; tight if v = 1, 3 mod 6 (Steiner triple systems)",
    .place = "docs/theorems.md, Theorem 19",
};

class TriplesTripleChange final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    if (!asks_for_pairs(p, 3) || p.k != 3 || p.v < least_v || p.v > largest_v) {
      return std::nullopt;
    }
    const std::uint64_t b = ceil_div(p.v * (p.v / 2), 3);
    const bool tight = p.v % 6 == 1 || p.v % 6 == 3;
    return Promise{b, tight, b == ceil_div(p.v * (p.v - 1) / 2, 3)};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    const std::unique_ptr<BlockSource> source = triples_double_change_entry::construction().build(
        {"triples-double-change", {p.v, 3, 2, Kind::circular}, {}, {}, {}}, Registry({}));
    std::vector<Triple> triples;
    for (Triple triple{}; source->next(triple);) {
      triples.push_back(triple);
    }
    std::vector<Block> list;
    for (const Triple& triple : DisjointOrder(std::move(triples)).run()) {
      list.emplace_back(triple.begin(), triple.end());
    }
    return std::make_unique<BlockListSource>(p, std::move(list));
  }

  std::string explanation(const Parameters& p) const override {
    return fmt::format(
        "Take the triples of the minimum circular DCCD({},3), and put them in an order in which "
        "consecutive ones are disjoint, as in a proof of Dirac's theorem on Hamilton cycles.",
        p.v);
  }
};

}  // namespace

const Construction& construction() { return only<TriplesTripleChange>(); }

}  // namespace triples_triple_change_entry
}  // namespace changeover
