#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/verify/verdict.hpp"
#include "naive_verdict.hpp"

namespace changeover::disjoint_walk_test {
namespace {

TEST(DisjointWalk, ServesWhatCannotHoldAnElement) {
  const Registry& registry = Registry::standard();
  const Construction& walk = *registry.find("disjoint-walk");
  for (std::uint64_t k = 2; k <= 6; ++k) {
    for (std::uint64_t v = 2 * k + 1; v <= 30; ++v) {
      for (const Kind kind : {Kind::linear, Kind::circular}) {
        const Parameters p{.v = v, .k = k, .change = k, .kind = kind};
        const auto offer = walk.offer(p, registry);
        ASSERT_TRUE(offer) << name(p);
        const Design design = registry.build_design(offer->recipe);
        ASSERT_TRUE(verify(design).valid()) << name(p);
        ASSERT_EQ(design.block_count(), offer->b);
        ASSERT_GE(offer->b, lower_bound(p).blocks);
        if (v <= 12) {
          ASSERT_TRUE(test::naive_verdict(design).valid);
        }
      }
    }
  }
  EXPECT_FALSE(walk.offer({.v = 6, .k = 3, .change = 3}, registry));
  EXPECT_FALSE(walk.offer({.v = 20, .k = 3, .change = 2}, registry));
  EXPECT_THROW((void)registry.build({"disjoint-walk", {.v = 6, .k = 3, .change = 3}, {}, {}, {}}),
               BadInput);
}

}  // namespace
}  // namespace changeover::disjoint_walk_test
