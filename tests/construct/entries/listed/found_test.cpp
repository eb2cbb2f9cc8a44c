// The collection of designs that searches found: each is what it says, and worth keeping.
#include <gtest/gtest.h>

#include <utility>

#include "changeover/bounds/lower_bound.hpp"
#include "construct/found/found_designs.hpp"
#include "construction_checks.hpp"

namespace changeover {
namespace {

using namespace test;

// Everything that the collection offers, a design for each of its files.
const std::vector<Offer>& collection() {
  static const std::vector<Offer> all = [] {
    std::vector<Offer> offers;
    for (const FoundDesign& design : read_found_designs(found_design_files())) {
      const auto offer = offer_of("found", design.recipe.parameters);
      EXPECT_TRUE(offer && offer->recipe.inputs == std::vector<Recipe>{design.recipe})
          << name(design.recipe.parameters) << " is in two files";
      offers.push_back(offer.value_or(Offer{}));
    }
    return offers;
  }();
  return all;
}

TEST(Found, EveryFileIsTheDesignOfItsName) {
  ASSERT_GE(collection().size(), 750U);
  for (const FoundFile& file : found_design_files()) {
    const Parameters p = read_found_designs({&file, 1}).front().recipe.parameters;
    EXPECT_EQ(file.name, std::to_string(p.v) + "_" + std::to_string(p.k) + "_" +
                             std::to_string(p.change) + "_" + std::string(to_string(p.kind)) +
                             (p.strength == 2 ? "" : "_" + std::to_string(p.strength)) + ".txt");
  }
}

TEST(Found, EveryDesignIsWhatItSays) {
  for (const Offer& offer : collection()) {
    SCOPED_TRACE(name(offer.recipe.parameters));
    const Verdict verdict = verify(*standard().build(offer.recipe));
    EXPECT_TRUE(verdict.valid());
    EXPECT_EQ(verdict.b, offer.b);
    EXPECT_EQ(verdict.tight(), offer.tight);
    EXPECT_EQ(verdict.economical(), offer.economical);
    EXPECT_LE(verdict.fixed.size(), 1U);
    EXPECT_GE(offer.b, lower_bound(offer.recipe.parameters).blocks);
    EXPECT_NE(construction("found").explain(offer.recipe).find("changeover"), std::string::npos)
        << "a design must say where it comes from";
  }
}

TEST(Found, EveryDesignHasFewerBlocksThanOtherConstructionsGive) {
  std::vector<const Construction*> others(standard().constructions().begin(),
                                          standard().constructions().end());
  std::erase(others, &construction("found"));
  const Registry without(std::move(others));
  for (const Offer& offer : collection()) {
    const auto best = without.best(offer.recipe.parameters);
    EXPECT_TRUE(!best || offer.b < best->b)
        << name(offer.recipe.parameters) << ": " << offer.b << " blocks are no news";
  }
}

TEST(Found, ARecipeStaysWhatItIs) {
  const Offer offer = *offer_of("found", {26, 4, 2, Kind::circular, 2});
  EXPECT_EQ(offer.b, 65U);
  Recipe recipe = offer.recipe;
  recipe.inputs.front().blocks.front() = {0, 1, 2, 3};
  EXPECT_FALSE(verify(*standard().build(recipe)).valid());  // Its own blocks, not the collection's.
  recipe = offer.recipe;
  recipe.inputs.clear();
  expect_refused(recipe, "without its input");
  recipe = offer.recipe;
  recipe.parameters.v = 27;
  expect_refused(recipe, "with other parameters");
  recipe = offer.recipe;
  recipe.inputs.front().construction = "cyclic";
  expect_refused(recipe, "with an input that lists no blocks");
}

}  // namespace
}  // namespace changeover
