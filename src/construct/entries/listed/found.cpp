// Designs that searches of this program found and no other construction gives, shipped with it. Each is
// a file in src/construct/found, which says where it comes from; the build puts the files into the
// library. A recipe carries its blocks, so it stays what it is whatever is found later.
#include <fmt/format.h>

#include <map>
#include <utility>

#include "bounds/counting_bound.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "construct/entry.hpp"
#include "construct/found/found_designs.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

using ByParameters = std::map<Parameters, FoundDesign>;

const ByParameters& found_designs() {
  static const ByParameters designs = [] {
    ByParameters all;
    for (FoundDesign& design : read_found_designs(found_design_files())) {
      const Parameters p = design.recipe.parameters;
      all.emplace(p, std::move(design));
    }
    return all;
  }();
  return designs;
}

// Of a valid design: whether it covers each pair, or what its strength says, newly, once. In the collection no two elements are
// in every block of a circular design, which the tests see to.
bool is_tight(const Parameters& p, std::uint64_t b) {
  const std::uint64_t first = p.kind == Kind::linear ? binomial(p.k, p.strength) : 0;
  const std::uint64_t later = p.kind == Kind::linear ? b - 1 : b;
  return first + later * newly_covered_at_most(p) == binomial(p.v, p.strength);
}

constexpr Description description{
    .name = "found",
    .summary = "a design that a search found, from the library's collection",
    .preconditions = "some parameters; see the collection",
    .guarantee = "as many blocks as the collection says, verified by the tests",
};

class Found final : public Entry {
 public:
  Found() : Entry(description) {}

  std::optional<Offer> offer(const Parameters& p, const Registry&) const override {
    const auto found = found_designs().find(p);
    if (found == found_designs().end()) {
      return std::nullopt;
    }
    Offer offer;
    offer.recipe = Recipe{std::string(name()), p, {}, {found->second.recipe}, {}};
    offer.b = found->second.b;
    offer.economical = offer.b == counting_bound(p);
    offer.tight = is_tight(p, offer.b);
    return offer;
  }

  std::unique_ptr<BlockSource> build(const Recipe& recipe,
                                     const Registry& registry) const override {
    return registry.build(input(recipe));
  }

  std::optional<BaseBlocks> base_blocks(const Recipe& recipe) const override {
    const Recipe& from = input(recipe);
    return Registry::standard().construction_of(from).base_blocks(from);
  }

  std::string explain(const Recipe& recipe) const override {
    return "Found by search: " + input(recipe).provenance + ".";
  }

  std::vector<std::string> labels(const Recipe& recipe, const Registry& registry) const override {
    const Recipe& from = input(recipe);
    return registry.construction_of(from).labels(from, registry);
  }

 private:
  /// The list of blocks, or base blocks, that the recipe carries. @throws BadInput if it has none.
  [[nodiscard]] const Recipe& input(const Recipe& recipe) const {
    require_recipe(
        recipe, *this,
        Recipe{std::string(name()), recipe.parameters, {}, recipe.inputs, {}, recipe.provenance});
    if (recipe.inputs.size() != 1 || recipe.inputs.front().parameters != recipe.parameters ||
        (recipe.inputs.front().construction != "literal" &&
         recipe.inputs.front().construction != "developed")) {
      throw BadInput(
          "found takes one input, literal or developed, with the same parameters; correct the "
          "recipe");
    }
    return recipe.inputs.front();
  }
};

}  // namespace

const Construction& found_construction() { return only<Found>(); }

}  // namespace changeover
