// The tight circular DCCD(c(4k−6)+1, k, c²(4k−6)+c) for every c ≥ 1 and every k ≥ 3.
//
// The printed theorem stops at c = 5. What is needed for more is a way of pairing 2c numbers, which
// has a closed form: construct/cyclic.hpp, proved in docs/theorems.md. The pairs are made as they
// are asked for, so the design is a stream without any memory for its base blocks.
#include "changeover/construct/cyclic.hpp"

#include <algorithm>
#include <utility>

#include "changeover/construct/entry.hpp"
#include "changeover/construct/registry.hpp"

namespace changeover {
namespace {

// 0 if p is not in the family.
std::uint64_t base_block_count(const Parameters& p) {
  if (!asks_for_pairs(p, 2) || p.kind != Kind::circular || p.k < 3 ||
      (p.v - 1) % (4 * p.k - 6) != 0) {
    return 0;
  }
  return (p.v - 1) / (4 * p.k - 6);
}

std::optional<Recipe> recipe_for(const Construction& construction, const Parameters& p) {
  const std::uint64_t c = base_block_count(p);
  if (c == 0) {
    return std::nullopt;
  }
  return Recipe{std::string(construction.name()), p, {{"c", static_cast<std::int64_t>(c)}}, {}, {}};
}

IntervalDevelopedSource::Points points_of(std::uint64_t c, std::uint64_t k) {
  return [c, k](std::uint64_t which, std::span<Element> points) {
    std::ranges::copy(double_change_points(c, k, which), points.begin());
  };
}

class Cyclic final : public Construction {
 public:
  std::string_view name() const override { return "cyclic"; }
  std::string_view summary() const override {
    return "c base blocks {0,...,k-3,x,y} over Z_v from a pairing of 2c numbers, developed";
  }
  std::string_view preconditions() const override {
    return "circular, m = 2, k >= 3, v = c(4k-6)+1 with c >= 1";
  }
  std::string_view guarantee() const override {
    return "a tight circular DCCD(c(4k-6)+1,k,cv); an expansion set if k-2 | 2c+1 and v <= 2^20";
  }
  Citation citation() const override {
    return {"ChafeeStevens2025", "Theorem 10, here for all c: docs/theorems.md, Theorem 1"};
  }

  std::optional<Offer> offer(const Parameters& p, const Registry&) const override {
    std::optional<Recipe> recipe = recipe_for(*this, p);
    if (!recipe) {
      return std::nullopt;
    }
    return Offer{*std::move(recipe), base_block_count(p) * p.v, true, true,
                 has_interval_expansion_set(p.v, p.k - 2)};
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe, const Registry&) const override {
    const std::uint64_t c = required_count(recipe);
    const std::uint64_t k = recipe.parameters.k;
    return std::make_unique<IntervalDevelopedSource>(recipe.parameters, 0, k - 2, c,
                                                     points_of(c, k));
  }

  // As in the printed family: at position p = jc+i, 1 ≤ i < c, two blocks of a round meet in A+j;
  // at p = jc, where B_{c−1}+(j−1) holds A+j as well, too. Hence U_p = A + ⌊p/c⌋.
  std::optional<std::vector<UnchangedSubset>> expansion_set(const Recipe& recipe,
                                                            const Registry&) const override {
    const std::uint64_t c = required_count(recipe);
    const std::uint64_t n = recipe.parameters.k - 2;
    if (!has_interval_expansion_set(recipe.parameters.v, n)) {
      return std::nullopt;
    }
    return interval_expansion_set(c, recipe.parameters.v, n);
  }

  std::optional<BaseBlocks> base_blocks(const Recipe& recipe) const override {
    if (required_count(recipe) > max_written_out_elements / recipe.parameters.k) {
      return std::nullopt;
    }
    return interval_base_blocks(recipe)->written_out();
  }

  std::optional<IntervalBaseBlocks> interval_base_blocks(const Recipe& recipe) const override {
    const std::uint64_t c = required_count(recipe);
    if (c > max_listed_points / 2) {
      return std::nullopt;
    }
    return double_change_base_blocks(c, recipe.parameters.k);
  }

  std::string explain(const Recipe& recipe) const override {
    const std::uint64_t c = required_count(recipe);
    const std::uint64_t k = recipe.parameters.k;
    return explain_development(recipe.parameters, k - 2, c, points_of(c, k));
  }

 private:
  // c, of a recipe of this construction.
  std::uint64_t required_count(const Recipe& recipe) const {
    require_recipe(recipe, *this, recipe_for(*this, recipe.parameters));
    return base_block_count(recipe.parameters);
  }
};

}  // namespace

const Construction& cyclic_construction() {
  static const Cyclic construction;
  return construction;
}

}  // namespace changeover
