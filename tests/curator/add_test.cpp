#include "changeover/curator/curator.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

#include "changeover/catalog/catalog.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/construct/best_known.hpp"
#include "changeover/construct/closure.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/isomorphism/isomorphism.hpp"
#include "construct/trusted_entry.hpp"
#include "message_of.hpp"
#include "naive_verdict.hpp"
#include "run_program.hpp"

namespace changeover::test::add_test {
namespace {

using testing::HasSubstr;

Design best_design(const Parameters& p) {
  const Registry& registry = Registry::standard();
  return registry.build_design(registry.best(p).value().recipe);
}

const Parameters six{.v = 6, .k = 4, .change = 2, .kind = Kind::circular};

TEST(Newcomer, IsWhatItsBlocksAre) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (std::uint64_t v = 4; v < 12; ++v) {
      for (std::uint64_t change = 1; change <= 3; ++change) {
        const Parameters p{.v = v, .k = 3, .change = change, .kind = kind};
        if (!Registry::standard().best(p)) {
          continue;
        }
        const Design design = best_design(p);
        const Newcomer newcomer = newcomer_of(
            design, {.credit = {.who = "me", .date = "2026-11-22", .program = "", .command = ""},
                     .note = "a note"});
        ASSERT_TRUE(newcomer.entry) << newcomer.refused;
        EXPECT_EQ(newcomer.entry->parameters, p);
        EXPECT_EQ(newcomer.entry->b, design.block_count());
        EXPECT_LE(newcomer.entry->lower_bound, newcomer.entry->b);
        EXPECT_EQ(entry_defect(*newcomer.entry), "");
        EXPECT_EQ(newcomer.entry->note, "a note");
      }
    }
  }
}

// Blocks at random: an entry exactly where the definition says yes.
TEST(Newcomer, IsRefusedWhereTheDefinitionSaysNo) {
  std::mt19937 random(1);
  const Design good = best_design(six);
  int refused = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<Block> blocks = good.blocks();
    for (std::uint64_t changes = random() % 3; changes > 0; --changes) {
      Block& block = blocks[random() % blocks.size()];
      const auto element = static_cast<Element>(random() % 6);
      if (std::ranges::find(block, element) == block.end()) {
        block[random() % 4] = element;
      }
    }
    const Design design(six, blocks);
    const Newcomer newcomer = newcomer_of(design, {});
    EXPECT_EQ(newcomer.entry.has_value(), naive_verdict(design).valid);
    EXPECT_EQ(newcomer.entry.has_value(), newcomer.refused.empty());
    refused += newcomer.entry ? 0 : 1;
  }
  EXPECT_GT(refused, 50);
  EXPECT_EQ(newcomer_of(Design(six), {}).refused, "there is no block; give at least one");
  EXPECT_THAT(
      newcomer_of(Design(six, std::vector<Block>{{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 3, 5}}), {})
          .refused,
      HasSubstr("do not change exactly 2 elements, the first from block"));
}

TEST(Newcomer, KeepsTheRecipeThatMakesItsBlocks) {
  Design design = best_design({.v = 13, .k = 4, .change = 2, .kind = Kind::circular});
  const Recipe tree = *design.recipe;
  ASSERT_NE(tree.construction, "literal");
  if (tree.construction != "found") {
    EXPECT_EQ(newcomer_of(design, {}).entry->recipe, tree);
  }
  // Of other blocks, without a credit, of no construction.
  std::vector<Block> turned = design.blocks();
  std::ranges::rotate(turned, turned.begin() + 1);
  Design other(design.parameters(), turned);
  other.recipe = tree;
  EXPECT_EQ(newcomer_of(other, {}).entry->recipe, literal_recipe(other));
  other.recipe->construction = "no-rule";
  EXPECT_EQ(newcomer_of(other, {}).entry->recipe, literal_recipe(other));
  other.recipe = Recipe{"found", other.parameters(), {}, {}, {}, "13.4.2.circular.9.00000000"};
  EXPECT_EQ(newcomer_of(other, {}).entry->recipe, literal_recipe(other));
  other.recipe = fix_recipe(*other.recipe, 1);
  EXPECT_EQ(newcomer_of(other, {}).entry->recipe, literal_recipe(other));
}

TEST(Newcomer, CreditsWhatTheFileSays) {
  Design design = best_design(six);
  design.recipe = literal_recipe(design, "changeover 9.9.9: search 6 4 --seed 1");
  const CatalogEntry entry = *newcomer_of(design, {}).entry;
  EXPECT_EQ(entry.credit.program, "changeover 9.9.9");
  EXPECT_EQ(entry.credit.command, "changeover search 6 4 --seed 1");
  EXPECT_EQ(entry.recipe.provenance, "");
  design.recipe = literal_recipe(design, "drawn on a napkin");
  EXPECT_EQ(newcomer_of(design, {}).entry->credit.command, "drawn on a napkin");
}

TEST(Newcomer, RefusesWordsThatAreNoText) {
  const Design design = best_design(six);
  EXPECT_REFUSAL(
      static_cast<void>(newcomer_of(design, {.credit = {}, .cites = {}, .note = "\xff"})), BadInput,
      "the credit or note of the design has unprintable characters; write one plain line");
  for (const std::string& bad :
       {std::string("a\nb"), std::string("\x1b[2J"), std::string("\xff"), std::string(3000, 'x')}) {
    EXPECT_THROW(static_cast<void>(newcomer_of(design, {.credit = {}, .cites = {}, .note = bad})),
                 BadInput);
    EXPECT_THROW(static_cast<void>(newcomer_of(
                     design, {.credit = {.who = bad, .date = "", .program = "", .command = ""}})),
                 BadInput);
    EXPECT_THROW(static_cast<void>(newcomer_of(design, {.credit = {}, .cites = {bad}})), BadInput);
    Design told = design;
    told.recipe = literal_recipe(told, bad);
    EXPECT_THROW(static_cast<void>(newcomer_of(told, {})), BadInput);
  }
}

