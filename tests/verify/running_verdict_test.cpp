#include <gtest/gtest.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover::running_verdict_test {
namespace {

// The development of {0,1,2,3,7} over Z_15, tight if it is circular.
Design a_design(Kind kind) {
  Design design({.v = 15, .k = 5, .kind = kind});
  for (Element j = 0; j < 15; ++j) {
    Block block;
    for (const Element x : Block{0, 1, 2, 3, 7}) {
      block.push_back((x + j) % 15);
    }
    std::sort(block.begin(), block.end());
    design.append(block);
  }
  return design;
}

Verdict of_passing_blocks(const Design& design, std::size_t blocks) {
  RunningVerdict running(design.parameters());
  for (std::size_t i = 0; i < blocks; ++i) {
    running.add(design.block(i));
  }
  return running.finish();
}

TEST(RunningVerdict, IsTheVerdictOnTheSameList) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    const Design design = a_design(kind);
    EXPECT_EQ(of_passing_blocks(design, design.block_count()), verify(design));
  }
}

TEST(RunningVerdict, SeesThatTheLastBlockIsMissing) {
  const Design design = a_design(Kind::circular);
  EXPECT_TRUE(of_passing_blocks(design, design.block_count()).valid());
  EXPECT_FALSE(of_passing_blocks(design, design.block_count() - 1).valid());
}

TEST(RunningVerdict, RefusesBlocksOfAnotherSizeAndTooManyElements) {
  RunningVerdict running({.v = 9, .k = 3});
  EXPECT_THROW(running.add(Block{0, 1}), BadInput);
  EXPECT_THROW(running.add(Block{0, 1, 9}), BadInput);
  EXPECT_THROW(RunningVerdict({.v = 70'000, .k = 3}), MissingResource);
}

}  // namespace
}  // namespace changeover::running_verdict_test
