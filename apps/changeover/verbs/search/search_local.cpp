// changeover search V K: fewer blocks by local search.
#include <fmt/format.h>

#include "changeover/core/error.hpp"
#include "changeover/search/local_search.hpp"
#include "cli/status_line.hpp"
#include "cli/team.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "request/search_request.hpp"

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
  std::string own = fmt::format("{}\n{}\n{}\n", result.moves, result.how, result.checkpoint_fault);
  own += result.design ? pack(*result.design) : "";
  std::uint64_t moves = 0;
  for (const std::string& said : team.exchange(own)) {
    std::string_view rest = said;
    const auto line = [&rest] {
      std::string text(rest.substr(0, rest.find('\n')));
      rest.remove_prefix(text.size() + 1);
      return text;
    };
    moves += std::stoull(line());
    const std::string how = line();
    const std::string fault = line();
    if (result.checkpoint_fault.empty()) {
      result.checkpoint_fault = fault;
    }
    Design design = unpack(p, rest);
    if (design.block_count() > 0 &&
        (!result.design || design.block_count() < result.design->block_count())) {
      result.design = surely_verified(std::move(design), "what another process found");
      result.how = how;
    }
  }
  result.moves = moves;
}

// Why the design that is known is shown without a search: above a table, else on stderr.
void say_unsearched(const LocalSearch& request, SearchFind& find, const std::string& reason) {
  const std::string line = "no search was made: " + reason;
  if (request.output.format() == "table") {
    find.lines.push_back(line);
  } else {
    status_line().say("changeover: " + printable(line));
  }
}

}  // namespace

Answer search(const LocalSearch& request) {
  const Parameters& p = request.parameters;
  const auto running = std::make_shared<Running>(request.run, request.output);
  std::optional<Bound> bound;
  if (auto none = proved_none(request, p, running->control(), bound)) {
    return final_answer(running, *std::move(none));
  }
  ImproveOptions options;
  options.target = request.blocks;
  if (!request.checkpoint.empty()) {
    options.checkpoint = checkpoint_of(request, Team::world().index());
  }
  ImproveResult result;
  if (bound) {
    result = improve(p, options, running->control());
  } else {
    result.why_stopped = running->control().why_stopped();
  }
  share_best(result, p);
  running->finish();

  const std::optional<std::uint64_t> before = result.started_from;
  const std::uint64_t wanted = request.blocks.value_or(bound ? bound->blocks : 1);
  const bool better = result.design && (!before || result.design->block_count() < *before);
  const bool reached = result.design && result.design->block_count() <= wanted;
  const int code =
      reached || (!request.blocks && better) ? exit_code::found : exit_code::limit_reached;
  if (!result.design) {
    return final_answer(
        running,
        no_design(request.output, code,
                  fmt::format("No {} yet: stopped ({}) before there was one{}", name(p),
                              to_string(result.why_stopped),
                              bound ? fmt::format("; at least {}: {}",
                                                  count_of(bound->blocks, "block"), bound->reason)
                                    : std::string("."))));
  }
  const double seconds = result.elapsed.count();
  const std::string effort = fmt::format(
      "{} in {:.1f} s ({:.1f} million/s), {}; stopped: {}", count_of(result.moves, "move"), seconds,
      seconds > 0 ? static_cast<double>(result.moves) / seconds / 1e6 : 0.0,
      count_of(result.attempts, "attempt"), to_string(result.why_stopped));
  SearchFind find{(*std::move(result.design)).take(), {}};
  if (better || !find.design.recipe) {
    find.design.recipe = literal_recipe(find.design, provenance(request, p, ""));
    find.lines.push_back(
        fmt::format("found by local search{}: {}{}", better ? "" : " in an earlier run", result.how,
                    better && before ? fmt::format("; {} were known", count_of(*before, "block"))
                                     : std::string()));
  } else {
    find.lines.push_back(result.unsearched.empty()
                             ? "the best recipe known; local search found nothing better"
                             : "the best recipe known");
  }
  if (!result.unsearched.empty() && Team::world().first()) {
    say_unsearched(request, find, result.unsearched);
  }
  find.lines.push_back(effort);
  Answer answer = show_find(find, request, code);
  if (!result.checkpoint_fault.empty()) {
    answer.fault = std::make_exception_ptr(MissingResource(
        fmt::format("the answer is complete, but the checkpoint is not as far as the search: {}",
                    result.checkpoint_fault)));
  }
  return final_answer(running, std::move(answer));
}

}  // namespace changeover::cli
