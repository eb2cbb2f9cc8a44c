// Tight circular single-change designs without some neighbours: closed-up-cyclic and substituted-cyclic.
#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "construction_checks.hpp"

namespace changeover::cyclic_without_neighbours_test {
namespace {

using namespace test;

Parameters parameters(std::uint64_t v, std::uint64_t k, Kind kind = Kind::circular) {
  return {v, k, 1, kind, 2};
}

// The c and r of v = 2c(k−1)+1−r, 0 ≤ r < 2(k−1).
struct Place {
  std::uint64_t c = 0;
  std::uint64_t r = 0;
};

Place place_of(std::uint64_t v, std::uint64_t k) {
  Place place;
  while (2 * place.c * (k - 1) + 1 < v) {
    ++place.c;
  }
  place.r = 2 * place.c * (k - 1) + 1 - v;
  return place;
}

bool closes_up(const Place& place, std::uint64_t k) {
  return place.r > 0 && (place.c > 2 || (place.c == 2 && place.r < k));
}

bool has_substitutes(const Place& place, std::uint64_t k) {
  return place.r > 0 && place.r < k && place.c > 2;
}

template <typename Check>
void for_each_v(std::uint64_t k_to, std::uint64_t windows, const Check& check) {
  for (std::uint64_t k = 3; k <= k_to; ++k) {
    for (std::uint64_t v = 2 * k + 1; v <= 2 * windows * (k - 1) + 1; ++v) {
      check(v, k, place_of(v, k));
    }
  }
}

TEST(ClosedUpCyclic, IsAsPromisedOverAllOfItsGaps) {
  for_each_v(9, 5, [](std::uint64_t v, std::uint64_t k, const Place& place) {
    for (const Kind kind : {Kind::circular, Kind::linear}) {
      const auto offer = offer_of("closed-up-cyclic", parameters(v, k, kind));
      ASSERT_EQ(offer.has_value(), closes_up(place, k)) << v << ' ' << k;
      if (offer) {
        EXPECT_EQ(offer->b + (kind == Kind::linear ? 1 : 0),
                  place.c * (v + place.r) - (place.c + 1) * place.r);
        expect_as_promised(*offer);
      }
    }
  });
}

TEST(ClosedUpCyclic, IsTwoOverTheBoundBelowFourTimesTheBlockSize) {
  for (std::uint64_t k = 8; k <= 48; ++k) {
    for (std::uint64_t v = 3 * k - 2; v + 7 <= 4 * k; ++v) {
      const auto offer = offer_of("closed-up-cyclic", parameters(v, k));
      ASSERT_TRUE(offer);
      EXPECT_EQ(offer->b, 3 * v - 4 * k + 3);
      EXPECT_LE(offer->b, lower_bound(parameters(v, k)).blocks + 2);
      EXPECT_TRUE(verify(*standard().build(offer->recipe)).valid()) << v << ' ' << k;
    }
  }
}

TEST(SubstitutedCyclic, IsAsPromisedOverAllOfItsGaps) {
  for_each_v(8, 6, [](std::uint64_t v, std::uint64_t k, const Place& place) {
    for (const Kind kind : {Kind::circular, Kind::linear}) {
      const auto offer = offer_of("substituted-cyclic", parameters(v, k, kind));
      ASSERT_EQ(offer.has_value(), has_substitutes(place, k)) << v << ' ' << k;
      if (offer) {
        EXPECT_EQ(offer->b + (kind == Kind::linear ? 1 : 0),
                  place.c * (v + place.r) - 2 * (place.c - 1) * place.r);
        expect_as_promised(*offer);
      }
    }
  });
}

TEST(CyclicWithoutNeighbours, LargeOnesAreValid) {
  for (const auto& [v, k] :
       {std::pair<std::uint64_t, std::uint64_t>{285, 30}, {265, 30}, {320, 17}}) {
    for (const char* name : {"closed-up-cyclic", "substituted-cyclic"}) {
      for (const Kind kind : {Kind::circular, Kind::linear}) {
        const auto offer = offer_of(name, parameters(v, k, kind));
        ASSERT_TRUE(offer) << name << ' ' << v;
        EXPECT_TRUE(verify(*standard().build(offer->recipe)).valid());
      }
    }
  }
}

TEST(CyclicWithoutNeighbours, RefuseSpoiltRecipes) {
  for (const char* name : {"closed-up-cyclic", "substituted-cyclic"}) {
    expect_spoilt_recipes_refused(offer_of(name, parameters(17, 4))->recipe,
                                  {.any_v = true, .any_kind = true});
  }
  EXPECT_FALSE(offer_of("closed-up-cyclic", parameters(25, 7)));
  EXPECT_FALSE(offer_of("closed-up-cyclic", parameters(18, 7)));
  EXPECT_FALSE(offer_of("substituted-cyclic", parameters(22, 7)));
  EXPECT_FALSE(offer_of("substituted-cyclic", parameters(30, 7)));
}

}  // namespace
}  // namespace changeover::cyclic_without_neighbours_test
