// The tight circular SCCD(2c(k−1)+1, k, 2c²(k−1)+c): {0, …, k−2} with one multiple of k−1,
// developed.
//
// Base block A ∪ {(p+1)(k−1)}, A = {0, …, k−2}, newly covers the differences p(k−1)+1, …,
// (p+1)(k−1), so the c of them cover 1, …, c(k−1) = (v−1)/2, each once. The base block that
// contains k−1 comes last: it holds A+1 = {1, …, k−1}, which is what it shares with the next
// translate of the first.
#include <utility>

#include "changeover/construct/cyclic.hpp"
#include "changeover/construct/entry.hpp"
#include "changeover/construct/registry.hpp"

namespace changeover {
namespace {

// 0 if p is not in the family.
std::uint64_t base_block_count(const Parameters& p) {
  if (!asks_for_pairs(p, 1) || p.kind != Kind::circular || (p.v - 1) % (2 * (p.k - 1)) != 0) {
    return 0;
  }
  return (p.v - 1) / (2 * (p.k - 1));
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
    points.front() = single_change_point(c, k, which);
  };
}

class CyclicSingleChange final : public Construction {
 public:
  std::string_view name() const override { return "cyclic-single-change"; }
  std::string_view summary() const override {
    return "c base blocks {0,...,k-2,j(k-1)} over Z_v, 1 <= j <= c, developed";
  }
  std::string_view preconditions() const override {
    return "circular, m = 1, k >= 2, v = 2c(k-1)+1 with c >= 1";
  }
  std::string_view guarantee() const override {
    return "a tight circular SCCD(2c(k-1)+1,k,cv), with an expansion set if k = 2 and v <= 2^20";
  }
  Citation citation() const override { return {"ChafeeStevens2023", ""}; }

  std::optional<Offer> offer(const Parameters& p, const Registry&) const override {
    std::optional<Recipe> recipe = recipe_for(*this, p);
    if (!recipe) {
      return std::nullopt;
    }
    return Offer{*std::move(recipe), base_block_count(p) * p.v, true, true,
                 has_interval_expansion_set(p.v, p.k - 1)};
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe, const Registry&) const override {
    const std::uint64_t c = required_count(recipe);
    const std::uint64_t k = recipe.parameters.k;
    return std::make_unique<IntervalDevelopedSource>(recipe.parameters, 0, k - 1, c,
                                                     points_of(c, k));
  }

  // U_p = A + ⌊p/c⌋ as in the double-change family. v ≡ 1 modulo k−1, so k = 2 is all that divides.
  std::optional<std::vector<UnchangedSubset>> expansion_set(const Recipe& recipe,
                                                            const Registry&) const override {
    const std::uint64_t c = required_count(recipe);
    const std::uint64_t n = recipe.parameters.k - 1;
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
    if (c > max_listed_points) {
      return std::nullopt;
    }
    return single_change_base_blocks(c, recipe.parameters.k);
  }

  std::string explain(const Recipe& recipe) const override {
    const std::uint64_t c = required_count(recipe);
    const std::uint64_t k = recipe.parameters.k;
    return explain_development(recipe.parameters, k - 1, c, points_of(c, k));
  }

 private:
  // c, of a recipe of this construction.
  std::uint64_t required_count(const Recipe& recipe) const {
    require_recipe(recipe, *this, recipe_for(*this, recipe.parameters));
    return base_block_count(recipe.parameters);
  }
};

}  // namespace

const Construction& cyclic_single_change_construction() {
  static const CyclicSingleChange construction;
  return construction;
}

}  // namespace changeover
