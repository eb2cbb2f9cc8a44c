// changeover design V K: the best design that a construction gives, verified.
#include <fmt/format.h>

#include "answer/offers.hpp"
#include "answer/show_design.hpp"
#include "request/parameters.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct DesignRequest {
  ParameterRequest asked;
  OutputRequest output;
  std::string construction;
  bool leaving = false;
};

Answer run(const DesignRequest& request) {
  const Registry& registry = Registry::standard();
  const std::vector<Parameters> asked = request.asked.of_each_kind();
  if (request.leaving) {
    request.output.require("--leaving", formats_of_marks());
  }
  const auto offer = best_offer(asked, request.construction);
  if (!offer) {
    return decline(asked, request.construction, request.output);
  }
  if (const auto defect =
          format_defect(offer->recipe.parameters, offer->b, request.output.format())) {
    throw UsageError{*defect};
  }
  const Construction& construction = *registry.find(offer->recipe.construction);
  const std::shared_ptr<BlockSource> source = registry.build(offer->recipe);
  std::optional<Judgement> judgement = judge_at_once(*source, *offer);

  Exhibit exhibit;
  exhibit.header.labels = construction.labels(offer->recipe, registry);
  exhibit.header.recipe = offer->recipe;
  exhibit.leaving = request.leaving;
  if (!judgement && takes_long_to_judge(*source, *offer) &&
      can_be_judged_while_written(request.output)) {
    return show_design_while_judging(source, *offer, exhibit, request.output);
  }
  exhibit.judgement = judgement ? *std::move(judgement) : judge(*source, *offer);
  if (const auto base = construction.base_blocks(offer->recipe); base && base->blocks.size() > 1) {
    exhibit.base_blocks = base->blocks.size();
  }
  if (const auto set = construction.expansion_set(offer->recipe, registry)) {
    for (const UnchangedSubset& subset : *set) {
      exhibit.positions.push_back(subset.position);
    }
  }
  exhibit.title = fmt::format("{}, {}: {}\n{} {}\nverified: {}", name(offer->recipe.parameters),
                              count_of(offer->b, "block"), quality(exhibit.judgement),
                              construction.explain(offer->recipe),
                              construction.citation().to_string(), exhibit.judgement.certificate);
  if (!exhibit.positions.empty()) {
    exhibit.title += fmt::format("\n^ marks the {} unchanged subsets of an expansion set",
                                 exhibit.positions.size());
  }
  return show_design(source, std::move(exhibit), request.output);
}

}  // namespace

void add_design(Program& program) {
  auto [verb, request] =
      program.add("design", "the best design that a construction gives, verified", run);
  request.asked.add_to(verb);
  request.asked.add_strength_to(verb);
  verb.option("--construction", request.construction, "NAME", "use this construction only");
  verb.flag("--leaving", request.leaving, "mark leaving elements too, in tables and LaTeX");
  request.output.add_to(verb, design_formats());
  verb.examples(
      {"changeover design 61 4                     as a table, introduced elements marked *",
       "changeover design 8 5 --leaving            leaving elements marked . too",
       "changeover design 9 5 --change 1 --json    a single-change design as JSON",
       "changeover design 21 4 --format latex -o d.tex"});
}

}  // namespace changeover::cli
