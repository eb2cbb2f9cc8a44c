#include "stays.hpp"

#include <gtest/gtest.h>

#include <set>

#include "bounds/stays.hpp"
#include "run/random.hpp"

namespace changeover::stays_test {
namespace {

// Random sets until every `strength` elements were together, with a taste: some runs keep much of the set before,
// some jump, some have small sets.
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

// The check can fail.
TEST(Stays, OfAListInWhichNotAllMeetMayBeFewer) {
  const std::vector<Block> sets{{0, 1}, {1, 2}, {2, 3}, {3, 4}};
  EXPECT_EQ(test::stays(5, sets), (std::vector<std::uint64_t>{1, 1, 1, 1, 1}));
  EXPECT_EQ(test::broken_inequality_of_stays(5, 2, 2, sets), 1U);
}

}  // namespace
}  // namespace changeover::stays_test
