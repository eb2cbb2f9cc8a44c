// Recipes that a released version wrote make the blocks that they made then.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "changeover/catalog/entry.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/sha256.hpp"
#include "changeover/io/formats.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover::test::old_recipes_test {
namespace {

void collect(const nlohmann::json& recipe, std::set<std::string>& names) {
  names.insert(recipe.at("construction").get<std::string>());
  for (const auto& input : recipe.at("inputs")) {
    collect(input, names);
  }
}

TEST(OldRecipes, MakeTheSameBlocksForEver) {
  std::ifstream file(CHANGEOVER_TEST_DATA "/written_by_0.1/recipes.jsonl");
  std::set<std::string> names;
  std::size_t recipes = 0;
  for (std::string line; std::getline(file, line); ++recipes) {
    const auto kept = nlohmann::json::parse(line);
    const Recipe recipe = recipe_from_json(kept.at("recipe").dump());
    const DesignDigest digest = design_digest(*Registry::standard().build(recipe));
    EXPECT_EQ(digest.b, kept.at("b").get<std::uint64_t>()) << line;
    EXPECT_EQ(to_hex(digest.checksum), kept.at("sha256").get<std::string>()) << line;
    collect(kept.at("recipe"), names);
  }
  EXPECT_EQ(recipes, 117U);
  EXPECT_GE(names.size(), 40U) << "constructions";
}

}  // namespace
}  // namespace changeover::test::old_recipes_test
