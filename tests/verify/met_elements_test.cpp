// Which pairs have met in ranges: against a table of all pairs, in many orders of the ranges.
#include "verify/met_elements.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "run/random.hpp"

namespace changeover::met_elements_test {
namespace {

TEST(MetElements, AsATableOfAllPairs) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Random random(seed, 1);
    const std::uint32_t v = 2 + random.below(120);
    MetElements met(v);
    std::vector<std::vector<bool>> table(v, std::vector<bool>(v, false));
    struct Call {
      Element x;
      ElementRange others;
    };
    std::vector<Call> calls;
    const std::uint32_t elements = 1 + random.below(4);  // most ranges are of few elements
    const std::uint32_t longest = 1 + random.below(6);
    for (std::uint32_t i = random.below(300); i > 0; --i) {
      const Element x = random.below(5) == 0 ? random.below(v) : v - 1 - random.below(elements) % v;
      const Element first = random.below(v);
      Element last = std::min(v - 1, first + random.below(longest));
      if (first == x) {
        continue;
      }
      last = first < x ? std::min(last, x - 1) : last;
      calls.push_back({x, {first, last}});
    }
    if (seed % 3 != 0) {  // from above, or from below
      std::ranges::sort(calls, [&](const Call& a, const Call& b) {
        return seed % 3 == 1 ? a.others.first > b.others.first : a.others.first < b.others.first;
      });
    }
    for (const auto& [x, others] : calls) {
      met.meet(x, others);
      for (Element y = others.first; y <= others.last; ++y) {
        table[std::max(x, y)][std::min(x, y)] = true;
      }
    }
    std::vector<std::pair<Element, Element>> missing;
    for (Element y = 0; y < v; ++y) {
      for (Element x = 0; x < y; ++x) {
        if (!table[y][x]) {
          missing.emplace_back(x, y);
        }
      }
    }
    const MetElements::Missing found = met.missing(10);
    EXPECT_EQ(found.pairs, missing.size()) << seed;
    missing.resize(std::min<std::size_t>(missing.size(), 10));
    EXPECT_EQ(found.examples, missing) << seed;
  }
}

// Ranges that come from above, beside each other or twice: each costs no more than its place.
TEST(MetElements, ManyRangesOfOneElement) {
  constexpr Element v = 400'000;
  MetElements met(v);
  for (int turn = 0; turn < 2; ++turn) {
    for (Element x = v - 2; x >= 2; x -= 2) {
      met.meet(v - 1, {x, x});
    }
  }
  for (Element x = v - 3; x > 1; x -= 2) {
    met.meet(v - 1, {x, x});
  }
  met.meet(v - 1, {0, 1});
  std::uint64_t others = std::uint64_t{v - 1} * (v - 2) / 2;
  EXPECT_EQ(met.missing(0).pairs, others);
}

}  // namespace
}  // namespace changeover::met_elements_test
