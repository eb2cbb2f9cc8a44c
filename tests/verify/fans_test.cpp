// Designs verified by their fans: against reading every block of small lists of all sorts.
#include "changeover/verify/fans.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "changeover/core/error.hpp"
#include "listed_fans.hpp"
#include "message_of.hpp"
#include "run/random.hpp"

namespace changeover::fans_test {
namespace {

using test::expect_as_read;
using test::Listed;
using test::OwnFan;

// Fans as they come: kept elements below, above and on both sides of the interval, one element
// changed from the fan before or any.
std::vector<OwnFan> random_fans(const Parameters& p, std::size_t many, Random& random) {
  std::vector<OwnFan> fans;
  const auto v = static_cast<std::uint32_t>(p.v);
  while (fans.size() < many) {
    OwnFan fan;
    fan.first = random.below(v);
    fan.last = std::min(v - 1, fan.first + random.below(1 + random.below(v)));
    std::vector<Element> outside;
    for (Element x = 0; x < v; ++x) {
      if (x < fan.first || x > fan.last) {
        outside.push_back(x);
      }
    }
    if (!fans.empty() && random.one_in_two()) {
      fan.kept = fans.back().kept;
      if (!std::ranges::all_of(fan.kept,
                               [&](Element x) { return std::ranges::count(outside, x) > 0; })) {
        continue;
      }
    } else {
      if (outside.size() + 1 < p.k) {
        continue;
      }
      while (fan.kept.size() + 1 < p.k) {
        const std::size_t i = random.below(static_cast<std::uint32_t>(outside.size()));
        fan.kept.push_back(outside[i]);
        outside.erase(outside.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
    fans.push_back(std::move(fan));
  }
  return fans;
}

TEST(Fans, AnyListIsJudgedAsByReading) {
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    Random random(seed, 1);
    const std::uint32_t k = 1 + random.below(5);
    const std::uint32_t v = k + random.below(14);
    const Parameters p{.v = v,
                       .k = k,
                       .change = 1 + random.below(std::min(k, 2U)),
                       .kind = random.one_in_two() ? Kind::linear : Kind::circular,
                       .strength = 2};
    if (p.k < 2) {
      continue;
    }
    SCOPED_TRACE(seed);
    Listed fans(p, random_fans(p, 1 + random.below(40), random));
    expect_as_read(fans);
  }
}

TEST(Fans, WhatIsNoBlockIsRefused) {
  const Parameters p{.v = 9, .k = 3, .change = 1, .kind = Kind::linear, .strength = 2};
  const auto refusal = [](const Parameters& q, const OwnFan& fan) {
    Listed list(q, {{{0, 1}, 2, 2}, fan});
    return message_of<BadInput>([&] { (void)verify_fans(list); });
  };
  const std::string shape = "fan 2: it must keep k-1 = 2 elements beside an interval";
  EXPECT_EQ(refusal(p, {{0, 1}, 4, 3}), shape);
  EXPECT_EQ(refusal(p, {{0}, 4, 5}), shape);
  EXPECT_EQ(refusal(p, {{0, 1, 2}, 4, 5}), shape);
  EXPECT_EQ(refusal(p, {{0, 1}, 4, 9}), "fan 2: element 9 is not below v = 9");
  EXPECT_EQ(refusal(p, {{0, 9}, 4, 5}), "fan 2: element 9 is not below v = 9");
  EXPECT_EQ(refusal(p, {{0, 0}, 4, 5}), "fan 2: it repeats the element 0");
  EXPECT_EQ(refusal(p, {{0, 5}, 4, 5}), "fan 2: it repeats the element 5");
  Parameters triples = p;
  triples.strength = 3;
  EXPECT_EQ(refusal(triples, {{0, 1}, 4, 5}),
            "fans are verified for strength 2, not 3; read the blocks");
}

}  // namespace
}  // namespace changeover::fans_test
