// The collection of designs that searches found: each is what it says, and worth keeping.
#include <gtest/gtest.h>

#include <utility>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/planner.hpp"
#include "construction_checks.hpp"

namespace changeover {
namespace {

using namespace test;

// Everything that the collection offers.
const std::vector<Offer>& collection() {
  static const std::vector<Offer> all = [] {
    std::vector<Offer> offers;
    for (std::uint64_t change = 1; change <= 4; ++change) {
      for (const Kind kind : {Kind::linear, Kind::circular}) {
        for (std::uint64_t k = 3; k <= 40; ++k) {
          for (std::uint64_t v = k + change; v <= 150; ++v) {
            if (auto offer = offer_of("found", {v, k, change, kind, 2})) {
              offers.push_back(*std::move(offer));
            }
          }
        }
      }
    }
    return offers;
  }();
  return all;
}

TEST(Found, EveryDesignIsWhatItSays) {
  EXPECT_GE(collection().size(), 49U);
  for (const Offer& offer : collection()) {
    const auto source = standard().build(offer.recipe);
    const Verdict verdict = verify(*source);
    EXPECT_TRUE(verdict.valid()) << name(offer.recipe.parameters);
    EXPECT_EQ(verdict.b, offer.b) << name(offer.recipe.parameters);
    EXPECT_EQ(verdict.tight(), offer.tight) << name(offer.recipe.parameters);
    EXPECT_EQ(verdict.economical(), offer.economical) << name(offer.recipe.parameters);
    EXPECT_LE(verdict.fixed.size(), 1U) << name(offer.recipe.parameters);
    EXPECT_GE(offer.b, lower_bound(offer.recipe.parameters).blocks);
    EXPECT_NE(construction("found").explain(offer.recipe).find("changeover"), std::string::npos)
        << "a design must say where it comes from";
  }
}

TEST(Found, EveryDesignHasFewerBlocksThanOtherConstructionsGive) {
  std::vector<const Construction*> others;
  for (const Construction* each : standard().constructions()) {
    if (each->name() != "found") {
      others.push_back(each);
    }
  }
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
