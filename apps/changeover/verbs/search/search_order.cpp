// changeover search --order FILE: the blocks of a file in another order.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "changeover/io/input.hpp"
#include "changeover/search/local_search.hpp"
#include "core/words.hpp"
#include "io/write/json_writer.hpp"
#include "request/search_request.hpp"

namespace changeover::cli {
namespace {

struct Ordered {
  std::vector<std::size_t> order;
  std::vector<std::string> lines;                              ///< what is to be said
  std::vector<std::pair<std::string, std::uint64_t>> numbers;  ///< the same for JSON
};

Answer show_list(const Design& arranged, const Ordered& ordered, const SearchRequest& request,
                 int code) {
  if (request.output.json()) {
    JsonWriter json;
    json.begin_object().key("order").value(ordered.order);
    for (const auto& [name, number] : ordered.numbers) {
      json.key(name).value(number);
    }
    json.list("blocks", arranged.blocks(), [&](const Block& block) {
      json.list(block, [&](Element x) { json.value(arranged.label(x)); });
    });
    return text_answer(json.end_object().take() + "\n", request.output, code);
  }
  std::string text;
  for (const std::string& line : ordered.lines) {
    text += "# " + line + "\n";
  }
  for (const Block& block : arranged.blocks()) {
    for (std::size_t i = 0; i < block.size(); ++i) {
      text += (i == 0 ? "" : " ") + arranged.label(block[i]);
    }
    text += "\n";
  }
  return text_answer(text, request.output, code);
}

}  // namespace

Answer search(const OrderSearch& request) {
  ReadOptions reading;
  reading.kind = request.kind;
  reading.change = request.change;
  const Design given = read_design(request.file, reading);
  const std::vector<Block> blocks = given.blocks();
  const auto running = std::make_shared<Running>(request.run, request.output);

  Ordered ordered;
  int code = exit_code::found;
  if (request.change) {
    ChangeOrder found =
        order_for_change(blocks, {.v = given.v(), .m = *request.change, .kind = request.kind}, {},
                         running->control());
    running->finish();
    const std::string change = count_of(*request.change, "element");
    if (found.outcome == Outcome::none) {
      return final_answer(
          running, no_design(request.output, exit_code::proved_none,
                             fmt::format("No {} order of these {} changes {} at every step: {}.",
                                         to_string(request.kind), count_of(blocks.size(), "block"),
                                         change, found.reason)));
    }
    if (found.outcome == Outcome::unknown) {
      return final_answer(running, no_design(request.output, exit_code::limit_reached,
                                             fmt::format("No such order was found; stopped: {}.",
                                                         to_string(found.why_stopped))));
    }
    ordered.order = std::move(found.order);
    ordered.lines = {
        fmt::format("{}, {} changed at every step", count_of(blocks.size(), "block"), change)};
    ordered.numbers = {{"change", *request.change}};
  } else {
    LeastChangeOrder found = order_for_least_change(blocks, {.v = given.v(), .kind = request.kind},
                                                    {}, running->control());
    running->finish();
    ordered.lines = {fmt::format(
        "{}: {} introduced in all, {} in the order given; no order has less than {}{}",
        count_of(blocks.size(), "block"), count_of(found.cost, "element"), found.first_cost,
        found.lower_bound, found.least() ? ", so this is the least" : "")};
    ordered.numbers = {{"cost", found.cost},
                       {"lower_bound", found.lower_bound},
                       {"cost_as_given", found.first_cost}};
    ordered.order = std::move(found.order);
    code = found.least() || found.why_stopped == WhyStopped::exhausted ? exit_code::found
                                                                       : exit_code::limit_reached;
  }

  Parameters p = given.parameters().as(request.kind);
  p.change = request.change.value_or(p.change);
  Design design(p, arranged(blocks, ordered.order));
  design.set_labels(given.labels());
  return final_answer(running, request.change && verify(design).valid()
                                   ? show_find({std::move(design), ordered.lines}, request, code)
                                   : show_list(design, ordered, request, code));
}

}  // namespace changeover::cli
