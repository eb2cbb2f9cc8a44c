// The states of local search against a count from scratch and against the definition.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

#include "changeover/core/design.hpp"
#include "core/sorted.hpp"
#include "naive_verdict.hpp"
#include "search/local/anneal.hpp"
#include "search/local/random_list.hpp"
#include "search/local/segment_orbits.hpp"
#include "search/local/segment_pairs.hpp"
#include "search/local/segment_subsets.hpp"

namespace changeover::segment_test {
namespace {

struct Case {
  Parameters parameters;
  std::size_t blocks = 0;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (const auto& [v, k, m, b] : std::vector<std::array<std::uint64_t, 4>>{{5, 3, 1, 8},
                                                                              {5, 3, 2, 7},
                                                                              {7, 2, 1, 20},
                                                                              {8, 5, 3, 6},
                                                                              {9, 4, 2, 12},
                                                                              {12, 6, 1, 15},
                                                                              {16, 5, 2, 20},
                                                                              {17, 5, 4, 9},
                                                                              {20, 6, 2, 25},
                                                                              {33, 5, 2, 30},
                                                                              {49, 4, 1, 40},
                                                                              {70, 6, 2, 40},
                                                                              {4, 3, 1, 3},
                                                                              {6, 2, 2, 9}}) {
      all.push_back({{.v = v, .k = k, .change = m, .kind = kind}, static_cast<std::size_t>(b)});
    }
  }
  return all;
}

// Bad steps of the list, by sets.
std::size_t bad_steps(const Design& design) {
  const std::size_t b = design.block_count();
  const bool circular = design.parameters().kind == Kind::circular;
  std::size_t bad = 0;
  for (std::size_t i = 0; i + (circular ? 0 : 1) < b; ++i) {
    const auto one = design.block(i);
    const std::set<Element> set(one.begin(), one.end());
    std::size_t changes = 0;
    for (const Element x : design.block((i + 1) % b)) {
      changes += set.count(x) == 0 ? 1U : 0U;
    }
    bad += changes != design.parameters().change ? 1U : 0U;
  }
  return bad;
}

template <typename Count>
void expect_counts(const SegmentPairs<Count>& state, const Design& design) {
  std::uint64_t missing = 0;
  for (Element y = 1; y < design.v(); ++y) {
    for (Element x = 0; x < y; ++x) {
      std::uint32_t times = 0;
      for (std::size_t i = 0; i < design.block_count(); ++i) {
        const auto block = design.block(i);
        times +=
            std::count(block.begin(), block.end(), x) * std::count(block.begin(), block.end(), y) >
                    0
                ? 1U
                : 0U;
      }
      ASSERT_EQ(state.count(x, y), times) << x << ' ' << y;
      ASSERT_EQ(state.count(y, x), times) << x << ' ' << y;
      missing += times == 0 ? 1 : 0;
    }
  }
  ASSERT_EQ(state.missing(), missing);
}

// Random moves: each must change missing() by what attempt() was told, keep the change property,
// and leave the counts that a new state of the same blocks has.
template <typename State, typename Check>
void walk(State& state, std::size_t moves, Random& random, Check&& check) {
  for (std::size_t n = 0; n < moves; ++n) {
    const SegmentSwap move = state.missing() > 0 && random.one_in_two()
                                 ? state.propose_aimed(random)
                                 : state.propose(random);
    if (move.length == 0) {
      continue;
    }
    const auto before = static_cast<std::int64_t>(state.missing());
    std::int64_t told = 0;
    const bool wanted = random.below(4) != 0;
    const bool made = state.attempt(move, [&](std::int32_t change) {
      told = change;
      return wanted;
    });
    ASSERT_EQ(made, wanted);
    ASSERT_EQ(static_cast<std::int64_t>(state.missing()), before + (made ? told : 0));
    if (n % 16 == 0) {
      ASSERT_EQ(bad_steps(state.design()), 0U);
    }
    if (n % 64 == 0) {
      ASSERT_NO_FATAL_FAILURE(check(state));
    }
  }
  ASSERT_EQ(bad_steps(state.design()), 0U);
  ASSERT_NO_FATAL_FAILURE(check(state));
}

template <typename Count>
void walk_pairs(const Case& of, std::uint64_t seed, std::size_t& walked) {
  Random random(seed);
  const auto start = random_list(of.parameters, of.blocks, random);
  if (!start) {
    return;  // (6,2) circular with an odd number of blocks, …
  }
  ++walked;
  ASSERT_TRUE(SegmentPairs<Count>::fits(*start));
  SegmentPairs<Count> state(*start);
  walk(state, 3000, random, [](const SegmentPairs<Count>& now) {
    expect_counts(now, now.design());
    const SegmentPairs<Count> fresh(now.design());
    ASSERT_EQ(fresh.missing(), now.missing());
  });
}

TEST(SegmentPairs, CountsWhatACountFromScratchCounts) {
  std::size_t walked = 0;
  for (const Case& of : cases()) {
    SCOPED_TRACE(name(of.parameters));
    ASSERT_NO_FATAL_FAILURE(walk_pairs<std::uint8_t>(of, 1, walked));
    ASSERT_NO_FATAL_FAILURE(walk_pairs<std::uint16_t>(of, 2, walked));
  }
  EXPECT_GE(walked, 2 * cases().size() - 4);
}

TEST(SegmentPairs, PartsStayPartsWhereverTheyGo) {
  std::size_t moved = 0;
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      Random random(seed);
      const Parameters p{.v = 9, .k = 4, .change = 1, .kind = kind};
      const Design start = random_list(p, 16, random).value();
      // Two disjoint sets that stay from one block to the next.
      std::vector<LockedPart> parts;
      for (std::uint32_t i = 0; i + 1 < 16 && parts.size() < 2; ++i) {
        Block stays;
        std::ranges::set_intersection(sorted(start.block(i)), sorted(start.block(i + 1)),
                                      std::back_inserter(stays));
        if (parts.empty() || std::ranges::none_of(stays, [&](Element x) {
              return std::ranges::find(parts[0].elements, x) != parts[0].elements.end();
            })) {
          parts.push_back({stays, i});
        }
      }
      SegmentPairs<std::uint8_t> state(start, 0, {.cells = {}, .parts = parts});
      walk(state, 3000, random, [&](const SegmentPairs<std::uint8_t>& now) {
        for (const LockedPart& part : now.parts()) {
          for (const Element x : part.elements) {
            ASSERT_TRUE(now.contains(part.block, x));
            ASSERT_TRUE(now.contains((part.block + 1) % 16, x));
          }
        }
      });
      for (std::size_t i = 0; i < parts.size(); ++i) {
        ASSERT_EQ(state.parts()[i].elements, parts[i].elements);
        moved += state.parts()[i].block != parts[i].block ? 1U : 0U;
      }
      // What they left is free again: all cells that are locked now belong to them.
      std::size_t free = 0;
      for (int n = 0; n < 200; ++n) {
        free += state.propose(random).length > 0 ? 1U : 0U;
      }
      EXPECT_GT(free, 20U);
    }
  }
  EXPECT_GT(moved, 20U);
}

