// bliss on incidence graphs: a second opinion on sequences, the only one on collections of blocks.
#include "changeover/isomorphism/isomorphism.hpp"

#include <gtest/gtest.h>

#include "../../src/isomorphism/incidence_graph.hpp"
#include "sample_designs.hpp"

namespace changeover::test::block_system_test {
namespace {

BlockOrder order_of(Kind kind, bool reversal) {
  if (kind == Kind::linear) {
    return reversal ? BlockOrder::reversible_sequence : BlockOrder::sequence;
  }
  return reversal ? BlockOrder::reversible_circle : BlockOrder::circle;
}

TEST(IncidenceGraph, BlissAgreesWithSortingColumnsOnSamenessAndGroups) {
  Generator random(7);
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (const bool reversal : {false, true}) {
      const Sameness same{.rotation = true, .reversal = reversal};
      const BlockOrder order = order_of(kind, reversal);
      for (int round = 0; round < 150; ++round) {
        const std::size_t v = 3 + below(random, 6);
        const std::size_t k = 2 + below(random, v - 2);
        const std::size_t b = 3 + below(random, 8);
        const Design one = random_blocks(random, v, k, b, kind);
        // Half of the time the same, otherwise near.
        const Design other = below(random, 2) == 0 ? image(random_map(random, one, reversal), one)
                                                   : mutated(random, one);
        const GraphForm a = graph_form(one, order);
        const GraphForm c = graph_form(other, order);
        EXPECT_EQ(a.colours == c.colours && a.edges == c.edges,
                  find_isomorphism(one, other, same).has_value());
        EXPECT_EQ(a.group_order, automorphisms(one, same).order);
      }
    }
  }
}

TEST(BlockSystem, ForgetsTheOrderAndTheNamesButNotTheBlocks) {
  Generator random(8);
  for (int round = 0; round < 150; ++round) {
    const std::size_t v = 4 + below(random, 8);
    const std::size_t k = 2 + below(random, v - 3);
    const Design design = random_blocks(random, v, k, 1 + below(random, 12), Kind::linear);
    const Design renamed = image(random_map(random, design, false), design);
    std::vector<std::size_t> order(design.block_count());
    std::iota(order.begin(), order.end(), std::size_t{0});
    shuffle(random, order);
    Design shuffled(design.parameters());
    for (const std::size_t i : order) {
      shuffled.append(renamed.block(i));
    }
    const BlockSystem system = block_system(design);
    EXPECT_EQ(system.blocks, block_system(shuffled).blocks);
    EXPECT_EQ(system.group_order, block_system(shuffled).group_order);
    for (const auto& generator : system.generators) {
      std::vector<Block> here;
      std::vector<Block> there;
      for (std::size_t i = 0; i < design.block_count(); ++i) {
        Block block(design.block(i).begin(), design.block(i).end());
        std::sort(block.begin(), block.end());
        here.push_back(block);
        std::ranges::transform(block, block.begin(), [&](Element x) { return generator[x]; });
        std::sort(block.begin(), block.end());
        there.push_back(block);
      }
      std::sort(here.begin(), here.end());
      std::sort(there.begin(), there.end());
      EXPECT_EQ(here, there);
    }
  }
}

TEST(BlockSystem, TheFanoPlaneHas168SymmetriesAndARepeatedBlockIsCounted) {
  const Parameters p{.v = 7, .k = 3, .change = 2, .kind = Kind::linear};
  std::vector<Block> fano;
  for (Element i = 0; i < 7; ++i) {
    fano.push_back({i, (i + 1) % 7, (i + 3) % 7});
  }
  const BlockSystem plane = block_system(Design(p, fano));
  EXPECT_EQ(plane.group_order, "168");
  fano.push_back(fano.front());
  const BlockSystem twice = block_system(Design(p, fano));
  EXPECT_EQ(twice.group_order, "24");
  EXPECT_EQ(twice.blocks.size(), 8U);
}

}  // namespace
}  // namespace changeover::test::block_system_test
