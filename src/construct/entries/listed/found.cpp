// Designs that are written down: what searches found and no other construction gives, and what the
// user has added. They are in the catalog, and a recipe names one by its label, which has the
// checksum of its blocks in it, so it stays what it is whatever is found later. A recipe of an
// older program carries the blocks as its input.
#include <fmt/format.h>

#include "bounds/counting_bound.hpp"
#include "changeover/catalog/catalog.hpp"
#include "changeover/catalog/entry.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"
#include "construct/trusted_entry.hpp"
#include "core/checked.hpp"

namespace changeover::found_entry {
namespace {

// Whether a valid design covers each pair (or what its strength says) newly once. No two elements
// are in every block of a circular design that comes with the program; the tests see to that.
bool is_tight(const Parameters& p, std::uint64_t b) {
  const std::uint64_t first = p.kind == Kind::linear ? binomial(p.k, p.strength) : 0;
  const std::uint64_t later = p.kind == Kind::linear ? b - 1 : b;
  return first + later * newly_covered_at_most(p) == binomial(p.v, p.strength);
}

constexpr Description description{
    .name = "found",
    .summary = "a design that is written down in the catalog, found by a search as a rule",
    .preconditions = "some parameters; see the catalog",
    .guarantee = "as many blocks as the catalog says, verified",
};

bool carries_blocks(const Recipe& recipe) {
  return recipe.construction == "literal" || recipe.construction == "developed";
}

class Found final : public Described<Entry, description> {
 public:
  std::optional<Offer> offer(const Parameters& p, const Registry&) const override {
    const Catalog& catalog = standard_catalog();
    while (const auto known = catalog.fewest(p, true)) {
      // A shipped one is trusted: reading it would take as long as all other offers together.
      if (!known->shipped && !trusted_entry(catalog, known->label)) {
        continue;  // It is left out from now on.
      }
      Offer offer;
      offer.recipe = recipe_of(p);
      offer.recipe.provenance = known->label;
      offer.b = known->b;
      offer.economical = offer.b == counting_bound(p);
      offer.tight = is_tight(p, offer.b);
      return offer;
    }
    return std::nullopt;
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    return registry.build(written(recipe));
  }

  std::optional<BaseBlocks> base_blocks(const Recipe& recipe) const override {
    const Recipe from = written(recipe);
    return Registry::standard().construction_of(from).base_blocks(from);
  }

  std::string explain(const Recipe& recipe) const override {
    if (!recipe.inputs.empty()) {
      return "Found by search: " + written(recipe).provenance + ".";
    }
    const CatalogEntry entry = entry_of(recipe);
    const Credit& credit = entry.credit;
    std::string from = credit.command;
    for (const std::string& more : {credit.program, credit.who, credit.date}) {
      from += (from.empty() || more.empty() ? "" : "; ") + more;
    }
    const std::string known =
        fmt::format("Written down in the catalog as {}: {}.", entry.label(), from);
    // Blocks that are only a list say nothing more.
    return entry.recipe.construction == "developed"
               ? known + " " +
                     Registry::standard().construction_of(entry.recipe).explain(entry.recipe)
               : known;
  }

  std::vector<std::string> labels(const Recipe& recipe, const Registry& registry) const override {
    const Recipe from = written(recipe);
    return registry.construction_of(from).labels(from, registry);
  }

 private:
  [[nodiscard]] CatalogEntry entry_of(const Recipe& recipe) const {
    Recipe expected = recipe_of(recipe.parameters);
    expected.provenance = recipe.provenance;
    require_recipe(recipe, *this, expected);
    const auto label = parse_design_label(recipe.provenance);
    if (!label || label->parameters != recipe.parameters) {
      throw BadInput(
          "found takes the label of a design with the same parameters as its provenance; correct "
          "the recipe");
    }
    const auto entry = standard_catalog().find(recipe.provenance);
    if (!entry || !carries_blocks(entry->recipe)) {
      throw BadInput(
          fmt::format("no design {} is written down in the catalog; ask the author of "
                      "the recipe for it, and add it (changeover catalog add FILE)",
                      recipe.provenance));
    }
    return *entry;
  }

  /// The list of blocks, or base blocks. @throws BadInput if there is none.
  [[nodiscard]] Recipe written(const Recipe& recipe) const {
    if (recipe.inputs.empty()) {
      return entry_of(recipe).recipe;
    }
    require_recipe(
        recipe, *this,
        Recipe{std::string(name()), recipe.parameters, {}, recipe.inputs, {}, recipe.provenance});
    if (recipe.inputs.size() != 1 || recipe.inputs.front().parameters != recipe.parameters ||
        !carries_blocks(recipe.inputs.front())) {
      throw BadInput(
          "found takes a label, or one input, literal or developed, with the same parameters; "
          "correct the recipe");
    }
    return recipe.inputs.front();
  }
};

}  // namespace

const Construction& construction() { return only<Found>(); }

}  // namespace changeover::found_entry
