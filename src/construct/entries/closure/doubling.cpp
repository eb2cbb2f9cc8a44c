// The tight circular DCCD(2k−2, k, k−1), k even: the tight circular SCCD(k−1, k/2, k−1) with every
// element x replaced by the two elements 2x and 2x+1.
//
// A single change becomes a double change. {2x, 2x+1} is covered when x is introduced, and x is
// introduced once; {y,z} of different x is covered exactly where {⌊y/2⌋, ⌊z/2⌋} was. For k = 2
// there is one block and nothing to double.
#include <fmt/format.h>

#include <utility>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"

namespace changeover::doubling_entry {
namespace {

constexpr std::string_view single_change = "mcsorley-circular";

std::optional<Recipe> recipe_for(const Construction& construction, const Parameters& p) {
  if (!asks_for_pairs(p, 2) || p.kind != Kind::circular || p.k % 2 != 0 || p.v != 2 * p.k - 2) {
    return std::nullopt;
  }
  Recipe recipe{std::string(construction.name()), p, {}, {}, {}};
  if (p.k > 2) {
    const Parameters half{p.k - 1, p.k / 2, 1, Kind::circular, 2};
    recipe.inputs.push_back(Recipe{std::string(single_change), half, {}, {}, {}});
  }
  return recipe;
}

constexpr Description description{
    .name = "doubling",
    .summary = "every element of a tight circular SCCD(k-1,k/2) replaced by two",
    .preconditions = "circular, m = 2, v = 2k-2, k even",
    .guarantee = "a tight circular DCCD(2k-2,k,k-1)",
    .cited = "ChafeeStevens2025",
    .place = "Theorem 3",
};

class Doubling final : public Described<Entry, description> {
 public:
  std::optional<Offer> offer(const Parameters& p, const Registry& registry) const override {
    std::optional<Recipe> recipe = recipe_for(*this, p);
    if (!recipe || (!recipe->inputs.empty() && registry.find(single_change) == nullptr)) {
      return std::nullopt;
    }
    return Offer{*std::move(recipe), p.k - 1, true, true, p.k == 4};
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    require_recipe(recipe, *this, recipe_for(*this, recipe.parameters));
    if (recipe.inputs.empty()) {
      return std::make_unique<BlockListSource>(recipe.parameters, std::vector<Block>{{0, 1}});
    }
    return blown_up(recipe.parameters, registry.build(recipe.inputs.front()), 2);
  }

  // v = 2(k−2) + 2, so k−2 divides v only for k = 4 (k = 3 is odd): a partition of Z_6 into the
  // unchanged subsets {2,3}, {4,5}, {0,1} after blocks 1, 2, 3 of {0,1,2,3}, {2,3,4,5}, {4,5,0,1}.
  std::optional<std::vector<UnchangedSubset>> expansion_set(const Recipe& recipe,
                                                            const Registry&) const override {
    require_recipe(recipe, *this, recipe_for(*this, recipe.parameters));
    if (recipe.parameters.k != 4) {
      return std::nullopt;
    }
    return std::vector<UnchangedSubset>{{1, {2, 3}}, {2, {4, 5}}, {3, {0, 1}}};
  }

  std::string explain(const Recipe& recipe) const override {
    require_recipe(recipe, *this, recipe_for(*this, recipe.parameters));
    if (recipe.inputs.empty()) {
      return "The one block {0,1}.";
    }
    return fmt::format("Replace every element x in the blocks of the {} by 2x and 2x+1.",
                       changeover::name(recipe.inputs.front().parameters));
  }
};

}  // namespace

const Construction& construction() { return only<Doubling>(); }

}  // namespace changeover::doubling_entry
