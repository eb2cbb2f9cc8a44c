#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/verify/difference.hpp"
#include "construction_checks.hpp"

namespace changeover::cyclic_half_test {
namespace {

using namespace test;

Parameters parameters(std::uint64_t c, std::uint64_t k) {
  return {c * (4 * k - 6), k, 2, Kind::circular, 2};
}

TEST(CyclicHalf, IsMinimum) {
  for (std::uint64_t k = 5; k <= 11; k += 2) {
    for (std::uint64_t c = 1; c <= 13; ++c) {
      const Parameters p = parameters(c, k);
      const auto offer = offer_of("cyclic-half", p);
      ASSERT_EQ(offer.has_value(), c % 4 < 2) << name(p);
      if (offer) {
        EXPECT_EQ(offer->b, c * p.v);
        EXPECT_EQ(lower_bound(p).blocks, offer->b);
        EXPECT_FALSE(offer->tight || offer->economical);
        if (c <= 5) {
          expect_as_promised(*offer);
        }
      }
    }
  }
}

// Each element meets the opposite one twice, and each other once.
TEST(CyclicHalf, CoversOppositePairsTwice) {
  const auto offer = offer_of("cyclic-half", parameters(4, 5));
  ASSERT_TRUE(offer);
  const std::unique_ptr<BlockSource> source = standard().build(offer->recipe);
  const Verdict verdict = verify(*source);
  EXPECT_TRUE(verdict.valid());
  EXPECT_EQ(verdict.excess, 28);
}

TEST(CyclicHalf, ServesNothingElse) {
  const Parameters p = parameters(5, 7);
  EXPECT_FALSE(offer_of("cyclic-half", p.on(p.v + 1)));
  EXPECT_FALSE(offer_of("cyclic-half", p.on(p.v - 2)));
  EXPECT_FALSE(offer_of("cyclic-half", {p.v, 7, 2, Kind::linear, 2}));
  EXPECT_FALSE(offer_of("cyclic-half", {p.v, 7, 1, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("cyclic-half", parameters(5, 6)));
  EXPECT_FALSE(offer_of("cyclic-half", parameters(5, 3)));
  expect_spoilt_recipes_refused(offer_of("cyclic-half", p)->recipe);
}

TEST(CyclicHalf, HasACertificateForAMillionElements) {
  const Parameters p = parameters(71'429, 5);
  ASSERT_GT(p.v, 1'000'000U);
  const auto offer = offer_of("cyclic-half", p);
  ASSERT_TRUE(offer);
  const auto base = construction("cyclic-half").interval_base_blocks(offer->recipe);
  ASSERT_TRUE(base);
  const DifferenceVerdict verdict = verify_differences(*base);
  EXPECT_TRUE(verdict.valid());
  EXPECT_FALSE(verdict.tight);
  EXPECT_EQ(verdict.b, offer->b);
}

}  // namespace
}  // namespace changeover::cyclic_half_test
