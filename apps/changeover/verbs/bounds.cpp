// changeover bounds V K: each lower bound with its reason, the best design known, the gap.
#include <fmt/format.h>

#include "answer/answer.hpp"
#include "answer/catalog/entry_words.hpp"
#include "construct/known_documents.hpp"
#include "core/each.hpp"
#include "io/write/latex_prose.hpp"
#include "request/parameters.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct BoundsRequest {
  ParameterRequest asked;
  OutputRequest output;
};

std::string text(const KnownBounds& answer) {
  std::string text = name(answer.parameters) + "\n";
  if (answer.impossible) {
    return text + fmt::format("  impossible: {}\n", *answer.impossible);
  }
  for (const Bound& bound : answer.bounds) {
    text += fmt::format("  b >= {:<8} {}: {}\n", bound.blocks, bound.name, bound.reason);
  }
  const std::string reported =
      answer.reported ? fmt::format("  {}\n", reported_words(*answer.reported)) : "";
  if (!answer.best) {
    return text + reported + "  no construction serves these parameters: open\n";
  }
  const std::uint64_t gap = answer.best->b - answer.bounds.front().blocks;
  text += fmt::format("  b <= {:<8} {}\n", answer.best->b, answer.best->recipe.construction);
  return text + reported +
         (gap == 0 ? "  minimum: the bound is attained\n"
                   : fmt::format("  open: between {} and {}\n", answer.bounds.front().blocks,
                                 answer.best->b));
}

std::string latex(const KnownBounds& answer) {
  std::vector<std::string> keys;
  std::string text =
      fmt::format("\\paragraph{{{}}}\n\\begin{{itemize}}\n", latex_prose(name(answer.parameters)));
  const auto item = [&](const std::string& words) {
    add_keys(words, keys);
    text += fmt::format("\\item {}\n", latex_prose(words, keys));
  };
  if (answer.impossible) {
    item("impossible: " + *answer.impossible);
  }
  for (const Bound& bound : answer.bounds) {
    item(fmt::format("b >= {} ({}): {}", bound.blocks, bound.name, bound.reason));
  }
  if (answer.best) {
    const Construction& by = *Registry::standard().find(answer.best->recipe.construction);
    item(fmt::format("b <= {} ({}): {} {}", answer.best->b, by.name(),
                     by.explain(answer.best->recipe), by.citation().to_string()));
  }
  if (answer.reported) {
    item(fmt::format("{} [{}]: reported, blocks not held here", answer.reported->blocks,
                     answer.reported->cites));
  }
  return text + "\\end{itemize}\n";
}

Answer run(const BoundsRequest& request) {
  const std::vector<KnownBounds> answers = each_of<KnownBounds>(
      request.asked.of_each_kind(), [&](const Parameters& p) { return known_bounds(p); });
  const bool is_latex = request.output.format() == "latex";
  const std::string all = joined(
      answers, "", [&](const KnownBounds& each) { return is_latex ? latex(each) : text(each); });
  return text_answer(request.output.json() ? bounds_json(best_of(answers)) + "\n" : all,
                     request.output);
}

}  // namespace

void add_bounds(Program& program) {
  auto [verb, request] = program.add<BoundsRequest>(
      "bounds", "lower bounds with their reasons, and the best design known", run);
  request.asked.add_to(verb);
  request.asked.add_strength_to(verb);
  request.output.add_to(verb, {"text", "latex", "json"});
  verb.examples({"changeover bounds 20 5", "changeover bounds 8 5 --circular --json",
                 "changeover bounds 10 7 --change 1 --strength 3   every three elements meet",
                 "JSON is about one kind: if none is named, the one with the fewest blocks known"});
}

}  // namespace changeover::cli
