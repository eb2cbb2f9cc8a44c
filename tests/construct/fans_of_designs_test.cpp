// Designs of the constructions that have fans, as they are and changed.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "construct/trusted_entry.hpp"
#include "listed_fans.hpp"
#include "run/random.hpp"

namespace changeover::fans_of_designs_test {
namespace {

using test::expect_as_read;
using test::Listed;
using test::OwnFan;
using test::written_out;

std::vector<Recipe> recipes_with_fans() {
  std::vector<Recipe> recipes;
  const Registry& registry = Registry::standard();
  for (std::uint64_t v = 20; v <= 120; ++v) {
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      for (const char* const name : {"concatenate", "ring", "ring-of-copies"}) {
        const Parameters p{.v = v, .k = 5, .change = 1, .kind = kind, .strength = 2};
        if (auto offer = registry.find(name)->offer(p, registry)) {
          recipes.push_back(std::move(offer->recipe));
        }
      }
    }
  }
  return recipes;
}

TEST(FansOfDesigns, OfConstructionsAreTheirBlocks) {
  const Registry& registry = Registry::standard();
  std::set<std::string> names;
  for (const Recipe& recipe : recipes_with_fans()) {
    SCOPED_TRACE(recipe.construction + " " + name(recipe.parameters));
    const auto fans = registry.construction_of(recipe).fans(recipe, registry);
    ASSERT_NE(fans, nullptr);
    const auto blocks = registry.build(recipe);
    EXPECT_EQ(read_within_memory(*blocks).blocks(), written_out(*fans));
    EXPECT_EQ(fans->block_count(), blocks->block_count());
    expect_as_read(*fans);
    EXPECT_TRUE(verify_fans(*registry.fans(recipe)).valid());
    names.insert(recipe.construction);
  }
  EXPECT_EQ(names, (std::set<std::string>{"concatenate", "ring", "ring-of-copies"}));
}

// An element changed, an interval longer or shorter, a fan left out, doubled or moved.
TEST(FansOfDesigns, ChangedDesignsAreJudgedAsByReading) {
  const Registry& registry = Registry::standard();
  std::size_t rejected = 0;
  std::size_t changed = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    Random random(seed, 2);
    const Parameters p{.v = 40 + random.below(30),
                       .k = 5,
                       .change = 1,
                       .kind = random.one_in_two() ? Kind::linear : Kind::circular,
                       .strength = 2};
    const char* const construction = p.kind == Kind::linear ? "concatenate" : "ring";
    const auto offer = registry.find(construction)->offer(p, registry);
    if (!offer) {
      continue;
    }
    std::vector<OwnFan> fans;
    const auto source = registry.fans(offer->recipe);
    while (const auto fan = source->next()) {
      fans.push_back({Block(fan->kept.begin(), fan->kept.end()), fan->first, fan->last});
    }
    const std::size_t at = random.below(static_cast<std::uint32_t>(fans.size()));
    const auto v = static_cast<std::uint32_t>(p.v);
    switch (random.below(5)) {
      case 0:
        fans[at].kept[random.below(4)] = random.below(v);
        break;
      case 1:
        fans[at].last = std::min(v - 1, fans[at].last + 1);
        break;
      case 2:
        fans[at].first = std::min(fans[at].last, fans[at].first + 1);
        break;
      case 3:
        fans.erase(fans.begin() + static_cast<std::ptrdiff_t>(at));
        break;
      default:
        std::swap(fans[at], fans[random.below(static_cast<std::uint32_t>(fans.size()))]);
    }
    SCOPED_TRACE(seed);
    Listed list(p, fans);
    ++changed;
    try {
      const bool valid = verify_fans(list).valid();
      rejected += valid ? 0U : 1U;
    } catch (const BadInput&) {  // an element twice in a block
      ++rejected;
      continue;
    }
    list.rewind();
    expect_as_read(list);
  }
  EXPECT_GT(changed, 80U);
  EXPECT_GT(rejected, changed / 2);
}

TEST(FansOfDesigns, AMillionElements) {
  const Parameters p{.v = 1'000'000, .k = 5, .change = 1, .kind = Kind::linear, .strength = 2};
  const Registry& registry = Registry::standard();
  const auto offer = registry.best(p);
  ASSERT_TRUE(offer);
  const FanVerdict verdict = verify_fans(*registry.fans(offer->recipe));
  EXPECT_TRUE(verdict.valid());
  EXPECT_TRUE(verdict.economical());
  EXPECT_EQ(verdict.b, 124'999'874'999U);
  EXPECT_LT(verdict.fans, 5'000'000U);
}

}  // namespace
}  // namespace changeover::fans_of_designs_test
