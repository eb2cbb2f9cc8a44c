#include "loadorder/shares/groups/planes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/workers.hpp"
#include "loadorder/shares/owners/plane_owners.hpp"
#include "message_of.hpp"

namespace changeover::test::planes_test {
namespace {

TEST(FiniteFields, AreThoseOfPrimePowers) {
  const std::set<std::uint64_t> orders{2,  3,  4,  5,  7,  8,  9,  11, 13,
                                       16, 17, 19, 23, 25, 27, 29, 31, 32};
  for (std::uint64_t q = 0; q <= 32; ++q) {
    EXPECT_EQ(FiniteField::of_order(q).has_value(), orders.contains(q)) << q;
  }
  EXPECT_TRUE(FiniteField::of_order(256).has_value());
  EXPECT_FALSE(FiniteField::of_order(257).has_value());
  EXPECT_REFUSAL(Plane(6, false), BadInput,
                 "there is no field with 6 elements, or it is too large; give a prime power");
}

TEST(FiniteFields, HaveTheLawsOfAField) {
  for (const std::uint32_t q : {2U, 3U, 4U, 5U, 8U, 9U, 16U}) {
    const FiniteField f = *FiniteField::of_order(q);
    for (std::uint32_t a = 0; a < q; ++a) {
      EXPECT_EQ(f.add(a, 0), a);
      EXPECT_EQ(f.multiply(a, 1), a);
      EXPECT_EQ(f.add(a, f.negative(a)), 0U);
      EXPECT_TRUE(a == 0 || f.multiply(a, f.inverse(a)) == 1);
      for (std::uint32_t b = 0; b < q; ++b) {
        EXPECT_EQ(f.add(a, b), f.add(b, a));
        EXPECT_EQ(f.multiply(a, b), f.multiply(b, a));
        EXPECT_EQ(f.multiply(a, b) == 0, a == 0 || b == 0);
        for (std::uint32_t c = 0; c < q; ++c) {
          EXPECT_EQ(f.add(f.add(a, b), c), f.add(a, f.add(b, c)));
          EXPECT_EQ(f.multiply(f.multiply(a, b), c), f.multiply(a, f.multiply(b, c)));
          EXPECT_EQ(f.multiply(a, f.add(b, c)), f.add(f.multiply(a, b), f.multiply(a, c)));
        }
      }
    }
  }
}

TEST(Planes, HaveEachTwoPointsOnOneLine) {
  for (const bool affine : {false, true}) {
    for (const std::uint64_t q : {2U, 3U, 4U, 5U, 8U, 9U}) {
      const Plane plane(q, affine);
      std::vector<int> met(static_cast<std::size_t>(plane.points() * plane.points()), 0);
      for (std::uint64_t line = 0; line < plane.lines(); ++line) {
        const std::vector<Element> points = plane.points_of(line);
        ASSERT_EQ(points.size(), plane.on_a_line());
        ASSERT_TRUE(std::is_sorted(points.begin(), points.end()));
        for (const Element x : points) {
          for (const Element y : points) {
            ++met[x * plane.points() + y];
            EXPECT_TRUE(x == y || plane.line_of(x, y) == line);
          }
        }
      }
      for (std::uint64_t x = 0; x < plane.points(); ++x) {
        std::set<std::uint64_t> lines;
        for (std::uint64_t i = 0; i < plane.through_a_point(); ++i) {
          lines.insert(plane.line_through(x, i));
        }
        EXPECT_EQ(lines.size(), q + 1);
        for (const std::uint64_t line : lines) {
          const auto points = plane.points_of(line);
          EXPECT_TRUE(std::find(points.begin(), points.end(), x) != points.end());
        }
        for (std::uint64_t y = 0; y < plane.points(); ++y) {
          EXPECT_EQ(met[x * plane.points() + y], static_cast<int>(x == y ? q + 1 : 1));
        }
      }
    }
  }
}

TEST(Planes, EachPointIsHeldOnALineWhereOneIsStreamed) {
  for (const bool affine : {false, true}) {
    for (const std::uint64_t q : {2U, 3U, 4U, 5U, 7U, 8U, 9U, 11U, 13U, 16U, 23U}) {
      const GroupShares shares = streamed_plane_shares(q, affine);
      std::vector<bool> held(static_cast<std::size_t>(shares.groups), false);
      std::set<ItemPair> met;
      for (const GroupShare& share : shares.workers) {
        ASSERT_EQ(share.streamed.size(), 1U);
        ASSERT_EQ(share.held.size(), q - (affine ? 1 : 0));
        for (const Element x : share.held) {
          held[x] = true;
          met.emplace(std::min(x, share.streamed[0]), std::max(x, share.streamed[0]));
          for (const Element y : share.held) {
            met.emplace(std::min(x, y), std::max(x, y));
          }
        }
      }
      EXPECT_TRUE(std::ranges::all_of(held, [](bool is_held) { return is_held; })) << q;
      EXPECT_EQ(met.size(), shares.groups * (shares.groups + 1) / 2) << q;
    }
  }
}

// Rooms that hold all groups of a line but one.
TEST(Planes, AreUsedWithLessRoom) {
  EXPECT_EQ(split_load_order(1024, 256, 12).facts().makespan, 342U);
  EXPECT_EQ(split_load_order(1024, 181, 30).facts().makespan, 205U);
  const SplitFacts many = split_load_order(4096, 345, 133).facts();
  EXPECT_LE(many.makespan, 376U);
  EXPECT_LE(many.makespan * 100, many.makespan_bound.loads * 106);
}

// Groups of one or two items: those of two are on all lines alike, as far as chance has it.
TEST(Planes, LargerGroupsAreSpreadOverLines) {
  for (const std::uint64_t q : {19U, 31U}) {
    const Plane plane(q, false);
    const ItemGroups groups{plane.points() + plane.points() / 16, plane.points()};
    std::uint64_t most = 0;
    for (std::uint64_t line = 0; line < plane.lines(); ++line) {
      most = std::max(most, groups.size(plane.points_of(line)));
    }
    EXPECT_LE(most, (q + 1) * 5 / 4 + 6) << q;
  }
}

TEST(Planes, PairsAreCountedAsTheyAreGiven) {
  for (const bool affine : {false, true}) {
    for (const std::uint64_t items : {13U, 20U, 57U, 100U}) {
      const PlaneOwners owners(Plane(3, affine), items);
      std::vector<std::uint64_t> counted(affine ? 12 : 13, 0);
      for (Element y = 0; y < items; ++y) {
        for (Element x = 0; x < y; ++x) {
          ++counted[owners.owner(x, y)];
          EXPECT_EQ(owners.owner(x, y), owners.owner(y, x));
        }
      }
      EXPECT_EQ(owners.pairs(), counted) << items;
    }
  }
}

}  // namespace
}  // namespace changeover::test::planes_test
