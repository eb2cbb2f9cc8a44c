#include "changeover/construct/best_known.hpp"

#include <gtest/gtest.h>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/core/error.hpp"

namespace changeover::explanation_test {
namespace {

const Registry& registry() { return Registry::standard(); }

Parameters cell(std::uint64_t v, std::uint64_t k, Kind kind) {
  return {.v = v, .k = k, .change = 2, .kind = kind};
}

TEST(BestOffer, IsTheOneWithFewestBlocksAndTheFirstAmongEquals) {
  std::size_t ties = 0;
  for (std::uint64_t v = 6; v <= 14; ++v) {
    const Parameters circular = cell(v, 4, Kind::circular);
    const Parameters linear = cell(v, 4, Kind::linear);
    const auto of_circular = best_known(registry(), circular);
    const auto of_linear = best_known(registry(), linear);
    ASSERT_TRUE(of_circular && of_linear) << v;
    const auto best = best_offer(registry(), std::vector{circular, linear});
    const auto reversed = best_offer(registry(), std::vector{linear, circular});
    ASSERT_TRUE(best && reversed);
    EXPECT_EQ(best->b, std::min(of_circular->b, of_linear->b));
    EXPECT_EQ(reversed->b, best->b);
    if (of_circular->b == of_linear->b) {
      ++ties;
      EXPECT_EQ(best->recipe.parameters.kind, Kind::circular);
      EXPECT_EQ(reversed->recipe.parameters.kind, Kind::linear);
    }
  }
  EXPECT_GT(ties, 0U);
}

TEST(BestOffer, IsOfOneConstructionIfThatIsAsked) {
  const std::vector<Parameters> asked{cell(20, 5, Kind::circular), cell(20, 5, Kind::linear)};
  const Construction* const stream = registry().find("hold-and-stream");
  const auto offer = best_offer(registry(), asked, stream);
  ASSERT_TRUE(offer);
  EXPECT_EQ(offer->recipe.construction, "hold-and-stream");
  EXPECT_GT(offer->b, best_offer(registry(), asked)->b);
}

TEST(BestOffer, IsNothingWhereNoDesignExists) {
  EXPECT_TRUE(impossibility(cell(4, 2, Kind::linear)));
  EXPECT_FALSE(best_offer(registry(), std::vector{cell(4, 2, Kind::linear)}));
  EXPECT_FALSE(best_offer(registry(), {}));
}

// Every node is what its part of the recipe says, and has as many blocks as can be read.
void expect_explained(const RecipeNode& node, const Recipe& recipe) {
  EXPECT_EQ(node.construction->name(), recipe.construction);
  EXPECT_EQ(node.parameters, recipe.parameters);
  EXPECT_EQ(node.explanation, node.construction->explain(recipe));
  EXPECT_EQ(node.b, registry().build_design(recipe).block_count());
  ASSERT_EQ(node.inputs.size(), recipe.inputs.size());
  for (std::size_t i = 0; i < node.inputs.size(); ++i) {
    expect_explained(node.inputs[i], recipe.inputs[i]);
  }
}

TEST(Explanation, IsTheTreeOfTheRecipe) {
  std::size_t with_inputs = 0;
  for (const Parameters& p : {cell(105, 9, Kind::circular), cell(30, 4, Kind::linear)}) {
    const auto offer = best_offer(registry(), std::span(&p, 1));
    ASSERT_TRUE(offer);
    const RecipeNode tree = explained(registry(), offer->recipe);
    expect_explained(tree, offer->recipe);
    with_inputs += tree.inputs.empty() ? 0U : 1U;
  }
  EXPECT_GT(with_inputs, 0U);
}

TEST(Explanation, RefusesConstructionsThatThereAreNot) {
  Recipe recipe;
  recipe.construction = "nonsense";
  recipe.parameters = cell(9, 4, Kind::linear);
  EXPECT_THROW(static_cast<void>(explained(registry(), recipe)), BadInput);
}

}  // namespace
}  // namespace changeover::explanation_test
