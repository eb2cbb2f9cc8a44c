// changeover search V K --base-blocks: circular designs with an automorphism.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/each.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"
#include "request/search_request.hpp"

namespace changeover::cli {
namespace {

std::string line_of(const ShapeAttempt& attempt) {
  std::string line = to_string(attempt.shape) + ": ";
  line += attempt.outcome == Outcome::found  ? "found"
          : attempt.outcome == Outcome::none ? "none, says the SAT solver"
                                             : "not found";
  if (attempt.outcome == Outcome::unknown && attempt.missing) {
    line += fmt::format(" (at best {} of pairs missing)", count_of(*attempt.missing, "orbit"));
  }
  return line;
}

std::string way_of(const ShapeOptions& shapes) {
  std::string way = "--base-blocks";
  way += shapes.tight ? " --tight" : "";
  way += shapes.n ? fmt::format(" --cycle {}", *shapes.n) : "";
  return way + (shapes.fixed ? fmt::format(" --fixed-points {}", *shapes.fixed) : "");
}

}  // namespace

void credit(Recipe& developed, const std::string& words) {
  (developed.inputs.empty() ? developed : developed.inputs.front()).provenance = words;
}

Answer search(const BaseBlockSearch& request) {
  const Parameters& p = request.parameters;
  if (const auto reason = impossibility(p)) {
    return no_design(request.output, exit_code::proved_none,
                     fmt::format("No {} exists: {}.", name(p), *reason));
  }
  const auto running = std::make_shared<Running>(request.run, request.output);
  const BaseBlockResult result = search_base_blocks(p, request.options, running->control());
  running->finish();

  std::vector<std::string> lines = each_of<std::string>(result.attempts, line_of);
  if (result.attempts.empty() && result.why_stopped == WhyStopped::exhausted) {
    lines.push_back("no automorphism of this kind is possible for these parameters");
  }
  lines.push_back(describe(result));
  if (!result.found()) {
    JsonWriter json;
    json.begin_object().key("found").value(false).key("attempts").value(lines).end_object();
    return final_answer(running, no_design(request.output, exit_code::limit_reached,
                                           fmt::format("{}", fmt::join(lines, "\n")), json.take()));
  }
  SearchFind find{*result.design, lines};
  if (result.recipe) {
    find.design.recipe = result.recipe;
    credit(*find.design.recipe, provenance(request, p, way_of(request.options.shapes)));
  }
  return final_answer(running, show_find(find, request, exit_code::found));
}

}  // namespace changeover::cli
