#include "changeover/construct/expansion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <utility>

#include "construction_checks.hpp"
#include "message_of.hpp"

namespace changeover::expansion_test {
namespace {

using namespace test;

struct Given {
  Design design;
  ExpansionSet set;
};

Given given(std::string_view by, const Parameters& p) {
  const Recipe recipe = offer_of(by, p)->recipe;
  return {standard().build_design(recipe), *construction(by).expansion_set(recipe, standard())};
}

Given fifteen() { return given("cyclic-paper", {15, 5, 2, Kind::circular, 2}); }
Given linear_seven() { return given("printed", {7, 3, 2, Kind::linear, 2}); }

OneFactorization factors(const ExpansionSet& set,
                         FactorizationKind kind = FactorizationKind::circle) {
  return one_factorization(static_cast<std::uint32_t>(set.size() + 1), kind);
}

void expect_defect(const Design& design, const ExpansionSet& set, const std::string& words) {
  const auto defect = expansion_set_defect(design, set);
  ASSERT_TRUE(defect) << words;
  EXPECT_NE(defect->find(words), std::string::npos) << *defect;
  EXPECT_EQ(defect->find('\n'), std::string::npos);
  EXPECT_THROW((void)expand(design, set, factors(set)), Error) << words;
}

TEST(ExpansionSet, OfAFamilyHasNoDefect) {
  for (const Given& g :
       {fifteen(), linear_seven(), given("doubling", {6, 4, 2, Kind::circular, 2})}) {
    EXPECT_EQ(expansion_set_defect(g.design, g.set), std::nullopt);
  }
}

TEST(ExpansionSet, ThatIsSpoiltInOnePlaceIsRefused) {
  const Given g = fifteen();
  const auto spoilt = [&](const auto& change) {
    ExpansionSet set = g.set;
    change(set);
    return set;
  };
  expect_defect(g.design, {}, "element 0 is in no subset");
  expect_defect(g.design, spoilt([](auto& set) { set.pop_back(); }), "is in no subset");
  expect_defect(g.design, spoilt([](auto& set) { std::swap(set[0], set[1]); }),
                "position 3 follows position 6: positions must increase");
  expect_defect(g.design, spoilt([](auto& set) { set[1].position = set[0].position; }),
                "must increase");
  expect_defect(g.design, spoilt([](auto& set) {
                  set.insert(set.begin(), {1, set[0].elements});
                }),
                "is in the subsets at positions 1 and 3");
  expect_defect(g.design,
                spoilt([](auto& set) { std::swap(set[0].elements[0], set[0].elements[1]); }),
                "do not increase");
  expect_defect(g.design, spoilt([](auto& set) { set[0].elements.pop_back(); }),
                "the subset at position 3 has 2 elements, not k - m = 3");
  expect_defect(g.design, spoilt([](auto& set) { set[0].elements.back() = 15; }),
                "the subset at position 3 holds 15, which is not below v = 15");
  expect_defect(g.design, spoilt([](auto& set) { std::swap(set[0].elements, set[1].elements); }),
                "is not what blocks");
  expect_defect(g.design, spoilt([](auto& set) { set.back().position = 16; }),
                "position 16 is past the last block, 15");
  expect_defect(g.design, spoilt([](auto& set) {
                  std::rotate(set.begin(), set.end() - 1, set.end());
                  set.front().position = 0;
                }),
                "a circular design has no position 0: before its first block is ");
  for (std::size_t i = 0; i < g.set.size(); ++i) {
    for (const std::size_t shift : {std::size_t{1}, ~std::size_t{0}}) {
      expect_defect(g.design, spoilt([&](auto& set) { set[i].position += shift; }),
                    i + 1 == g.set.size() && shift == 1 ? "past the last" : "is not what blocks");
    }
  }
}

TEST(ExpansionSet, OfALinearDesignMayUseItsEndsFreely) {
  const Given g = linear_seven();
  ExpansionSet set = g.set;
  EXPECT_EQ(set.front(), (UnchangedSubset{0, {2}}));
  EXPECT_EQ(set.back(), (UnchangedSubset{7, {1}}));
  set[4].position = 4;  // element 6 is kept there as well
  EXPECT_EQ(expansion_set_defect(g.design, set), std::nullopt);
  std::swap(set.front().elements, set.back().elements);  // the last block lacks element 2
  expect_defect(g.design, set, "the subset at position 7 is not in the last block");
  Design circular = g.design;
  circular.set_kind(Kind::circular);
  expect_defect(circular, g.set, "no position 0");
}

TEST(ExpansionSet, NamesElementsByTheirLabels) {
  Given g = linear_seven();
  g.design.set_labels({"a", "b", "c", "d", "e", "f", "g"});
  g.set.erase(g.set.begin());
  expect_defect(g.design, g.set, "element c is in no subset");
}

TEST(ExpansionSet, OfDesignsWithoutStepsIsRefused) {
  const Design none(Parameters{3, 3, 2, Kind::linear, 2});
  EXPECT_TRUE(expansion_set_defect(none, {{0, {0}}, {1, {1}}, {2, {2}}}));
  const Design one(Parameters{3, 3, 2, Kind::circular, 2}, std::vector<Block>{{0, 1, 2}});
  EXPECT_TRUE(expansion_set_defect(one, {{1, {0}}, {2, {1}}, {3, {2}}}));
  const Design pairs(Parameters{6, 2, 2, Kind::linear, 2}, std::vector<Block>{{0, 1}, {2, 3}});
  EXPECT_TRUE(expansion_set_defect(pairs, {}));
}

TEST(ExpansionSet, DoesNotUsePartOfWhatABadStepKeeps) {
  const Parameters six{6, 4, 2, Kind::linear, 2};
  const Design design(six, std::vector<Block>{{0, 1, 2, 3}, {1, 2, 3, 4}, {2, 3, 4, 5}});
  expect_defect(design, {{0, {0, 1}}, {1, {2, 3}}, {3, {4, 5}}}, "is not what blocks 1 and 2");
}

TEST(Expand, MakesTightDesignsWithBothKindsOfFactorization) {
  for (const Given& g :
       {fifteen(), linear_seven(), given("cyclic-paper", {19, 3, 2, Kind::circular, 2}),
        given("cyclic-paper", {57, 5, 2, Kind::circular, 2})}) {
    const std::size_t subsets = g.set.size();
    for (const FactorizationKind kind : {FactorizationKind::circle, FactorizationKind::doubled}) {
      const Design larger = expand(g.design, g.set, factors(g.set, kind));
      const Verdict verdict = verify(larger);
      EXPECT_TRUE(verdict.tight());
      EXPECT_EQ(larger.v(), g.design.v() + subsets + 1);
      EXPECT_EQ(verdict.b, g.design.block_count() + subsets * (subsets + 1) / 2);
      EXPECT_EQ(larger.parameters().kind, g.design.parameters().kind);
      // New elements are kept nowhere, so there is no further expansion set.
      const ExpansionSearch search = find_expansion_sets(larger);
      if (larger.parameters().kind == Kind::circular) {
        EXPECT_TRUE(search.complete && search.sets.empty());
      }
    }
  }
}

TEST(Expand, AsAStreamMakesTheSameBlocks) {
  for (const Given& g :
       {fifteen(), linear_seven(), given("doubling", {6, 4, 2, Kind::circular, 2})}) {
    for (const FactorizationKind kind : {FactorizationKind::circle, FactorizationKind::doubled}) {
      const std::vector<Block> expected = expand(g.design, g.set, factors(g.set, kind)).blocks();
      const auto source = expand(std::make_unique<DesignSource>(g.design), g.set, kind);
      EXPECT_EQ(source->block_count(), expected.size());
      EXPECT_EQ(source->parameters().v, g.design.v() + g.set.size() + 1);
      expect_blocks_however_often(*source, expected);
    }
  }
}

TEST(Expand, OrdersTheBlocksAtAPositionByTheEdgesOfItsFactor) {
  const Given g = linear_seven();
  const OneFactorization k8 = factors(g.set);
  const Design larger = expand(g.design, g.set, k8);
  for (std::size_t i = 0; i < 4; ++i) {
    const Edge edge = k8.factors[0][i];
    EXPECT_EQ(Block(larger.block(i).begin(), larger.block(i).end()),
              (Block{2, 7 + edge.a, 7 + edge.b}));
  }
  EXPECT_EQ(larger.block_count(), 35U);
  EXPECT_EQ(larger.block(34)[0], 1U);
}

TEST(Expand, RefusesAFactorizationThatIsSpoiltInOnePlace) {
  const Given g = fifteen();
  const auto refused = [&](const auto& change,
                           const std::string& words = "not a 1-factorization: ") {
    OneFactorization k6 = factors(g.set);
    change(k6);
    EXPECT_REFUSAL((void)expand(g.design, g.set, k6), BadInput, words);
  };
  refused([](auto& k) { k = one_factorization(8); },
          "5 unchanged subsets need a 1-factorization of K_6, not of K_8");
  refused([](auto& k) { k = one_factorization(4); },
          "5 unchanged subsets need a 1-factorization of K_6, not of K_4");
  refused([](auto& k) { k.factors.pop_back(); });
  refused([](auto& k) { k.factors[1] = k.factors[0]; });
  refused([](auto& k) { k.factors[2].pop_back(); });
  refused([](auto& k) { std::swap(k.factors[0][0], k.factors[1][0]); });
  refused([](auto& k) { std::swap(k.factors[0][0].a, k.factors[0][0].b); });
  refused([](auto& k) { std::swap(k.factors[0][0].b, k.factors[0][1].b); });
  refused([](auto& k) { k.factors[0][0].b = 6; });
  refused([](auto& k) { k.order = 8; },
          "5 unchanged subsets need a 1-factorization of K_6, not of K_8");
}

TEST(Expand, RefusesWhatTheTheoremDoesNotCover) {
  const Parameters single{3, 2, 1, Kind::circular, 2};
  const Design scd(single, std::vector<Block>{{0, 1}, {1, 2}, {2, 0}});
  const ExpansionSet ends{{1, {1}}, {2, {2}}, {3, {0}}};
  EXPECT_EQ(expansion_set_defect(scd, ends), std::nullopt);
  EXPECT_THROW((void)expand(scd, ends, one_factorization(4)), ImpossibleParameters);
  EXPECT_THROW((void)expand(std::make_unique<DesignSource>(scd), ends), ImpossibleParameters);

  const Parameters eight{8, 4, 2, Kind::linear, 2};  // four subsets of two
  const Design even(eight, std::vector<Block>{{0, 1, 2, 3}, {2, 3, 4, 5}, {4, 5, 6, 7}});
  const ExpansionSet four{{0, {0, 1}}, {1, {2, 3}}, {2, {4, 5}}, {3, {6, 7}}};
  EXPECT_EQ(expansion_set_defect(even, four), std::nullopt);
  EXPECT_REFUSAL((void)expand(even, four, one_factorization(6)), ImpossibleParameters,
                 "expansion needs an odd number of subsets, not 4: K_5 has no 1-factorization");
  EXPECT_THROW((void)expand(std::make_unique<DesignSource>(even), four), ImpossibleParameters);
}

TEST(Expand, AsAStreamChecksTheShapeOfTheSet) {
  const Given g = fifteen();
  ExpansionSet set = g.set;
  std::swap(set[0], set[1]);
  EXPECT_REFUSAL((void)expand(std::make_unique<DesignSource>(g.design), set), BadInput,
                 "not an expansion set: position 3 follows position 6");
  set = g.set;
  set[0].elements[0] = 0;
  EXPECT_THROW((void)expand(std::make_unique<DesignSource>(g.design), set), BadInput);
  set = g.set;
  set.back().position = 16;
  const auto source = expand(std::make_unique<DesignSource>(g.design), set);
  EXPECT_REFUSAL((void)blocks_of(*source), BadInput, "position 16 is past the last block, 15");
}

TEST(Expand, LabelsNewElementsWithFreshNumbers) {
  Given g = linear_seven();
  g.design.set_labels({"a", "b", "c", "d", "e", "f", "g"});
  EXPECT_EQ(expand(g.design, g.set, factors(g.set)).label(7), "7");
  g.design.set_labels({"1", "2", "3", "4", "5", "6", "7"});
  const Design larger = expand(g.design, g.set, factors(g.set));
  EXPECT_EQ(larger.label(6), "7");
  EXPECT_EQ(larger.label(7), "8");
  EXPECT_EQ(larger.label(14), "15");
  EXPECT_TRUE(expand(fifteen().design, fifteen().set, one_factorization(6)).labels().empty());

  EXPECT_TRUE(expanded_labels({}, 4).empty());
  EXPECT_EQ(expanded_labels({"x", "4", "007"}, 2),
            (std::vector<std::string>{"x", "4", "007", "5", "6"}));
  EXPECT_EQ(expanded_labels({"x", "9", "y"}, 2),
            (std::vector<std::string>{"x", "9", "y", "3", "4"}));
  EXPECT_EQ(expanded_labels({"7", "4"}, 2), (std::vector<std::string>{"7", "4", "2", "3"}));
  EXPECT_EQ(expanded_labels({"3", "5"}, 3), (std::vector<std::string>{"3", "5", "6", "7", "8"}));
}

RC_GTEST_PROP(Expand, IsTightForEveryCyclicDesignCutAnywhere, ()) {
  const auto [c, k] = *rc::gen::element(std::pair{1, 3}, std::pair{1, 5}, std::pair{2, 3},
                                        std::pair{2, 7}, std::pair{3, 9}, std::pair{4, 5});
  const auto size = static_cast<std::uint64_t>(k);
  const std::uint64_t v = static_cast<std::uint64_t>(c) * (4 * size - 6) + 1;
  Recipe recipe = offer_of("cut", {v, size, 2, Kind::linear, 2})->recipe;
  recipe.arguments["at"] = *rc::gen::inRange<std::int64_t>(0, static_cast<std::int64_t>(v));
  const Design design = standard().build_design(recipe);
  const ExpansionSet set = *construction("cut").expansion_set(recipe, standard());
  const auto kind = *rc::gen::element(FactorizationKind::circle, FactorizationKind::doubled);
  const Design larger = expand(design, set, factors(set, kind));
  const Verdict before = verify(design);
  const Verdict after = verify(larger);
  RC_ASSERT(after.valid());
  RC_ASSERT(after.excess == before.excess);
  RC_ASSERT(after.economical() == before.economical());
  // Any permutation of the factors and of their edges does as well.
  OneFactorization mixed = factors(set, kind);
  const auto turn = *rc::gen::inRange<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(set.size()));
  std::rotate(mixed.factors.begin(), mixed.factors.begin() + turn, mixed.factors.end());
  RC_ASSERT(verify(expand(design, set, mixed)).excess == before.excess);
}

}  // namespace
}  // namespace changeover::expansion_test
