// The collection of designs that searches found: each is what it says, and worth keeping.
#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/construct/registry.hpp"
#include "construction_checks.hpp"

namespace changeover::found_test {
namespace {

using namespace test;

// What comes with the program: the entries that carry their blocks, and the best of each cell as it
// is offered.
const std::vector<CatalogEntry>& entries() {
  static const std::vector<CatalogEntry> all = [] {
    std::vector<CatalogEntry> carrying;
    standard_catalog().each({.best_only = false}, [&](const CatalogEntry& entry) {
      if (entry.carries_blocks()) {
        carrying.push_back(entry);
      }
      return true;
    });
    return carrying;
  }();
  return all;
}

const std::vector<Offer>& collection() {
  static const std::vector<Offer> all = [] {
    std::map<Parameters, Offer> offers;
    for (const CatalogEntry& entry : entries()) {
      const auto offer = offer_of("found", entry.parameters);
      EXPECT_TRUE(offer && offer->b <= entry.b) << entry.label();
      offers.emplace(entry.parameters, offer.value_or(Offer{}));
    }
    std::vector<Offer> values;
    for (auto& [p, offer] : offers) {
      values.push_back(std::move(offer));
    }
    return values;
  }();
  return all;
}

TEST(Found, EveryEntryHasTheBlocksOfItsLabel) {
  ASSERT_GE(collection().size(), 750U);
  for (const CatalogEntry& entry : entries()) {
    SCOPED_TRACE(entry.label());
    const DesignDigest digest = design_digest(*standard().build(entry.recipe));
    EXPECT_EQ(digest.b, entry.b);
    EXPECT_EQ(digest.checksum, entry.checksum);
    EXPECT_FALSE(entry.credit.who.empty());
    if (entry.cites.empty()) {
      EXPECT_FALSE(entry.credit.date.empty());
      EXPECT_FALSE(entry.credit.command.empty()) << "a design must say where it comes from";
    }
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
    EXPECT_NE(construction("found").explain(offer.recipe).find(offer.recipe.provenance),
              std::string::npos);
  }
}

// Lines last: what a search found stays in the catalog when a family reaches it later, and then the
// family is offered.
TEST(Found, IsOfferedOnlyBeforeConstructionsWithMoreBlocks) {
  std::vector<const Construction*> others(standard().constructions().begin(),
                                          standard().constructions().end());
  std::erase(others, &construction("found"));
  const Registry without(std::move(others));
  std::size_t news = 0;
  for (const Offer& offer : collection()) {
    const auto best = without.best(offer.recipe.parameters);
    ASSERT_TRUE(standard_catalog().find(offer.recipe.provenance));
    const bool is_news = !best || offer.b < best->b;
    const auto chosen = standard().best(offer.recipe.parameters);
    EXPECT_TRUE(is_news || chosen->recipe.construction != "found") << name(offer.recipe.parameters);
    news += is_news ? 1U : 0U;
  }
  EXPECT_GE(news * 3, collection().size() * 2);
}

TEST(Found, ARecipeNamesADesignByItsLabel) {
  const Offer offer = *offer_of("found", {26, 4, 2, Kind::circular, 2});
  EXPECT_EQ(offer.b, 65U);
  const auto label = parse_design_label(offer.recipe.provenance);
  ASSERT_TRUE(label);
  EXPECT_EQ(label->parameters, offer.recipe.parameters);
  Recipe recipe = offer.recipe;
  recipe.provenance.clear();
  expect_refused(recipe, "without a label");
  recipe.provenance = "26.4.2.circular.65.00000000";
  expect_refused(recipe, "with the label of no design");
  recipe.provenance = offer.recipe.provenance.substr(0, offer.recipe.provenance.size() - 1);
  expect_refused(recipe, "with a part of a label");
  recipe = offer.recipe;
  recipe.parameters.v = 27;
  expect_refused(recipe, "with other parameters");
  recipe = offer.recipe;
  recipe.arguments["n"] = 1;
  expect_refused(recipe, "with an argument");
}

// As programs before the catalog wrote them.
TEST(Found, ARecipeMayCarryItsBlocks) {
  const Offer offer = *offer_of("found", {26, 4, 2, Kind::circular, 2});
  const auto entry = standard_catalog().find(offer.recipe.provenance);
  ASSERT_TRUE(entry);
  Recipe recipe = offer.recipe;
  recipe.provenance.clear();
  recipe.inputs = {entry->recipe};
  EXPECT_TRUE(verify(*standard().build(recipe)).valid());
  recipe.inputs.front().blocks.front() = {0, 1, 2, 3};
  EXPECT_FALSE(verify(*standard().build(recipe)).valid());  // Its own blocks, not the catalog's.
  recipe.inputs = {entry->recipe};
  recipe.parameters.v = 27;
  expect_refused(recipe, "with other parameters");
  recipe.parameters.v = 26;
  recipe.inputs.front().construction = "cyclic";
  expect_refused(recipe, "with an input that lists no blocks");
}

}  // namespace
}  // namespace changeover::found_test
