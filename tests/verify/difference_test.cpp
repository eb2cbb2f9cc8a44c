#include "changeover/verify/difference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "changeover/core/developed.hpp"
#include "changeover/core/error.hpp"
#include "changeover/verify/verdict.hpp"
#include "message_of.hpp"

namespace changeover::difference_test {
namespace {

void expect_same_as_full_verification(const BaseBlocks& base) {
  const DifferenceVerdict differences = verify_differences(base);
  DevelopedSource source(base);
  const Verdict full = verify(source);
  ASSERT_EQ(differences.valid(), full.valid());
  ASSERT_EQ(differences.tight, full.tight());
  ASSERT_EQ(differences.b, full.b);
  ASSERT_EQ(differences.bad_steps * base.parameters.v, full.bad_steps);
  ASSERT_EQ(differences.uncovered == 0, full.uncovered == 0);
  ASSERT_EQ(differences.excess, full.excess);
}

TEST(DifferenceVerdict, EqualsTheFullVerificationOnRandomBaseBlocks) {
  std::mt19937 random(7);
  int valid = 0;
  for (int round = 0; round < 4000; ++round) {
    const std::uint32_t v = 4 + static_cast<std::uint32_t>(random() % 14);
    const std::uint32_t k = 2 + static_cast<std::uint32_t>(random() % (v - 2));
    const std::uint32_t m = 1 + static_cast<std::uint32_t>(random() % std::min(3U, k));
    const std::size_t c = 1 + random() % 4;
    BaseBlocks base{{.v = v, .k = k, .change = m, .kind = Kind::circular}, {}};
    Block points(v);
    std::iota(points.begin(), points.end(), 0U);
    std::shuffle(points.begin(), points.end(), random);
    for (std::size_t i = 0; i < c; ++i) {
      for (std::uint32_t j = 0; j < m; ++j) {
        std::swap(points[random() % k], points[k + random() % (v - k)]);
      }
      base.blocks.emplace_back(points.begin(), points.begin() + k);
    }
    expect_same_as_full_verification(base);
    ASSERT_FALSE(HasFatalFailure()) << "v=" << v << " k=" << k << " m=" << m << " c=" << c;
    valid += verify_differences(base).valid() ? 1 : 0;
  }
  EXPECT_GT(valid, 10);
}

TEST(DifferenceVerdict, EqualsTheFullVerificationUnderSeveralCycles) {
  std::mt19937 random(11);
  int valid = 0;
  int tight = 0;
  for (int round = 0; round < 6000; ++round) {
    const Automorphism pi{.n = 2 + random() % 5, .cycles = 1 + random() % 3, .fixed = 0};
    const std::uint64_t v = pi.v();
    if (v < 4) {
      continue;
    }
    const std::uint64_t k = 2 + random() % (v - 2);
    const std::uint64_t m = 1 + random() % std::min<std::uint64_t>(2, k);
    BaseBlocks developed{{.v = v, .k = k, .change = m, .kind = Kind::circular}, {}};
    Block points(static_cast<std::size_t>(v));
    std::iota(points.begin(), points.end(), 0U);
    std::shuffle(points.begin(), points.end(), random);
    const std::size_t c = 1 + random() % 6;
    for (std::size_t i = 0; i < c; ++i) {
      for (std::uint64_t j = 0; j < m; ++j) {
        std::swap(points[random() % k], points[k + random() % (v - k)]);
      }
      developed.blocks.emplace_back(points.begin(),
                                    points.begin() + static_cast<std::ptrdiff_t>(k));
    }
    const DifferenceVerdict differences = verify_differences(developed, pi);
    DevelopedSource source(developed, pi);
    const Verdict full = verify(source);
    ASSERT_EQ(differences.valid(), full.valid());
    ASSERT_EQ(differences.tight, full.tight());
    ASSERT_EQ(differences.b, full.b);
    ASSERT_EQ(differences.bad_steps * pi.n, full.bad_steps);
    ASSERT_EQ(differences.uncovered == 0, full.uncovered == 0);
    ASSERT_EQ(differences.excess, full.excess);
    valid += differences.valid() ? 1 : 0;
    tight += differences.tight ? 1 : 0;
  }
  EXPECT_GT(valid, 10);
  EXPECT_GT(tight, 0);
}

TEST(DifferenceVerdict, RefusesPermutationsOfOtherElements) {
  const BaseBlocks base{{.v = 6, .k = 3, .change = 1, .kind = Kind::circular}, {{0, 1, 3}}};
  const auto refused = [&](const Automorphism& pi) {
    return message_of<BadInput>([&] { (void)verify_differences(base, pi); });
  };
  EXPECT_EQ(refused({3, 1, 0}),
            "the permutation has 1 cycle of length 3 and 0 fixed elements: use one whose cycles "
            "have all 6 elements");
  EXPECT_EQ(refused({5, 1, 1}),
            "the permutation has 1 cycle of length 5 and 1 fixed element: use one whose cycles "
            "have all 6 elements");
}

TEST(DifferenceVerdict, EqualsTheFullVerificationOnEveryBaseBlockOfSmallParameters) {
  int valid = 0;
  for (std::uint32_t v = 3; v <= 11; ++v) {
    for (std::uint32_t mask = 1; mask < (1U << v); mask += 2) {
      Block block;
      for (Element x = 0; x < v; ++x) {
        if ((mask >> x & 1U) != 0) {
          block.push_back(x);
        }
      }
      for (std::uint32_t m = 1; m <= 2; ++m) {
        if (block.size() >= 2 && block.size() < v) {
          const BaseBlocks base{{.v = v, .k = block.size(), .change = m, .kind = Kind::circular},
                                {block}};
          expect_same_as_full_verification(base);
          ASSERT_FALSE(HasFatalFailure());
          valid += verify_differences(base).valid() ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(valid, 20);
}

TEST(DifferenceVerdict, DemandsTheLink) {
  // The two base blocks of the tight DCCD(21,4,42). With the block that contains k − 2 = 2 last,
  // the step to the next round keeps two elements; in the other order it keeps one, and all pairs
  // still occur.
  const Parameters p{.v = 21, .k = 4, .kind = Kind::circular};
  const BaseBlocks right{p, {{0, 1, 4, 12}, {0, 1, 2, 7}}};
  const BaseBlocks wrong{p, {{0, 1, 2, 7}, {0, 1, 4, 12}}};
  EXPECT_TRUE(verify_differences(right).tight);
  const DifferenceVerdict verdict = verify_differences(wrong);
  EXPECT_EQ(verdict.uncovered, 0U);
  EXPECT_EQ(verdict.bad_steps, 1U);
  EXPECT_EQ(verdict.first_bad_step, 2U);
  EXPECT_FALSE(verdict.valid());
  expect_same_as_full_verification(right);
  expect_same_as_full_verification(wrong);
}

TEST(DifferenceVerdict, RefusesMalformedBaseBlocks) {
  const Parameters p{.v = 11, .k = 4, .kind = Kind::circular};
  EXPECT_THROW((void)verify_differences(BaseBlocks{p, {}}), BadInput);
  EXPECT_THROW((void)verify_differences(BaseBlocks{p, {{0, 1, 2}}}), BadInput);
  EXPECT_THROW((void)verify_differences(BaseBlocks{p, {{0, 1, 2, 11}}}), BadInput);
  EXPECT_THROW((void)verify_differences(BaseBlocks{p, {{0, 1, 2, 2}}}), BadInput);
}

}  // namespace
}  // namespace changeover::difference_test
