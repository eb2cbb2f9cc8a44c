#include "changeover/construct/best_known.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <map>

#include "changeover/construct/closure.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "changeover/verify/verdict.hpp"
#include "construct/entry.hpp"
#include "message_of.hpp"
#include "naive_verdict.hpp"
#include "oracle_minima.hpp"

namespace changeover::best_known_test {
namespace {

bool valid(const Design& design) { return verify(design).valid(); }

const Registry& registry() { return Registry::standard(); }

TEST(Planner, FillsEveryCellWithAValidDesignThatIsNoWorseThanHoldAndStream) {
  const Construction& fallback = *registry().find("hold-and-stream");
  for (std::uint64_t m = 1; m <= 2; ++m) {
    const BestKnownTable plan = best_known_table(
        registry(), {.v_from = 3, .v_to = 45, .k_from = 3, .k_to = 8, .change = m});
    for (const KnownCell& cell : plan.cells()) {
      const Parameters& p = cell.parameters;
      if (cell.impossible) {
        EXPECT_TRUE(p.v < p.k || impossibility(p)) << name(p);
        EXPECT_FALSE(cell.best);
        continue;
      }
      ASSERT_TRUE(cell.best) << name(p);
      ASSERT_EQ(cell.best->recipe.parameters, p);
      const Design design = registry().build_design(cell.best->recipe);
      ASSERT_TRUE(valid(design)) << name(p);
      ASSERT_EQ(design.block_count(), cell.best->b) << name(p);
      ASSERT_GE(cell.best->b, cell.bound.blocks) << name(p);
      if (const auto other = fallback.offer(p, registry())) {
        ASSERT_LE(cell.best->b, other->b) << name(p);
      }
      if (const auto other = registry().best(p)) {
        ASSERT_LE(cell.best->b, other->b) << name(p);
      }
      if (p.v <= 10) {
        ASSERT_TRUE(test::naive_verdict(design).valid) << name(p);
      }
    }
  }
}

TEST(Planner, NeverBeatsAKnownMinimumAndSaysMinimumOnlyWhereItIs) {
  std::size_t met = 0;
  for (const auto& [p, b] : test::oracle_minima()) {
    const BestKnownTable plan = best_known_table(
        registry(),
        {.v_from = p.v, .v_to = p.v + 4, .k_from = p.k, .k_to = p.k, .change = p.change});
    const KnownCell& cell = plan.at(p);
    ASSERT_TRUE(cell.best) << name(p);
    EXPECT_GE(cell.best->b, b) << name(p);
    met += cell.best->b == b ? 1U : 0U;
    if (cell.status() == "minimum") {
      EXPECT_EQ(cell.best->b, b) << name(p);
    }
  }
  EXPECT_GT(met, 60U);
}

// One more element in every block: no cell needs more blocks than the one before it on its diagonal.
// The first three ranges hold the cells that come with the catalog, the others are worked out.
TEST(Planner, NeedsNoMoreBlocksForALargerDesignWithAFixedElement) {
  std::size_t compared = 0;
  for (std::uint64_t m = 1; m <= 8; ++m) {
    const bool stored = m <= 3;
    const BestKnownTable plan = best_known_table(registry(), {.v_from = 3,
                                                              .v_to = stored ? 160U : 46U,
                                                              .k_from = 2,
                                                              .k_to = stored ? 40U : 23U,
                                                              .change = m});
    std::map<Parameters, std::uint64_t> blocks;
    for (const KnownCell& cell : plan.cells()) {
      if (cell.best) {
        blocks[cell.parameters] = cell.best->b;
      }
    }
    for (const auto& [p, b] : blocks) {
      Parameters larger = p;
      ++larger.v;
      ++larger.k;
      if (const auto found = blocks.find(larger); found != blocks.end()) {
        EXPECT_LE(found->second, b) << name(larger) << " and " << name(p);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 25'000U);
}

// Promises a design on 8 elements in three blocks, and does not keep it.
class Liar final : public Construction {
 public:
  std::string_view name() const override { return "liar"; }
  std::string_view summary() const override { return ""; }
  std::string_view preconditions() const override { return ""; }
  std::string_view guarantee() const override { return ""; }
  Citation citation() const override { return {}; }
  std::optional<Offer> offer(const Parameters& p, const Registry&) const override {
    return p.v == 8 && p.k == 4 ? std::optional(Offer{{"liar", p, {}, {}, blocks()}, 3})
                                : std::nullopt;
  }
  std::unique_ptr<BlockSource> build(const Recipe& recipe, const Registry&) const override {
    return std::make_unique<BlockListSource>(recipe.parameters, recipe.blocks);
  }
  std::string explain(const Recipe&) const override { return ""; }

 private:
  static std::vector<Block> blocks() { return {{0, 1, 2, 3}, {2, 3, 4, 5}, {4, 5, 6, 7}}; }
};

TEST(Planner, RefusesADesignThatItsConstructionDoesNotKeep) {
  const Liar liar;
  EXPECT_THROW(
      (void)best_known_table(Registry({&liar}),
                             {.v_from = 5, .v_to = 9, .k_from = 3, .k_to = 4, .change = 2}),
      InternalError);
}

TEST(Planner, RefusesRangesThatMakeNoSense) {
  EXPECT_REFUSAL((void)best_known_table(
                     registry(), {.v_from = 9, .v_to = 5, .k_from = 3, .k_to = 4, .change = 2}),
                 ImpossibleParameters, "the range v = 9..5, k = 3..4 is empty or has k < 2");
  EXPECT_REFUSAL((void)best_known_table(
                     registry(), {.v_from = 5, .v_to = 5000, .k_from = 3, .k_to = 4, .change = 2}),
                 ImpossibleParameters, "v = 5000 exceeds 1000, the most that is looked at at once");
  EXPECT_THROW((void)best_known_table(
                   registry(), {.v_from = 5, .v_to = 9, .k_from = 1, .k_to = 4, .change = 2}),
               ImpossibleParameters);
  EXPECT_REFUSAL((void)best_known_table(
                     registry(), {.v_from = 5, .v_to = 9, .k_from = 3, .k_to = 4, .change = 0}),
                 ImpossibleParameters,
                 "change = 0: consecutive blocks must differ in at least 1 element");
  // The number of cells would be 0 modulo 2⁶⁴.
  EXPECT_THROW(
      (void)best_known_table(
          registry(),
          {.v_from = 5, .v_to = 8, .k_from = 3, .k_to = (std::uint64_t{1} << 61) + 2, .change = 2}),
      ImpossibleParameters);
  const BestKnownTable plan =
      best_known_table(registry(), {.v_from = 5, .v_to = 9, .k_from = 3, .k_to = 4, .change = 2});
  EXPECT_REFUSAL((void)plan.at({.v = 10, .k = 3}), BadInput,
                 "linear DCCD(10,3) is outside the range");
}

// No divisor of so large a change number is looked for: that would take for ever.
TEST(Planner, AnswersAtOnceWhereBlocksAreSmallerThanTheChange) {
  for (const std::uint64_t m :
       {std::uint64_t{1} << 32, std::numeric_limits<std::uint64_t>::max() - 1}) {
    const BestKnownTable plan = best_known_table(
        registry(), {.v_from = 3, .v_to = 40, .k_from = 3, .k_to = 8, .change = m});
    for (const KnownCell& cell : plan.cells()) {
      EXPECT_TRUE(cell.impossible) << name(cell.parameters);
    }
  }
}

TEST(Truncate, TakesAnElementAwayFromEveryDesignThatAllowsIt) {
  std::size_t done = 0;
  for (const Kind kind : {Kind::circular, Kind::linear}) {
    for (std::uint64_t m = 1; m <= 2; ++m) {
      for (std::uint64_t k = 3; k <= 6; ++k) {
        for (std::uint64_t v = k + 2; v <= 30; ++v) {
          const auto offer = registry().best({.v = v, .k = k, .change = m, .kind = kind});
          ASSERT_TRUE(offer);
          const Design design = registry().build_design(offer->recipe);
          const auto recipe = truncate_recipe(offer->recipe, design);
          if (!recipe) {
            continue;
          }
          const Design smaller = registry().build_design(*recipe);
          ++done;
          ASSERT_EQ(smaller.v(), v - 1);
          ASSERT_TRUE(valid(smaller)) << name(smaller.parameters());
          ASSERT_EQ(smaller.block_count(), design.block_count());
        }
      }
    }
  }
  EXPECT_GT(done, 300U);
}

TEST(Planner, StopsWhenTheControlAboveItWantsTo) {
  std::atomic<bool> interrupted{true};
  RunControl control({.interrupted = &interrupted});
  const RunScope scope(control);
  EXPECT_THROW((void)best_known_table(
                   registry(), {.v_from = 5, .v_to = 9, .k_from = 3, .k_to = 4, .change = 2}),
               Stopped);
}

TEST(Truncate, RefusesAnElementThatIsInEveryBlock) {
  const auto offer =
      registry().best({.v = 7, .k = 5, .kind = Kind::circular});  // one fixed element
  ASSERT_TRUE(offer);
  const Design design = registry().build_design(offer->recipe);
  const Verdict verdict = verify(design);
  ASSERT_EQ(verdict.fixed.size(), 1U);
  Parameters smaller = design.parameters();
  --smaller.v;
  const Recipe recipe{
      "truncate", smaller, {{"element", verdict.fixed.front()}}, {offer->recipe}, {}};
  EXPECT_THROW((void)registry().build(recipe), BadInput);
}

TEST(Drop, LeavesOutWhatIsNotNeededAndNothingElse) {
  // A tight design followed by itself, backwards to its beginning: about half can go.
  const auto offer = registry().best({.v = 11, .k = 4, .kind = Kind::circular});
  Design twice({.v = 11, .k = 4, .kind = Kind::linear});
  const Design once = registry().build_design(offer->recipe);
  for (std::size_t i = 0; i < 2 * once.block_count(); ++i) {
    twice.append(once.block(i % once.block_count()));
  }
  const Design less = registry().build_design(drop_recipe(literal_recipe(twice)));
  EXPECT_TRUE(valid(less));
  EXPECT_EQ(less.block_count(), needed_block_count(twice));
  EXPECT_LE(less.block_count(), once.block_count());
  // Of a tight circular design nothing can go.
  EXPECT_EQ(needed_block_count(once), once.block_count());
}

TEST(Drop, TheBestCutIsTheFirstOfThoseThatNeedFewestBlocks) {
  std::size_t with_less = 0;
  for (std::uint64_t v = 8; v <= 16; ++v) {
    for (const std::uint64_t m : {1U, 2U, 3U}) {
      const Parameters p{.v = v, .k = 4, .change = m, .kind = Kind::circular};
      const auto offer = registry().find("hold-and-stream")->offer(p, registry());
      if (!offer) {
        continue;
      }
      const Design design = registry().build_design(offer->recipe);
      const std::size_t b = design.block_count();
      Parameters linear = p;
      linear.kind = Kind::linear;
      BestCut expected{0, b};
      for (std::size_t at = 0; at < b; ++at) {
        Design opened(linear);
        for (std::size_t i = 0; i < b; ++i) {
          opened.append(design.block((at + i) % b));
        }
        const std::uint64_t needed = needed_block_count(opened);
        if (needed < expected.needed) {
          expected = {at, needed};
        }
      }
      const BestCut cut = best_cut(design, b, 0);
      EXPECT_EQ(cut.at, expected.at) << name(p);
      EXPECT_EQ(cut.needed, expected.needed) << name(p);
      with_less += cut.needed < b ? 1U : 0U;
    }
  }
  EXPECT_GT(with_less, 3U);
}

TEST(Unfix, IsTheConverseOfFix) {
  const auto offer = registry().best({.v = 11, .k = 4, .kind = Kind::circular});
  const Recipe fixed = fix_recipe(offer->recipe, 1);
  const auto back = unfix_recipe(fixed, registry().build_design(fixed));
  ASSERT_TRUE(back);
  const Design design = registry().build_design(*back);
  EXPECT_TRUE(verify(design).tight());
  EXPECT_EQ(design.block_count(), 11U);
  EXPECT_FALSE(unfix_recipe(offer->recipe, registry().build_design(offer->recipe)));
  Recipe wrong = *back;
  wrong.arguments["element"] = 3;
  EXPECT_THROW((void)registry().build_design(wrong), BadInput);
  wrong.arguments["element"] = 99;
  EXPECT_THROW((void)registry().build(wrong), BadInput);
}

TEST(Cut, RecipeNeedsACircularDesign) {
  const auto offer = registry().best({.v = 11, .k = 4, .kind = Kind::linear});
  EXPECT_REFUSAL((void)cut_recipe(offer->recipe), BadInput,
                 "cut: only a circular design can be cut open");
}

}  // namespace
}  // namespace changeover::best_known_test
