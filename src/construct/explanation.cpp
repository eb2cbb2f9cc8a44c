#include "changeover/construct/best_known.hpp"

#include <utility>

namespace changeover {

std::optional<Offer> best_offer(const Registry& registry, std::span<const Parameters> asked,
                                const Construction* only) {
  std::optional<Offer> best;
  for (const Parameters& p : asked) {
    std::optional<Offer> offer = only != nullptr    ? only->offer(p, registry)
                                 : impossibility(p) ? std::nullopt
                                                    : best_known(registry, p);
    if (offer && (!best || offer->b < best->b)) {
      best = std::move(offer);
    }
  }
  return best;
}

RecipeNode explained(const Registry& registry, const Recipe& recipe) {
  const Construction& construction = registry.construction_of(recipe);
  RecipeNode node{.construction = &construction,
                  .parameters = recipe.parameters,
                  .b = registry.build(recipe)->block_count(),
                  .explanation = construction.explain(recipe),
                  .citation = construction.citation().to_string(),
                  .inputs = {}};
  for (const Recipe& input : recipe.inputs) {
    node.inputs.push_back(explained(registry, input));
  }
  return node;
}

}  // namespace changeover
