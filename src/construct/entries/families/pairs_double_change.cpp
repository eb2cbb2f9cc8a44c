// The minimum DCCD(v,2): the edges of K_v in an order in which consecutive edges are disjoint.
//
// Even v = 2n ≥ 6: the 1-factors {i,∞}, {i−j,i+j}, 1 ≤ j < n, over Z_{v−1}, i = 0, …, v−2. Factor i
// goes from j = n−1 down to 1 and ends with {i,∞}; factor i+1 begins with {i+1−(n−1), i+1+(n−1)} =
// {i+n+1, i+n}, which holds i only if n ≤ 2.
// Odd v = 2n+1 ≥ 7: the near-1-factors {i−j,i+j}, 1 ≤ j ≤ n, over Z_v. Near-1-factor i begins with
// j = 1 and ends with j = 3: {i−3,i+3} and {i,i+2} have an element in common only if v = 3 or 5.
// Both are developed from factor 0, so that the list is circular. For v = 5 it is a Hamiltonian
// path of the Petersen graph, which has no Hamiltonian cycle: a circular DCCD(5,2) needs an 11th
// block.
#include <fmt/format.h>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"
#include "construct/tools/short_blocks.hpp"

namespace changeover::pairs_double_change_entry {
namespace {

constexpr std::string_view path_of_5 = "01 23 04 12 34 02 13 24 03 14";
constexpr std::string_view walk_of_5 = "01 23 01 24 03 14 02 13 04 12 34";

bool needs_one_more(const Parameters& p) { return p.v == 5 && p.kind == Kind::circular; }

// v ≥ 6.
std::unique_ptr<BlockSource> factors(const Parameters& p) {
  const bool even = p.v % 2 == 0;
  const std::uint64_t n = p.v / 2;
  const std::uint64_t modulus = even ? p.v - 1 : p.v;
  return numbered(p, modulus * n, [=](std::uint64_t number, std::span<Element> block) {
    const std::uint64_t factor = number / n;
    const std::uint64_t edge = number % n;
    // In a near-1-factor 1, 2, 4, 5, …, n, 3.
    const std::uint64_t j = even            ? n - 1 - edge
                            : edge + 1 == n ? 3
                            : edge < 2      ? edge + 1
                                            : edge + 2;
    block[0] = static_cast<Element>((factor + modulus - j) % modulus);
    block[1] = static_cast<Element>(j == 0 ? modulus : (factor + j) % modulus);
  });
}

constexpr Description description{
    .name = "pairs-double-change",
    .summary = "the edges of a complete graph, 1-factor after 1-factor, consecutive edges disjoint",
    .preconditions = "m = 2, k = 2, v >= 5",
    .guarantee =
        "a minimum DCCD(v,2): v(v-1)/2 blocks and tight, but 11 blocks if circular and v = 5",
    .cited = "Lindbloom2011",
};

class PairsDoubleChange final : public Described<Family, description> {
  std::optional<Promise> promise(const Parameters& p) const override {
    if (!asks_for_pairs(p, 2) || p.k != 2 || p.v < 5) {
      return std::nullopt;
    }
    const bool tight = !needs_one_more(p);
    return Promise{p.v * (p.v - 1) / 2 + (tight ? 0 : 1), tight, tight};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    if (p.v == 5) {
      const std::string_view list = p.kind == Kind::circular ? walk_of_5 : path_of_5;
      return std::make_unique<BlockListSource>(p, short_blocks(list));
    }
    return factors(p);
  }

  std::string explanation(const Parameters& p) const override {
    if (p.v == 5) {
      return p.kind == Kind::circular
                 ? "A closed walk of length 11 through the Petersen graph, whose vertices are the "
                   "pairs."
                 : "A Hamiltonian path of the Petersen graph, whose vertices are the pairs.";
    }
    if (p.v % 2 == 0) {
      return fmt::format(
          "For i = 0,…,{0}, the edges {{i-j,i+j}} over Z_{1}, j = {2},…,1, and {{i,{1}}}.", p.v - 2,
          p.v - 1, p.v / 2 - 1);
    }
    return fmt::format("For i = 0,…,{}, the edges {{i-j,i+j}} over Z_{}, j = 1,…,{} with 3 last.",
                       p.v - 1, p.v, p.v / 2);
  }
};

}  // namespace

const Construction& construction() { return only<PairsDoubleChange>(); }

}  // namespace changeover::pairs_double_change_entry
