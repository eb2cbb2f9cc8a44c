// The tight circular design of two windows, linear with one block fewer.
#include <gtest/gtest.h>

#include "construction_checks.hpp"

namespace changeover::chained_cyclic_test {
namespace {

using namespace test;

Parameters linear(std::uint64_t v, std::uint64_t k) { return {v, k, 1, Kind::linear, 2}; }

TEST(ChainedCyclic, HasABlockLessThanTheCircularOne) {
  for (std::uint64_t k = 3; k <= 60; ++k) {
    for (std::uint64_t v = k + 1; v <= 4 * k + 2; ++v) {
      const auto offer = offer_of("chained-cyclic", linear(v, k));
      ASSERT_EQ(offer.has_value(), k >= 4 && v == 4 * k - 3) << v << ' ' << k;
      if (offer) {
        EXPECT_EQ(offer->b, 8 * k - 7);
        expect_as_promised(*offer);
      }
    }
  }
  expect_spoilt_recipes_refused(offer_of("chained-cyclic", linear(37, 10))->recipe);
}

}  // namespace
}  // namespace changeover::chained_cyclic_test
