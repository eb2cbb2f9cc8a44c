// changeover bounds V K: each lower bound with its reason, the best design known, the gap.
#include <fmt/format.h>

#include "io/write/json_writer.hpp"
#include "request/request.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct BoundsRequest {
  ParameterRequest asked;
  OutputRequest output;
};

struct Answer {
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

Answer answer(const Parameters& p) {
  Answer answer{.parameters = p, .impossible = impossibility(p), .bounds = {}, .best = {}};
  if (!answer.impossible) {
    answer.bounds = lower_bounds(p);
    answer.best = best_known(p);
  }
  return answer;
}

std::string text(const Answer& answer) {
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
const Answer& chosen(const std::vector<Answer>& answers) {
  const Answer* best = &answers.front();
  for (const Answer& answer : answers) {
    if (answer.best && (!best->best || answer.best->b < best->best->b)) {
      best = &answer;
    }
  }
  return *best;
}

std::string json(const Answer& answer) {
  const Parameters& p = answer.parameters;
  JsonWriter json;
  json.begin_object().key("v").value(p.v).key("k").value(p.k).key("change").value(p.change);
  json.key("kind").value(to_string(p.kind));
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

int run(const BoundsRequest& request) {
  std::vector<Answer> answers;
  for (const Parameters& p : request.asked.parameters()) {
    answers.push_back(answer(p));
  }
  std::string all;
  if (request.output.chosen() == "json") {
    all = json(chosen(answers));
  } else {
    for (const Answer& each : answers) {
      all += text(each);
    }
  }
  deliver(all, request.output);
  return exit_code::done;
}

}  // namespace

void add_bounds(Program& program) {
  auto request = std::make_shared<BoundsRequest>();
  Verb& verb = program.add("bounds", "lower bounds with their reasons, and the best design known");
  request->asked.add_to(verb);
  request->output.add_to(verb, {"text", "json"});
  verb.examples({"changeover bounds 20 5", "changeover bounds 8 5 --circular --json",
                 "JSON is about one kind: if none is named, the one with the fewest blocks known"});
  verb.run([request] { return run(*request); });
}

}  // namespace changeover::cli
