#include <gtest/gtest.h>

#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover::single_block_test {
namespace {

TEST(SingleBlock, IsTheTightDesignWithAsManyElementsAsABlockHolds) {
  const Registry& registry = Registry::standard();
  for (std::uint64_t k = 2; k <= 12; ++k) {
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      for (std::uint64_t m = 1; m <= k; ++m) {
        const auto offer = registry.best({.v = k, .k = k, .change = m, .kind = kind});
        ASSERT_TRUE(offer);
        EXPECT_EQ(offer->b, 1U);
        EXPECT_TRUE(verify(*registry.build(offer->recipe)).tight());
      }
    }
  }
  EXPECT_FALSE(registry.find("single-block")->offer({.v = 5, .k = 4, .change = 1}, registry));
  EXPECT_TRUE(
      registry.find("single-block")->offer({.v = 4, .k = 4, .change = 1, .strength = 3}, registry));
  EXPECT_FALSE(
      registry.find("single-block")->offer({.v = 2, .k = 2, .change = 1, .strength = 3}, registry));
  EXPECT_THROW((void)registry.build({"single-block", {.v = 5, .k = 4, .change = 1}, {}, {}, {}}),
               BadInput);
}

}  // namespace
}  // namespace changeover::single_block_test
