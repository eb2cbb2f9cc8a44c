// changeover design V K: the best design that a construction gives, verified.
#include "answer/design/chosen_design.hpp"
#include "answer/design/show_design.hpp"
#include "answer/known/known_table.hpp"
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
  const bool streams = can_be_judged_while_written(request.output);
  ChosenDesign chosen = built(*offer, streams ? Unread::may_be_left : Unread::never);
  chosen.exhibit.leaving = request.leaving;
  if (!chosen.judged) {
    return show_design_while_judging(chosen.source, *offer, chosen.exhibit, request.output);
  }
  return show_design(chosen.source, std::move(chosen.exhibit), request.output);
}

}  // namespace

void add_design(Program& program) {
  auto [verb, request] =
      program.add<DesignRequest>("design", "build the best known design, and verify it", run);
  request.asked.add_to(verb, true, better_kind);
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
