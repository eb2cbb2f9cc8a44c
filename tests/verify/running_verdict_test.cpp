#include <gtest/gtest.h>

#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover {
namespace {

Design a_design(const Parameters& p) {
  const Registry& registry = Registry::standard();
  return registry.build_design(registry.best(p)->recipe);
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
    const Design design = a_design({.v = 20, .k = 5, .kind = kind});
    EXPECT_EQ(of_passing_blocks(design, design.block_count()), verify(design));
  }
}

TEST(RunningVerdict, SeesThatTheLastBlockIsMissing) {
  const Design design = a_design({.v = 11, .k = 4, .kind = Kind::circular});
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
}  // namespace changeover
