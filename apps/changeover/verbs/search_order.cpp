// changeover search --order FILE: the blocks of a file in another order.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "changeover/io/formats.hpp"
#include "changeover/io/input.hpp"
#include "changeover/search/ordering.hpp"
#include "io/write/json_writer.hpp"
#include "request/search_request.hpp"

namespace changeover::cli {
namespace {

struct Ordered {
  std::vector<std::size_t> order;
  std::vector<std::string> lines;                              ///< what is to be said
  std::vector<std::pair<std::string, std::uint64_t>> numbers;  ///< the same for JSON
};

void show_list(const Design& arranged, const Ordered& ordered, const SearchRequest& request) {
  if (request.output.chosen() == "json") {
    JsonWriter json;
    json.begin_object().key("order").value(ordered.order);
    for (const auto& [name, number] : ordered.numbers) {
      json.key(name).value(number);
    }
    json.key("blocks").begin_array();
    for (const Block& block : arranged.blocks()) {
      json.begin_array();
      for (const Element x : block) {
        json.value(arranged.label(x));
      }
      json.end_array();
    }
    json.end_array().end_object();
    deliver(json.take() + "\n", request.output);
    return;
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
  deliver(text, request.output);
}

int decline(const SearchRequest& request, const std::string& words, int code) {
  show_none(request, words);
  return code;
}

}  // namespace

int search_order(const SearchRequest& request) {
  if (request.circular && request.linear) {
    throw UsageError{"--circular and --linear exclude each other"};
  }
  if (request.v || request.k) {
    throw UsageError{"--order takes V and K from the file; leave them out"};
  }
  const Kind kind = request.circular ? Kind::circular : Kind::linear;
  ReadOptions reading;
  reading.kind = kind;
  reading.change = request.change;
  const Design given = read_design(request.order_file, reading);
  const std::vector<Block> blocks = given.blocks();
  Running running(request.run, request.output);

  Ordered ordered;
  int code = exit_code::found;
  if (request.change) {
    ChangeOrder found = order_for_change(
        blocks, {.v = given.v(), .m = *request.change, .kind = kind}, {}, running.control());
    running.finish();
    if (found.answer == OrderAnswer::none) {
      return decline(request,
                     fmt::format("No {} order of these {} changes {} at every step: {}.",
                                 to_string(kind), count_of(blocks.size(), "block"),
                                 count_of(*request.change, "element"), found.reason),
                     exit_code::proved_none);
    }
    if (found.answer == OrderAnswer::unknown) {
      return decline(request,
                     fmt::format("No such order was found; stopped: {}.", to_string(found.why)),
                     exit_code::limit_reached);
    }
    ordered.order = std::move(found.order);
    ordered.lines = {fmt::format("{}, {} changed at every step", count_of(blocks.size(), "block"),
                                 count_of(*request.change, "element"))};
    ordered.numbers = {{"change", *request.change}};
  } else {
    LeastChangeOrder found =
        order_for_least_change(blocks, {.v = given.v(), .kind = kind}, {}, running.control());
    running.finish();
    ordered.lines = {fmt::format(
        "{}: {} introduced in all, {} in the order given; no order has less than {}{}",
        count_of(blocks.size(), "block"), count_of(found.cost, "element"), found.first_cost,
        found.lower_bound, found.least() ? ", so this is the least" : "")};
    ordered.numbers = {{"cost", found.cost},
                       {"lower_bound", found.lower_bound},
                       {"cost_as_given", found.first_cost}};
    ordered.order = std::move(found.order);
    code = found.least() || found.why == WhyStopped::exhausted ? exit_code::found
                                                               : exit_code::limit_reached;
  }

  Parameters p = given.parameters();
  p.kind = kind;
  p.change = request.change.value_or(p.change);
  Design design(p, arranged(blocks, ordered.order));
  design.set_labels(given.labels());
  if (request.change && verify(design).valid()) {
    show_find({std::move(design), ordered.lines}, request);
  } else {
    show_list(design, ordered, request);
  }
  return code;
}

}  // namespace changeover::cli
