// Recipes at random as JSON: read as they were written; damaged, a recipe or one line.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "../random_designs.hpp"
#include "changeover/io/formats.hpp"
#include "damage.hpp"

namespace changeover::recipe_property_test {
namespace {

Recipe some_recipe(std::uint32_t seed) {
  std::mt19937 random(seed);
  Recipe recipe = random_recipe(random);
  recipe.provenance = test::some_text({"found by hand", "\"", "\\", "\n", "é", "漢", "{", "\t"}, 4);
  recipe.arguments[recipe.provenance] = std::numeric_limits<std::int64_t>::min();
  return recipe;
}

RC_GTEST_PROP(RecipeProperty, IsReadAsItWasWritten, (std::uint32_t seed)) {
  const Recipe recipe = some_recipe(seed);
  const std::string json = recipe_to_json(recipe);
  RC_ASSERT(json.find('\n') == std::string::npos);
  RC_ASSERT(recipe_from_json(json) == recipe);
}

RC_GTEST_PROP(RecipeProperty, DamagedItIsRefusedOrAnotherRecipe,
              (std::uint32_t seed, const std::vector<test::Damage>& damages)) {
  const std::string good = recipe_to_json(some_recipe(seed));
  for (const test::Damage& damage : damages) {
    Recipe recipe;
    if (test::accepted("f:", [&] { recipe = recipe_from_json(damage.of(good), "f"); })) {
      RC_ASSERT(recipe_from_json(recipe_to_json(recipe)) == recipe);
    }
  }
}

}  // namespace
}  // namespace changeover::recipe_property_test
