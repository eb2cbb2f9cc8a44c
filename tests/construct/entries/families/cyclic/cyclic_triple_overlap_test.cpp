#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/verify/difference.hpp"
#include "construction_checks.hpp"

namespace changeover::cyclic_triple_overlap_test {
namespace {

using namespace test;

Parameters parameters(std::uint64_t c, std::uint64_t k) {
  return {6 * c * (k - 2), k, 3, Kind::circular, 2};
}

const Construction& maker() { return construction("cyclic-triple-overlap"); }

// c blocks more than the counting bound; minimum if k ≡ 1 (mod 3), for then no design has fewer.
TEST(CyclicTripleOverlap, IsAsNearTheBoundAsItCanBe) {
  for (const std::uint64_t c : {1U, 4U, 5U, 8U, 9U, 12U, 13U}) {
    for (std::uint64_t k = 4; k <= 16; ++k) {
      const Parameters p = parameters(c, k);
      const auto offer = offer_of("cyclic-triple-overlap", p);
      ASSERT_TRUE(offer) << name(p);
      EXPECT_EQ(offer->b, c * p.v);
      EXPECT_FALSE(offer->tight || offer->economical);
      if (k % 3 == 1 && p.v <= 400) {
        EXPECT_EQ(lower_bound(p).blocks, offer->b) << name(p);
      }
      if (c * k <= 60) {
        expect_as_promised(*offer);
      }
    }
  }
}

// Each element meets the opposite one twice, and each other once.
TEST(CyclicTripleOverlap, CoversOppositePairsTwice) {
  const auto offer = offer_of("cyclic-triple-overlap", parameters(4, 6));
  ASSERT_TRUE(offer);
  const Verdict verdict = verify(*standard().build(offer->recipe));
  EXPECT_TRUE(verdict.valid());
  EXPECT_EQ(verdict.excess, 48);
}

// Two base blocks for every k: three blocks more than the counting bound.
TEST(CyclicTripleOverlap, OfTwoBaseBlocksCoversOneDifferenceTwice) {
  for (std::uint64_t k = 5; k <= 30; ++k) {
    const Parameters p{12 * (k - 2) - 1, k, 3, Kind::circular, 2};
    const auto offer = offer_of("cyclic-triple-overlap", p);
    ASSERT_TRUE(offer) << name(p);
    const std::uint64_t pairs = p.v * (p.v - 1) / 2;
    EXPECT_EQ(offer->b, (pairs + 3 * k - 7) / (3 * k - 6) + 3) << name(p);
    if (k % 3 == 1) {
      EXPECT_EQ(offer->b, lower_bound(p).blocks) << name(p);
    }
    expect_as_promised(*offer);
    const Verdict verdict = verify(*standard().build(offer->recipe));
    EXPECT_EQ(verdict.excess, static_cast<std::int64_t>(p.v));
  }
}

TEST(CyclicTripleOverlap, CertifiesLargeBlocks) {
  const auto offer = offer_of("cyclic-triple-overlap", parameters(9, 100'003));
  ASSERT_TRUE(offer);
  const DifferenceVerdict verdict =
      verify_differences(*maker().interval_base_blocks(offer->recipe));
  EXPECT_TRUE(verdict.valid());
  EXPECT_FALSE(verdict.tight);
  EXPECT_EQ(verdict.b, offer->b);
}

TEST(CyclicTripleOverlap, ServesNothingElse) {
  const Parameters p = parameters(5, 7);
  EXPECT_FALSE(offer_of("cyclic-triple-overlap", p.on(p.v + 1)));
  EXPECT_FALSE(offer_of("cyclic-triple-overlap", {p.v, 7, 3, Kind::linear, 2}));
  EXPECT_FALSE(offer_of("cyclic-triple-overlap", {p.v, 7, 2, Kind::circular, 2}));
  EXPECT_FALSE(offer_of("cyclic-triple-overlap", {p.v, 7, 3, Kind::circular, 3}));
  EXPECT_FALSE(offer_of("cyclic-triple-overlap", parameters(2, 7)));
  EXPECT_FALSE(offer_of("cyclic-triple-overlap", parameters(3, 7)));
  EXPECT_TRUE(offer_of("cyclic-triple-overlap", parameters(3, 6)));
  EXPECT_FALSE(offer_of("cyclic-triple-overlap", parameters(5, 3)));
  expect_spoilt_recipes_refused(offer_of("cyclic-triple-overlap", p)->recipe, {.any_v = true});
}

}  // namespace
}  // namespace changeover::cyclic_triple_overlap_test
