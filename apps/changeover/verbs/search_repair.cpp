// changeover search --repair FILE, --extend FILE: a design from a list of blocks that is none yet.
#include <fmt/format.h>

#include "changeover/io/input.hpp"
#include "changeover/search/repair.hpp"
#include "request/search_request.hpp"

namespace changeover::cli {
namespace {

// V and K may be given too, for a list that does not have every element yet.
Design given_list(const SearchRequest& request, const std::string& path) {
  if (request.circular && request.linear) {
    throw UsageError{"--circular and --linear exclude each other"};
  }
  ReadOptions options{
      .v = request.v, .k = request.k, .change = request.change, .kind = {}, .strength = {}};
  if (request.circular || request.linear) {
    options.kind = request.circular ? Kind::circular : Kind::linear;
  }
  if (request.strength) {
    if (*request.strength < 2 || *request.strength > max_strength) {
      throw UsageError{fmt::format("--strength {} is out of range; give 2 to {}", *request.strength,
                                   max_strength)};
    }
    options.strength = static_cast<std::uint32_t>(*request.strength);
  }
  return read_design(path, options);
}

int decline(const SearchRequest& request, WhyStopped why) {
  show_none(request, fmt::format("No design yet: stopped ({}) before everything was covered.",
                                 to_string(why)));
  return exit_code::limit_reached;
}

}  // namespace

int search_repair(const SearchRequest& request) {
  const Design list = given_list(request, request.repair_file);
  Running running(request.run, request.output);
  RepairResult result = repair(list, {}, running.control());
  running.finish();
  if (!result.design) {
    return decline(request, result.why_stopped);
  }
  SearchFind find{*std::move(result.design), {}};
  find.lines.push_back(
      fmt::format("repaired: the list had {}, {} and {}; {} of its blocks are kept",
                  count_of(result.given, "block"), count_of(result.bad_steps, "wrong step"),
                  count_of(result.uncovered, "uncovered pair"), result.kept));
  if (!result.unsearched.empty()) {
    find.lines.push_back("blocks were added one by one: " + result.unsearched);
  }
  find.design.recipe =
      literal_recipe(find.design, request.provenance(find.design.parameters(), "--repair"));
  show_find(find, request);
  return exit_code::found;
}

int search_extend(const SearchRequest& request) {
  const Design beginning = given_list(request, request.extend_file);
  Running running(request.run, request.output);
  ExtendResult result =
      extend(beginning, {.blocks = request.blocks, .moves = {}}, running.control());
  running.finish();
  if (!result.design) {
    return decline(request, result.why_stopped);
  }
  SearchFind find{*std::move(result.design), {}};
  find.lines.push_back(
      fmt::format("begins with the {} given; no design that does has fewer than {}; stopped: {}",
                  count_of(beginning.block_count(), "block"), count_of(result.lower_bound, "block"),
                  to_string(result.why_stopped)));
  if (!result.unsearched.empty()) {
    find.lines.push_back("blocks were added one by one: " + result.unsearched);
  }
  find.design.recipe =
      literal_recipe(find.design, request.provenance(find.design.parameters(), "--extend"));
  const bool enough = result.why_stopped == WhyStopped::found;
  show_find(find, request);
  return enough ? exit_code::found : exit_code::limit_reached;
}

}  // namespace changeover::cli
