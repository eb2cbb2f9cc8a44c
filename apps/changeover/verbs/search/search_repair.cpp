// changeover search --repair FILE, --extend FILE: a design from a list of blocks that is none yet.
#include <fmt/format.h>

#include "changeover/io/input.hpp"
#include "changeover/search/local_search.hpp"
#include "core/words.hpp"
#include "request/search_request.hpp"

namespace changeover::cli {
namespace {

// What became of a list, and what is to be said of it.
template <typename Result>
Answer answer(Result result, const std::string& line, const std::string& way,
              const SearchRequest& request, int code) {
  if (!result.design) {
    return no_design(request.output, exit_code::limit_reached,
                     fmt::format("No design yet: stopped ({}) before everything was covered.",
                                 to_string(result.why_stopped)));
  }
  SearchFind find{(*std::move(result.design)).take(), {line}};
  if (!result.unsearched.empty()) {
    find.lines.push_back("blocks were added one by one: " + result.unsearched);
  }
  find.design.recipe =
      literal_recipe(find.design, provenance(request, find.design.parameters(), way));
  return show_find(find, request, code);
}

}  // namespace

Answer search(const RepairSearch& request) {
  const Design list = read_design(request.file, request.reading);
  const auto running = std::make_shared<Running>(request.run, request.output);
  const RepairResult result = repair(list, {}, running->control());
  running->finish();
  return final_answer(
      running,
      answer(result,
             fmt::format("repaired: the list had {}, {} and {}; {} of its blocks are kept",
                         count_of(result.given, "block"), count_of(result.bad_steps, "wrong step"),
                         count_of(result.uncovered, "uncovered pair"), result.kept),
             "--repair", request, exit_code::found));
}

Answer search(const ExtendSearch& request) {
  const Design beginning = read_design(request.file, request.reading);
  const auto running = std::make_shared<Running>(request.run, request.output);
  const ExtendResult result =
      extend(beginning, {.blocks = request.blocks, .moves = {}}, running->control());
  running->finish();
  return final_answer(
      running,
      answer(
          result,
          fmt::format(
              "begins with the {} given; no design that does has fewer than {}; stopped: {}",
              count_of(beginning.block_count(), "block"), count_of(result.lower_bound, "block"),
              to_string(result.why_stopped)),
          "--extend", request,
          result.why_stopped == WhyStopped::found ? exit_code::found : exit_code::limit_reached));
}

}  // namespace changeover::cli
