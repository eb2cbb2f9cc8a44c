// changeover bounds V K: each lower bound with its reason, the best design known, the gap.
#include <fmt/format.h>

#include "answer/answer.hpp"
#include "construct/known_tables.hpp"
#include "core/each.hpp"
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
  const std::string all =
      answer.all ? fmt::format("  all of them   {}\n", classified_words(*answer.all)) : "";
  return text + all + reported +
         (gap == 0 ? "  minimum: the bound is attained\n"
                   : fmt::format("  open: between {} and {}\n", answer.bounds.front().blocks,
                                 answer.best->b));
}

Answer run(const BoundsRequest& request) {
  const std::vector<KnownBounds> answers = each_of<KnownBounds>(
      request.asked.of_each_kind(), [&](const Parameters& p) { return known_bounds(p); });
  const bool is_latex = request.output.format() == "latex";
  const std::string all = joined(answers, "", [&](const KnownBounds& each) {
    return is_latex ? bounds_latex(each) : text(each);
  });
  return text_answer(request.output.json() ? bounds_json(best_of(answers)) + "\n" : all,
                     request.output);
}

}  // namespace

void add_bounds(Program& program) {
  auto [verb, request] = program.add<BoundsRequest>(
      "bounds", "show lower bounds with their reasons, and the best design known", run);
  request.asked.add_to(
      verb, true, "default: both; in JSON the kind with fewer blocks known, circular if equal");
  request.asked.add_strength_to(verb);
  request.output.add_to(verb, {"text", "latex", "json"});
  verb.examples({"changeover bounds 20 5", "changeover bounds 8 5 --circular --json",
                 "changeover bounds 10 7 --change 1 --strength 3   every three elements meet",
                 "changeover bounds 8 5 --json    without a kind, JSON has the kind with the "
                 "fewest known blocks"});
}

}  // namespace changeover::cli
