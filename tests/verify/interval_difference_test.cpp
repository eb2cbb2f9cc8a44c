#include "changeover/verify/difference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <string>

#include "changeover/core/error.hpp"
#include "changeover/verify/verdict.hpp"
#include "message_of.hpp"

namespace changeover::interval_difference_test {
namespace {

// Equal to the certificate of the written-out base blocks in everything that it says.
void expect_same_as_differences(const IntervalBaseBlocks& base) {
  const DifferenceVerdict intervals = verify_differences(base);
  const DifferenceVerdict differences = verify_differences(base.written_out());
  ASSERT_EQ(intervals.b, differences.b);
  ASSERT_EQ(intervals.bad_steps, differences.bad_steps);
  ASSERT_EQ(intervals.first_bad_step, differences.first_bad_step);
  ASSERT_EQ(intervals.uncovered, differences.uncovered);
  ASSERT_EQ(intervals.uncovered_examples, differences.uncovered_examples);
  ASSERT_EQ(intervals.excess, differences.excess);
  ASSERT_EQ(intervals.tight, differences.tight);
  ASSERT_EQ(intervals.valid(), differences.valid());
}

void expect_same_as_full_verification(const IntervalBaseBlocks& base) {
  const DifferenceVerdict intervals = verify_differences(base);
  IntervalDevelopedSource source(base);
  const Verdict full = verify(source);
  ASSERT_EQ(intervals.b, full.b);
  ASSERT_EQ(intervals.bad_steps * base.parameters.v, full.bad_steps);
  ASSERT_EQ(intervals.valid(), full.valid());
  ASSERT_EQ(intervals.tight, full.tight());
  ASSERT_EQ(intervals.uncovered == 0, full.uncovered == 0);
  ASSERT_EQ(intervals.excess, full.excess);
}

std::string describe(const IntervalBaseBlocks& base) {
  const Parameters& p = base.parameters;
  std::string text = "v=" + std::to_string(p.v) + " k=" + std::to_string(p.k) +
                     " m=" + std::to_string(p.change) + " a=" + std::to_string(base.start) +
                     " n=" + std::to_string(base.length) + ":";
  for (const Element x : base.points) {
    text += " " + std::to_string(x);
  }
  return text;
}

IntervalBaseBlocks shifted(IntervalBaseBlocks base, std::uint64_t by) {
  base.start = (base.start + by) % base.parameters.v;
  for (Element& x : base.points) {
    x = static_cast<Element>((x + by) % base.parameters.v);
  }
  return base;
}

// The printed base blocks of [ChafeeStevens2025, Theorem 10] for c = 3.
IntervalBaseBlocks three_base_blocks(std::uint64_t k) {
  const auto n = static_cast<Element>(k - 2);
  return {{.v = 12 * k - 17, .k = k, .kind = Kind::circular},
          0,
          n,
          {2 * n, 7 * n + 3, 3 * n + 1, 5 * n + 2, n, 4 * n + 2}};
}

TEST(IntervalDifferences, EqualsBothOtherVerificationsOnRandomBaseBlocks) {
  std::mt19937 random(11);
  int valid = 0;
  int invalid = 0;
  for (int round = 0; round < 20000; ++round) {
    const std::uint32_t v = 3 + static_cast<std::uint32_t>(random() % 14);
    const std::uint32_t k = 2 + static_cast<std::uint32_t>(random() % (v - 1));
    const std::uint32_t n = static_cast<std::uint32_t>(random() % k);
    const std::uint32_t start = static_cast<std::uint32_t>(random() % v);
    // Mostly the shape of the cyclic families: as many points as change.
    const std::uint32_t m =
        random() % 3 != 0 ? k - n : 1 + static_cast<std::uint32_t>(random() % std::min(3U, k));
    const std::size_t c = 1 + random() % 5;
    IntervalBaseBlocks base{{.v = v, .k = k, .change = m, .kind = Kind::circular}, start, n, {}};
    Block outside(v - n);
    std::iota(outside.begin(), outside.end(), start + n);
    for (Element& x : outside) {
      x %= v;
    }
    for (std::size_t i = 0; i < c; ++i) {
      if (i + 1 < c || random() % 2 == 0) {
        std::shuffle(outside.begin(), outside.end(), random);
      } else {
        std::sort(outside.begin(), outside.end(), [&](Element x, Element y) {
          return (x + v - start) % v < (y + v - start) % v;  // a+n first: the link
        });
      }
      base.points.insert(base.points.end(), outside.begin(), outside.begin() + (k - n));
    }
    expect_same_as_differences(base);
    expect_same_as_full_verification(base);
    ASSERT_FALSE(HasFatalFailure()) << describe(base);
    ++(verify_differences(base).valid() ? valid : invalid);
  }
  EXPECT_GT(valid, 1000);
  EXPECT_GT(invalid, 1000);
}

TEST(IntervalDifferences, EqualsTheOtherCertificateOnEveryPairOfPointsInEveryOrder) {
  // Two base blocks of k = 4 over Z_21, and of k = 3 over Z_10 to Z_13.
  int tight = 0;
  int valid = 0;
  for (const auto& [v, n] : {std::pair{21U, 2U}, std::pair{10U, 1U}, std::pair{11U, 1U},
                             std::pair{12U, 1U}, std::pair{13U, 1U}}) {
    for (std::uint32_t a = n; a < v; ++a) {
      for (std::uint32_t b = a + 1; b < v; ++b) {
        for (std::uint32_t c = n; c < v; ++c) {
          for (std::uint32_t d = c + 1; d < v; ++d) {
            const IntervalBaseBlocks base{
                {.v = v, .k = n + 2, .kind = Kind::circular}, 0, n, {a, b, c, d}};
            const DifferenceVerdict verdict = verify_differences(base);
            tight += verdict.tight ? 1 : 0;
            valid += verdict.valid() ? 1 : 0;
            if (v < 20 || verdict.uncovered == 0) {
              expect_same_as_differences(base);
              ASSERT_FALSE(HasFatalFailure()) << describe(base);
            }
          }
        }
      }
    }
  }
  EXPECT_GT(tight, 0);
  EXPECT_GT(valid, tight);
}

TEST(IntervalDifferences, EqualsTheOtherCertificateOnEveryIntervalOfEveryBlock) {
  for (std::uint32_t v = 3; v <= 11; ++v) {
    for (std::uint32_t mask = 1; mask < (1U << v); ++mask) {
      Block block;
      for (Element x = 0; x < v; ++x) {
        if ((mask >> x & 1U) != 0) {
          block.push_back(x);
        }
      }
      if (block.size() < 2) {
        continue;
      }
      for (std::uint32_t m = 1; m <= 2; ++m) {
        const BaseBlocks plain{{.v = v, .k = block.size(), .change = m, .kind = Kind::circular},
                               {block}};
        const DifferenceVerdict expected = verify_differences(plain);
        // Every interval inside the block, and no interval at all.
        for (const Element start : block) {
          IntervalBaseBlocks base{plain.parameters, start, 0, {}};
          while (base.length < block.size()) {
            base.points.clear();
            for (const Element x : block) {
              if ((x + v - start) % v >= base.length) {
                base.points.push_back(x);
              }
            }
            const DifferenceVerdict verdict = verify_differences(base);
            ASSERT_EQ(verdict.bad_steps, expected.bad_steps) << describe(base);
            ASSERT_EQ(verdict.uncovered_examples, expected.uncovered_examples) << describe(base);
            ASSERT_EQ(verdict.excess, expected.excess) << describe(base);
            ASSERT_EQ(verdict.tight, expected.tight) << describe(base);
            if ((mask >> ((start + base.length) % v) & 1U) == 0) {
              break;
            }
            ++base.length;
          }
        }
      }
    }
  }
}

TEST(IntervalDifferences, DoesNotDependOnWhereTheIntervalStands) {
  const IntervalBaseBlocks base = three_base_blocks(5);
  for (std::uint64_t by = 0; by < base.parameters.v; ++by) {
    const IntervalBaseBlocks moved = shifted(base, by);
    EXPECT_TRUE(verify_differences(moved).tight) << by;
    expect_same_as_differences(moved);
    expect_same_as_full_verification(moved);
  }
}

TEST(IntervalDifferences, AcceptsTheExampleOfTheHeader) {
  const IntervalBaseBlocks base{{.v = 21, .k = 4, .kind = Kind::circular}, 0, 2, {4, 12, 2, 7}};
  EXPECT_TRUE(verify_differences(base).valid() && verify_differences(base).tight);
  EXPECT_EQ(base.written_out().blocks, (std::vector<Block>{{0, 1, 4, 12}, {0, 1, 2, 7}}));
  EXPECT_EQ(base.block_count(), 42U);
  expect_same_as_full_verification(base);
}

TEST(IntervalDifferences, DemandsTheLink) {
  for (std::uint64_t k = 4; k <= 30;
       ++k) {  // k = 3: {0,4,7} and {1,2,7} share an element by chance
    const IntervalBaseBlocks right = three_base_blocks(k);
    EXPECT_TRUE(verify_differences(right).tight);
    IntervalBaseBlocks wrong = right;  // the base block with k − 2 first
    std::rotate(wrong.points.begin(), wrong.points.begin() + 4, wrong.points.end());
    const DifferenceVerdict verdict = verify_differences(wrong);
    EXPECT_EQ(verdict.uncovered, 0U);
    EXPECT_EQ(verdict.bad_steps, 1U);
    EXPECT_EQ(verdict.first_bad_step, 3U);
    EXPECT_FALSE(verdict.valid());
    EXPECT_FALSE(verdict.tight);
    expect_same_as_differences(wrong);
    expect_same_as_full_verification(wrong);
  }
}

TEST(IntervalDifferences, NoticesEveryChangeOfOnePoint) {
  const IntervalBaseBlocks right = three_base_blocks(6);
  int valid = 0;
  for (std::size_t place = 0; place < right.points.size(); ++place) {
    for (Element x = 4; x < right.parameters.v; ++x) {
      IntervalBaseBlocks wrong = right;
      wrong.points[place] = x;
      const auto block = wrong.points_of(place / 2);
      if (x == right.points[place] || block[0] == block[1]) {
        continue;
      }
      valid += verify_differences(wrong).valid() ? 1 : 0;
      expect_same_as_differences(wrong);
      expect_same_as_full_verification(wrong);
    }
  }
  EXPECT_EQ(valid, 1);  // {0,1,2,3,4,41} in place of {0,1,2,3,4,18}: tight as well
}

TEST(IntervalDifferences, CountsTheDifferenceHalfwayForHalfAsManyPairs) {
  // Z_6, base block {0,1} ∪ {3}: differences 1, 2, 3; m = 1 fails, m = 2 holds at the link.
  const IntervalBaseBlocks base{{.v = 6, .k = 3, .change = 2, .kind = Kind::circular}, 0, 2, {3}};
  const DifferenceVerdict verdict = verify_differences(base);
  EXPECT_TRUE(verdict.valid());
  EXPECT_FALSE(verdict.tight);
  EXPECT_EQ(verdict.excess, 3U);
  expect_same_as_full_verification(base);
}

TEST(IntervalDifferences, RefusesMalformedBaseBlocks) {
  const Parameters p{.v = 11, .k = 4, .kind = Kind::circular};
  const auto refused = [](const IntervalBaseBlocks& base, const std::string& part) {
    try {
      (void)verify_differences(base);
      ADD_FAILURE() << describe(base);
    } catch (const BadInput& fault) {
      EXPECT_NE(std::string(fault.what()).find(part), std::string::npos) << fault.what();
    }
  };
  refused({p, 0, 2, {}}, "points");
  refused({p, 0, 2, {2, 5, 7}}, "points");
  refused({p, 0, 4, {2, 5}}, "interval");
  refused({p, 11, 2, {2, 5}}, "starts at 11");
  refused({p, 0, 2, {2, 11}}, "11 is not below");
  refused({p, 0, 2, {5, 5}}, "repeats the element 5");
  refused({p, 0, 2, {2, 5, 1, 6}}, "base block 2: the point 1");
  refused({p, 10, 2, {2, 0}}, "the point 0");
  refused({{.v = 4, .k = 4, .kind = Kind::circular}, 0, 2, {3, 3}}, "repeats the element 3");
  EXPECT_THROW((void)verify_differences(IntervalBaseBlocks{{.v = 3, .k = 4}, 0, 2, {2, 3}}),
               ImpossibleParameters);
  EXPECT_REFUSAL((void)verify_differences(IntervalBaseBlocks{
                     {.v = 11, .k = 4, .kind = Kind::circular, .strength = 3}, 0, 2, {2, 5}}),
                 ImpossibleParameters, "differences certify pairs only: use strength 2");
}

TEST(IntervalDifferences, StaysExactNearTheLargestNumberOfElements) {
  // One base block of k = 2³⁰ elements: v = 4k − 5, and b = v.
  const std::uint64_t k = std::uint64_t{1} << 30;
  const std::uint64_t v = 4 * k - 5;
  const auto n = static_cast<Element>(k - 2);
  const IntervalBaseBlocks base{{.v = v, .k = k, .kind = Kind::circular}, 0, n, {n, 2 * n + 1}};
  const DifferenceVerdict verdict = verify_differences(base);
  EXPECT_TRUE(verdict.tight);
  EXPECT_EQ(verdict.b, v);
  EXPECT_TRUE(verify_differences(shifted(base, v - 5)).tight);
  IntervalBaseBlocks wrong = base;
  ++wrong.points[1];
  const DifferenceVerdict broken = verify_differences(wrong);
  EXPECT_FALSE(broken.valid());
  EXPECT_GT(broken.uncovered, 0U);
  EXPECT_EQ(broken.excess, broken.uncovered * v);
}

TEST(IntervalDevelopedSource, StreamsWhatTheWrittenOutBaseBlocksDevelopInto) {
  std::mt19937 random(3);
  for (int round = 0; round < 300; ++round) {
    const std::uint64_t k = 3 + random() % 12;
    const IntervalBaseBlocks base = shifted(three_base_blocks(k), random() % (12 * k - 17));
    IntervalDevelopedSource interval(base);
    DevelopedSource plain(base.written_out());
    EXPECT_EQ(interval.parameters(), plain.parameters());
    EXPECT_EQ(interval.block_count(), plain.block_count());
    EXPECT_EQ(base.block_count(), plain.block_count());
    Block left(k);
    Block right(k);
    for (int twice = 0; twice < 2; ++twice) {
      while (plain.next(right)) {
        ASSERT_TRUE(interval.next(left));
        ASSERT_EQ(left, right);
      }
      EXPECT_FALSE(interval.next(left));
      EXPECT_TRUE(interval.rewind() && plain.rewind());
    }
  }
}

TEST(IntervalDevelopedSource, RefusesWhatHasNoShape) {
  const Parameters p{.v = 11, .k = 4, .kind = Kind::circular};
  const auto nothing = [](std::uint64_t, std::span<Element>) {};
  EXPECT_REFUSAL(IntervalDevelopedSource(p, 0, 4, 1, nothing), BadInput,
                 "an interval of 4 elements leaves no point in a block of k = 4");
  EXPECT_REFUSAL(IntervalDevelopedSource(p, 11, 2, 1, nothing), BadInput,
                 "the interval starts at 11, not below v = 11");
  EXPECT_THROW(IntervalDevelopedSource(p, 0, 2, 0, nothing), BadInput);
  EXPECT_THROW(IntervalDevelopedSource(p, 0, 2, ~std::uint64_t{0}, nothing), ImpossibleParameters);
  EXPECT_REFUSAL(IntervalDevelopedSource({p, 0, 2, {2}}), BadInput,
                 "1 point cannot be shared out among base blocks: each takes 2");
  EXPECT_REFUSAL(IntervalDevelopedSource({p, 0, 4, {2}}), BadInput,
                 "an interval of 4 elements leaves no point in a block of k = 4");
  EXPECT_REFUSAL((void)(IntervalBaseBlocks{p, 0, 4, {2}}.written_out()), BadInput,
                 "an interval of 4 elements leaves no point in a block of k = 4");
}

}  // namespace
}  // namespace changeover::interval_difference_test
