// No construction and no rule of the registry is left without a property: what offers designs is
// asked at random, what works on a design is given random ones, and a name that is in neither table
// fails.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "changeover/construct/closure.hpp"
#include "construct/tools/concatenation/groups.hpp"
#include "construction_checks.hpp"

namespace changeover::every_construction_test {
namespace {

using namespace test;

std::uint64_t below(std::mt19937& random, std::uint64_t n) {
  return std::uniform_int_distribution<std::uint64_t>(0, n - 1)(random);
}

// ---- What offers designs ------------------------------------------------------------------------

using Offers = std::map<std::string, std::vector<Offer>, std::less<>>;

/// Offers of each construction in a box of parameters, and of those that serve only others.
const Offers& offers_by_name() {
  static const Offers offers = [] {
    Offers found;
    const auto ask = [&](const Parameters& p) {
      if (impossibility(p)) {
        return;
      }
      for (const Construction* one : standard().constructions()) {
        const auto offer = one->offer(p, standard());
        if (offer && offer->b * p.k <= 20'000) {
          found[std::string(one->name())].push_back(*offer);
        }
      }
    };
    for (const Kind kind : {Kind::linear, Kind::circular}) {
      for (std::uint64_t v = 4; v <= 34; ++v) {
        for (std::uint64_t k = 2; k <= std::min<std::uint64_t>(v, 12); ++k) {
          for (std::uint64_t m = 1; m <= std::min<std::uint64_t>(k, 4); ++m) {
            ask({v, k, m, kind, 2});
          }
        }
      }
      ask({61, 4, 2, kind, 2});
      ask({83, 4, 2, kind, 2});
      ask({35, 6, 1, kind, 2});
      ask({45, 7, 1, kind, 2});
      ask({46, 4, 2, kind, 2});
      ask({82, 6, 2, kind, 2});
      ask({25, 4, 2, kind, 2});
      for (std::uint64_t v = 8; v <= 14; ++v) {  // some cover more than pairs
        ask({v, v - 2, 2, kind, 3});
        ask({v, v - 1, 1, kind, 4});
        ask({v, 3, 1, kind, 3});
      }
    }
    return found;
  }();
  return offers;
}

RC_GTEST_PROP(EveryConstruction, BuildsWhatItPromises, (std::uint32_t seed)) {
  std::mt19937 random(seed);
  for (const auto& [name, offers] : offers_by_name()) {
    // Small ones most of the time: the definition is slow.
    const Offer* chosen = &offers[below(random, offers.size())];
    for (int tries = 0; tries < 3; ++tries) {
      const Offer& other = offers[below(random, offers.size())];
      chosen = other.b * other.recipe.parameters.k < chosen->b * chosen->recipe.parameters.k
                   ? &other
                   : chosen;
    }
    expect_as_promised(*chosen);
    RC_ASSERT(!::testing::Test::HasFailure());
  }
}

// ---- What works on a design ---------------------------------------------------------------------

/// A design that a random walk makes: each step exchanges m elements, until all pairs were there
/// and, if it is circular, the first block is one step away. nullopt if that takes too long.
std::optional<Design> walk(const Parameters& p, std::mt19937& random) {
  std::vector<Element> elements(static_cast<std::size_t>(p.v));
  std::iota(elements.begin(), elements.end(), Element{0});
  std::shuffle(elements.begin(), elements.end(), random);
  const auto k = static_cast<std::ptrdiff_t>(p.k);
  const auto m = static_cast<std::ptrdiff_t>(p.change);
  std::vector<Block> blocks;
  std::set<std::pair<Element, Element>> met;
  for (int steps = 0; steps < 400; ++steps) {
    Block block(elements.begin(), elements.begin() + k);
    std::sort(block.begin(), block.end());
    for (std::size_t j = 0; j < block.size(); ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        met.insert({block[i], block[j]});
      }
    }
    blocks.push_back(block);
    Block lost;
    std::set_difference(blocks.front().begin(), blocks.front().end(), block.begin(), block.end(),
                        std::back_inserter(lost));
    const bool closed = blocks.size() > 2 && lost.size() == p.change;
    if (met.size() == p.v * (p.v - 1) / 2 && (p.kind == Kind::linear || closed)) {
      return Design(p, blocks);
    }
    std::shuffle(elements.begin(), elements.begin() + k, random);
    std::shuffle(elements.begin() + k, elements.end(), random);
    std::swap_ranges(elements.begin(), elements.begin() + m, elements.begin() + k);
  }
  return std::nullopt;
}

/// A valid design by whatever means, and a recipe that builds it.
std::pair<Recipe, Design> random_input(std::mt19937& random) {
  while (true) {
    const std::uint64_t m = 1 + below(random, 3);
    const std::uint64_t k = std::max<std::uint64_t>(m + below(random, 5), 2);
    const Parameters p{k + m + below(random, 6), k, m,
                       below(random, 2) == 0 ? Kind::linear : Kind::circular, 2};
    if (impossibility(p)) {
      continue;
    }
    if (below(random, 2) == 0) {
      if (const auto design = walk(p, random)) {
        return {literal_recipe(*design, "a walk"), *design};
      }
    } else if (const auto offers = standard().offers(p); !offers.empty()) {
      const Recipe& recipe = offers[below(random, offers.size())].recipe;
      return {recipe, standard().build_design(recipe)};
    }
  }
}

/// What a rule makes of an input, and what it says beforehand.
struct Result {
  Recipe recipe;
  Parameters parameters;
  std::uint64_t b = 0;
};

using Rule = std::function<std::optional<Result>(const Recipe&, const Design&, std::mt19937&)>;

Parameters with(Parameters p, std::uint64_t v, std::uint64_t k, std::uint64_t m) {
  p.v = v;
  p.k = k;
  p.change = m;
  return p;
}

std::optional<Result> of_made(const std::optional<Made>& made, const Parameters& p) {
  return made ? std::optional(Result{made->recipe, p, made->b}) : std::nullopt;
}

const std::map<std::string, Rule, std::less<>>& rules() {
  static const std::map<std::string, Rule, std::less<>> all{
      {"blow-up",
       [](const Recipe& r, const Design& d, std::mt19937& random) {
         const Parameters& p = r.parameters;
         const std::uint64_t s = 2 + below(random, 2);
         return std::optional(Result{blow_up_recipe(r, s), with(p, s * p.v, s * p.k, s * p.change),
                                     d.block_count()});
       }},
      {"close-up",
       [](const Recipe& r, const Design& d, std::mt19937&) {
         const Parameters& p = r.parameters;
         return of_made(close_up_recipe(r, d), with(p, p.v - 1, p.k, p.change));
       }},
      {"coarsen",
       [](const Recipe& r, const Design& d, std::mt19937& random) {
         const Parameters& p = r.parameters;
         const std::uint64_t g = 2 + below(random, 2);
         return of_made(coarsen_recipe(r, d, g), with(p, p.v, p.k + g - 1, g));
       }},
      {"concatenate-groups",
       [](const Recipe& r, const Design& d, std::mt19937&) -> std::optional<Result> {
         if (d.parameters().change < 2 || d.parameters().change >= d.k()) {
           return std::nullopt;
         }
         const Groups groups{2 + d.v() % 3, 1 + d.block_count() % 4};
         const std::uint64_t classes = class_count(groups, d.parameters().change);
         for (const Hinge& hinge : hinges(d)) {
           if (classes == 0 || classes > hinge.positions.size()) {
             continue;
           }
           const std::uint64_t h = d.v() - hinge.positions.size() * (d.k() - d.parameters().change);
           Parameters piece = with(d.parameters(), groups.size + h, d.k(), d.parameters().change);
           piece.kind = Kind::circular;
           const auto ring = piece.v > piece.k ? standard().best(piece) : std::nullopt;
           if (ring && !opened(standard().build_design(ring->recipe), h, 0)) {
             continue;
           }
           const Grouping how{groups, hinge, 0};
           const Parameters p = with(d.parameters(), d.v() + groups.groups * groups.size, d.k(),
                                     d.parameters().change);
           const auto more = piece_blocks(p, how, h, ring ? std::optional(ring->b) : std::nullopt,
                                          std::nullopt, false);
           if (more) {
             return Result{
                 concatenate_groups_recipe(
                     p, how, r, ring ? std::optional(ring->recipe) : std::nullopt, std::nullopt),
                 p,
                 d.block_count() + *more +
                     hinge.positions.size() * groups.groups * groups.size / d.parameters().change};
           }
         }
         return std::nullopt;
       }},
      {"cut",
       [](const Recipe& r, const Design& d, std::mt19937& random) -> std::optional<Result> {
         if (r.parameters.kind != Kind::circular) {
           return std::nullopt;
         }
         Parameters p = r.parameters;
         p.kind = Kind::linear;
         return Result{cut_recipe(r, below(random, d.block_count())), p, d.block_count()};
       }},
      {"developed",
       [](const Recipe& r, const Design& d, std::mt19937&) -> std::optional<Result> {
         const auto base = standard().construction_of(r).base_blocks(r);
         if (!base) {
           return std::nullopt;
         }
         const auto v = static_cast<std::int64_t>(r.parameters.v);
         return Result{
             {"developed", r.parameters, {{"n", v}, {"f", 0}, {"shift", 1}}, {}, base->blocks},
             r.parameters,
             d.block_count()};
       }},
      {"drop",
       [](const Recipe& r, const Design& d, std::mt19937&) {
         return std::optional(Result{drop_recipe(r), r.parameters, needed_block_count(d)});
       }},
      {"fix",
       [](const Recipe& r, const Design& d, std::mt19937& random) {
         const Parameters& p = r.parameters;
         const std::uint64_t f = 1 + below(random, 3);
         return std::optional(
             Result{fix_recipe(r, f), with(p, p.v + f, p.k + f, p.change), d.block_count()});
       }},
      {"interpolate",
       [](const Recipe& r, const Design& d, std::mt19937&) -> std::optional<Result> {
         const Parameters& p = r.parameters;
         if (p.change == 1) {
           return std::nullopt;
         }
         return Result{interpolate_recipe(r, 1), with(p, p.v, p.k, 1),
                       interpolated_count(p, 1, d.block_count())};
       }},
      {"join-ends",
       [](const Recipe& r, const Design& d, std::mt19937&) {
         Parameters p = r.parameters;
         p.kind = Kind::circular;
         return of_made(join_ends_recipe(r, d), p);
       }},
      {"literal",
       [](const Recipe& r, const Design& d, std::mt19937&) {
         return std::optional(Result{literal_recipe(d, "as it is"), r.parameters, d.block_count()});
       }},
      {"partial-expansion",
       [](const Recipe& r, const Design& d, std::mt19937& random) -> std::optional<Result> {
         const Parameters& p = r.parameters;
         const std::uint64_t w = p.change * (1 + below(random, 2));
         const auto cover = cover_positions(d);
         if (!cover || !new_elements_fit(p, w)) {
           return std::nullopt;
         }
         const auto b = partial_expansion_count(p, d.block_count(), *cover, w);
         if (!b) {
           return std::nullopt;
         }
         return Result{partial_expansion_recipe(r, *cover, w), with(p, p.v + w, p.k, p.change), *b};
       }},
      {"truncate",
       [](const Recipe& r, const Design& d, std::mt19937&) -> std::optional<Result> {
         const Parameters& p = r.parameters;
         const auto made = truncate_recipe(r, d);
         return made
                    ? std::optional(Result{*made, with(p, p.v - 1, p.k, p.change), d.block_count()})
                    : std::nullopt;
       }},
      {"unfix",
       [](const Recipe& r, const Design& d, std::mt19937&) -> std::optional<Result> {
         const Recipe larger = fix_recipe(r, 1);
         const auto made = unfix_recipe(larger, standard().build_design(larger));
         return made ? std::optional(Result{*made, r.parameters, d.block_count()}) : std::nullopt;
       }},
  };
  return all;
}

RC_GTEST_PROP(EveryRule, MakesAValidDesignOfAnyValidOne, (std::uint32_t seed)) {
  std::mt19937 random(seed);
  const auto [input, design] = random_input(random);
  RC_ASSERT(naive_verdict(design).valid);
  for (const auto& [rule, apply] : rules()) {
    const std::optional<Result> result = apply(input, design, random);
    if (!result) {
      continue;
    }
    SCOPED_TRACE(rule + " of a " + name(design.parameters()) + " by " + input.construction);
    RC_LOG() << rule << " of a " << name(design.parameters()) << " by " << input.construction;
    const auto source = standard().build(result->recipe);
    RC_ASSERT(source->parameters() == result->parameters);
    RC_ASSERT(result->recipe.parameters == result->parameters);
    RC_ASSERT(source->block_count() == result->b);
    const Verdict verdict = verify(*source);
    RC_ASSERT(verdict.b == result->b);
    RC_ASSERT(verdict.valid());
    const Design made = standard().build_design(result->recipe);
    RC_ASSERT(made.block_count() == result->b);
    if (made.v() * made.block_count() <= 600) {
      RC_ASSERT(naive_verdict(made).valid);
    }
  }
}

TEST(EveryRule, IsAppliedSometimes) {
  std::mt19937 random(3);
  std::map<std::string, int, std::less<>> times;
  for (int i = 0; i < 150; ++i) {
    const auto [input, design] = random_input(random);
    for (const auto& [rule, apply] : rules()) {
      times[rule] += apply(input, design, random) ? 1 : 0;
    }
  }
  for (const auto& [rule, apply] : rules()) {
    EXPECT_GT(times[rule], 0) << rule << " fits none of the random inputs";
  }
}

// The tables and the registry are the same set: a new construction that offers nothing in the box,
// and is no rule of the table, has no property yet.
TEST(EveryConstruction, HasAProperty) {
  std::set<std::string, std::less<>> names;
  for (const Construction* one : standard().constructions()) {
    names.emplace(one->name());
    EXPECT_TRUE(offers_by_name().contains(one->name()) || rules().contains(one->name()))
        << one->name()
        << ": give it a row in rules(), or parameters in offers_by_name() that it serves";
  }
  for (const auto& [rule, apply] : rules()) {
    EXPECT_TRUE(names.contains(rule)) << rule << " is not in the registry";
  }
  EXPECT_GE(names.size(), 35U);
}

}  // namespace
}  // namespace changeover::every_construction_test