TEST(SegmentPairs, BytesAndWordsGoTheSameWay) {
  Random random(3);
  const Design start = random_list({.v = 40, .k = 6, .kind = Kind::circular}, 60, random).value();
  SegmentPairs<std::uint8_t> bytes(start);
  SegmentPairs<std::uint16_t> words(start);
  RunControl control({});
  Random one(4);
  Random two(4);
  const AnnealSchedule schedule{.moves = 20'000, .hot = 1.0, .cold = 0.2};
  const AnnealOutcome of_bytes = anneal(bytes, schedule, one, control);
  const AnnealOutcome of_words = anneal(words, schedule, two, control);
  EXPECT_EQ(of_bytes.accepted, of_words.accepted);
  EXPECT_EQ(of_bytes.missing, of_words.missing);
  EXPECT_GT(of_bytes.accepted, 100U);
}

TEST(SegmentPairs, AMoveIsItsOwnInverse) {
  Random random(5);
  const Design start = random_list({.v = 20, .k = 5, .kind = Kind::linear}, 30, random).value();
  SegmentPairs<std::uint8_t> state(start);
  int moves = 0;
  for (int n = 0; n < 500; ++n) {
    const SegmentSwap move = state.propose(random);
    if (move.length > 0) {
      const std::uint64_t before = state.missing();
      state.apply(move);
      state.apply(move);
      ASSERT_EQ(state.missing(), before);
      ++moves;
    }
  }
  EXPECT_GT(moves, 100);
  const Design end = state.design();
  for (std::size_t i = 0; i < start.block_count(); ++i) {
    const auto one = start.block(i);
    const auto two = end.block(i);
    EXPECT_EQ(std::set<Element>(one.begin(), one.end()), std::set<Element>(two.begin(), two.end()));
  }
}

TEST(SegmentPairs, LeavesFrozenBlocksAlone) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    Random random(6);
    const Design start = random_list({.v = 15, .k = 4, .kind = kind}, 20, random).value();
    SegmentPairs<std::uint8_t> state(start, 7);
    walk(state, 3000, random, [&](const SegmentPairs<std::uint8_t>& now) {
      for (std::uint32_t i = 0; i < 7; ++i) {
        const auto was = start.block(i);
        const auto is = now.block(i);
        ASSERT_TRUE(std::equal(was.begin(), was.end(), is.begin(), is.end()));
      }
    });
  }
}

