#include "curator/by_base_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "changeover/catalog/catalog.hpp"
#include "changeover/construct/registry.hpp"

namespace changeover::test::by_base_blocks_test {
namespace {

std::vector<Block> sorted(const Design& design) {
  std::vector<Block> blocks = design.blocks();
  for (Block& block : blocks) {
    std::ranges::sort(block);
  }
  return blocks;
}

// All developed designs that come with the program, as nothing but lists of blocks.
TEST(ByBaseBlocks, FindsWhatDesignsAreDevelopedFrom) {
  int count = 0;
  standard_catalog().each(
      {.v_to = 40, .construction = "developed"}, [&](const CatalogEntry& entry) {
        const Design design = Registry::standard().build_design(entry.recipe);
        const auto n = static_cast<std::size_t>(entry.recipe.arguments.at("n"));
        const auto found = by_base_blocks(Design(design.parameters(), design.blocks()));
        if (entry.recipe.arguments.at("shift") == 1) {
          EXPECT_TRUE(found) << entry.label();
          if (found) {
            EXPECT_TRUE(sorted(*found) == sorted(design)) << entry.label();
            EXPECT_TRUE(Registry::standard().build_design(*found->recipe).blocks() ==
                        found->blocks());
            EXPECT_EQ(found->recipe->construction, "developed");
            EXPECT_LE(found->recipe->blocks.size(), design.block_count() / n) << entry.label();
          }
        }
        ++count;
        return true;
      });
  EXPECT_GT(count, 20);
}

TEST(ByBaseBlocks, NothingWithoutAnAutomorphismOrInALinearList) {
  const Parameters p{.v = 13, .k = 4, .change = 1, .kind = Kind::circular};
  const Registry& registry = Registry::standard();
  const Design design = registry.build_design(registry.best(p)->recipe);
  ASSERT_TRUE(by_base_blocks(Design(p, design.blocks())));
  Parameters linear = p;
  linear.kind = Kind::linear;
  EXPECT_FALSE(by_base_blocks(Design(linear, design.blocks())));
  // Other names, under which no automorphism adds 1.
  std::mt19937 random(1);
  std::vector<Element> names(p.v);
  std::iota(names.begin(), names.end(), Element{0});
  std::shuffle(names.begin(), names.end(), random);
  std::vector<Block> renamed = design.blocks();
  for (Block& block : renamed) {
    std::ranges::transform(block, block.begin(), [&](Element x) { return names[x]; });
  }
  EXPECT_FALSE(by_base_blocks(Design(p, renamed)));
  std::vector<Block> changed = design.blocks();
  std::swap(changed[3], changed[4]);
  EXPECT_FALSE(by_base_blocks(Design(p, changed)));
}

}  // namespace
}  // namespace changeover::test::by_base_blocks_test
