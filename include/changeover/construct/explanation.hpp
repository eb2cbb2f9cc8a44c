// What constructions answer when they are asked for a design, and how they explain it.
//
//     const Registry& registry = Registry::standard();
//     const std::vector<Parameters> asked = {{.v = 8, .k = 5, .kind = Kind::circular}, {.v = 8, .k = 5}};
//     const auto offer = best_offer(registry, asked);           // of both kinds, the one with fewer blocks
//     const RecipeNode tree = explained(registry, offer->recipe);
//     std::cout << tree.explanation << ' ' << tree.citation << '\n';
//
// The tree of a recipe has a node for each construction that takes part; the designs that one works on are its inputs.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/core/recipe.hpp"

namespace changeover {

/// The best offer for any of some parameters, the first among equals: what best_known() has, or, if
/// `only` is given, what that construction offers. nullopt if nothing serves them. @throws as best_known().
[[nodiscard]] std::optional<Offer> best_offer(const Registry& registry,
                                              std::span<const Parameters> asked,
                                              const Construction* only = nullptr);

/// How one design of a recipe is made.
struct RecipeNode {
  const Construction* construction = nullptr;  ///< of the registry
  Parameters parameters;
  std::optional<std::uint64_t> b;  ///< blocks, if they are counted without making them
  std::string explanation;
  std::string citation;
  std::vector<RecipeNode> inputs;
};

/// The tree of a recipe. Each node is built as far as it takes to count its blocks, none is verified.
/// @throws BadInput as Registry::construction_of() and Registry::build().
[[nodiscard]] RecipeNode explained(const Registry& registry, const Recipe& recipe);

}  // namespace changeover