TEST(Same, UpToNamesRotationAndReversal) {
  const TemporaryFolder folder;
  Catalog catalog({.user = folder.file("mine.db")});
  const Design design = best_design({.v = 9, .k = 4, .change = 2, .kind = Kind::circular});
  const CatalogEntry entry = *newcomer_of(design, {}).entry;
  catalog.add(entry);
  EXPECT_FALSE(same_in_catalog(catalog, entry));
  std::vector<Block> blocks = design.blocks();
  for (Block& block : blocks) {
    for (Element& x : block) {
      x = 8 - x;
    }
  }
  std::ranges::rotate(blocks, blocks.begin() + 2);
  std::ranges::reverse(blocks);
  EXPECT_EQ(same_in_catalog(catalog, *newcomer_of(Design(design.parameters(), blocks), {}).entry),
            entry.label());
  // One block more is another design.
  Design longer = best_design({.v = 9, .k = 4, .change = 2, .kind = Kind::linear});
  EXPECT_FALSE(same_in_catalog(catalog, *newcomer_of(longer, {}).entry));
}

// The same design by other names, from another block on, or backwards.
Design disguised(const Design& design, std::mt19937& random) {
  std::vector<Element> names(design.v());
  std::iota(names.begin(), names.end(), Element{0});
  std::ranges::shuffle(names, random);
  std::vector<Block> blocks = design.blocks();
  for (Block& block : blocks) {
    std::ranges::transform(block, block.begin(), [&](Element x) { return names[x]; });
  }
  if (design.parameters().kind == Kind::circular) {
    const auto shift = static_cast<std::ptrdiff_t>(random() % blocks.size());
    std::ranges::rotate(blocks, blocks.begin() + shift);
  }
  if (random() % 2 == 0) {
    std::ranges::reverse(blocks);
  }
  return {design.parameters(), blocks};
}

// Many designs held against many: what each pair by itself says, whatever was asked before.
TEST(Same, ManyAsEachPairByItself) {
  std::mt19937 random(7);
  const Registry& registry = Registry::standard();
  std::vector<Design> kinds;  // some of a cell with as many blocks, and not the same
  for (const CatalogEntry& entry :
       standard_catalog().cell({.v = 10, .k = 4, .change = 1, .kind = Kind::circular})) {
    const Design design = registry.build_design(entry.recipe);
    if (std::ranges::none_of(kinds, [&](const Design& other) {
          return find_isomorphism(design, other, {.rotation = true, .reversal = true}).has_value();
        })) {
      kinds.push_back(design);
    }
  }
  ASSERT_GT(kinds.size(), 5U);
  const TemporaryFolder folder;
  Catalog catalog({.user = folder.file("mine.db")});
  std::map<std::string, Design> there;
  for (std::size_t i = 0; i + 1 < kinds.size(); ++i) {
    for (int namings = 0; namings < 3; ++namings) {
      const Design design = disguised(kinds[i], random);
      const CatalogEntry entry = *newcomer_of(design, {}).entry;
      catalog.add(entry);
      there.emplace(entry.label(), design);
    }
  }
  SameDesigns same(catalog);
  int found = 0;
  int missing = 0;
  for (int i = 0; i < 60; ++i) {
    Design design = disguised(kinds[random() % kinds.size()], random);
    if (i % 10 == 0) {  // one that is there itself
      design =
          std::next(there.begin(), static_cast<std::ptrdiff_t>(random() % there.size()))->second;
    }
    const CatalogEntry entry = *newcomer_of(design, {}).entry;
    const auto is_same = [&](const auto& other) {
      return other.first != entry.label() && other.second.parameters() == design.parameters() &&
             find_isomorphism(design, other.second, {.rotation = true, .reversal = true});
    };
    const auto label = same.find(entry);
    EXPECT_EQ(label.has_value(), std::ranges::any_of(there, is_same)) << i;
    EXPECT_EQ(same_in_catalog(catalog, entry).has_value(), label.has_value()) << i;
    if (label) {
      ASSERT_TRUE(there.contains(*label));
      EXPECT_TRUE(is_same(*there.find(*label))) << i;
    }
    ++(label ? found : missing);
    if (!label && random() % 4 == 0) {
      same.remember(entry);
      catalog.add(entry);
      there.emplace(entry.label(), design);
    }
  }
  EXPECT_GT(found, 10);
  EXPECT_GT(missing, 0);
}

TEST(Gains, AreBuiltAndBetter) {
  // A design that nothing in the catalog serves, so that everything around is a gain or is not, as
  // the registry says.
  const Design design = best_design({.v = 6, .k = 4, .change = 2, .kind = Kind::circular});
  for (const Gain& gain : gains_of(*newcomer_of(design, {}).entry)) {
    EXPECT_TRUE(!gain.before || gain.b < *gain.before) << gain.rule;
  }
  // Nothing is known for change numbers as large as this one's blow-ups.
  Recipe large = blow_up_recipe(*design.recipe, 7);
  const Newcomer newcomer = newcomer_of(Registry::standard().build_design(large), {});
  ASSERT_TRUE(newcomer.entry);
  for (const Gain& gain : gains_of(*newcomer.entry)) {
    const auto offer = best_known(Registry::standard(), gain.parameters);
    EXPECT_EQ(offer ? std::optional(offer->b) : std::nullopt, gain.before) << gain.rule;
    EXPECT_TRUE(!gain.before || gain.b < *gain.before) << gain.rule;
  }
}

}  // namespace
}  // namespace changeover::test::add_test
