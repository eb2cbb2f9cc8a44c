#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/best_known.hpp"
#include "changeover/verify/difference.hpp"
#include "construction_checks.hpp"

namespace changeover::two_orbits_test {
namespace {

using namespace test;

Parameters parameters(std::uint64_t k, std::uint64_t j) {
  return {(2 * k - 3) * (4 * j + 1) + 1, k, 2, Kind::circular, 2};
}

TEST(TwoOrbits, AreTightForEveryEvenBlockSize) {
  for (std::uint64_t k = 4; k <= 16; k += 2) {
    for (std::uint64_t j = 2; parameters(k, j).v <= 400; ++j) {
      const Parameters p = parameters(k, j);
      const auto offer = offer_of("two-orbits", p);
      ASSERT_TRUE(offer) << name(p);
      EXPECT_EQ(offer->b * 2 * (2 * k - 3), p.v * (p.v - 1));
      EXPECT_TRUE(offer->tight && offer->economical);
      EXPECT_EQ(offer->expansion_set, (2 * j + 1) % (k / 2 - 1) == 0) << name(p);
      EXPECT_EQ(lower_bound(p).blocks, offer->b);
      if (p.v <= 130) {
        expect_as_promised(*offer);
      }
    }
  }
}

// All differences at once, for each way in which the places are paired.
TEST(TwoOrbits, AreTightForEveryNumberOfBaseBlocks) {
  for (std::uint64_t k = 4; k <= 10; k += 2) {
    for (std::uint64_t j = 2; j <= 150; ++j) {
      const auto offer = offer_of("two-orbits", parameters(k, j));
      ASSERT_TRUE(offer);
      auto base = construction("two-orbits").orbit_base_blocks(offer->recipe);
      ASSERT_TRUE(base);
      const DifferenceVerdict verdict = verify_differences(base->base, base->automorphism);
      ASSERT_TRUE(verdict.valid() && verdict.tight) << k << ' ' << j;
      EXPECT_EQ(verdict.b, offer->b);
    }
  }
}

TEST(TwoOrbits, ServeNothingElse) {
  const Parameters p = parameters(6, 3);
  for (const std::uint64_t v : {p.v - 1, p.v + 1, p.v - 9, p.v + 9, p.v + 18, std::uint64_t{10}}) {
    EXPECT_FALSE(offer_of("two-orbits", p.on(v))) << v;
  }
  EXPECT_FALSE(offer_of("two-orbits", parameters(6, 0)));
  EXPECT_FALSE(offer_of("two-orbits", parameters(6, 1)));
  for (std::uint64_t odd = 3; odd <= 9; odd += 2) {
    EXPECT_FALSE(offer_of("two-orbits", parameters(odd, 3)));
  }
  EXPECT_FALSE(offer_of("two-orbits", {p.v, p.k, 2, Kind::linear, 2}));
  EXPECT_FALSE(offer_of("two-orbits", {p.v, p.k, 1, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("two-orbits", {p.v, p.k, 2, Kind::circular, 3}));
  expect_spoilt_recipes_refused(offer_of("two-orbits", p)->recipe);
}

// The corollary of Theorem 31: the pairs {i} of the two orbits partition the elements.
TEST(TwoOrbits, ExpandToTightDesignsOfThirtyMoreAndMore) {
  for (std::uint64_t j = 2; j <= 6; ++j) {
    const Parameters p{30 * j + 10, 4, 2, Kind::circular, 2};
    const auto offer = best_known(standard(), p);
    ASSERT_TRUE(offer);
    EXPECT_TRUE(offer->tight) << name(p);
    EXPECT_EQ(offer->b * 10, p.v * (p.v - 1));
    EXPECT_TRUE(verify(*standard().build(offer->recipe)).valid());
  }
}

TEST(TwoOrbits, HaveACertificateForAMillionElements) {
  const Parameters p = parameters(4, 50'000);
  const auto offer = offer_of("two-orbits", p);
  ASSERT_TRUE(offer);
  auto base = construction("two-orbits").orbit_base_blocks(offer->recipe);
  ASSERT_TRUE(base);
  const DifferenceVerdict verdict = verify_differences(base->base, base->automorphism);
  EXPECT_TRUE(verdict.valid() && verdict.tight);
  EXPECT_EQ(verdict.b, offer->b);
  std::swap(base->base.blocks.back(), base->base.blocks.front());
  EXPECT_FALSE(verify_differences(base->base, base->automorphism).valid());
}

}  // namespace
}  // namespace changeover::two_orbits_test
