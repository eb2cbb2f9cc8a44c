// The tight circular DCCD(c(4k−6)+1, k, c²(4k−6)+c) for c ≤ 5: base blocks over Z_v, as printed.
//
// Every base block is A = {0, …, k−3} with two more elements, so A is what two of them have in
// common; the last one holds k−2 too, and so shares A+1 = {1, …, k−2} with the next translate of
// the first.
#include <fmt/format.h>

#include <array>
#include <numeric>
#include <span>
#include <utility>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"
#include "core/each.hpp"

namespace changeover::cyclic_paper_entry {
namespace {

// The two elements besides A, as p·n + q with n = k−2.
struct Multiple {
  std::uint64_t p, q;
};
struct Extra {
  Multiple first, second;
};

constexpr std::array<Extra, 1> table_1{{{{1, 0}, {2, 1}}}};
constexpr std::array<Extra, 2> table_2{{{{2, 0}, {5, 2}}, {{1, 0}, {3, 1}}}};
constexpr std::array<Extra, 3> table_3{{{{2, 0}, {7, 3}}, {{3, 1}, {5, 2}}, {{1, 0}, {4, 2}}}};
constexpr std::array<Extra, 4> table_4{
    {{{2, 0}, {8, 4}}, {{3, 1}, {5, 2}}, {{4, 2}, {7, 4}}, {{1, 0}, {6, 3}}}};
constexpr std::array<Extra, 5> table_5{
    {{{2, 0}, {6, 3}}, {{3, 0}, {9, 4}}, {{4, 2}, {7, 4}}, {{5, 3}, {8, 4}}, {{1, 0}, {10, 5}}}};

std::span<const Extra> extras(std::uint64_t c) {
  switch (c) {
    case 1:
      return table_1;
    case 2:
      return table_2;
    case 3:
      return table_3;
    case 4:
      return table_4;
    default:
      return table_5;
  }
}

std::uint64_t value(Multiple x, std::uint64_t n) { return x.p * n + x.q; }

// c, of parameters that are served.
std::uint64_t count(const Parameters& p) { return (p.v - 1) / (4 * p.k - 6); }

BaseBlocks base(const Parameters& p) {
  const std::uint64_t n = p.k - 2;
  BaseBlocks result{p, {}};
  for (const Extra& extra : extras(count(p))) {
    Block block(static_cast<std::size_t>(n));
    std::iota(block.begin(), block.end(), Element{0});
    block.push_back(static_cast<Element>(value(extra.first, n)));
    block.push_back(static_cast<Element>(value(extra.second, n)));
    result.blocks.push_back(std::move(block));
  }
  return result;
}

// k−2 divides v = c(4(k−2)+2)+1 exactly if it divides 2c+1.
bool has_expansion_set(const Parameters& p) { return p.v % (p.k - 2) == 0; }

constexpr Description description{
    .name = "cyclic-paper",
    .summary = "c base blocks {0,...,k-3,x,y} over Z_v, developed",
    .preconditions = "circular, m = 2, k >= 3, v = c(4k-6)+1 with 1 <= c <= 5",
    .guarantee = "a tight circular DCCD(c(4k-6)+1,k,cv), with an expansion set if k-2 divides 2c+1",
    .cited = "ChafeeStevens2025",
    .place = "Theorem 10",
};

class CyclicPaper final : public Described<Family, description> {
 public:
  // Block number jc+i+1 is B_i + j. At position p = jc+i, 1 ≤ i ≤ c−1, B_{i−1}+j and B_i+j meet in
  // A+j; at p = jc, j ≥ 1, B_{c−1}+(j−1) and B_0+j meet in A+j, and for j = v, the end, A+v = A.
  // So U_p = A + ⌊p/c⌋ for all p. With n = k−2 and v = ℓn, the intervals A+n, A+2n, …, A+ℓn
  // partition Z_v: they are U_{icn}, i = 1, …, ℓ, and the last one is at position b = cv (which is
  // U_0 in the paper).
  std::optional<std::vector<UnchangedSubset>> expansion_set(const Recipe& recipe,
                                                            const Registry&) const override {
    const Parameters& p = required(recipe);
    if (!has_expansion_set(p)) {
      return std::nullopt;
    }
    const std::uint64_t n = p.k - 2;
    std::vector<UnchangedSubset> set;
    for (std::uint64_t i = 1; i <= p.v / n; ++i) {
      Block interval(static_cast<std::size_t>(n));
      std::iota(interval.begin(), interval.end(), static_cast<Element>(i * n % p.v));
      set.push_back({static_cast<std::size_t>(i * count(p) * n), std::move(interval)});
    }
    return set;
  }

  std::optional<BaseBlocks> base_blocks(const Recipe& recipe) const override {
    return base(required(recipe));
  }

 protected:
  Recipe recipe_for(const Parameters& p) const override {
    return recipe_of(p, {{"c", static_cast<std::int64_t>(count(p))}});
  }

  std::optional<Promise> promise(const Parameters& p) const override {
    if (!asks_for_pairs(p, 2) || p.kind != Kind::circular || p.k < 3 ||
        (p.v - 1) % (4 * p.k - 6) != 0 || count(p) < 1 || count(p) > 5) {
      return std::nullopt;
    }
    return Promise{count(p) * p.v, true, true, has_expansion_set(p)};
  }

  std::unique_ptr<BlockSource> blocks(const Parameters& p) const override {
    return std::make_unique<DevelopedSource>(base(p));
  }

  std::string explanation(const Parameters& p) const override {
    const std::uint64_t n = p.k - 2;
    const std::string blocks = joined(extras(count(p)), [&](const Extra& extra) {
      return fmt::format("{{{},{},{}}}", first_elements(n), value(extra.first, n),
                         value(extra.second, n));
    });
    return fmt::format("Develop the base block{} {} over Z_{}.", count(p) == 1 ? "" : "s", blocks,
                       p.v);
  }
};

}  // namespace

const Construction& construction() { return only<CyclicPaper>(); }

}  // namespace changeover::cyclic_paper_entry
