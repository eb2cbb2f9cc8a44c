// changeover search --first, --last, --expansion-set, --contains: designs that constructions can
// build upon.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "changeover/io/input.hpp"
#include "changeover/search/local_search.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "request/search_request.hpp"

namespace changeover::cli {

std::string way_of(const Wanted& wanted) {
  std::vector<std::string> way;
  if (!wanted.first.empty()) {
    way.push_back(fmt::format("--first {}", fmt::join(wanted.first, ",")));
  }
  if (!wanted.last.empty()) {
    way.push_back(fmt::format("--last {}", fmt::join(wanted.last, ",")));
  }
  if (wanted.expansion_set) {
    way.emplace_back("--expansion-set");
  }
  if (!wanted.contained.empty()) {
    way.emplace_back("--contains FILE");
  }
  return fmt::format("{}", fmt::join(way, " "));
}

namespace {

std::vector<std::uint64_t> positions_of(const std::vector<UnchangedSubset>& parts) {
  return each_of<std::uint64_t>(parts, &UnchangedSubset::position);
}

std::vector<std::string> said_of(const LockedResult& result, const Wanted& wanted) {
  std::vector<std::string> lines{fmt::format(
      "{} in {:.1f} s, {}; stopped: {}", count_of(result.moves, "move"), result.elapsed.count(),
      count_of(result.attempts, "attempt"), to_string(result.why_stopped))};
  if (result.known) {
    lines.emplace_back("a known design has the properties, with its elements renumbered");
  }
  if (!result.parts.empty()) {
    const std::vector<std::uint64_t> positions = positions_of(result.parts);
    const bool all = wanted.first.empty() && wanted.last.empty();
    lines.push_back(fmt::format("the unchanged subsets at {} {} partition {} elements",
                                positions.size() == 1 ? "position" : "positions",
                                fmt::join(positions, ", "), all ? "all" : "the other"));
  }
  return lines;
}

}  // namespace

Answer search(const LockedSearch& request) {
  const Parameters& p = request.parameters;
  Wanted wanted = request.wanted;
  if (!request.contains_file.empty()) {
    ReadOptions reading = request.reading;
    reading.v = p.v;
    reading.k = p.k;
    reading.change = p.change;
    wanted.contained = read_design(request.contains_file, reading).blocks();
  }
  const auto running = std::make_shared<Running>(request.run, request.output);
  std::optional<Bound> bound;
  if (auto none = proved_none(request, p, running->control(), bound)) {
    return final_answer(running, *std::move(none));
  }
  if (request.blocks && wanted_defect(p, wanted).empty()) {
    const Bound needed = wanted_bound(p, wanted);
    if (*request.blocks < needed.blocks) {
      return final_answer(running, none_for(request, p, needed.reason, " has what is wanted"));
    }
  }
  LockedResult result =
      search_locked(p, wanted, {.blocks = request.blocks, .moves = {}}, running->control());
  running->finish();
  if (!result.design) {
    return final_answer(running, no_design(request.output, exit_code::limit_reached,
                                           fmt::format("No such {} yet: stopped ({}) after {}.",
                                                       name(p), to_string(result.why_stopped),
                                                       count_of(result.attempts, "attempt"))));
  }
  const bool reached = !request.blocks || result.design->block_count() <= *request.blocks;
  std::vector<std::string> lines = said_of(result, wanted);
  SearchFind find{(*std::move(result.design)).take(), std::move(lines)};
  find.positions = positions_of(result.parts);
  find.design.recipe = literal_recipe(find.design, provenance(request, p, way_of(wanted)));
  return final_answer(
      running, show_find(find, request, reached ? exit_code::found : exit_code::limit_reached));
}

}  // namespace changeover::cli
