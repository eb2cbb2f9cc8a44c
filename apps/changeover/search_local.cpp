// changeover search V K: fewer blocks by local search.
#include <fmt/format.h>

#include "changeover/core/error.hpp"
#include "changeover/io/json_writer.hpp"
#include "changeover/search/local_search.hpp"
#include "search_request.hpp"
#include "team.hpp"

namespace changeover::cli {
namespace {

// The best that any member of the team has; the same for all.
void share_best(ImproveResult& result, const Parameters& p) {
  Team& team = Team::world();
  if (team.size() == 1) {
    return;
  }
  if (result.why_stopped == WhyStopped::found) {
    team.announce();
  }
  std::string own = fmt::format("{}\n{}\n", result.moves, result.how);
  own += result.design ? pack(*result.design) : "";
  std::uint64_t moves = 0;
  for (const std::string& said : team.exchange(own)) {
    const std::size_t line = said.find('\n');
    const std::size_t end = said.find('\n', line + 1);
    moves += std::stoull(said.substr(0, line));
    const std::string how = said.substr(line + 1, end - line - 1);
    Design design = unpack(p, std::string_view(said).substr(end + 1));
    if (design.block_count() > 0 &&
        (!result.design || design.block_count() < result.design->block_count())) {
      result.design = std::move(design);
      result.how = how;
    }
  }
  result.moves = moves;
}

// What is to be said if there is no design to show.
void say_none(const SearchRequest& request, const std::string& explanation) {
  if (!Team::world().first()) {
    return;
  }
  std::string text = explanation + "\n";
  if (request.output.chosen() == "json") {
    JsonWriter json;
    json.begin_object().key("found").value(false).key("explanation").value(explanation);
    text = json.end_object().take() + "\n";
  }
  deliver(text, "-");
}

int decline(const SearchRequest& request, const Parameters& p, const std::string& reason) {
  say_none(request,
           fmt::format("No {} {}: {}.", name(p),
                       request.blocks ? fmt::format("with {}", count_of(*request.blocks, "block"))
                                      : std::string("exists"),
                       reason));
  return exit_code::proved_none;
}

}  // namespace

int search_locally(const SearchRequest& request) {
  const Parameters p = request.parameters();
  if (const auto reason = impossibility(p)) {
    return decline(request, p, *reason);
  }
  const Bound bound = lower_bound(p);
  if (request.blocks && *request.blocks < bound.blocks) {
    return decline(request, p, bound.reason);
  }
  ImproveOptions options;
  options.target = request.blocks;
  options.checkpoint = request.checkpoint;
  if (!request.checkpoint.empty() && !Team::world().first()) {
    options.checkpoint += fmt::format(".{}", Team::world().index());
  }
  Running running(request.run, request.output);
  ImproveResult result = improve(p, options, running.control());
  share_best(result, p);
  running.finish();

  const std::optional<std::uint64_t> before = result.started_from;
  const std::uint64_t wanted = request.blocks.value_or(bound.blocks);
  const bool better = result.design && (!before || result.design->block_count() < *before);
  const bool reached = result.design && result.design->block_count() <= wanted;
  const int code =
      reached || (!request.blocks && better) ? exit_code::found : exit_code::limit_reached;
  if (!Team::world().first()) {
    return code;
  }
  const double seconds = result.elapsed.count();
  const std::string effort =
      fmt::format("{} moves in {:.1f} s ({:.1f} million/s), {}; stopped: {}", result.moves, seconds,
                  seconds > 0 ? static_cast<double>(result.moves) / seconds / 1e6 : 0.0,
                  count_of(result.attempts, "attempt"), to_string(result.why_stopped));
  if (!result.design) {
    say_none(request, fmt::format("No {} found; at least {}: {}\n{}", name(p),
                                  count_of(bound.blocks, "block"), bound.reason, effort));
    return code;
  }
  SearchFind find{*result.design, {}};
  if (better) {
    find.design.recipe = literal_recipe(find.design, request.provenance(p, ""));
    find.lines.push_back(fmt::format(
        "found by local search: {}{}", result.how,
        before ? fmt::format("; {} were known", count_of(*before, "block")) : std::string()));
  } else {
    find.lines.push_back("the best recipe known; local search found nothing better");
    if (!find.design.recipe) {
      if (const auto known = best_known(p)) {
        find.design.recipe = known->recipe;
      }
    }
  }
  find.lines.push_back(effort);
  show_find(find, request);
  return code;
}

}  // namespace changeover::cli
