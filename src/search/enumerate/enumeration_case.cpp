#include "search/enumerate/enumeration_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "changeover/search/enumeration.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

void check_supported(const Parameters& p, std::uint64_t b) {
  check(p);
  if (p.strength != 2) {
    throw ImpossibleParameters("enumeration supports strength 2 only; give strength 2");
  }
  if (p.v > max_enumeration_elements) {
    throw ImpossibleParameters(
        fmt::format("enumeration supports at most {} elements, not {}; give fewer",
                    max_enumeration_elements, p.v));
  }
  if (b > max_enumeration_blocks) {
    throw ImpossibleParameters(fmt::format(
        "enumeration supports at most {} blocks, not {}; give fewer", max_enumeration_blocks, b));
  }
}

// Covered pairs, counted with repetition, less the number of pairs.
std::int64_t excess(const Parameters& p, std::uint64_t b) {
  const std::uint64_t each = newly_covered_at_most(p);
  const std::uint64_t covered =
      p.kind == Kind::circular ? b * each : binomial(p.k, 2) + (b - 1) * each;
  return static_cast<std::int64_t>(covered) - static_cast<std::int64_t>(binomial(p.v, 2));
}

}  // namespace

std::vector<EnumerationCase> enumeration_cases(const Parameters& p, std::uint64_t b,
                                               bool one_rotation) {
  check_supported(p, b);
  std::vector<EnumerationCase> cases;
  const bool circular = p.kind == Kind::circular;
  // With two blocks, an element that left and one that was introduced never meet.
  if (b < 3 || p.v < p.k + p.change) {
    return cases;
  }
  // With at most one fixed element every pair is newly covered. If f ≥ 2 are removed, the others
  // form a design without fixed elements.
  const std::uint64_t most_fixed =
      circular ? p.k - std::min(p.k, std::max<std::uint64_t>(p.change, 2)) : 0;
  for (std::uint64_t f = 0; f <= most_fixed; f = f == 0 ? 2 : f + 1) {
    Parameters rest = p.on(p.v - f);
    rest.k -= f;
    const EnumerationCase base{.v = rest.v,
                               .k = rest.k,
                               .change = rest.change,
                               .b = b,
                               .circular = circular,
                               .excess = excess(rest, b),
                               .fixed = f,
                               .longest_run = 0};
    if (base.excess < 0) {
      continue;
    }
    if (!circular || !one_rotation) {
      cases.push_back(base);
      continue;
    }
    // Runs of limited length take at least (k−1)·b of the places, and m·b of them begin.
    for (std::size_t run = ceil_div(rest.k - 1, rest.change); run < b; ++run) {
      cases.push_back(base);
      cases.back().longest_run = run;
    }
  }
  return cases;
}

namespace {

constexpr std::int64_t prices = 4;
constexpr std::int64_t most_cost = 511;  // stands for "impossible" too
constexpr unsigned lane_bits = 16;

std::int64_t lane(std::uint64_t word, std::int64_t price) {
  return static_cast<std::int64_t>((word >> (lane_bits * static_cast<unsigned>(price))) & 0xffffU);
}

std::uint64_t in_lane(std::int64_t value, std::int64_t price) {
  return static_cast<std::uint64_t>(value) << (lane_bits * static_cast<unsigned>(price));
}

}  // namespace

DegreeTable::DegreeTable(const EnumerationCase& own) : change_(own.change), rows_(own.b) {
  const auto stay = static_cast<std::int64_t>(own.change);
  const auto introduction = static_cast<std::int64_t>(own.k) - 1;
  constexpr std::array roles{EndRole::anywhere, EndRole::in, EndRole::out};
  for (std::size_t left = 0; left < own.b; ++left) {
    for (const EndRole role : roles) {
      for (const bool in : {false, true}) {
        for (std::int64_t missing = 0; missing < 64; ++missing) {
          std::uint64_t word = 0;
          for (std::int64_t price = 0; price < prices; ++price) {
            std::int64_t cost = most_cost;
            if (left == 0) {
              const bool allowed = role == EndRole::anywhere || (role == EndRole::in) == in;
              cost = allowed && missing == 0 ? 0 : most_cost;
            } else {
              const auto after = [&](bool next_in, std::int64_t covers) {
                const auto still =
                    static_cast<std::size_t>(std::max<std::int64_t>(missing - covers, 0));
                return lane(rows_[left - 1][offset(role, next_in) + still], price) +
                       std::max<std::int64_t>(covers - missing, 0);
              };
              const std::int64_t next_in =
                  in ? after(true, stay) : after(true, introduction) + price;
              cost = std::min({most_cost, next_in, after(false, 0)});
            }
            word |= in_lane(cost, price);
          }
          rows_[left][offset(role, in) + static_cast<std::size_t>(missing)] = word;
        }
      }
    }
  }
}

std::uint64_t DegreeTable::allowance(std::int64_t excess, std::size_t blocks_left) const {
  constexpr std::int64_t top = 0x7fff;
  const auto introductions = static_cast<std::int64_t>(change_ * blocks_left);
  std::uint64_t word = 0;
  for (std::int64_t price = 0; price < prices; ++price) {
    word |= in_lane(std::min(top, 2 * excess + price * introductions), price);
  }
  return word;
}

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
