// changeover search V K --base-blocks: circular designs with an automorphism.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "changeover/search/base_block_search.hpp"
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

}  // namespace

int search_base_blocks(const SearchRequest& request) {
  const Parameters p = request.parameters(Kind::circular);
  if (const auto reason = impossibility(p)) {
    show_none(request, fmt::format("No {} exists: {}.", name(p), *reason));
    return exit_code::proved_none;
  }
  BaseBlockOptions options;
  options.shapes.n = request.cycle_length;
  options.shapes.fixed = request.fixed_points;
  options.shapes.tight = request.tight;
  options.shapes.most_blocks = request.blocks;
  Running running(request.run, request.output);
  const BaseBlockResult result = search_base_blocks(p, options, running.control());
  running.finish();

  std::vector<std::string> lines;
  lines.reserve(result.attempts.size() + 2);
  for (const ShapeAttempt& attempt : result.attempts) {
    lines.push_back(line_of(attempt));
  }
  if (result.attempts.empty() && result.why_stopped == WhyStopped::exhausted) {
    lines.push_back("no automorphism of this kind is possible for these parameters");
  }
  lines.push_back(describe(result));
  if (!result.found()) {
    JsonWriter json;
    json.begin_object().key("found").value(false).key("attempts").value(lines).end_object();
    show_none(request, fmt::format("{}", fmt::join(lines, "\n")), json.take());
    return exit_code::limit_reached;
  }
  SearchFind find{*result.design, lines};
  if (result.recipe) {
    find.design.recipe = result.recipe;
    Recipe& leaf = find.design.recipe->inputs.empty() ? *find.design.recipe
                                                      : find.design.recipe->inputs.front();
    leaf.provenance = request.provenance(p, "--base-blocks");
  }
  show_find(find, request);
  return exit_code::found;
}

}  // namespace changeover::cli