TEST(SegmentPairs, RefusesMovesThatWouldOverflowACounter) {
  // Element 0 is in 255 blocks of 300: no move may bring it into more.
  Random random(7);
  Parameters p{.v = 8, .k = 3, .change = 1};
  Design start(p);
  for (Element i = 0; i < 255; ++i) {
    start.append(Block{0, 1, 2 + i % 6});
    if (i == 254) {
      start.append(Block{1, 2 + i % 6, 3});
    }
  }
  const std::uint32_t blocks = static_cast<std::uint32_t>(start.block_count());
  ASSERT_GT(blocks, 255U);
  Design narrow(p);
  for (std::size_t i = 0; i < 255; ++i) {
    narrow.append(start.block(i));
  }
  ASSERT_TRUE(SegmentPairs<std::uint8_t>::fits(narrow));
  SegmentPairs<std::uint8_t> state(narrow);
  SegmentPairs<std::uint16_t> roomy(narrow);
  const auto moves_0_or_1 = [](const SegmentSwap& move) {
    return move.length > 0 && (move.x <= 1 || move.y <= 1);
  };
  int with_room = 0;
  for (int n = 0; n < 1000; ++n) {
    EXPECT_FALSE(moves_0_or_1(state.propose(random)));
    with_room += moves_0_or_1(roomy.propose(random)) ? 1 : 0;
  }
  EXPECT_GT(with_room, 0) << "the moves that bytes refuse are there";
  Design wide(p);
  for (std::size_t i = 0; i < 256; ++i) {
    wide.append(Block{0, 1, 2 + static_cast<Element>(i % 6)});
  }
  EXPECT_FALSE(SegmentPairs<std::uint8_t>::fits(wide));
  EXPECT_TRUE(SegmentPairs<std::uint16_t>::fits(wide));
}

TEST(SegmentSubsets, CountsWhatACountFromScratchCounts) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (const auto& [v, k, m, b, t] :
         std::vector<std::array<std::uint64_t, 5>>{{7, 4, 1, 12, 2},
                                                   {8, 4, 2, 15, 3},
                                                   {9, 5, 1, 14, 3},
                                                   {9, 5, 2, 12, 4},
                                                   {10, 4, 3, 16, 4},
                                                   {12, 6, 2, 12, 3}}) {
      const Parameters p{
          .v = v, .k = k, .change = m, .kind = kind, .strength = static_cast<std::uint32_t>(t)};
      SCOPED_TRACE(name(p));
      Random random(8);
      SegmentSubsets state(random_list(p, static_cast<std::size_t>(b), random).value());
      ASSERT_NO_FATAL_FAILURE(walk(state, 600, random, [](const SegmentSubsets& now) {
        const Design design = now.design();
        const auto verdict = test::naive_verdict(design);
        ASSERT_EQ(verdict.uncovered, now.missing());
        const SegmentSubsets fresh(design);
        ASSERT_EQ(fresh.missing(), now.missing());
        Block subset;
        for (Element x = 0; x < design.parameters().strength; ++x) {
          subset.push_back(2 * x);
        }
        ASSERT_EQ(fresh.count(subset), now.count(subset));
      }));
    }
  }
}

