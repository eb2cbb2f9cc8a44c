#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/best_known.hpp"
#include "changeover/verify/difference.hpp"
#include "construct/tools/stretched_lists.hpp"
#include "construction_checks.hpp"

namespace changeover::stretched_orbits_test {
namespace {

using namespace test;

// The number `stretches` of times that a list is stretched.
Parameters parameters(const StretchedList& list, std::uint64_t stretches) {
  return circular_single_change(list.g * (list.n + 2 * list.h * stretches), list.k());
}

// The three conditions of Theorem 30, from the blocks as they are written.
TEST(StretchedOrbits, ListsCoverEachDifferenceOnce) {
  for (const StretchedList& list : stretched_lists()) {
    const auto most = static_cast<std::int64_t>((list.n - 1) / 2);
    const auto is_in = [](const std::vector<OrbitPoint>& block, const OrbitPoint& point) {
      return std::ranges::find(block, point) != block.end();
    };
    std::vector<OrbitPoint> before = list.blocks.back();
    for (OrbitPoint& point : before) {
      --point.residue;
    }
    for (std::uint64_t orbit = 0; orbit < list.g; ++orbit) {
      for (std::int64_t i = 0; i < static_cast<std::int64_t>(list.h); ++i) {
        EXPECT_TRUE(is_in(before, {i, orbit}) && is_in(list.blocks.front(), {i, orbit}));
      }
    }
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::set<std::int64_t>> differences;
    std::size_t count = 0;
    for (const std::vector<OrbitPoint>& block : list.blocks) {
      ASSERT_EQ(block.size(), list.k());
      std::vector<OrbitPoint> entering;
      std::ranges::copy_if(block, std::back_inserter(entering),
                           [&](const OrbitPoint& point) { return !is_in(before, point); });
      ASSERT_EQ(entering.size(), 1U);
      for (const OrbitPoint& point : block) {
        if (point == entering.front()) {
          continue;
        }
        auto [a, b] = std::pair(entering.front(), point);
        if (a.orbit < b.orbit) {
          std::swap(a, b);
        }
        std::int64_t apart = a.residue - b.residue;
        apart = a.orbit == b.orbit ? std::abs(apart) : apart;
        EXPECT_LE(std::abs(apart), most);
        EXPECT_TRUE(a.orbit != b.orbit || apart > 0);
        differences[{a.orbit, b.orbit}].insert(apart);
        ++count;
      }
      before = block;
    }
    std::size_t distinct = 0;
    for (const auto& [orbits, of_them] : differences) {
      distinct += of_them.size();
    }
    EXPECT_EQ(distinct, count);
    EXPECT_EQ(count, (list.n * list.g - 1) * list.g / 2);
  }
}

TEST(StretchedOrbits, AreTightHoweverFarTheyAreStretched) {
  for (const StretchedList& list : stretched_lists()) {
    for (std::uint64_t stretches = 0; stretches < 8; ++stretches) {
      const Parameters p = parameters(list, stretches);
      const auto offer = offer_of("stretched-orbits", p);
      ASSERT_TRUE(offer) << name(p);
      EXPECT_EQ(offer->b * 2 * (p.k - 1), p.v * (p.v - 1));
      EXPECT_TRUE(offer->tight && offer->economical);
      EXPECT_EQ(offer->expansion_set, list.h == 1);
      EXPECT_EQ(lower_bound(p).blocks, offer->b);
      expect_as_promised(*offer);
    }
  }
}

TEST(StretchedOrbits, ServeNothingElse) {
  for (const StretchedList& list : stretched_lists()) {
    const Parameters p = parameters(list, 3);
    for (const std::uint64_t v :
         {p.v - 1, p.v + 1, p.v - list.g, p.v + list.g, list.g * (list.n - 2 * list.h)}) {
      EXPECT_FALSE(offer_of("stretched-orbits", p.on(v))) << v;
    }
    EXPECT_FALSE(offer_of("stretched-orbits", {p.v, p.k, 1, Kind::linear, 2}));
    EXPECT_FALSE(offer_of("stretched-orbits", {p.v, p.k, 2, Kind::circular, 2}));
    expect_spoilt_recipes_refused(offer_of("stretched-orbits", p)->recipe);
  }
}

// SCCD(v, 6) under Theorem 30: classes modulo 10.
TEST(StretchedOrbits, MakeCircularDesignsWithSixElementsInABlockOneOverAtMost) {
  const std::set<std::uint64_t> minimum{1, 2, 5, 6, 7};
  for (std::uint64_t v = 161; v <= 340; ++v) {
    const Parameters p = circular_single_change(v, 6);
    const auto offer = best_known(standard(), p);
    ASSERT_TRUE(offer);
    EXPECT_EQ(offer->b - lower_bound(p).blocks, minimum.contains(v % 10) ? 0U : 1U) << v;
  }
}

TEST(StretchedOrbits, HaveACertificateForAMillionElements) {
  const Parameters p = circular_single_change(1'000'005, 6);
  const auto offer = offer_of("stretched-orbits", p);
  ASSERT_TRUE(offer);
  auto base = construction("stretched-orbits").orbit_base_blocks(offer->recipe);
  ASSERT_TRUE(base);
  const DifferenceVerdict verdict = verify_differences(base->base, base->automorphism);
  EXPECT_TRUE(verdict.valid() && verdict.tight);
  EXPECT_EQ(verdict.b, offer->b);

  const auto source = standard().build(offer->recipe);
  Block block(6);
  for (std::size_t i = 0; i < 2000; ++i) {
    ASSERT_TRUE(source->next(block));
    ASSERT_EQ(block, base->base.blocks[i]);
  }
  Element& point = base->base.blocks[1000].back();
  point = point % 200'001 == 0 ? point + 1 : point - 1;
  EXPECT_FALSE(verify_differences(base->base, base->automorphism).valid());
}

}  // namespace
}  // namespace changeover::stretched_orbits_test
