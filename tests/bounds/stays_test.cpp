#include "stays.hpp"

#include <gtest/gtest.h>

#include <set>

#include "bounds/short_stays.hpp"
#include "bounds/stays.hpp"
#include "run/random.hpp"

namespace changeover::stays_test {
namespace {

// Random sets until every `strength` elements were together, with a taste: some runs keep much of
// the set before, some jump, some have small sets.
std::vector<Block> random_cover(std::uint64_t v, std::uint64_t k, std::uint64_t strength,
                                Random& random) {
  std::set<Block> missing;
  for (Element a = 0; a < v; ++a) {
    for (Element b = 0; b < a; ++b) {
      if (strength == 2) {
        missing.insert({b, a});
      }
      for (Element c = 0; strength == 3 && c < b; ++c) {
        missing.insert({c, b, a});
      }
    }
  }
  const std::uint32_t keep = random.below(static_cast<std::uint32_t>(k + 1));
  std::vector<Block> sets;
  while (!missing.empty()) {
    auto wanted = missing.begin();
    std::advance(wanted, random.below(static_cast<std::uint32_t>(missing.size())));
    std::set<Element> next(wanted->begin(), wanted->end());
    if (!sets.empty()) {
      for (const Element x : sets.back()) {
        if (next.size() < k && random.below(static_cast<std::uint32_t>(k)) < keep) {
          next.insert(x);
        }
      }
    }
    while (next.size() < k && !random.one_in_two()) {
      next.insert(random.below(static_cast<std::uint32_t>(v)));
    }
    sets.emplace_back(next.begin(), next.end());
    for (auto it = missing.begin(); it != missing.end();) {
      it = std::includes(next.begin(), next.end(), it->begin(), it->end()) ? missing.erase(it)
                                                                           : std::next(it);
    }
  }
  return sets;
}

TEST(Stays, AreAtLeastSoManyInEveryRandomListInWhichAllMeet) {
  Random random(5);
  for (int i = 0; i < 3000; ++i) {
    const std::uint64_t strength = i % 4 == 0 ? 3 : 2;
    const std::uint64_t k = strength + random.below(5);
    const std::uint64_t v = k + random.below(10);
    const std::vector<Block> sets = random_cover(v, k, strength, random);
    EXPECT_EQ(test::broken_inequality_of_stays(v, k, strength, sets), std::nullopt)
        << v << ' ' << k << ' ' << strength << " in list " << i;
    std::uint64_t introductions = 0;
    for (const std::uint64_t stays : test::stays(v, sets)) {
      introductions += stays;
    }
    EXPECT_GE(introductions, least_introductions(v, k, strength).count) << v << ' ' << k;
  }
}

// Any of the elements, those with the fewest stays in particular, by counting pairs within them.
TEST(Stays, AreAtLeastSoManyWithinAPart) {
  Random random(6);
  for (int i = 0; i < 3000; ++i) {
    const std::uint64_t k = 2 + random.below(6);
    const std::uint64_t v = k + random.below(12);
    const std::vector<Block> sets = random_cover(v, k, 2, random);
    for (std::uint64_t s = 1; s <= 12; ++s) {
      std::uint64_t sum = 0;
      for (const std::uint64_t stays : test::stays(v, sets)) {
        sum += stays <= s ? s + 1 - stays : 0;
      }
      EXPECT_LE(sum, most_stays_short(s, k)) << v << ' ' << k << ", s = " << s;
    }
  }
}

TEST(Stays, WithinAPartTheSmallerConstantCounts) {
  EXPECT_EQ(most_stays_short(1, 11), 11U);
  EXPECT_EQ(most_stays_short(2, 11), 33U);
  EXPECT_EQ(most_stays_short(3, 11), 76U);  // 7.5k - 6
  EXPECT_EQ(most_stays_short(3, 12), 84U);  // 7k, and so is 7.5k - 6
  EXPECT_EQ(most_stays_short(3, 13), 91U);
  EXPECT_EQ(most_stays_short(4, 13), 146U);  // 12k - 10
  EXPECT_EQ(most_stays_short(5, 3), 37U);    // half of 75, rounded down
  for (std::uint64_t k = 2; k <= 200; ++k) {
    for (std::uint64_t s = 2; s <= 40; ++s) {
      const std::uint64_t before = most_stays_short(s, k) - most_stays_short(s - 1, k);
      EXPECT_GE(most_stays_short(s + 1, k) - most_stays_short(s, k), before) << s << ' ' << k;
    }
  }
}

// The check can fail.
TEST(Stays, OfAListInWhichNotAllMeetMayBeFewer) {
  const std::vector<Block> sets{{0, 1}, {1, 2}, {2, 3}, {3, 4}};
  EXPECT_EQ(test::stays(5, sets), (std::vector<std::uint64_t>{1, 1, 1, 1, 1}));
  EXPECT_EQ(test::broken_inequality_of_stays(5, 2, 2, sets), 1U);
}

}  // namespace
}  // namespace changeover::stays_test
