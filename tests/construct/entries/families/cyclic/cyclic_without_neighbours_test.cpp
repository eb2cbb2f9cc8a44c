// Tight circular single-change designs without some neighbours: chained-visits, closed-up-cyclic,
// even-visits, substituted-cyclic.
#include <gtest/gtest.h>

#include <algorithm>

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

TEST(EvenVisits, IsAsPromisedOverAllOfItsGaps) {
  std::size_t built = 0;
  for_each_v(10, 6, [&](std::uint64_t v, std::uint64_t k, const Place& place) {
    for (const Kind kind : {Kind::circular, Kind::linear}) {
      const auto offer = offer_of("even-visits", parameters(v, k, kind));
      ASSERT_EQ(offer.has_value(), place.c >= 2 && place.r > 0 && place.r < k) << v << ' ' << k;
      if (offer) {
        EXPECT_EQ(offer->b + (kind == Kind::linear ? 1 : 0),
                  place.c * (v + place.r) - (2 * place.c - 1) * place.r);
        expect_as_promised(*offer);
        ++built;
      }
    }
  });
  EXPECT_EQ(built, 2U * 5U * (2 + 3 + 4 + 5 + 6 + 7 + 8 + 9));  // K values of r for each c
}

// The m-th part of the blocks of the single-change list, rounded up.
TEST(EvenVisits, UnionsAreAsPromisedForEveryChangeNumber) {
  std::size_t built = 0;
  for (std::uint64_t m = 2; m <= 5; ++m) {
    for (std::uint64_t k = m + 2; k <= 3 * m + 3; ++k) {
      const std::uint64_t small_k = k - m + 1;
      for (std::uint64_t v = 2 * small_k + 1; v <= 8 * (small_k - 1) + 1; ++v) {
        const Place place = place_of(v, small_k);
        for (const Kind kind : {Kind::circular, Kind::linear}) {
          const auto offer = offer_of("even-visits", {v, k, m, kind, 2});
          ASSERT_EQ(offer.has_value(),
                    place.c >= 2 && place.r > 0 && place.r < small_k && small_k > 2 * m)
              << v << ' ' << k << ' ' << m;
          if (offer) {
            const auto single = offer_of("even-visits", parameters(v, small_k, kind));
            ASSERT_TRUE(single);
            EXPECT_EQ(offer->b, (single->b + m - 1) / m);
            expect_as_promised(*offer);
            ++built;
          }
        }
      }
    }
  }
  EXPECT_GT(built, 500U);
}

TEST(ChainedVisits, UnionsAreAsPromisedForEveryChangeNumber) {
  std::size_t built = 0;
  for (std::uint64_t m = 2; m <= 6; ++m) {
    for (std::uint64_t big = 2 * m; big <= std::max<std::uint64_t>(9, 2 * m + 1); ++big) {
      for (std::uint64_t v = 4 * big + 2; v <= 12 * big + 1; ++v) {
        const Parameters p{v, big + m, m, Kind::linear, 2};
        const auto offer = offer_of("chained-visits", p);
        const auto single = offer_of("chained-visits", parameters(v, big + 1, Kind::linear));
        ASSERT_EQ(offer.has_value(), single.has_value()) << v << ' ' << big << ' ' << m;
        if (offer) {
          EXPECT_EQ(offer->b, (single->b + m - 1) / m);
          expect_as_promised(*offer);
          ++built;
        }
      }
    }
  }
  EXPECT_GT(built, 400U);  // among them all that the proof leaves to be looked through
}

TEST(EvenVisits, SupersedesWhatSavesLessForEachElement) {
  for_each_v(16, 5, [](std::uint64_t v, std::uint64_t k, const Place& place) {
    const auto even = offer_of("even-visits", parameters(v, k));
    if (even && place.c >= 3) {
      EXPECT_LT(even->b, offer_of("closed-up-cyclic", parameters(v, k))->b);
      EXPECT_LT(even->b, offer_of("substituted-cyclic", parameters(v, k))->b);
    }
    // One and two elements fewer than the tight design: one block over the bound.
    if (even && place.r <= 2) {
      EXPECT_EQ(even->b, (v * (v - 1) / 2 + k - 2) / (k - 1) + 1) << v << ' ' << k;
    }
  });
}

TEST(ChainedVisits, HaveOneBlockFewerThanEvenVisits) {
  std::size_t built = 0;
  for_each_v(24, 8, [&](std::uint64_t v, std::uint64_t k, const Place& place) {
    EXPECT_FALSE(offer_of("chained-visits", parameters(v, k)));
    const auto offer = offer_of("chained-visits", parameters(v, k, Kind::linear));
    ASSERT_EQ(offer.has_value(), place.r >= 2 && (place.c >= 5 ? place.r < k : place.r + 1 < k) &&
                                     (place.c >= 4 ? k >= 4 : place.c == 3 && k >= 5))
        << v << ' ' << k;
    if (offer) {
      EXPECT_EQ(offer->b + 1, offer_of("even-visits", parameters(v, k, Kind::linear))->b);
      if (k <= 10) {
        expect_as_promised(*offer);
      } else {
        EXPECT_TRUE(verify(*standard().build(offer->recipe)).valid()) << v << ' ' << k;
      }
      ++built;
    }
  });
  // K-2 values of r for c = 3, from K = 4 on, and c = 4; K-1 for each c from 5 to 8.
  EXPECT_EQ(built, 2U * 22U * 21U / 2U - 1U + 4U * (23U * 22U / 2U - 1U));
}

TEST(CyclicWithoutNeighbours, LargeOnesAreValid) {
  for (const auto& [v, k] :
       {std::pair<std::uint64_t, std::uint64_t>{285, 30}, {265, 30}, {320, 17}}) {
    for (const char* name : {"closed-up-cyclic", "even-visits", "substituted-cyclic"}) {
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
  for (const Parameters& p : {Parameters{44, 7, 1, Kind::linear, 2}, {27, 7, 2, Kind::linear, 2}}) {
    expect_spoilt_recipes_refused(offer_of("even-visits", p)->recipe,
                                  {.any_v = true, .any_kind = true});
  }
  for (const Parameters& p : {Parameters{34, 7, 1, Kind::linear, 2},
                              {45, 7, 1, Kind::linear, 2},
                              {66, 8, 1, Kind::linear, 2},
                              {40, 9, 2, Kind::linear, 2}}) {
    expect_spoilt_recipes_refused(offer_of("chained-visits", p)->recipe, {.any_v = true});
  }
  EXPECT_FALSE(offer_of("even-visits", {39, 7, 4, Kind::linear, 2}));  // K < 2m
  EXPECT_FALSE(offer_of("closed-up-cyclic", parameters(25, 7)));
  EXPECT_FALSE(offer_of("closed-up-cyclic", parameters(18, 7)));
  EXPECT_FALSE(offer_of("substituted-cyclic", parameters(22, 7)));
  EXPECT_FALSE(offer_of("substituted-cyclic", parameters(30, 7)));
}

}  // namespace
}  // namespace changeover::cyclic_without_neighbours_test
