#include <gtest/gtest.h>

#include <chrono>

#include "changeover/construct/closure.hpp"
#include "changeover/run/control.hpp"
#include "construct/tools/close_up.hpp"
#include "construct/tools/coarsen.hpp"
#include "construction_checks.hpp"
#include "message_of.hpp"
#include "stays.hpp"

namespace changeover::rules_on_stays_test {
namespace {

using namespace test;

Recipe best(std::uint64_t v, std::uint64_t k, std::uint64_t m, Kind kind) {
  return standard().best({v, k, m, kind, 2})->recipe;
}

void expect_made(const Recipe& recipe, std::uint64_t b) {
  const auto source = standard().build(recipe);
  EXPECT_EQ(source->block_count(), b) << recipe.construction;
  const Verdict verdict = verify(*source);
  EXPECT_TRUE(verdict.valid()) << recipe.construction << ' ' << name(recipe.parameters);
  EXPECT_EQ(verdict.b, b);
  EXPECT_FALSE(standard().construction_of(recipe).explain(recipe).empty());
}

TEST(CloseUp, SavesTheStaysOfWhateverElementGoes) {
  for (std::uint64_t k = 3; k <= 6; ++k) {
    for (std::uint64_t v = k + 2; v <= 4 * k + 3; ++v) {
      const Design design = standard().build_design(best(v, k, 1, Kind::linear));
      const std::vector<std::uint64_t> counted = stays(v, design.blocks());
      for (Element x = 0; x < v; ++x) {
        const auto closed = closed_up(design, x);
        ASSERT_TRUE(closed);
        EXPECT_TRUE(naive_verdict(*closed).valid) << v << ' ' << k << ' ' << x;
        EXPECT_LE(closed->block_count() + counted[x], design.block_count());
      }
      const auto made = close_up_recipe(*design.recipe, design);
      ASSERT_TRUE(made);
      expect_made(made->recipe, made->b);
    }
  }
}

TEST(CloseUp, IsForLinearSingleChangeDesignsOnMoreThanOneElementBeyondABlock) {
  for (const auto& [v, m, kind] :
       {std::tuple<std::uint64_t, std::uint64_t, Kind>{9, 1, Kind::circular},
        {9, 2, Kind::linear},
        {5, 1, Kind::linear}}) {
    const Design design = standard().build_design(best(v, 4, m, kind));
    EXPECT_FALSE(closed_up(design, 0));
    EXPECT_FALSE(close_up_recipe(*design.recipe, design));
  }
  const Design design = standard().build_design(best(12, 4, 1, Kind::linear));
  EXPECT_FALSE(closed_up(design, 0, 8));
  EXPECT_FALSE(closed_up(design, 11, 2));
}

TEST(Coarsen, IsADesignForEveryChangeNumberAndFirstGroup) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    std::size_t exact = 0;
    std::size_t made = 0;
    for (std::uint64_t k = 3; k <= 6; ++k) {
      for (std::uint64_t v = 2 * k; v <= 5 * k; ++v) {
        const Design design = standard().build_design(best(v, k, 1, kind));
        for (std::uint64_t g = 2; g <= 4; ++g) {
          for (std::uint64_t first = 1; first <= g; ++first) {
            if (const auto coarse = coarsened(design, g, first)) {
              EXPECT_EQ(coarse->parameters().kind, kind);
              EXPECT_TRUE(naive_verdict(*coarse).valid)
                  << v << ' ' << k << ' ' << g << ' ' << first;
            }
          }
          if (const auto best_of = coarsen_recipe(*design.recipe, design, g)) {
            expect_made(best_of->recipe, best_of->b);
            const std::uint64_t groups = (design.block_count() + g - 1) / g;
            EXPECT_GE(best_of->b, groups);
            exact += best_of->b == groups ? 1U : 0U;
            ++made;
          }
        }
      }
    }
    EXPECT_GE(made, kind == Kind::linear ? 100U : 50U);
    EXPECT_GE(exact * 2, made);
  }
}

TEST(Interpolate, MakesEachStepInSmallerOnes) {
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    for (const auto& [m, smaller] :
         {std::pair<std::uint64_t, std::uint64_t>{2, 1}, {3, 1}, {4, 2}, {4, 1}}) {
      for (std::uint64_t v = 9; v <= 14; ++v) {
        const auto offer = standard().best({v, 5, m, kind, 2});
        ASSERT_TRUE(offer);
        expect_made(interpolate_recipe(offer->recipe, smaller),
                    interpolated_count(offer->recipe.parameters, smaller, offer->b));
      }
    }
  }
  const Recipe input = best(9, 5, 4, Kind::linear);
  EXPECT_EQ(interpolate_recipe(input, 4), input);
  EXPECT_REFUSAL((void)interpolate_recipe(input, 3), BadInput,
                 "3 does not divide the change number 4");
  EXPECT_THROW((void)interpolate_recipe(input, 0), BadInput);
}

// Wherever the stop comes, what was half made is taken apart once. Where it comes is up to the
// clock, so many are tried.
TEST(CloseUp, StopsWhereverItIs) {
  const Design design = standard().build_design(best(120, 12, 1, Kind::linear));
  std::size_t stopped = 0;
  std::size_t finished = 0;
  for (int microseconds = 0; finished < 3; microseconds += 20) {
    RunControl control({.time = std::chrono::microseconds(microseconds)});
    const RunScope scope(control);
    try {
      EXPECT_TRUE(close_up_recipe(*design.recipe, design));
      ++finished;
    } catch (const Stopped&) {
      ++stopped;
    }
  }
  EXPECT_GT(stopped, 0U);
}

TEST(RulesOnStays, RefuseSpoiltRecipes) {
  const Design design = standard().build_design(best(16, 5, 1, Kind::linear));
  const Recipe interpolated = interpolate_recipe(best(12, 5, 2, Kind::linear), 1);
  for (const Recipe& recipe : {close_up_recipe(*design.recipe, design)->recipe,
                               coarsen_recipe(*design.recipe, design, 2)->recipe, interpolated}) {
    const auto spoil = [&](const std::string& how, const auto& change) {
      Recipe spoilt = recipe;
      change(spoilt);
      expect_refused(spoilt, how);
    };
    spoil("no input", [](Recipe& r) { r.inputs.clear(); });
    spoil("two inputs", [](Recipe& r) { r.inputs.push_back(r.inputs.front()); });
    spoil("v + 1", [](Recipe& r) { ++r.parameters.v; });
    spoil("k + 1", [](Recipe& r) { ++r.parameters.k; });
    spoil("circular", [](Recipe& r) { r.parameters.kind = Kind::circular; });
    spoil("m = 0", [](Recipe& r) { r.parameters.change = 0; });
    spoil("t = 3", [](Recipe& r) { r.parameters.strength = 3; });
    spoil("an argument more", [](Recipe& r) { r.arguments["nonsense"] = 1; });
    spoil("a block", [](Recipe& r) { r.blocks.push_back({0, 1}); });
    for (const auto& [argument, value] : recipe.arguments) {
      spoil("no " + argument, [&key = argument](Recipe& r) { r.arguments.erase(key); });
      spoil(argument + " < 0", [&key = argument](Recipe& r) { r.arguments[key] = -1; });
      spoil(argument + " huge", [&key = argument](Recipe& r) { r.arguments[key] = 1 << 30; });
    }
  }
}

}  // namespace
}  // namespace changeover::rules_on_stays_test
