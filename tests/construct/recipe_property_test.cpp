// Recipes of constructions, written as JSON and damaged: refused, or built as they say, the same
// whenever they are built, and a design if no given blocks are in them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <chrono>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/io/formats.hpp"
#include "changeover/run/control.hpp"
#include "changeover/verify/verdict.hpp"
#include "damage.hpp"

namespace changeover::recipe_property_test {
namespace {

const Registry& registry() { return Registry::standard(); }

// One of the offers for small parameters, and closures of it.
const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> all = [] {
    std::vector<Recipe> list;
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      for (std::uint64_t v = 5; v < 18; ++v) {
        for (std::uint64_t change = 1; change < 3; ++change) {
          for (const Offer& offer :
               registry().offers({.v = v, .k = 4, .change = change, .kind = kind})) {
            list.push_back(offer.recipe);
            list.push_back(blow_up_recipe(offer.recipe, 2));
            list.push_back(drop_recipe(fix_recipe(offer.recipe, 1)));
          }
        }
      }
    }
    return list;
  }();
  return all;
}

// A damaged recipe may be of a giant: no more is looked at.
constexpr std::uint64_t most_v = 200;
constexpr std::uint64_t most_blocks = 5000;

bool is_small(const Recipe& recipe) {
  return recipe.parameters.v <= most_v && std::ranges::all_of(recipe.inputs, is_small);
}

bool is_made_of_constructions(const Recipe& recipe) {
  return recipe.blocks.empty() && std::ranges::all_of(recipe.inputs, is_made_of_constructions);
}

std::optional<Design> built(const Recipe& recipe) {
  const auto source = registry().build(recipe);
  RC_ASSERT(source->parameters() == recipe.parameters);
  const auto count = source->block_count();
  return count && *count <= most_blocks ? std::optional(registry().build_design(recipe))
                                        : std::nullopt;
}

RC_GTEST_PROP(RecipesOfConstructions, AreReadAndBuiltAsTheyWereWritten, ()) {
  const Recipe recipe = *rc::gen::elementOf(recipes());
  const Recipe again = recipe_from_json(recipe_to_json(recipe));
  RC_ASSERT(again == recipe);
  const Design design = registry().build_design(again);
  RC_ASSERT(design.parameters() == recipe.parameters);
  RC_ASSERT(design.blocks() == registry().build_design(recipe).blocks());
  RC_ASSERT(verify(design).valid());
}

RC_GTEST_PROP(RecipesOfConstructions, DamagedTheyAreRefusedOrBuiltAsTheySay,
              (const std::vector<test::Damage>& damages)) {
  const std::string good = recipe_to_json(*rc::gen::elementOf(recipes()));
  for (std::size_t i = 0; i < damages.size() && i < 20; ++i) {
    Recipe recipe;
    const std::string bad = damages[i].of(good);
    if (!test::accepted("f:", [&] { recipe = recipe_from_json(bad, "f"); }) || !is_small(recipe)) {
      continue;
    }
    RunControl control(
        {.time = std::chrono::seconds(10), .memory_bytes = std::uint64_t{64} << 20U});
    const RunScope scope(control);
    std::optional<Design> design;
    bool refused = true;
    test::accepted<ImpossibleParameters>(
        "", [&] { refused = !test::accepted("", [&] { design = built(recipe); }); });
    if (refused || !design) {
      continue;
    }
    RC_LOG() << bad << '\n';
    RC_ASSERT(design->parameters() == recipe.parameters);
    RC_ASSERT(design->blocks() == registry().build_design(recipe).blocks());
    if (is_made_of_constructions(recipe)) {
      RC_ASSERT(verify(*design).valid());
    }
  }
}

}  // namespace
}  // namespace changeover::recipe_property_test
