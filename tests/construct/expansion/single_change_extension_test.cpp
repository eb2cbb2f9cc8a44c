#include "construct/expansion/single_change_extension.hpp"

#include <gtest/gtest.h>

#include "construction_checks.hpp"
#include "message_of.hpp"

namespace changeover::single_change_extension_test {
namespace {

using namespace test;

Design design_of(std::uint64_t v, std::uint64_t k, Kind kind) {
  const char* entry = k == 3 ? "triples-single-change" : "quadruples-single-change";
  return standard().build_design(offer_of(entry, {v, k, 1, kind, 2})->recipe);
}

Design circular_five() {
  return Design({.v = 5, .k = 3, .change = 1, .kind = Kind::circular},
                std::vector<Block>{{0, 1, 2}, {0, 2, 3}, {2, 3, 4}, {1, 3, 4}, {0, 1, 4}});
}

TEST(SingleChangeExtension, KeepsTheExcessOfADesign) {
  for (const std::uint64_t k : {3U, 4U}) {
    ASSERT_TRUE(has_single_change_extension(k));
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      for (std::uint64_t v = 2 * k - 1; v <= 16; ++v) {
        const Design design = design_of(v, k, kind);
        const std::uint64_t excess = verify(design).excess;
        std::uint64_t b = design.block_count();
        for (std::uint64_t rounds = 0; rounds < 4; ++rounds) {
          const auto source = extend_single_change(design, rounds);
          const std::uint64_t larger = v + rounds * 2 * (k - 1);
          EXPECT_EQ(source->parameters().v, larger);
          EXPECT_EQ(source->block_count(), b);
          const Verdict verdict = verify(*source);
          EXPECT_TRUE(verdict.valid());
          EXPECT_EQ(verdict.excess, excess);
          EXPECT_EQ(verdict.b, b);
          b += 2 * larger + 2 * k - 3;
        }
      }
    }
  }
}

TEST(SingleChangeExtension, IsADesignByTheDefinition) {
  const auto source = extend_single_change(circular_five(), 2);
  const Design larger = read_all(*source);
  EXPECT_EQ(larger.block_count(), 39U);
  const NaiveVerdict naive = naive_verdict(larger);
  EXPECT_TRUE(naive.valid);
  EXPECT_EQ(naive.excess, 0U);
}

TEST(SingleChangeExtension, InTwoRoundsIsTheExtensionOfTheExtension) {
  for (const std::uint64_t k : {3U, 4U}) {
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      const Design design = design_of(8, k, kind);
      const Design once = read_all(*extend_single_change(design, 1));
      EXPECT_EQ(blocks_of(*extend_single_change(once, 1)),
                blocks_of(*extend_single_change(design, 2)));
      EXPECT_EQ(blocks_of(*extend_single_change(design, 0)), design.blocks());
    }
  }
}

TEST(SingleChangeExtension, CanRewindAnywhere) {
  const auto source = extend_single_change(circular_five(), 2);
  const std::vector<Block> all = blocks_of(*source);
  expect_blocks_however_often(*source, all);
}

TEST(SingleChangeExtension, CarriesExpansionSets) {
  for (const auto& [v, k, kind] :
       {std::tuple{6U, 3U, Kind::linear}, std::tuple{8U, 3U, Kind::circular},
        std::tuple{12U, 4U, Kind::linear}, std::tuple{9U, 4U, Kind::circular}}) {
    const Design design = design_of(v, k, kind);
    for (std::uint64_t rounds = 0; rounds < 4; ++rounds) {
      const auto set = extended_expansion_set(design, rounds);
      ASSERT_TRUE(set);
      const Design larger = read_all(*extend_single_change(design, rounds));
      EXPECT_EQ(expansion_set_defect(larger, *set), std::nullopt);
    }
  }
  EXPECT_FALSE(extended_expansion_set(circular_five(), 1));
}

TEST(SingleChangeExtension, NamesWhatStandsInTheWay) {
  const auto defect = [](const Design& design) {
    return single_change_extension_defect(design).value_or("none");
  };
  EXPECT_EQ(defect(circular_five()), "none");
  EXPECT_EQ(defect(Design({7, 3, 2, Kind::linear, 2})),
            "a linear DCCD(7,3) is not a single-change design of strength 2");
  EXPECT_EQ(defect(Design({7, 5, 1, Kind::linear, 2})),
            "no extension is known for blocks of 5 elements");
  EXPECT_EQ(defect(Design({7, 4, 1, Kind::linear, 2})),
            "it needs v >= 2k - 2 = 6 and at least k = 4 blocks");
  // The element that comes last, 4, is not in the first block.
  const Design other({.v = 5, .k = 3, .change = 1, .kind = Kind::circular},
                     std::vector<Block>{{0, 1, 2}, {2, 3, 1}, {3, 0, 2}, {0, 3, 4}});
  EXPECT_NE(defect(other).find("stay until the first block follows"), std::string::npos);
  // 4 does not stay for two blocks.
  const Design passing({.v = 6, .k = 4, .change = 1, .kind = Kind::linear},
                       std::vector<Block>{{0, 1, 2, 3}, {0, 1, 2, 5}, {0, 1, 2, 4}, {0, 1, 2, 3}});
  EXPECT_NE(defect(passing).find("stay until the last block"), std::string::npos);
  EXPECT_REFUSAL((void)extend_single_change(passing, 1), BadInput,
                 "cannot be extended: the last 2 blocks do not introduce different elements");
  EXPECT_REFUSAL((void)extended_expansion_set(passing, 1), BadInput,
                 "blocks do not introduce different elements that all stay until the");
}

TEST(SingleChangeExtension, RefusesMoreElementsThanThereAre) {
  EXPECT_THROW((void)extend_single_change(circular_five(), std::uint64_t{1} << 30),
               ImpossibleParameters);
  EXPECT_THROW((void)extend_single_change(circular_five(), ~std::uint64_t{0}),
               ImpossibleParameters);
  const auto largest = extend_single_change(circular_five(), (std::uint64_t{1} << 30) - 2);
  EXPECT_EQ(largest->parameters().v, 0xffff'fffdU);
}

}  // namespace
}  // namespace changeover::single_change_extension_test
