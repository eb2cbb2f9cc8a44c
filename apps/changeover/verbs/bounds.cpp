// changeover bounds V K: each lower bound with its reason, the best design known, the gap.
#include <fmt/format.h>

#include "answer/offers.hpp"
#include "changeover/bounds/lower_bound.hpp"
#include "io/write/json_writer.hpp"
#include "request/parameters.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct BoundsRequest {
  ParameterRequest asked;
  OutputRequest output;
};

struct Known {
  Parameters parameters;
  std::optional<std::string> impossible;
  std::vector<Bound> bounds;
  std::optional<Offer> best;

  [[nodiscard]] std::string status() const {
    if (impossible) {
      return "impossible";
    }
    if (!best) {
      return "open";
    }
    return best->b == bounds.front().blocks ? "minimum" : "best-known";
  }
};

Known known(const Parameters& p) {
  Known answer{.parameters = p, .impossible = impossibility(p), .bounds = {}, .best = {}};
  if (!answer.impossible) {
    answer.bounds = lower_bounds(p);
    answer.best = best_known(p);
  }
  return answer;
}

std::string text(const Known& answer) {
  std::string text = name(answer.parameters) + "\n";
  if (answer.impossible) {
    return text + fmt::format("  impossible: {}\n", *answer.impossible);
  }
  for (const Bound& bound : answer.bounds) {
    text += fmt::format("  b >= {:<8} {}: {}\n", bound.blocks, bound.name, bound.reason);
  }
  if (!answer.best) {
    return text + "  no construction serves these parameters: open\n";
  }
  const std::uint64_t gap = answer.best->b - answer.bounds.front().blocks;
  text += fmt::format("  b <= {:<8} {}\n", answer.best->b, answer.best->recipe.construction);
  return text + (gap == 0 ? "  minimum: the bound is attained\n"
                          : fmt::format("  open: between {} and {}\n", answer.bounds.front().blocks,
                                        answer.best->b));
}

// The kind that a single answer is about: the one with the fewest blocks known, circular among equals.
const Known& chosen(const std::vector<Known>& answers) {
  const Known* best = &answers.front();
  for (const Known& answer : answers) {
    if (answer.best && (!best->best || answer.best->b < best->best->b)) {
      best = &answer;
    }
  }
  return *best;
}

std::string json(const Known& answer) {
  const Parameters& p = answer.parameters;
  JsonWriter json;
  json.begin_object().key("v").value(p.v).key("k").value(p.k).key("change").value(p.change);
  json.key("kind").value(to_string(p.kind)).key("strength").value(std::uint64_t{p.strength});
  json.key("lower_bound");
  answer.impossible ? json.null() : json.value(answer.bounds.front().blocks);
  json.key("reason").value(answer.impossible ? *answer.impossible : answer.bounds.front().reason);
  json.key("best_known");
  answer.best ? json.value(answer.best->b) : json.null();
  json.key("construction");
  answer.best ? json.value(answer.best->recipe.construction) : json.null();
  json.key("status").value(answer.status());
  json.key("bounds").begin_array();
  for (const Bound& bound : answer.bounds) {
    json.begin_object().key("lower_bound").value(bound.blocks).key("name").value(bound.name);
    json.key("reason").value(bound.reason).end_object();
  }
  json.end_array().end_object();
  return json.take() + "\n";
}

Answer run(const BoundsRequest& request) {
  std::vector<Known> answers;
  for (const Parameters& p : request.asked.of_each_kind()) {
    answers.push_back(known(p));
  }
  std::string all;
  for (const Known& each : answers) {
    all += text(each);
  }
  return text_answer(request.output.json() ? json(chosen(answers)) : all, request.output);
}

}  // namespace

void add_bounds(Program& program) {
  auto [verb, request] =
      program.add("bounds", "lower bounds with their reasons, and the best design known", run);
  request.asked.add_to(verb);
  request.asked.add_strength_to(verb);
  request.output.add_to(verb, {"text", "json"});
  verb.examples({"changeover bounds 20 5", "changeover bounds 8 5 --circular --json",
                 "changeover bounds 10 7 --change 1 --strength 3   every three elements meet",
                 "JSON is about one kind: if none is named, the one with the fewest blocks known"});
}

}  // namespace changeover::cli
