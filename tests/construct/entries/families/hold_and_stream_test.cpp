#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/verify/verdict.hpp"
#include "naive_verdict.hpp"

namespace changeover::hold_and_stream_test {
namespace {

const Construction& hold_and_stream() { return *Registry::standard().find("hold-and-stream"); }

TEST(HoldAndStream, ServesEverythingWithChangesSmallerThanBlocksAndKeepsItsPromise) {
  const Registry& registry = Registry::standard();
  std::size_t with_tail = 0;
  for (std::uint64_t m = 1; m <= 4; ++m) {
    for (std::uint64_t k = m + 1; k <= 9; ++k) {
      for (std::uint64_t v = k + m; v <= 34; ++v) {
        for (const Kind kind : {Kind::linear, Kind::circular}) {
          const Parameters p{.v = v, .k = k, .change = m, .kind = kind};
          const auto offer = hold_and_stream().offer(p, registry);
          ASSERT_TRUE(offer) << name(p);
          const Design design = registry.build_design(offer->recipe);
          const Verdict verdict = verify(design);
          ASSERT_TRUE(verdict.valid()) << name(p) << " bad steps " << verdict.bad_steps
                                       << " uncovered " << verdict.uncovered;
          ASSERT_EQ(verdict.b, offer->b) << name(p);
          ASSERT_GE(verdict.b, lower_bound(p).blocks) << name(p);
          with_tail += offer->recipe.inputs.size();
          if (v <= 12) {
            ASSERT_TRUE(test::naive_verdict(design).valid) << name(p);
          }
        }
      }
    }
  }
  EXPECT_GT(with_tail, 50U);
}

TEST(HoldAndStream, IsWithinAQuarterOfTheBoundForManyElements) {
  for (const std::uint64_t k : {4U, 8U, 16U}) {
    const Parameters p{.v = 20 * k, .k = k, .change = 1};
    const auto offer = hold_and_stream().offer(p, Registry::standard());
    ASSERT_TRUE(offer);
    EXPECT_LT(static_cast<double>(offer->b), 1.25 * static_cast<double>(lower_bound(p).blocks));
  }
}

TEST(HoldAndStream, CanBeReadTwice) {
  const Registry& registry = Registry::standard();
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    const auto offer = hold_and_stream().offer({.v = 31, .k = 5, .kind = kind}, registry);
    const auto source = registry.build(offer->recipe);
    const Design first = read_all(*source);
    ASSERT_TRUE(source->rewind());
    const Design second = read_all(*source);
    EXPECT_TRUE(std::equal(first.elements().begin(), first.elements().end(),
                           second.elements().begin(), second.elements().end()));
  }
}

TEST(HoldAndStream, RefusesRecipesThatAreNotItsOwn) {
  const Registry& registry = Registry::standard();
  const auto offer = hold_and_stream().offer({.v = 31, .k = 5}, registry);
  Recipe wrong = offer->recipe;
  wrong.arguments["blocks"] += 1;
  EXPECT_THROW((void)registry.build(wrong), BadInput);
  wrong = offer->recipe;
  wrong.parameters.change = 5;
  EXPECT_THROW((void)registry.build(wrong), BadInput);
  wrong = offer->recipe;
  wrong.inputs.push_back(offer->recipe);
  EXPECT_THROW((void)registry.build(wrong), BadInput);
  EXPECT_FALSE(hold_and_stream().offer({.v = 6, .k = 5}, registry).has_value());
  EXPECT_FALSE(hold_and_stream().offer({.v = 9, .k = 3, .change = 3}, registry).has_value());
  EXPECT_FALSE(hold_and_stream().offer({.v = 4'000'000'000, .k = 3}, registry).has_value());
}

}  // namespace
}  // namespace changeover::hold_and_stream_test
