#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/search/base_block_search.hpp"
#include "message_of.hpp"
#include "naive_verdict.hpp"
#include "search/pair_orbits.hpp"
#include "search/symmetric/base_block_anneal.hpp"
#include "search/symmetric/base_block_sat.hpp"

namespace changeover::base_block_test {
namespace {

Parameters circular(std::uint64_t v, std::uint64_t k, std::uint64_t m = 2) {
  return {v, k, m, Kind::circular, 2};
}

BaseBlockOptions tight(std::optional<std::uint64_t> n = {}) {
  BaseBlockOptions options;
  options.shapes.tight = true;
  options.shapes.n = n;
  return options;
}

BaseBlockResult search(const Parameters& p, const BaseBlockOptions& options) {
  RunControl control({});
  return search_base_blocks(p, options, control);
}

Design developed(const Parameters& p, const BaseBlockShape& shape, std::vector<Block> blocks) {
  return Registry::standard().build_design(developed_recipe(p, shape, std::move(blocks)));
}

// ---- Shapes.

TEST(BaseBlockShapes, OfTightDesignsSatisfyTheDegreeIdentity) {
  // By trying all i and r of an element instead of by sums that can be reached.
  const auto solvable = [](const Parameters& p, std::uint64_t n, std::uint64_t c, bool everywhere) {
    for (std::uint64_t r = 1; r <= c; ++r) {
      for (std::uint64_t i = everywhere && r == c ? 0 : 1; i <= r; ++i) {
        if (n * (i * (p.k - 1) + p.change * (r - i)) == p.v - 1) {
          return true;
        }
      }
    }
    return false;
  };
  std::size_t shapes = 0;
  std::size_t with_fixed = 0;
  for (std::uint64_t m = 1; m <= 3; ++m) {
    for (std::uint64_t v = 4; v <= 30; ++v) {
      for (std::uint64_t k = std::max<std::uint64_t>(2, m); k + m <= v; ++k) {
        const Parameters p = circular(v, k, m);
        for (const BaseBlockShape& shape : base_block_shapes(p, {.tight = true})) {
          EXPECT_EQ(shape.v(), v);
          EXPECT_EQ(shape.b() * newly_covered_at_most(p), v * (v - 1) / 2);
          EXPECT_EQ(shape.n % 2, 1U);
          EXPECT_LE(shape.fixed, 1U);
          EXPECT_GE(shape.b(), lower_bound(p).blocks);
          // Of all b blocks for an element that π moves, of the c base blocks for a fixed one.
          EXPECT_TRUE(solvable(p, 1, shape.b(), false)) << name(p);
          EXPECT_TRUE(shape.fixed == 0 || solvable(p, shape.n, shape.base_blocks, true)) << name(p);
          ++shapes;
          with_fixed += shape.fixed;
        }
      }
    }
  }
  EXPECT_GE(shapes, 30U);
  EXPECT_GE(with_fixed, 3U);
}

TEST(BaseBlockShapes, OfKnownTightDesignsAreThere) {
  const auto has = [](const Parameters& p, const BaseBlockShape& shape) {
    const auto shapes = base_block_shapes(p, {.tight = true});
    return std::find(shapes.begin(), shapes.end(), shape) != shapes.end();
  };
  EXPECT_TRUE(has(circular(15, 4), {{3, 5, 0}, 7}));
  EXPECT_TRUE(has(circular(16, 4), {{3, 5, 1}, 8}));
  EXPECT_TRUE(has(circular(25, 4), {{5, 5, 0}, 12}));
  EXPECT_TRUE(has(circular(26, 4), {{13, 2, 0}, 5}));
  EXPECT_TRUE(has(circular(28, 6), {{7, 4, 0}, 6}));
  EXPECT_TRUE(has(circular(21, 3), {{7, 3, 0}, 10}));
  EXPECT_TRUE(has(circular(61, 4), {{61, 1, 0}, 6}));
}

TEST(BaseBlockShapes, MayHaveAFixedElementInEveryBlock) {
  EXPECT_FALSE(shape_obstruction(circular(7, 5), {{3, 2, 1}, 1}, true));
  EXPECT_TRUE(search(circular(7, 5), tight()).verdict().tight());
}

TEST(BaseBlockShapes, AreExcludedForThreeOpenTightDesigns) {
  // No automorphism moves the blocks of a tight circular DCCD with these parameters along.
  for (const auto& [v, k] : {std::pair{20, 4}, std::pair{18, 6}, std::pair{26, 8}}) {
    EXPECT_TRUE(
        base_block_shapes(circular(static_cast<std::uint64_t>(v), static_cast<std::uint64_t>(k)),
                          {.tight = true})
            .empty())
        << v;
  }
  EXPECT_EQ(
      shape_obstruction(circular(26, 8), {{5, 5, 1}, 5}, true),
      "a fixed element would be introduced j times in r ≥ j ≥ 1 base blocks, 7j + 2(r−j) = 5");
  EXPECT_EQ(
      shape_obstruction(circular(20, 4), {{19, 1, 1}, 2}, true),
      "a fixed element would be introduced j times in r ≥ j ≥ 1 base blocks, 3j + 2(r−j) = 1");
  EXPECT_FALSE(shape_obstruction(circular(26, 8), {{5, 5, 1}, 5}, false));
}

TEST(BaseBlockShapes, SayWhatExcludesThem) {
  const auto why = [](std::uint64_t v, std::uint64_t k, const BaseBlockShape& shape) {
    return shape_obstruction(circular(v, k), shape, true).value_or("");
  };
  EXPECT_EQ(why(15, 4, {{3, 5, 0}, 8}), "24 blocks newly cover 5 pairs each, and there are 105");
  EXPECT_EQ(why(10, 4, {{2, 5, 0}, 5}), "10 blocks newly cover 5 pairs each, and there are 45");
  EXPECT_EQ(why(8, 5, {{4, 2, 0}, 1}),
            "at least 5 blocks are needed: " + lower_bound(circular(8, 5)).reason);
  EXPECT_NE(why(15, 4, {{4, 5, 0}, 7}).find("v = 15 is not"), std::string::npos);
  EXPECT_NE(why(5, 4, {{5, 1, 0}, 2}), "");
  EXPECT_NE(why(16, 4, {{2, 8, 0}, 12}).find("is even"), std::string::npos);
  EXPECT_NE(why(26, 4, {{5, 4, 6}, 13}).find("two of 6 fixed elements"), std::string::npos);
}

TEST(BaseBlockShapes, ComeFewestBlocksFirst) {
  const auto shapes = base_block_shapes(circular(12, 4), {.most_blocks = 30});
  ASSERT_FALSE(shapes.empty());
  EXPECT_TRUE(std::is_sorted(shapes.begin(), shapes.end(),
                             [](const auto& a, const auto& b) { return a.b() < b.b(); }));
  EXPECT_LE(shapes.back().b(), 30U);
  EXPECT_EQ(base_block_shapes(circular(12, 4), {.n = 11, .fixed = 1}),
            (std::vector<BaseBlockShape>{{{11, 1, 1}, 2}}));
  EXPECT_TRUE(base_block_shapes(circular(12, 4), {.n = 7}).empty());
  EXPECT_EQ(base_block_shapes(circular(12, 4), {.n = 12, .base_blocks = 9}).size(), 1U);
  EXPECT_EQ(to_string(BaseBlockShape{{13, 2, 0}, 5}), "5 base blocks, 2 cycles of length 13");
  EXPECT_EQ(to_string(BaseBlockShape{{11, 1, 1}, 1}),
            "1 base block, 1 cycle of length 11, 1 fixed point");
}

TEST(PairOrbits, AreTheOrbitsOfPairs) {
  for (const Automorphism& pi : {Automorphism{7, 1, 0}, Automorphism{6, 1, 0},
                                 Automorphism{4, 2, 1}, Automorphism{3, 2, 3}}) {
    const PairOrbits orbits(pi);
    std::set<std::uint32_t> numbers;
    for (Element x = 0; x < pi.v(); ++x) {
      for (Element y = 0; y < x; ++y) {
        numbers.insert(orbits.of(x, y));
        EXPECT_EQ(orbits.of(x, y), orbits.of(y, x));
        EXPECT_EQ(orbits.of(x, y), orbits.of(pi.image(x, 1), pi.image(y, 1)));
      }
    }
    EXPECT_EQ(numbers.size(), orbits.count());
    EXPECT_EQ(*numbers.rbegin() + 1, orbits.count());
    EXPECT_EQ(pi.pair_orbits(), orbits.count());
  }
  EXPECT_EQ(PairOrbits({7, 1, 0}).count(), 3U);
  EXPECT_EQ(PairOrbits({6, 1, 0}).count(), 3U);
  EXPECT_EQ(PairOrbits({3, 2, 3}).count(), 2U + 3 + 6 + 3);
}

// ---- Both methods against trying everything.

// Calls visit with every list of c blocks of k elements below v.
void for_each_list(std::uint64_t v, std::uint64_t k, std::size_t c,
                   const std::function<bool(const std::vector<Block>&)>& visit) {
  std::vector<Block> all;
  Block chosen;
  const std::function<void(Element)> choose = [&](Element from) {
    if (chosen.size() == k) {
      all.push_back(chosen);
      return;
    }
    for (Element x = from; x < v; ++x) {
      chosen.push_back(x);
      choose(x + 1);
      chosen.pop_back();
    }
  };
  choose(0);
  std::vector<std::size_t> which(c, 0);
  for (bool more = true; more;) {
    std::vector<Block> list;
    for (const std::size_t i : which) {
      list.push_back(all[i]);
    }
    if (visit(list)) {
      return;
    }
    more = false;
    for (std::size_t& i : which) {
      if (++i < all.size()) {
        more = true;
        break;
      }
      i = 0;
    }
  }
}

// Whether some base blocks of this shape develop into a design; by the definition.
bool exists(const Parameters& p, const BaseBlockShape& shape, bool want_tight) {
  bool found = false;
  for_each_list(
      p.v, p.k, static_cast<std::size_t>(shape.base_blocks), [&](const std::vector<Block>& blocks) {
        const test::NaiveVerdict verdict = test::naive_verdict(developed(p, shape, blocks));
        found = verdict.valid &&
                (!want_tight || (verdict.excess == 0 && verdict.never_newly_covered == 0));
        return found;
      });
  return found;
}

TEST(BaseBlocksBySat, AgreeWithTryingEverything) {
  struct Case {
    Parameters p;
    BaseBlockShape shape;
  };
  std::size_t some = 0;
  std::size_t none = 0;
  for (const Case& each :
       std::vector<Case>{{circular(5, 3), {{5, 1, 0}, 1}},    {circular(6, 3), {{6, 1, 0}, 1}},
                         {circular(7, 3), {{7, 1, 0}, 1}},    {circular(6, 3), {{5, 1, 1}, 1}},
                         {circular(6, 4), {{3, 2, 0}, 1}},    {circular(6, 4), {{6, 1, 0}, 1}},
                         {circular(7, 4), {{3, 2, 1}, 2}},    {circular(7, 4), {{7, 1, 0}, 1}},
                         {circular(7, 5), {{3, 2, 1}, 1}},    {circular(5, 2), {{5, 1, 0}, 2}},
                         {circular(6, 2), {{5, 1, 1}, 3}},    {circular(5, 3, 1), {{5, 1, 0}, 1}},
                         {circular(6, 3, 1), {{3, 2, 0}, 3}}, {circular(6, 3, 1), {{5, 1, 1}, 2}},
                         {circular(5, 2, 1), {{5, 1, 0}, 2}}, {circular(4, 2, 1), {{2, 2, 0}, 3}},
                         {circular(4, 2, 1), {{3, 1, 1}, 2}}, {circular(4, 2, 1), {{2, 1, 2}, 4}},
                         {circular(7, 3, 3), {{7, 1, 0}, 1}}, {circular(7, 3, 3), {{7, 1, 0}, 2}},
                         {circular(8, 4, 3), {{7, 1, 1}, 1}}, {circular(8, 5), {{4, 2, 0}, 1}}}) {
    for (const bool want_tight : {false, true}) {
      RunControl control({});
      const BaseBlocksBySat result =
          base_blocks_by_sat(each.p, each.shape, want_tight, std::nullopt, control);
      const bool found = result.outcome == Outcome::found;
      EXPECT_NE(result.outcome, Outcome::unknown);
      EXPECT_NE(result.blocks.empty(), found);
      EXPECT_EQ(found, exists(each.p, each.shape, want_tight))
          << name(each.p) << " " << to_string(each.shape) << (want_tight ? " tight" : "");
      if (found) {
        const auto verdict = test::naive_verdict(developed(each.p, each.shape, result.blocks));
        EXPECT_TRUE(verdict.valid);
        EXPECT_TRUE(!want_tight || verdict.excess == 0);
      }
      (found ? some : none) += 1;
    }
  }
  EXPECT_GE(some, 10U);
  EXPECT_GE(none, 10U);
}

TEST(BaseBlocksBySat, GiveUpAtTheLimitOfConflicts) {
  RunControl control({});
  const BaseBlocksBySat result =
      base_blocks_by_sat(circular(27, 6), {{3, 9, 0}, 13}, true, 200, control);
  EXPECT_TRUE(result.blocks.empty());
  EXPECT_EQ(result.outcome, Outcome::unknown);
  EXPECT_GE(result.conflicts, 100U);
}

RC_GTEST_PROP(RandomBaseBlocks, HaveTheChangeProperty, ()) {
  const auto n = *rc::gen::inRange<std::uint64_t>(5, 20);
  const BaseBlockShape shape{
      {n, *rc::gen::inRange<std::uint64_t>(1, 4), *rc::gen::inRange<std::uint64_t>(0, 3)},
      *rc::gen::inRange<std::uint64_t>(1, 8)};
  const auto m = *rc::gen::inRange<std::uint64_t>(1, 4);
  const Parameters p = circular(
      shape.v(), *rc::gen::inRange<std::uint64_t>(std::max<std::uint64_t>(m, 2), n - 1), m);
  RC_PRE(p.k + m <= p.v);
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const std::vector<Block> blocks = random_base_blocks(p, shape, random);
  RC_PRE(!blocks.empty());
  RC_ASSERT(verify(developed(p, shape, blocks)).bad_steps == 0U);
}

// ---- The search.

TEST(SearchBaseBlocks, FindsTheCyclicDesignsOfThePaper) {
  for (const auto& [v, k] :
       {std::pair{11, 4}, std::pair{7, 3}, std::pair{15, 5}, std::pair{21, 4}}) {
    const Parameters p = circular(static_cast<std::uint64_t>(v), static_cast<std::uint64_t>(k));
    const BaseBlockResult result = search(p, tight(p.v));
    ASSERT_TRUE(result.found()) << v;
    EXPECT_TRUE(result.verdict().tight());
    EXPECT_EQ(result.comparison, Comparison::equal);
    EXPECT_EQ(result.why_stopped, WhyStopped::found);
  }
}

TEST(SearchBaseBlocks, FindsTightCircularDesignsWithSeveralCycles) {
  for (const auto& [v, k, n] : {std::tuple{15, 4, 3}, std::tuple{16, 4, 3}, std::tuple{26, 4, 13},
                                std::tuple{28, 6, 7}, std::tuple{21, 3, 7}}) {
    const Parameters p = circular(static_cast<std::uint64_t>(v), static_cast<std::uint64_t>(k));
    const BaseBlockResult result = search(p, tight(static_cast<std::uint64_t>(n)));
    ASSERT_TRUE(result.found()) << v;
    EXPECT_TRUE(result.verdict().tight());
    EXPECT_TRUE(result.verdict().economical());
    EXPECT_EQ(result.shape.n, static_cast<std::uint64_t>(n));
    EXPECT_EQ(result.design->recipe(), result.recipe);
    EXPECT_EQ(result.recipe->blocks.size(), result.shape.base_blocks);
    EXPECT_FALSE(result.recipe->provenance.empty());
    EXPECT_NE(describe(result).find("tight"), std::string::npos);
  }
}

TEST(SearchBaseBlocks, SlowFindsTheTightDccd25x4) {
  const BaseBlockResult result = search(circular(25, 4), tight(5));
  ASSERT_TRUE(result.found());
  EXPECT_TRUE(result.verdict().tight());
  EXPECT_EQ(result.verdict().b, 60U);
}

TEST(SearchBaseBlocks, FindsTightDesignsForOtherChangeNumbers) {
  for (const Parameters& p :
       {circular(9, 3, 1), circular(13, 4, 1), circular(13, 3, 3), circular(13, 4, 3),
        circular(19, 5, 3), circular(25, 6, 3), circular(28, 4, 4)}) {
    const BaseBlockResult result = search(p, tight());
    ASSERT_TRUE(result.found()) << name(p);
    EXPECT_TRUE(result.verdict().tight()) << name(p);
  }
}

TEST(SearchBaseBlocks, FindsTheTightCircularSccd9x4) {
  const BaseBlockResult result = search(circular(9, 4, 1), tight());
  ASSERT_TRUE(result.found());
  EXPECT_TRUE(result.verdict().tight());
  EXPECT_EQ(result.verdict().b, 12U);
  EXPECT_EQ(result.comparison, Comparison::equal);
}

TEST(SearchBaseBlocks, AnnealsWhereThereIsSlack) {
  BaseBlockOptions options;
  options.method = BaseBlockMethod::anneal;
  options.shapes.n = 29;
  options.shapes.fixed = 1;
  options.shapes.base_blocks = 3;
  const BaseBlockResult result = search(circular(30, 5), options);
  ASSERT_TRUE(result.found());
  EXPECT_TRUE(result.verdict().valid());
  EXPECT_LE(result.verdict().b, 87U);
  EXPECT_EQ(result.conflicts, 0U);
  EXPECT_GT(result.moves, 0U);
}

TEST(SearchBaseBlocks, GoesOnInRounds) {
  const Parameters p{.v = 26, .k = 4, .kind = Kind::circular};
  BaseBlockOptions options{.shapes = {.n = 13, .tight = true}};
  options.method = BaseBlockMethod::anneal;
  options.moves = 500;
  RunControl one({.threads = 1, .seed = 1});
  const BaseBlockResult before = search_base_blocks(p, options, one);
  EXPECT_FALSE(before.found());
  EXPECT_EQ(before.why_stopped, WhyStopped::step_limit);
  EXPECT_LE(before.moves, 500U * before.attempts.size());
  options.rounds = 14;
  RunControl many({.threads = 1, .seed = 1});
  const BaseBlockResult after = search_base_blocks(p, options, many);
  ASSERT_TRUE(after.found());
  EXPECT_TRUE(after.verdict().tight());
  // A shape that is tried again is still one.
  EXPECT_EQ(after.attempts.size(), before.attempts.size());
  std::uint64_t moves = 0;
  for (const ShapeAttempt& attempt : after.attempts) {
    moves += attempt.moves;
  }
  EXPECT_EQ(after.moves, moves);
}

TEST(SearchBaseBlocks, IsDeterministic) {
  for (const BaseBlockMethod method :
       {BaseBlockMethod::automatic, BaseBlockMethod::sat, BaseBlockMethod::anneal}) {
    BaseBlockOptions options;
    options.method = method;
    options.shapes.n = 13;
    options.shapes.most_blocks = 13;
    const BaseBlockResult once = search(circular(13, 5), options);
    const BaseBlockResult again = search(circular(13, 5), options);
    ASSERT_TRUE(once.found());
    EXPECT_EQ(once.base_blocks, again.base_blocks);
    EXPECT_EQ(once.moves, again.moves);
    EXPECT_EQ(once.conflicts, again.conflicts);
  }
}

TEST(SearchBaseBlocks, FamilyForTripleChangeIsTightForEveryK) {
  // docs/new_designs.md: {0, …, n−1, 2n, 3n} over Z_{6n+1}, n = k − 2.
  for (Element k = 4; k <= 40; ++k) {
    const Element n = k - 2;
    Block block(n);
    std::iota(block.begin(), block.end(), Element{0});
    block.insert(block.end(), {2 * n, 3 * n});
    const Parameters p = circular(6 * n + 1, k, 3);
    EXPECT_TRUE(verify(developed(p, {{p.v, 1, 0}, 1}, {block})).tight()) << k;
    block.back() = 3 * n - 1;
    EXPECT_FALSE(verify(developed(p, {{p.v, 1, 0}, 1}, {block})).tight()) << k;
  }
}

TEST(SearchBaseBlocks, CutsALinearDesignOpen) {
  Parameters p = circular(15, 4);
  p.kind = Kind::linear;
  const BaseBlockResult result = search(p, tight(3));
  ASSERT_TRUE(result.found());
  EXPECT_EQ(result.recipe->construction, "cut");
  EXPECT_EQ(result.verdict().parameters, p);
  EXPECT_TRUE(result.verdict().valid());
}

TEST(SearchBaseBlocks, GivesTheSameDesignForEveryShift) {
  for (const std::uint64_t shift : {2U, 5U, 12U}) {
    BaseBlockOptions options = tight(13);
    options.shift = shift;
    const BaseBlockResult result = search(circular(26, 4), options);
    ASSERT_TRUE(result.found());
    EXPECT_TRUE(result.verdict().tight());
    EXPECT_EQ(result.recipe->arguments.at("shift"), static_cast<std::int64_t>(shift));
  }
  BaseBlockOptions options = tight(13);
  options.shift = 26;
  EXPECT_REFUSAL((void)search(circular(26, 4), options), BadInput,
                 "the shift 26 is not a unit of Z_13; give a number coprime to 13");
}

TEST(SearchBaseBlocks, SaysThatAllShapesAreExcluded) {
  const BaseBlockResult result = search(circular(18, 6), tight());
  EXPECT_FALSE(result.found());
  EXPECT_EQ(result.why_stopped, WhyStopped::exhausted);
  EXPECT_EQ(describe(result), "No shape of base blocks passes the counting conditions.");
  const BaseBlockResult none =
      search({.v = 25, .k = 7, .change = 3, .kind = Kind::circular}, tight());
  EXPECT_EQ(none.why_stopped, WhyStopped::exhausted);
  EXPECT_NE(describe(none).find("the SAT solver says"), std::string::npos);
}

TEST(SearchBaseBlocks, StopsWhenToldTo) {
  RunControl control({.time = std::chrono::seconds(0)});
  const BaseBlockResult result = search_base_blocks(circular(27, 6), tight(), control);
  EXPECT_FALSE(result.found());
  EXPECT_EQ(result.why_stopped, WhyStopped::time_limit);
  BaseBlockOptions options = tight();
  options.conflicts = 50;
  options.moves = 1000;
  EXPECT_EQ(search(circular(27, 6), options).why_stopped, WhyStopped::step_limit);
}

TEST(SearchBaseBlocks, RefusesWhatItIsNotFor) {
  EXPECT_THROW((void)search(circular(3000, 4), {}), ImpossibleParameters);
  EXPECT_THROW((void)search({9, 4, 2, Kind::circular, 3}, {}), ImpossibleParameters);
  EXPECT_THROW((void)search(circular(3, 4), {}), ImpossibleParameters);
}

TEST(SearchBaseBlocks, MutatedBaseBlocksAreNoTightDesign) {
  const Parameters p = circular(26, 4);
  const BaseBlockResult result = search(p, tight(13));
  ASSERT_TRUE(result.found());
  const auto is_tight = [&](const std::vector<Block>& blocks) {
    return verify(developed(p, result.shape, blocks)).tight();
  };
  ASSERT_TRUE(is_tight(result.base_blocks));
  // One element exchanged: as a block changes its steps, hardly any can stay tight. All that do are
  // counted by the definition as well.
  for (std::size_t i = 0; i < result.base_blocks.size(); ++i) {
    for (std::size_t place = 0; place < p.k; ++place) {
      for (Element y = 0; y < p.v; ++y) {
        std::vector<Block> blocks = result.base_blocks;
        if (std::find(blocks[i].begin(), blocks[i].end(), y) != blocks[i].end()) {
          continue;
        }
        blocks[i][place] = y;
        const Verdict verdict = verify(developed(p, result.shape, blocks));
        EXPECT_FALSE(verdict.tight()) << i << " " << place << " " << y;
      }
    }
  }
  std::vector<Block> swapped = result.base_blocks;
  std::swap(swapped[0], swapped[2]);
  EXPECT_FALSE(is_tight(swapped));
  std::vector<Block> link = result.base_blocks;  // the link to π(B₀) alone is broken
  std::rotate(link.begin(), link.begin() + 1, link.end());
  EXPECT_GT(verify(developed(p, result.shape, link)).bad_steps, 0U);
  std::vector<Block> dropped = result.base_blocks;
  dropped.pop_back();
  EXPECT_FALSE(is_tight(dropped));
}

}  // namespace
}  // namespace changeover::base_block_test
