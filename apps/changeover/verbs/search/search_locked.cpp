// changeover search --first, --last, --expansion-set, --contains: designs that constructions can
// build on.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "changeover/io/input.hpp"
#include "changeover/search/local_search.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "request/search_request.hpp"

namespace changeover::cli {

std::string way_of(const Wanted& wanted, bool anew) {
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
  if (anew) {
    way.emplace_back("--anew");
  }
  return fmt::format("{}", fmt::join(way, " "));
}

std::vector<std::uint64_t> positions_of(const std::vector<UnchangedSubset>& subsets) {
  return each_of<std::uint64_t>(subsets, &UnchangedSubset::position);
}

std::vector<std::string> lines_as_wanted(const Wanted& wanted, bool known,
                                         const std::vector<UnchangedSubset>& subsets) {
  std::vector<std::string> lines;
  if (known) {
    lines.emplace_back("a known design has the properties, with its elements renumbered");
  }
  if (!subsets.empty()) {
    const bool all = wanted.first.empty() && wanted.last.empty();
    lines.push_back(fmt::format("the unchanged subsets at {} {} partition {} elements",
                                subsets.size() == 1 ? "position" : "positions",
                                fmt::join(positions_of(subsets), ", "), all ? "all" : "the other"));
  }
  return lines;
}

Wanted WantedRequest::read(const Parameters& p) const {
  Wanted all = wanted;
  if (!contains_file.empty()) {
    ReadOptions options = reading;
    options.v = p.v;
    options.k = p.k;
    options.change = p.change;
    options.strength = p.strength;
    options.no_other = true;
    const Design given = read_design(contains_file, options);
    if (!given.labels().empty()) {  // --first and --last name elements by their numbers
      throw BadInput(contains_file + ": the elements have names; give numbers from 0 to v-1");
    }
    all.contained = given.blocks();
    const std::string defect = wanted_defect(p, {.contained = all.contained});
    if (!defect.empty()) {
      throw BadInput(contains_file + ": " + defect);
    }
  }
  return all;
}

Answer search(const LockedSearch& request) {
  const Parameters& p = request.parameters;
  const Wanted wanted = request.read(p);
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
      search_locked(p, wanted, {.blocks = request.blocks, .moves = {}, .from_known = !request.anew},
                    running->control());
  running->finish();
  if (!result.design) {
    return final_answer(running, no_design(request.output, exit_code::limit_reached,
                                           fmt::format("No such {} yet: stopped ({}) after {}.",
                                                       name(p), to_string(result.why_stopped),
                                                       count_of(result.attempts, "attempt"))));
  }
  const bool reached = !request.blocks || result.design->block_count() <= *request.blocks;
  std::vector<std::string> lines{fmt::format(
      "{} in {:.1f} s, {}; stopped: {}", count_of(result.moves, "move"), result.elapsed.count(),
      count_of(result.attempts, "attempt"), to_string(result.why_stopped))};
  std::ranges::move(lines_as_wanted(wanted, result.known, result.parts), std::back_inserter(lines));
  SearchFind find{(*std::move(result.design)).take(), std::move(lines)};
  find.positions = positions_of(result.parts);
  find.design.recipe =
      literal_recipe(find.design, provenance(request, p, way_of(wanted, request.anew)));
  return final_answer(
      running, show_find(find, request, reached ? exit_code::found : exit_code::limit_reached));
}

}  // namespace changeover::cli
