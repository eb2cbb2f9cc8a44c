#include "run/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace changeover::random_test {
namespace {

TEST(Random, GivesTheSameNumbersForever) {
  std::uint64_t state = 1234567;  // the published first outputs of splitmix64 for this seed
  EXPECT_EQ(splitmix64(state), 6457827717110365317ULL);
  EXPECT_EQ(splitmix64(state), 3203168211198807973ULL);
  Random random(Random::State{1, 2, 3, 4});  // the published first outputs of xoshiro256**
  EXPECT_EQ(random.next(), 11520ULL);
  EXPECT_EQ(random.next(), 0ULL);
  EXPECT_EQ(random.next(), 1509978240ULL);
}

TEST(Random, GoesOnFromAStateThatWasKept) {
  Random random(5);
  random.next();
  Random copy(random.state());
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(random.next(), copy.next());
  }
}

TEST(Random, StreamsOfASeedDiffer) {
  std::set<std::uint64_t> first;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (std::uint64_t stream = 0; stream < 20; ++stream) {
      first.insert(Random(seed, stream).next());
    }
  }
  EXPECT_EQ(first.size(), 400U);
}

TEST(Random, NumbersBelowALimitAreEvenlySpread) {
  Random random(3);
  std::array<int, 7> times{};
  for (int i = 0; i < 70'000; ++i) {
    ++times.at(random.below(7));
  }
  for (const int count : times) {
    EXPECT_NEAR(count, 10'000, 500);
  }
  EXPECT_EQ(random.below(1), 0U);
  EXPECT_EQ(random.below(0), 0U);
}

}  // namespace
}  // namespace changeover::random_test
