#include "answer/design/chosen_design.hpp"

#include <fmt/format.h>

#include <utility>

#include "changeover/catalog/entry.hpp"
#include "changeover/core/error.hpp"
#include "core/words.hpp"

namespace changeover::cli {

ChosenDesign built(const Offer& offer, Unread unread) {
  const Registry& registry = Registry::standard();
  const Construction& construction = *registry.find(offer.recipe.construction);
  ChosenDesign chosen{.offer = offer, .source = registry.build(offer.recipe), .exhibit = {}};
  std::optional<Judgement> judgement = judge_at_once(*chosen.source, offer);
  Exhibit& exhibit = chosen.exhibit;
  exhibit.header.labels = construction.labels(offer.recipe, registry);
  exhibit.header.recipe = offer.recipe;
  if (!judgement && unread == Unread::may_be_left && takes_long_to_judge(*chosen.source, offer)) {
    chosen.judged = false;
    return chosen;
  }
  exhibit.judgement = judgement ? *std::move(judgement) : judge(*chosen.source, offer);
  if (const auto base = construction.base_blocks(offer.recipe); base && base->blocks.size() > 1) {
    exhibit.base_blocks = base->blocks.size();
  }
  if (const auto set = construction.expansion_set(offer.recipe, registry)) {
    for (const UnchangedSubset& subset : *set) {
      exhibit.positions.push_back(subset.position);
    }
  }
  exhibit.title = fmt::format("{}, {}: {}\n{} {}\nverified: {}", name(offer.recipe.parameters),
                              count_of(offer.b, "block"), quality(exhibit.judgement),
                              construction.explain(offer.recipe),
                              construction.citation().to_string(), exhibit.judgement.certificate);
  if (!exhibit.positions.empty()) {
    exhibit.title += fmt::format("\n^ marks the {} unchanged subsets of an expansion set",
                                 exhibit.positions.size());
  }
  return chosen;
}

void check_published_blocks(const CatalogEntry& entry) {
  if (design_digest(*Registry::standard().build(entry.recipe)).checksum != entry.checksum) {
    throw BadInput(
        fmt::format("{}: its recipe makes other blocks than those that were published; restore a "
                    "copy of the catalog",
                    entry.label()));
  }
}

ChosenDesign built(const CatalogEntry& entry) {
  const Registry& registry = Registry::standard();
  ChosenDesign chosen;
  chosen.offer.recipe = entry.recipe;
  chosen.offer.b = entry.b;
  check_published_blocks(entry);
  chosen.source = registry.build(entry.recipe);
  chosen.exhibit.judgement = judge(*chosen.source, chosen.offer);
  chosen.exhibit.title = fmt::format("{}: {}", entry.label(), quality(chosen.exhibit.judgement));
  chosen.exhibit.header.recipe = entry.recipe;
  chosen.source = registry.build(entry.recipe);
  return chosen;
}

}  // namespace changeover::cli
