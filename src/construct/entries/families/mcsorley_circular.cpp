// The tight circular SCCD(2k−1, k, 2k−1): k consecutive residues modulo 2k−1, developed.
//
// The only change from one block to the next is j out, j+k in. The differences that k adds to the
// k−1 residues before it are 1, …, k−1, each once up to sign, so every pair is covered exactly
// once.
#include <fmt/format.h>

#include <numeric>
#include <utility>

#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"

namespace changeover {
namespace {

std::optional<Recipe> recipe_for(const Construction& construction, const Parameters& p) {
  if (!asks_for_pairs(p, 1) || p.kind != Kind::circular || p.v != 2 * p.k - 1) {
    return std::nullopt;
  }
  return Recipe{std::string(construction.name()), p, {}, {}, {}};
}

class McSorleyCircular final : public Construction {
 public:
  std::string_view name() const override { return "mcsorley-circular"; }
  std::string_view summary() const override {
    return "k consecutive residues modulo 2k-1, developed";
  }
  std::string_view preconditions() const override { return "circular, m = 1, v = 2k-1, k >= 2"; }
  std::string_view guarantee() const override { return "a tight circular SCCD(2k-1,k,2k-1)"; }
  Citation citation() const override { return {"McSorley1999", ""}; }

  std::optional<Offer> offer(const Parameters& p, const Registry&) const override {
    std::optional<Recipe> recipe = recipe_for(*this, p);
    if (!recipe) {
      return std::nullopt;
    }
    return Offer{*std::move(recipe), p.v, true, true, false};
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe, const Registry&) const override {
    return std::make_unique<DevelopedSource>(*base_blocks(recipe));
  }

  std::optional<BaseBlocks> base_blocks(const Recipe& recipe) const override {
    require_recipe(recipe, *this, recipe_for(*this, recipe.parameters));
    Block base(static_cast<std::size_t>(recipe.parameters.k));
    std::iota(base.begin(), base.end(), Element{0});
    return BaseBlocks{recipe.parameters, {std::move(base)}};
  }

  std::string explain(const Recipe& recipe) const override {
    require_recipe(recipe, *this, recipe_for(*this, recipe.parameters));
    return fmt::format("Develop the base block {{{}}} over Z_{}.",
                       first_elements(recipe.parameters.k), recipe.parameters.v);
  }
};

}  // namespace

const Construction& mcsorley_circular_construction() {
  static const McSorleyCircular construction;
  return construction;
}

}  // namespace changeover
