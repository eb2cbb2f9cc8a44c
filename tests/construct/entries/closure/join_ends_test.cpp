#include <gtest/gtest.h>

#include <algorithm>

#include "changeover/construct/best_known.hpp"
#include "changeover/construct/closure.hpp"
#include "construct/tools/path.hpp"
#include "construction_checks.hpp"

namespace changeover::join_ends_test {
namespace {

using namespace test;

Parameters of(std::uint64_t v, std::uint64_t k, std::uint64_t m, Kind kind) {
  return {v, k, m, kind, 2};
}

TEST(JoinEnds, AddsTheBlocksOfAShortestWay) {
  std::size_t joined = 0;
  for (std::uint64_t m = 1; m <= 3; ++m) {
    for (std::uint64_t k = m + 1; k <= m + 5; ++k) {
      for (std::uint64_t v = k + m; v <= k + m + 9; ++v) {
        const auto offer = best_known(standard(), of(v, k, m, Kind::linear));
        if (!offer || offer->b < 3) {
          continue;
        }
        const Design design = standard().build_design(offer->recipe);
        const auto made = join_ends_recipe(offer->recipe, design);
        std::uint64_t distance = 0;
        for (const Element x : design.block(0)) {
          const auto last = design.block(design.block_count() - 1);
          distance += std::find(last.begin(), last.end(), x) == last.end() ? 1U : 0U;
        }
        const auto steps = connecting_steps(distance, k, m, v);
        ASSERT_EQ(made.has_value(), distance > 0 && steps.has_value());
        if (made) {
          EXPECT_EQ(made->b, offer->b + *steps - 1);
          expect_as_promised({made->recipe, made->b, false, false, false});
          ++joined;
        }
      }
    }
  }
  EXPECT_GT(joined, 100U);
}

TEST(JoinEnds, RefusesWhatIsNoLinearDesign) {
  const Recipe linear = best_known(standard(), of(9, 4, 1, Kind::linear))->recipe;
  const Recipe circular = best_known(standard(), of(9, 4, 1, Kind::circular))->recipe;
  EXPECT_FALSE(join_ends_recipe(circular, standard().build_design(circular)));
  const Recipe recipe = join_ends_recipe(linear, standard().build_design(linear))->recipe;
  expect_spoilt_recipes_refused(recipe);
  // Both ends of this one are the same block.
  const Recipe same = literal_recipe(
      Design(of(4, 2, 1, Kind::linear),
             std::vector<Block>{{0, 1}, {1, 2}, {2, 3}, {1, 3}, {0, 3}, {0, 2}, {0, 1}}));
  EXPECT_FALSE(join_ends_recipe(same, standard().build_design(same)));
  try {
    (void)standard().build({"join-ends", of(4, 2, 1, Kind::circular), {}, {same}, {}});
    ADD_FAILURE();
  } catch (const BadInput& fault) {
    EXPECT_STREQ(
        fault.what(),
        "join-ends needs a linear design of 3 blocks or more, the last not the first; this "
        "linear SCCD(4,2) is none");
  }
}

}  // namespace
}  // namespace changeover::join_ends_test
