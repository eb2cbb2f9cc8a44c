// changeover explain V K: the tree of constructions with their theorems.
#include <fmt/format.h>

#include <algorithm>

#include "answer/design/recipe_tree.hpp"
#include "answer/known/known_table.hpp"
#include "changeover/bounds/lower_bound.hpp"
#include "construct/references.hpp"
#include "core/words.hpp"
#include "io/write/latex_prose.hpp"
#include "request/parameters.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct ExplainRequest {
  ParameterRequest asked;
  OutputRequest output;
  std::string construction;
};

// A list within a list for each construction, four deep at most, as LaTeX has them.
std::string latex(const Recipe& recipe) {
  constexpr std::size_t deepest = 4;
  std::vector<std::string> keys;
  std::string text;
  std::size_t open = 0;
  const auto open_to = [&](std::size_t depth) {
    for (; open < depth; ++open) {
      text += "\\begin{itemize}\n";
    }
    for (; open > depth; --open) {
      text += "\\end{itemize}\n";
    }
  };
  for (const RecipeStep& step : recipe_steps(recipe)) {
    const std::string words = fmt::format("{}. {} {}", step.design, step.how, step.citation);
    add_keys(words, keys);
    open_to(std::min(step.depth + 1, deepest));
    text += fmt::format("\\item {}\n", latex_prose(words, keys));
  }
  open_to(0);
  return text;
}

Answer run(const ExplainRequest& request) {
  const std::vector<Parameters> asked = request.asked.of_each_kind();
  const auto offer = best_offer(asked, request.construction);
  if (!offer) {
    return decline(asked, request.construction, request.output);
  }
  if (request.output.json()) {
    return text_answer(explanation_json(offer->recipe) + "\n", request.output);
  }
  if (request.output.format() == "latex") {
    return text_answer(latex(offer->recipe), request.output);
  }
  std::string text = tree_text(offer->recipe);
  text += "lower bound: " + lower_bound(offer->recipe.parameters).reason + "\n";
  std::string others;
  for (const Parameters& p : asked) {
    for (const Offer& other : Registry::standard().offers(p)) {
      if (other.recipe != offer->recipe) {
        others += fmt::format("  {}: {} by {}\n", name(other.recipe.parameters),
                              count_of(other.b, "block"), other.recipe.construction);
      }
    }
  }
  return text_answer(text + (others.empty() ? "" : "other constructions\n" + others),
                     request.output);
}

}  // namespace

void add_explain(Program& program) {
  auto [verb, request] = program.add<ExplainRequest>(
      "explain", "show how a design is built: the tree of its constructions", run);
  request.asked.add_to(verb, true, better_kind);
  request.asked.add_strength_to(verb);
  verb.option("--construction", request.construction, "NAME", "explain this construction's design");
  request.output.add_to(verb, {"text", "latex", "json"});
  verb.examples({"changeover explain 253 13", "changeover explain 8 5 --json"});
}

}  // namespace changeover::cli
