#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/verify/difference.hpp"
#include "construct/tools/tournament_lists.hpp"
#include "construction_checks.hpp"

namespace changeover::tournament_orbits_test {
namespace {

using namespace test;

Parameters parameters(const TournamentList& list, std::uint64_t n) {
  return {list.orbits() * n, list.k, 2, Kind::circular, 2};
}

std::vector<OrbitBlock> kept_sets(const TournamentList& list) {
  std::vector<OrbitBlock> kept;
  OrbitBlock before = list.blocks.back();
  for (OrbitPoint& point : before) {
    point.residue -= list.shift;
  }
  for (const OrbitBlock& block : list.blocks) {
    std::ranges::copy_if(block, std::back_inserter(kept.emplace_back()), [&](const auto& point) {
      return std::ranges::find(before, point) != before.end();
    });
    before = block;
  }
  return kept;
}

// The conditions of Theorem 32, from the blocks as they are written.
TEST(TournamentOrbits, ListsLeaveWhatPasses) {
  for (const TournamentList& list : tournament_lists()) {
    const std::uint64_t g = list.orbits();
    const auto beats = [&](std::uint64_t c, std::uint64_t o) {
      const std::uint64_t ahead = (o + g - c) % g;
      return ahead >= 1 && ahead <= list.k - 2;
    };
    const std::vector<OrbitBlock> kept = kept_sets(list);
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::multiset<std::int64_t>> apart;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      ASSERT_EQ(list.blocks[i].size(), list.k);
      ASSERT_EQ(kept[i].size(), list.k - 2);
      for (auto a = list.blocks[i].begin(); a != list.blocks[i].end(); ++a) {
        for (auto b = std::next(a); b != list.blocks[i].end(); ++b) {
          const auto was_there = [&](const OrbitPoint& point) {
            return std::ranges::find(kept[i], point) != kept[i].end();
          };
          if (was_there(*a) && was_there(*b)) {
            continue;
          }
          ASSERT_LT(std::max(a->orbit, b->orbit), g);
          const auto& [from, to] =
              beats(b->orbit, a->orbit) ? std::pair(*b, *a) : std::pair(*a, *b);
          const std::int64_t difference = from.residue - to.residue;
          apart[{from.orbit, to.orbit}].insert(from.orbit == to.orbit ? std::abs(difference)
                                                                      : difference);
        }
      }
    }
    for (const Passage& passage : list.passages) {
      const std::uint64_t c = passage.orbit;
      std::multiset<std::int64_t> even;
      for (std::int64_t x = 1; x < passage.from; ++x) {
        even.insert(2 * x);
      }
      EXPECT_EQ((apart[{c, c}]), even);
      std::set<std::uint64_t> beaten;
      for (const OrbitPoint& point : kept[passage.before]) {
        ASSERT_TRUE(beats(c, point.orbit));
        beaten.insert(point.orbit);
        std::multiset<std::int64_t> middle;
        for (std::int64_t x = 1 - passage.from; x < passage.from; ++x) {
          middle.insert(passage.centre - point.residue + x);
        }
        EXPECT_EQ((apart[{c, point.orbit}]), middle);
      }
      EXPECT_EQ(beaten.size(), list.k - 2);
      EXPECT_LE(2 * passage.from - 1, static_cast<std::int64_t>(list.least));
    }
    EXPECT_EQ(list.passages.size(), g);
  }
}

TEST(TournamentOrbits, AreTightForEveryOddNumber) {
  for (const TournamentList& list : tournament_lists()) {
    for (std::uint64_t n = list.least; n <= 61; n += 2) {
      const Parameters p = parameters(list, n);
      const auto offer = offer_of("tournament-orbits", p);
      ASSERT_TRUE(offer) << name(p);
      EXPECT_EQ(offer->b * 2 * (2 * p.k - 3), p.v * (p.v - 1));
      EXPECT_TRUE(offer->tight && offer->economical);
      EXPECT_EQ(lower_bound(p).blocks, offer->b);
      if (n <= 25) {
        expect_as_promised(*offer);
      }
    }
  }
}

TEST(TournamentOrbits, ServeNothingElse) {
  for (const TournamentList& list : tournament_lists()) {
    const Parameters p = parameters(list, 11);
    for (const std::uint64_t v : {p.v - 1, p.v + 2, p.v - list.orbits(), p.v + list.orbits(),
                                  list.orbits() * (list.least - 2)}) {
      EXPECT_FALSE(offer_of("tournament-orbits", p.on(v))) << v;
    }
    EXPECT_FALSE(offer_of("tournament-orbits", {p.v, p.k, 2, Kind::linear, 2}));
    EXPECT_FALSE(offer_of("tournament-orbits", {p.v, p.k, 1, Kind::circular, 2}));
    EXPECT_FALSE(offer_of("tournament-orbits", {p.v, p.k + 1, 2, Kind::circular, 2}));
    expect_spoilt_recipes_refused(offer_of("tournament-orbits", p)->recipe);
  }
}

TEST(TournamentOrbits, HaveACertificateForAMillionElements) {
  const Parameters p{1'000'005, 4, 2, Kind::circular, 2};
  const auto offer = offer_of("tournament-orbits", p);
  ASSERT_TRUE(offer);
  auto base = construction("tournament-orbits").orbit_base_blocks(offer->recipe);
  ASSERT_TRUE(base);
  const DifferenceVerdict verdict = verify_differences(base->base, base->automorphism);
  EXPECT_TRUE(verdict.valid() && verdict.tight);
  EXPECT_EQ(verdict.b, offer->b);
  const auto source = standard().build(offer->recipe);
  Block block(4);
  for (std::size_t i = 0; i < 2000; ++i) {
    ASSERT_TRUE(source->next(block));
    ASSERT_EQ(block, base->base.blocks[i]);
  }
  std::swap(base->base.blocks.front(), base->base.blocks.back());
  EXPECT_FALSE(verify_differences(base->base, base->automorphism).valid());
}

}  // namespace
}  // namespace changeover::tournament_orbits_test
