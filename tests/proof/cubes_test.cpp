#include "changeover/proof/proof.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "message_of.hpp"

namespace changeover::cubes_test {
namespace {

bool cover_by_brute_force(const std::vector<Cube>& cubes, int variables) {
  for (unsigned bits = 0; bits < (1U << variables); ++bits) {
    const auto holds = [&](std::int32_t x) {
      return ((bits >> (x < 0 ? -x - 1 : x - 1)) & 1U) == (x > 0 ? 1U : 0U);
    };
    if (std::none_of(cubes.begin(), cubes.end(), [&](const Cube& cube) {
          return std::all_of(cube.begin(), cube.end(), holds);
        })) {
      return false;
    }
  }
  return true;
}

TEST(Cubes, CoverEverythingIfTheyAreTheLeavesOfATree) {
  EXPECT_TRUE(cubes_cover_everything({{}}));
  EXPECT_TRUE(cubes_cover_everything({{1}, {-1, 2}, {-1, -2}}));
  EXPECT_TRUE(cubes_cover_everything({{3, -1}, {1}, {-3, -1, 2}, {-2, -3, -1}}));
}

TEST(Cubes, LeaveSomethingOutIfOneIsMissingOrWrong) {
  EXPECT_FALSE(cubes_cover_everything({}));
  EXPECT_FALSE(cubes_cover_everything({{1}, {-1, 2}}));
  EXPECT_FALSE(cubes_cover_everything({{1}, {-1, 2}, {-1, -3}}));
  EXPECT_FALSE(cubes_cover_everything({{1}, {-2}}));
}

TEST(Cubes, AreRefusedIfTheyContradictThemselves) {
  EXPECT_REFUSAL((void)cubes_cover_everything({{1, -1}}), BadInput,
                 "a cube has the literal 0 or both a literal and its negation");
  EXPECT_REFUSAL((void)cubes_cover_everything({{0}}), BadInput,
                 "a cube has the literal 0 or both a literal and its negation");
}

// The part that is missing is on the side of the first literal, then of its negation, then deeper.
TEST(Cubes, LeaveNothingOutOnEitherSide) {
  EXPECT_FALSE(cubes_cover_everything({{1, 2}, {-1, 2}, {-1, -2}}));
  EXPECT_FALSE(cubes_cover_everything({{1, 2}, {1, -2}, {-1, -2}}));
  EXPECT_TRUE(cubes_cover_everything({{1, 2}, {1, -2}, {-1, 2}, {-1, -2}}));
  EXPECT_FALSE(cubes_cover_everything({{3}, {-3, 1, 2}, {-3, -1, 2}, {-3, -1, -2}}));
  EXPECT_FALSE(cubes_cover_everything({}));
  EXPECT_TRUE(cubes_cover_everything({{}}));
}

RC_GTEST_PROP(CubesProperty, AgreeWithBruteForce, ()) {
  constexpr int variables = 4;
  std::vector<Cube> cubes;
  const int count = *rc::gen::inRange(0, 12);
  for (int i = 0; i < count; ++i) {
    Cube& cube = cubes.emplace_back();
    for (int x = 1; x <= variables; ++x) {
      const int sign = *rc::gen::element(-1, 0, 0, 1);
      if (sign != 0) {
        cube.push_back(sign * x);
      }
    }
  }
  RC_ASSERT(cubes_cover_everything(cubes) == cover_by_brute_force(cubes, variables));
}

}  // namespace
}  // namespace changeover::cubes_test
