#include "search/enumerate/enumeration_reach.hpp"

#include <array>

#include "search/enumerate/masks.hpp"

namespace changeover {
namespace {

Mask above(std::size_t x) { return ~Mask{0} << x << 1; }

constexpr int most_steps = 2000;

class Reach {
 public:
  Reach(const EnumerationCase& own, const Position& position)
      : own_(own), excess_(position.excess) {
    for (std::size_t x = 0; x < own.v; ++x) {
      alive_[x] = position.missing[x];
      if ((position.block & bit(x)) != 0) {
        alive_[x] |= position.block & ~bit(x);
      }
    }
  }

  // Whether the set can grow by `more` elements, from `from` on, with at most `budget` dead pairs.
  bool grows(Mask set, Mask from, std::size_t more, std::int64_t budget) {
    if (budget == 0) {
      Mask common = from;
      for (Mask rest = set; rest != 0; rest &= rest - 1) {
        common &= alive_[lowest(rest)];
      }
      return clique(common, more);
    }
    if (more == 0) {
      return true;
    }
    for (Mask rest = from; rest != 0; rest &= rest - 1) {
      const std::size_t x = lowest(rest);
      const auto dead = static_cast<std::int64_t>(count(set & ~alive_[x]));
      if (++steps_ > most_steps ||
          (dead <= budget && grows(set | bit(x), rest & (rest - 1), more - 1, budget - dead))) {
        return true;
      }
    }
    return false;
  }

  bool unchanged_subset_meets() const {
    const Mask unchanged = own_.last_unchanged();
    std::size_t dead = 0;
    for (Mask rest = unchanged; rest != 0; rest &= rest - 1) {
      const std::size_t x = lowest(rest);
      dead += count(unchanged & above(x) & ~alive_[x]);
    }
    return static_cast<std::int64_t>(dead) <= excess_;
  }

 private:
  bool clique(Mask from, std::size_t size) {
    if (size <= 1) {
      return size == 0 || from != 0;
    }
    for (Mask rest = from; rest != 0; rest &= rest - 1) {
      const Mask beside = alive_[lowest(rest)] & rest & (rest - 1);
      if (size == 2 ? beside != 0 : ++steps_ > most_steps || clique(beside, size - 1)) {
        return true;
      }
    }
    return false;
  }

  const EnumerationCase& own_;
  std::int64_t excess_;
  std::array<Mask, 64> alive_{};
  int steps_ = 0;
};

}  // namespace

bool all_within_reach(const EnumerationCase& own, const Position& position) {
  Reach reach(own, position);
  if (own.circular && !reach.unchanged_subset_meets()) {
    return false;
  }
  const Mask all = own.all();
  // Start with whole blocks around each element that has to return: fewer cases, which decide most.
  for (Mask out = all & ~position.block; out != 0; out &= out - 1) {
    const std::size_t x = lowest(out);
    if (position.missing[x] != 0 &&
        !reach.grows(bit(x), all & ~bit(x), own.k - 1, position.excess)) {
      return false;
    }
  }
  for (std::size_t x = 0; x < own.v; ++x) {
    for (Mask later = position.missing[x] & above(x); later != 0; later &= later - 1) {
      const Mask pair = bit(x) | bit(lowest(later));
      if (!reach.grows(pair, all & ~pair, own.k - 2, position.excess)) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace changeover
