// The examples of the headers of construct/, as they stand there.
#include "example_support.hpp"

namespace changeover::test::construct_examples_test {
namespace {

TEST(ConstructExamples, BestKnown) {
  const Registry& registry = Registry::standard();
  BestKnownTable plan =
      best_known_table(registry, {.v_from = 5, .v_to = 24, .k_from = 3, .k_to = 6});
  const KnownCell& cell = plan.at({.v = 20, .k = 5, .kind = Kind::circular});
  EXPECT_GE(cell.best->b, cell.bound.blocks);
  EXPECT_EQ(cell.status(), cell.best->b == cell.bound.blocks ? "minimum" : "best-known");
}

TEST(ConstructExamples, Explanation) {
  const Registry& registry = Registry::standard();
  const std::vector<Parameters> asked = {{.v = 8, .k = 5, .kind = Kind::circular},
                                         {.v = 8, .k = 5}};
  const auto offer = best_offer(registry, asked);  // of both kinds, the one with fewer blocks
  const RecipeNode tree = explained(registry, offer->recipe);
  std::cout << tree.explanation << ' ' << tree.citation << '\n';
  EXPECT_EQ(tree.b, offer->b);
  EXPECT_FALSE(tree.citation.empty());
}

TEST(ConstructExamples, Closure) {
  Parameters p{.v = 5, .k = 3, .change = 1, .kind = Kind::circular};
  Recipe core{"mcsorley-circular", p, {}, {}, {}};
  Recipe larger = fix_recipe(blow_up_recipe(core, 3), 2);  // circular, 3-change, on (17,11)
  const Verdict verdict = verify(*Registry::standard().build(larger));
  EXPECT_TRUE(verdict.valid());
  EXPECT_EQ(verdict.parameters,
            (Parameters{.v = 17, .k = 11, .change = 3, .kind = Kind::circular}));
  EXPECT_EQ(verdict.b, 5U);
  EXPECT_EQ(Registry::standard().build_design(core).block_count(), 5U);
}

TEST(ConstructExamples, Expansion) {
  const Design design = best_design({.v = 7, .k = 3, .kind = Kind::circular});
  ExpansionSearch search = find_expansion_sets(design, {.how_many = 1});
  ASSERT_FALSE(search.sets.empty());
  Design larger = expand(design, search.sets.front(), one_factorization(8));
  EXPECT_EQ(larger.v(), 15U);
  EXPECT_TRUE(verify(larger).tight());
}

TEST(ConstructExamples, PartialExpansion) {
  const Design design = best_design({.v = 15, .k = 5, .kind = Kind::circular});
  ASSERT_EQ(design.block_count(), 15U);
  std::optional<UnchangedCover> cover = find_cover(design, {.new_elements = 4});
  ASSERT_TRUE(cover);
  Design larger = expand_by(design, *cover, 4);  // a circular DCCD(19,5,25), economical
  EXPECT_EQ(name(larger.parameters()), "circular DCCD(19,5)");
  EXPECT_EQ(larger.block_count(), 25U);
  EXPECT_TRUE(verify(larger).economical());
}

TEST(ConstructExamples, Enlarge) {
  const Design design = best_design({.v = 15, .k = 5, .kind = Kind::circular});
  Enlarged larger = enlarge(design);                        // by as many elements as serve it best
  Enlarged by_four = enlarge(design, {.new_elements = 4});  // by four
  EXPECT_EQ(by_four.design.v(), 19U);
  EXPECT_EQ(larger.design.block_count(), 30U);  // the positions where blocks were inserted
  EXPECT_EQ(larger.at.size(), 5U);
}

TEST(ConstructExamples, OneFactorization) {
  OneFactorization k8 = one_factorization(8);  // seven factors of four edges
  EXPECT_THAT(k8.factors, SizeIs(7));
  EXPECT_THAT(k8.factors, testing::Each(SizeIs(4)));
  OneFactor again = circle_factor(8, 3);  // k8.factors[3], without the other six
  EXPECT_EQ(again, k8.factors[3]);
  EXPECT_FALSE(factorization_defect(k8));
  EXPECT_TRUE(is_perfect(k8));
  auto other = cycle_types(one_factorization(8, FactorizationKind::doubled));
  EXPECT_TRUE(other.contains({4, 4}));
  EXPECT_FALSE(cycle_types(k8).contains({4, 4}));
}

TEST(ConstructExamples, Registry) {
  bool built = false;
  const Registry& registry = Registry::standard();
  if (auto offer = registry.best({.v = 61, .k = 4, .kind = Kind::circular})) {
    EXPECT_EQ(offer->b, 366U);
    auto blocks = registry.build(offer->recipe);  // a stream; verify it before showing it
    built = verify(*blocks).tight();
  }
  EXPECT_TRUE(built);
}

TEST(ConstructExamples, StandardCatalog) {
  std::string label;
  if (const auto entry = standard_catalog().best({.v = 20, .k = 6, .change = 1})) {
    label = entry->label();
  }
  EXPECT_THAT(label, testing::StartsWith("20.6.1.linear.37."));
}

}  // namespace
}  // namespace changeover::test::construct_examples_test
