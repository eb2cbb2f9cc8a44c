// changeover explain V K: the tree of constructions with their theorems.
#include <fmt/format.h>

#include "answer/design/recipe_tree.hpp"
#include "answer/known/offers.hpp"
#include "changeover/bounds/lower_bound.hpp"
#include "core/words.hpp"
#include "request/parameters.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct ExplainRequest {
  ParameterRequest asked;
  OutputRequest output;
  std::string construction;
};

Answer run(const ExplainRequest& request) {
  const std::vector<Parameters> asked = request.asked.of_each_kind();
  const auto offer = best_offer(asked, request.construction);
  if (!offer) {
    return decline(asked, request.construction, request.output);
  }
  if (request.output.json()) {
    return text_answer(explanation_json(offer->recipe) + "\n", request.output);
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
      "explain", "how a design is built: the tree of constructions", run);
  request.asked.add_to(verb);
  request.asked.add_strength_to(verb);
  verb.option("--construction", request.construction, "NAME", "explain this construction's design");
  request.output.add_to(verb, {"text", "json"});
  verb.examples({"changeover explain 253 13", "changeover explain 8 5 --json"});
}

}  // namespace changeover::cli
