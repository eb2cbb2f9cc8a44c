#include "answer/design/recipe_tree.hpp"

#include <fmt/format.h>

#include <optional>

#include "answer/design/judgement.hpp"
#include "construct/known_documents.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"

namespace changeover::cli {
namespace {

/// The design of a node, verified unless that takes long: a tree is shown for what it says, and of
/// a node that was not read it says so.
std::optional<Judgement> judgement_of(const Recipe& recipe) {
  const auto source = Registry::standard().build(recipe);
  Offer promise;
  promise.recipe = recipe;
  promise.b = source->block_count().value_or(0);
  std::optional<Judgement> judgement = judge_at_once(*source, promise);
  if (!judgement && !takes_long_to_judge(*source, promise)) {
    judgement = judge(*source, promise);
  }
  return judgement;
}

std::string quality_of(const Recipe& recipe) {
  if (const auto judgement = judgement_of(recipe)) {
    return quality(*judgement);
  }
  return not_verified_here(recipe.parameters, " --format text -o FILE");
}

void add_text(const RecipeNode& node, const Recipe& recipe, const std::string& indent,
              std::string& text) {
  const std::uint64_t b = node.b.value_or(0);
  std::uint64_t before = 0;
  for (const RecipeNode& input : node.inputs) {
    before += input.b.value_or(0);
  }
  text += fmt::format(
      "{}{}: {}{}\n", indent, name(node.parameters), count_of(b, "block"),
      node.inputs.empty() || b < before ? std::string() : fmt::format(" ({} added)", b - before));
  text += fmt::format("{}  by {}: {}\n", indent, node.construction->name(), node.explanation);
  text += fmt::format("{}  {}; {}\n", indent, node.citation, quality_of(recipe));
  for (std::size_t i = 0; i < node.inputs.size(); ++i) {
    text += indent + "  from\n";
    add_text(node.inputs[i], recipe.inputs[i], indent + "    ", text);
  }
}

void add_steps(const RecipeNode& node, std::size_t depth, std::vector<RecipeStep>& steps) {
  steps.push_back({depth,
                   node.b ? fmt::format("{}: {}", name(node.parameters), count_of(*node.b, "block"))
                          : name(node.parameters),
                   node.explanation, node.citation});
  for (const RecipeNode& input : node.inputs) {
    add_steps(input, depth + 1, steps);
  }
}

}  // namespace

std::vector<RecipeStep> recipe_steps(const Recipe& recipe) {
  std::vector<RecipeStep> steps;
  add_steps(explained(Registry::standard(), recipe), 0, steps);
  return steps;
}

std::string tree_text(const Recipe& recipe) {
  std::string text;
  add_text(explained(Registry::standard(), recipe), recipe, "", text);
  return text;
}

std::string tree_json(const Recipe& recipe) {
  JsonWriter json;
  write_tree(recipe, json, [](const Recipe& node, JsonWriter& to) {
    const auto judgement = judgement_of(node);
    judgement ? to.raw(verdict_to_json(judgement->verdict)) : to.null();
  });
  return json.take();
}

std::string explanation_json(const Recipe& recipe) {
  JsonWriter json;
  json.begin_object().key("recipe").raw(recipe_to_json(recipe));
  return json.key("tree").raw(tree_json(recipe)).end_object().take();
}

}  // namespace changeover::cli
