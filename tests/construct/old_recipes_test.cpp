// Recipes that a released version wrote make the blocks that they made then.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <tuple>

#include "changeover/catalog/catalog.hpp"
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

// Of each construction in the catalog that comes with the program, for each kind and class of v and
// k modulo 6: labels last, so a recipe makes the blocks that its checksum was made of.
TEST(OldRecipes, OfTheCatalogMakeTheSameBlocks) {
  using Sort = std::tuple<std::string, Kind, std::uint64_t, std::uint64_t, std::uint64_t>;
  std::map<Sort, CatalogEntry> smallest;
  standard_catalog().each({.best_only = false}, [&](const CatalogEntry& entry) {
    const Parameters& p = entry.parameters;
    const auto place =
        smallest
            .try_emplace(Sort{entry.recipe.construction, p.kind, p.change, p.v % 6, p.k % 6}, entry)
            .first;
    if (entry.b < place->second.b) {
      place->second = entry;
    }
    return true;
  });
  EXPECT_GE(smallest.size(), 2000U);
  for (const auto& [sort, entry] : smallest) {
    const DesignDigest digest = design_digest(*Registry::standard().build(entry.recipe));
    EXPECT_EQ(digest.b, entry.b) << entry.label();
    EXPECT_EQ(digest.checksum, entry.checksum) << entry.label();
  }
}

}  // namespace
}  // namespace changeover::test::old_recipes_test
