#include <gtest/gtest.h>

#include <algorithm>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"

namespace changeover::relayed_cyclic_test {
namespace {

using namespace test;

Parameters circular(std::uint64_t v, std::uint64_t k, std::uint64_t m = 1) {
  return {v, k, m, Kind::circular, 2};
}

// All that there is: t carriers at a time, and what is left is cyclic.
TEST(RelayedCyclic, IsAsPromisedForSingleChange) {
  std::size_t served = 0;
  for (std::uint64_t k = 4; k <= 12; ++k) {
    for (std::uint64_t v = k + 1; v <= 6 * k; ++v) {
      bool possible = false;
      std::uint64_t least = ~std::uint64_t{0};
      for (std::uint64_t t = 2; t + 2 <= k && v + 1 > k + t; ++t) {
        const std::uint64_t u = v - 2 * t + 1;
        const std::uint64_t n = k - t - 1;
        if (u % (2 * n) == 1 && u > 2 * n && u >= 2 * t - 1) {
          possible = true;
          least = std::min(least, u / (2 * n) * u + 2 * t - 1);
        }
      }
      const auto offer = offer_of("relayed-cyclic", circular(v, k));
      ASSERT_EQ(offer.has_value(), possible) << v << ' ' << k;
      if (offer) {
        ++served;
        EXPECT_EQ(offer->b, least);
        expect_as_promised(*offer);
      }
    }
  }
  EXPECT_GT(served, 100U);
}

TEST(RelayedCyclic, IsAsPromisedForOtherChangeNumbers) {
  std::array<std::size_t, 4> served{};
  for (std::uint64_t m = 2; m <= 3; ++m) {
    for (std::uint64_t k = 3 * m; k <= 14; ++k) {
      for (std::uint64_t v = k + m; v <= 70; ++v) {
        if (const auto offer = offer_of("relayed-cyclic", circular(v, k, m))) {
          ++served.at(m);
          expect_as_promised(*offer);
        }
      }
    }
  }
  EXPECT_GT(served[2], 20U);
  EXPECT_GT(served[3], 3U);
}

TEST(RelayedCyclic, IsFourOverTheBoundBelowFourTimesTheBlockSize) {
  for (std::uint64_t k = 6; k <= 40; ++k) {
    for (std::uint64_t v = 3 * k - k % 2; v <= 4 * k - 8; v += 2) {
      const auto offer = offer_of("relayed-cyclic", circular(v, k));
      ASSERT_TRUE(offer) << v << ' ' << k;
      EXPECT_LE(offer->b, 3 * v - 4 * k + 5);
      EXPECT_TRUE(verify(*standard().build(offer->recipe)).valid()) << v << ' ' << k;
    }
  }
}

TEST(RelayedCyclic, RefusesSpoiltRecipes) {
  const auto offer = offer_of("relayed-cyclic", circular(24, 8));
  ASSERT_TRUE(offer);
  expect_spoilt_recipes_refused(offer->recipe);
  Recipe other = offer->recipe;
  other.inputs.front() = Recipe{"literal", other.inputs.front().parameters, {}, {}, {{0, 1}}, {}};
  expect_refused(other, "an input that is not cyclic");
}

TEST(RelayedCyclic, HasCarriersThatStayOnce) {
  const auto offer = offer_of("relayed-cyclic", circular(24, 8));
  ASSERT_TRUE(offer);
  const Verdict verdict = verify(*standard().build(offer->recipe));
  const std::uint64_t u = offer->recipe.inputs.front().parameters.v;
  for (std::uint64_t x = u; x < 24; ++x) {
    EXPECT_EQ(verdict.elements[x].introductions, 1U);
  }
}

}  // namespace
}  // namespace changeover::relayed_cyclic_test
