// The tight circular DCCD(61, 4, 366): six base blocks over Z_61, as printed.
//
// The last base block contains k−2 = 2, so that {1,2} is kept on the way to the next six. No
// expansion set exists, for k−2 = 2 does not divide 61.
#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"

namespace changeover {
namespace {

constexpr Parameters served{61, 4, 2, Kind::circular, 2};

std::optional<Recipe> recipe_for(const Construction& construction, const Parameters& p) {
  if (p != served) {
    return std::nullopt;
  }
  return Recipe{std::string(construction.name()), p, {}, {}, {}};
}

class Cyclic61x4 final : public Construction {
 public:
  std::string_view name() const override { return "cyclic-61-4"; }
  std::string_view summary() const override { return "six base blocks over Z_61, developed"; }
  std::string_view preconditions() const override { return "circular, m = 2, v = 61, k = 4"; }
  std::string_view guarantee() const override { return "a tight circular DCCD(61,4,366)"; }
  Citation citation() const override { return {"ChafeeStevens2025", "Proposition 16"}; }

  std::optional<Offer> offer(const Parameters& p, const Registry&) const override {
    std::optional<Recipe> recipe = recipe_for(*this, p);
    if (!recipe) {
      return std::nullopt;
    }
    return Offer{*std::move(recipe), 366, true, true, false};
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe, const Registry&) const override {
    return std::make_unique<DevelopedSource>(*base_blocks(recipe));
  }

  std::optional<BaseBlocks> base_blocks(const Recipe& recipe) const override {
    require_recipe(recipe, *this, recipe_for(*this, recipe.parameters));
    return BaseBlocks{served,
                      {{0, 1, 4, 19},
                       {0, 1, 6, 22},
                       {0, 1, 8, 25},
                       {0, 1, 10, 48},
                       {0, 1, 12, 32},
                       {0, 1, 2, 28}}};
  }

  std::string explain(const Recipe& recipe) const override {
    require_recipe(recipe, *this, recipe_for(*this, recipe.parameters));
    return "Develop the base blocks {0,1,4,19}, {0,1,6,22}, {0,1,8,25}, {0,1,10,48}, {0,1,12,32}, "
           "{0,1,2,28} over Z_61.";
  }
};

}  // namespace

const Construction& cyclic_61_4_construction() {
  static const Cyclic61x4 construction;
  return construction;
}

}  // namespace changeover
