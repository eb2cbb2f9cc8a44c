// Canonical forms, maps and groups against all v!·2b maps of tiny lists, and on known designs.
#include "changeover/isomorphism/isomorphism.hpp"

#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "message_of.hpp"
#include "sample_designs.hpp"

namespace changeover::test::canonical_test {
namespace {

using Blocks = std::vector<std::vector<Element>>;

Blocks blocks_of(const Design& design) {
  Blocks blocks = design.blocks();
  for (Block& block : blocks) {
    std::sort(block.begin(), block.end());
  }
  return blocks;
}

struct Naive {
  Blocks least;             // over all maps
  std::uint64_t group = 0;  // maps that change nothing
};

// All maps, one after another, straight from the definition.
Naive naive(const Design& design, const Sameness& same) {
  const std::size_t b = design.block_count();
  const Blocks own = blocks_of(design);
  const bool turns = same.rotation && design.parameters().kind == Kind::circular;
  std::vector<Element> names(design.v());
  std::iota(names.begin(), names.end(), Element{0});
  Naive result;
  do {
    for (std::size_t shift = 0; shift < (turns ? b : 1); ++shift) {
      for (int direction = 0; direction < (same.reversal ? 2 : 1); ++direction) {
        Blocks moved;
        for (std::size_t i = 0; i < b; ++i) {
          const std::size_t from = (i + shift) % b;
          std::vector<Element> block;
          for (const Element x : own[direction == 0 ? from : b - 1 - from]) {
            block.push_back(names[x]);
          }
          std::sort(block.begin(), block.end());
          moved.push_back(block);
        }
        result.group += moved == own ? 1U : 0U;
        if (result.least.empty() || moved < result.least) {
          result.least = moved;
        }
      }
    }
  } while (std::next_permutation(names.begin(), names.end()));
  return result;
}

struct Setting {
  Kind kind = Kind::linear;
  Sameness same;
};

const std::vector<Setting>& settings() {
  static const std::vector<Setting> all{
      {Kind::linear, {}},
      {Kind::linear, {.rotation = true, .reversal = true}},
      {Kind::circular, {}},
      {Kind::circular, {.rotation = true, .reversal = true}},
      {Kind::circular, {.rotation = false, .reversal = false}},
  };
  return all;
}

TEST(CanonicalForm, TellsTinyListsApartExactlyAsAllMapsDo) {
  Generator random(1);
  int same = 0;
  for (const Setting& setting : settings()) {
    for (int round = 0; round < 60; ++round) {
      const std::size_t v = 2 + below(random, 4);
      const std::size_t k = 2 + below(random, v - 1);
      const std::size_t b = 1 + below(random, 5);
      const Design one = random_blocks(random, v, k, b, setting.kind);
      const Design other = random_blocks(random, v, k, b, setting.kind);
      const bool equal = naive(one, setting.same).least == naive(other, setting.same).least;
      const CanonicalForm a = canonical_form(one, setting.same);
      const CanonicalForm c = canonical_form(other, setting.same);
      EXPECT_EQ(blocks_of(a.design) == blocks_of(c.design), equal);
      EXPECT_EQ(find_isomorphism(one, other, setting.same).has_value(), equal);
      EXPECT_TRUE(carries(a.map, one, a.design));
      same += equal ? 1 : 0;
    }
  }
  EXPECT_GT(same, 30);
  EXPECT_LT(same, 270);
}

TEST(CanonicalForm, GroupsOfTinyListsHaveTheOrderCountedOverAllMaps) {
  Generator random(2);
  for (const Setting& setting : settings()) {
    for (int round = 0; round < 80; ++round) {
      const std::size_t v = 2 + below(random, 4);
      const std::size_t k = 2 + below(random, v - 1);
      const Design design = random_blocks(random, v, k, 1 + below(random, 6), setting.kind);
      const AutomorphismGroup group = automorphisms(design, setting.same);
      EXPECT_EQ(group.order, std::to_string(naive(design, setting.same).group));
      for (const Isomorphism& each : group.generators) {
        EXPECT_TRUE(carries(each, design, design));
      }
    }
  }
}

TEST(CanonicalForm, IsTheSameAfterAnyRelabellingRotationAndReversal) {
  Generator random(3);
  for (const Setting& setting : settings()) {
    if (!setting.same.rotation) {
      continue;
    }
    for (int round = 0; round < 200; ++round) {
      const std::size_t v = 4 + below(random, 30);
      const std::size_t k = 2 + below(random, v - 2);
      const Design design = random_blocks(random, v, k, 1 + below(random, 40), setting.kind);
      const Isomorphism map = random_map(random, design, setting.same.reversal);
      const Design moved = image(map, design);
      ASSERT_TRUE(carries(map, design, moved));
      EXPECT_EQ(blocks_of(canonical_form(design, setting.same).design),
                blocks_of(canonical_form(moved, setting.same).design));
      const auto found = find_isomorphism(design, moved, setting.same);
      ASSERT_TRUE(found.has_value());
      EXPECT_TRUE(carries(*found, design, moved));
      EXPECT_EQ(automorphisms(design, setting.same).order,
                automorphisms(moved, setting.same).order);
    }
  }
}

TEST(CanonicalForm, AListWithOneElementExchangedIsAnotherOne) {
  Generator random(4);
  int differ = 0;
  for (int round = 0; round < 200; ++round) {
    const Design design = random_blocks(random, 12, 4, 20, Kind::circular);
    const Design other = mutated(random, design);
    differ += find_isomorphism(design, other, {.rotation = true, .reversal = true}) ? 0 : 1;
  }
  EXPECT_EQ(differ, 200);
}

TEST(CanonicalForm, CanonicalFormsAreTheirOwnAndBeginALongestRun) {
  Generator random(5);
  for (int round = 0; round < 100; ++round) {
    const Design design = random_blocks(random, 9, 4, 12, Kind::circular);
    const Design form = canonical_form(design).design;
    EXPECT_EQ(blocks_of(canonical_form(form).design), blocks_of(form));
    EXPECT_EQ(blocks_of(standard_form(form).design), blocks_of(form));
    std::size_t longest = 0;
    std::size_t first = 0;
    const Blocks blocks = blocks_of(form);
    const auto holds = [&](std::size_t i, Element x) {
      const auto& block = blocks[i % blocks.size()];
      return std::find(block.begin(), block.end(), x) != block.end();
    };
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      for (const Element x : blocks[i]) {
        if (!holds(i + blocks.size() - 1, x)) {
          std::size_t length = 1;
          while (holds(i + length, x)) {
            ++length;
          }
          longest = std::max(longest, length);
          first = i == 0 ? std::max(first, length) : first;
        }
      }
    }
    EXPECT_EQ(first, longest);
  }
}

TEST(Automorphisms, TheCyclicDoubleChangeDesignOfElevenElementsTurns) {
  const Design design = developed(11, 2, {0, 1, 2, 5});
  const AutomorphismGroup group = automorphisms(design);
  EXPECT_EQ(group.order, "11");
  EXPECT_EQ(group.rotations, 11U);
  ASSERT_EQ(group.generators.size(), 1U);
  EXPECT_EQ(group.generators[0].shift, 1U);
  EXPECT_EQ(standard_forms_in_class(design, group), 1U);
}

TEST(Automorphisms, ElementsInTheSameBlocksAreExchangedAndLargeOrdersAreExact) {
  const Design design(Parameters{.v = 30, .k = 2, .change = 1, .kind = Kind::linear},
                      std::vector<Block>{{0, 1}, {1, 2}});
  const AutomorphismGroup group = automorphisms(design, {.rotation = true, .reversal = true});
  // 27 elements in no block, and the reversal.
  EXPECT_EQ(group.order, "21777738900836704321536000000");
  EXPECT_TRUE(group.reflections);
  ASSERT_EQ(group.twins.size(), 1U);
  EXPECT_EQ(group.twins[0].size(), 27U);
}

TEST(Automorphisms, ACircleThatRepeatsItselfTurnsByItsPeriod) {
  const Design design(Parameters{.v = 4, .k = 2, .change = 1, .kind = Kind::circular},
                      std::vector<Block>{{0, 1}, {1, 2}, {2, 3}, {0, 1}, {1, 2}, {2, 3}});
  EXPECT_EQ(automorphisms(design).rotations, 2U);
  EXPECT_EQ(automorphisms(design, {.rotation = true, .reversal = true}).order, "4");
}

TEST(Isomorphism, ComposingWithTheInverseDoesNothing) {
  Generator random(6);
  for (int round = 0; round < 100; ++round) {
    const Design design = random_blocks(random, 7, 3, 1 + below(random, 9), Kind::circular);
    const std::size_t b = design.block_count();
    const Isomorphism map = random_map(random, design, true);
    const Isomorphism next = random_map(random, design, true);
    EXPECT_EQ(compose(map, inverse(map, b), b), identity(7));
    EXPECT_TRUE(carries(compose(map, next, b), design, image(next, image(map, design))));
  }
}

TEST(Isomorphism, AWrongWitnessCarriesNothing) {
  const Design design = developed(11, 2, {0, 1, 2, 5});
  Isomorphism map = identity(11);
  EXPECT_TRUE(carries(map, design, design));
  map.shift = 1;
  EXPECT_FALSE(carries(map, design, design));
  map = identity(11);
  std::swap(map.elements[3], map.elements[4]);
  EXPECT_FALSE(carries(map, design, design));
  map.elements[3] = map.elements[4];
  EXPECT_FALSE(carries(map, design, design));
  EXPECT_REFUSAL((void)image(map, design), BadInput,
                 "this map does not act on 11 elements and 11 blocks");
  map = identity(10);
  EXPECT_FALSE(carries(map, design, design));
}

TEST(Isomorphism, LinearDesignsDoNotTurnAndAreNeverCircular) {
  Design design = developed(11, 2, {0, 1, 2, 5});
  Isomorphism turn = identity(11);
  turn.shift = 1;
  const Design turned = image(turn, design);
  EXPECT_TRUE(find_isomorphism(design, turned).has_value());
  design.set_kind(Kind::linear);
  EXPECT_FALSE(find_isomorphism(design, turned).has_value());
  EXPECT_REFUSAL((void)image(turn, design), BadInput,
                 "this map does not act on 11 elements and 11 blocks");
}

TEST(Isomorphism, ListsWithoutBlocksOrWithOtherParametersAreToldApart) {
  const Design none(Parameters{.v = 4, .k = 2, .change = 1, .kind = Kind::circular});
  EXPECT_TRUE(find_isomorphism(none, none).has_value());
  EXPECT_EQ(automorphisms(none, {.rotation = true, .reversal = true}).rotations, 1U);
  const Design more(Parameters{.v = 5, .k = 2, .change = 1, .kind = Kind::circular});
  EXPECT_FALSE(find_isomorphism(none, more).has_value());
}

}  // namespace
}  // namespace changeover::test::canonical_test