TEST(SegmentSubsets, GoesTheWayOfPairsAtStrengthTwo) {
  Random random(9);
  const Design start = random_list({.v = 11, .k = 4, .kind = Kind::circular}, 13, random).value();
  SegmentSubsets subsets(start);
  SegmentPairs<std::uint8_t> pairs(start);
  int moves = 0;
  for (int n = 0; n < 2000; ++n) {
    const SegmentSwap move = pairs.propose(random);
    if (move.length > 0) {
      const Element held = pairs.contains(move.first, move.x) ? move.x : move.y;
      const Element other = held == move.x ? move.y : move.x;
      const SegmentSwap same = subsets.segment(move.first, held, other);
      ASSERT_EQ(same.first, move.first);
      ASSERT_EQ(same.length, move.length);
      pairs.apply(move);
      subsets.apply(move);
      ASSERT_EQ(pairs.missing(), subsets.missing());
      ++moves;
    }
  }
  EXPECT_GT(moves, 400);
}

TEST(SegmentOrbits, IsADesignWithTheAutomorphismAfterEveryMove) {
  struct Imposed {
    std::uint64_t v, k, m;
    Automorphism pi;
    std::size_t c;
  };
  for (const Imposed& of : std::vector<Imposed>{{9, 3, 1, {3, 3}, 4},
                                                {10, 4, 2, {3, 3, 1}, 3},
                                                {11, 4, 2, {11, 1}, 1},
                                                {12, 5, 2, {5, 2, 2}, 4},
                                                {12, 4, 1, {4, 3}, 5},
                                                {12, 4, 3, {6, 2}, 3},
                                                {8, 3, 2, {2, 4}, 6},
                                                {7, 3, 2, {1, 7}, 7}}) {
    const Parameters p{.v = of.v, .k = of.k, .change = of.m, .kind = Kind::circular};
    SCOPED_TRACE(name(p));
    Random random(10);
    std::vector<Block> base;
    while (base.empty()) {
      const Block first = random_block(p, random);
      if (const auto between = random_walk(first, of.pi.image(first, 1), of.c, p, random)) {
        base = *between;
        base.insert(base.begin(), first);
      }
    }
    SegmentOrbits state(p, of.pi, base);
    std::uint64_t changed = 0;
    ASSERT_NO_FATAL_FAILURE(walk(state, 3000, random, [&](const SegmentOrbits& now) {
      const Design design = now.design();
      ASSERT_EQ(design.block_count(), of.c * of.pi.n);
      std::set<std::set<std::uint64_t>> uncovered;
      for (Element y = 1; y < of.v; ++y) {
        for (Element x = 0; x < y; ++x) {
          std::uint32_t times = 0;
          for (std::size_t i = 0; i < design.block_count(); ++i) {
            const auto block = design.block(i);
            times += std::count(block.begin(), block.end(), x) > 0 &&
                             std::count(block.begin(), block.end(), y) > 0
                         ? 1U
                         : 0U;
          }
          ASSERT_EQ(times == 0, now.count(x, y) == 0) << x << ' ' << y;
          if (times == 0) {
            std::set<std::uint64_t> orbit;
            for (std::uint64_t s = 0; s < of.pi.n; ++s) {
              const Element a = of.pi.image(x, s);
              const Element d = of.pi.image(y, s);
              orbit.insert(std::uint64_t{std::min(a, d)} << 32 | std::max(a, d));
            }
            uncovered.insert(orbit);
          }
        }
      }
      ASSERT_EQ(uncovered.size(), now.missing());
      const std::size_t c = of.c;
      for (std::size_t i = 0; i + c < design.block_count(); ++i) {
        std::set<Element> image;
        for (const Element x : design.block(i)) {
          image.insert(of.pi.image(x, 1));
        }
        const auto next = design.block(i + c);
        ASSERT_EQ(image, std::set<Element>(next.begin(), next.end()));
      }
      ++changed;
    }));
    EXPECT_GT(changed, 1U);
  }
}

}  // namespace
}  // namespace changeover::segment_test
