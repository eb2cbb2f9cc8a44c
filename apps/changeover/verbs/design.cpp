// changeover design V K: the best design that a construction gives, verified.
#include <fmt/format.h>

#include "answer/decline.hpp"
#include "answer/show_design.hpp"
#include "changeover/core/error.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct DesignRequest {
  ParameterRequest asked;
  OutputRequest output;
  std::string construction;
  bool leaving = false;
};

std::string names_of_constructions() {
  std::string names;
  for (const Construction* construction : Registry::standard().constructions()) {
    names += (names.empty() ? "" : ", ") + std::string(construction->name());
  }
  return names;
}

int run(const DesignRequest& request) {
  const Registry& registry = Registry::standard();
  const std::vector<Parameters> asked = request.asked.parameters();
  if (!request.construction.empty() && registry.find(request.construction) == nullptr) {
    throw UsageError{fmt::format("no construction is called '{}'; there are {}",
                                 request.construction, names_of_constructions())};
  }
  const auto offer = best_offer(asked, request.construction);
  if (!offer) {
    return decline(asked, request.construction, request.output);
  }
  if (const auto defect =
          format_defect(offer->recipe.parameters, offer->b, request.output.chosen())) {
    throw UsageError{*defect};
  }
  const Construction& construction = *registry.find(offer->recipe.construction);
  const std::unique_ptr<BlockSource> source = registry.build(offer->recipe);
  std::optional<Judgement> judgement = judge_at_once(*source, *offer);

  Exhibit exhibit;
  exhibit.header.labels = construction.labels(offer->recipe, registry);
  exhibit.header.recipe = offer->recipe;
  exhibit.leaving = request.leaving;
  if (!judgement && takes_long_to_judge(*source, *offer) &&
      can_be_judged_while_written(request.output)) {
    JudgedWhileRead judged(*source, *offer);
    show_design_while_judging(judged, exhibit, request.output);
    return exit_code::done;
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
  show_design(*source, exhibit, request.output);
  return exit_code::done;
}

}  // namespace

void add_design(Program& program) {
  auto request = std::make_shared<DesignRequest>();
  Verb& verb = program.add("design", "the best design that a construction gives, verified");
  request->asked.add_to(verb);
  verb.option("--construction", request->construction, "NAME", "use this construction only");
  verb.flag("--leaving", request->leaving, "mark leaving elements too, in tables and LaTeX");
  request->output.add_to(verb, design_formats());
  verb.examples(
      {"changeover design 61 4                     as a table, introduced elements marked *",
       "changeover design 8 5 --leaving            leaving elements marked . too",
       "changeover design 9 5 --change 1 --json    a single-change design as JSON",
       "changeover design 21 4 --format latex -o d.tex"});
  verb.run([request] { return run(*request); });
}

}  // namespace changeover::cli
