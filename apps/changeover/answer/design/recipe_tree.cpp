#include "answer/design/recipe_tree.hpp"

#include <fmt/format.h>

#include <optional>

#include "answer/answer.hpp"
#include "answer/design/judgement.hpp"
#include "changeover/construct/registry.hpp"

namespace changeover::cli {
namespace {

/// A node of the tree that was built. Its design is verified unless that takes long: a tree is shown for
/// what it says, and of a node that was not read it says so.
struct Step {
  const Construction* construction = nullptr;
  std::uint64_t b = 0;
  std::optional<Judgement> judgement;
};

Step step(const Recipe& recipe) {
  const Registry& registry = Registry::standard();
  const auto source = registry.build(recipe);
  Offer promise;
  promise.recipe = recipe;
  promise.b = source->block_count().value_or(0);
  Step step{registry.find(recipe.construction), promise.b, judge_at_once(*source, promise)};
  if (!step.judgement && !takes_long_to_judge(*source, promise)) {
    step.judgement = judge(*source, promise);
  }
  return step;
}

std::string quality(const Step& step, const Parameters& p) {
  if (step.judgement) {
    return quality(*step.judgement);
  }
  return fmt::format(
      "not verified here, for that takes long: changeover design {} {} --change {} --{} "
      "--format text -o FILE does",
      p.v, p.k, p.change, to_string(p.kind));
}

void add_text(const Recipe& recipe, const std::string& indent, std::string& text) {
  const Step node = step(recipe);
  const std::uint64_t b = node.b;
  std::uint64_t before = 0;
  for (const Recipe& input : recipe.inputs) {
    before += Registry::standard().build(input)->block_count().value_or(0);
  }
  text += fmt::format(
      "{}{}: {}{}\n", indent, name(recipe.parameters), count_of(b, "block"),
      recipe.inputs.empty() || b < before ? std::string() : fmt::format(" ({} added)", b - before));
  text += fmt::format("{}  by {}: {}\n", indent, recipe.construction,
                      node.construction->explain(recipe));
  text += fmt::format("{}  {}; {}\n", indent, node.construction->citation().to_string(),
                      quality(node, recipe.parameters));
  for (const Recipe& input : recipe.inputs) {
    text += indent + "  from\n";
    add_text(input, indent + "    ", text);
  }
}

}  // namespace

std::string tree_text(const Recipe& recipe) {
  std::string text;
  add_text(recipe, "", text);
  return text;
}

void tree_json(const Recipe& recipe, JsonWriter& json) {
  const Step node = step(recipe);
  json.begin_object();
  json.key("construction").value(recipe.construction);
  json.key("v").value(recipe.parameters.v).key("k").value(recipe.parameters.k);
  json.key("change").value(recipe.parameters.change);
  json.key("kind").value(to_string(recipe.parameters.kind));
  json.key("explanation").value(node.construction->explain(recipe));
  json.key("citation").value(node.construction->citation().to_string());
  json.key("b").value(node.b).key("verdict");
  node.judgement ? json.raw(verdict_to_json(node.judgement->verdict)) : json.null();
  json.key("inputs").begin_array();
  for (const Recipe& input : recipe.inputs) {
    tree_json(input, json);
  }
  json.end_array().end_object();
}

std::string explanation_json(const Recipe& recipe) {
  JsonWriter json;
  json.begin_object().key("recipe").raw(recipe_to_json(recipe)).key("tree");
  tree_json(recipe, json);
  return json.end_object().take();
}

}  // namespace changeover::cli
