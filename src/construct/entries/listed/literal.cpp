// A list of blocks as given, so that designs from elsewhere can take part in recipes. Nothing is
// offered and nothing promised: whether the list is a design is for verification to say.
#include <fmt/format.h>

#include <utility>

#include "changeover/construct/closure.hpp"
#include "changeover/construct/expansion.hpp"
#include "changeover/construct/registry.hpp"
#include "construct/entry.hpp"

namespace changeover::literal_entry {
namespace {

// So that building never hangs; the same set is found wherever the search does not end here.
constexpr std::uint64_t search_nodes = 10'000'000;

constexpr Description description{
    .name = "literal",
    .summary = "the blocks that the recipe lists",
    .preconditions = "any parameters, with a list of blocks",
    .guarantee = "none: verify the list",
};

class Literal final : public Described<Entry, description> {
 public:
  std::unique_ptr<BlockSource> build(const Recipe& recipe, const Registry&) const override {
    require_recipe(
        recipe, *this,
        Recipe{std::string(name()), recipe.parameters, {}, {}, recipe.blocks, recipe.provenance});
    return std::make_unique<BlockListSource>(recipe.parameters, recipe.blocks);
  }

  // The first one that exact cover finds.
  std::optional<std::vector<UnchangedSubset>> expansion_set(
      const Recipe& recipe, const Registry& registry) const override {
    const std::unique_ptr<BlockSource> source = build(recipe, registry);
    if (recipe.parameters.v > max_elements_in_memory) {
      return std::nullopt;
    }
    const ExpansionSearch search = find_expansion_sets(
        read_all(*source),
        {.how_many = 1, .count = false, .partial = false, .limits = {search_nodes, {}}});
    return search.sets.empty() ? std::nullopt : std::optional(search.sets.front());
  }

  std::string explain(const Recipe& recipe) const override {
    const std::string blocks =
        recipe.blocks.size() == 1
            ? "The one block is stored with the design"
            : fmt::format("The {} blocks are stored with the design", recipe.blocks.size());
    return recipe.provenance.empty() ? blocks + "."
                                     : fmt::format("{}, from: {}.", blocks, recipe.provenance);
  }
};

}  // namespace

const Construction& construction() { return only<Literal>(); }

}  // namespace changeover::literal_entry

namespace changeover {

Recipe literal_recipe(const Design& design, std::string provenance) {
  return {"literal", design.parameters(), {}, {}, design.blocks(), std::move(provenance)};
}

}  // namespace changeover
