// Checks ranges and combinations of keys.
#include <fmt/format.h>

#include <utility>
#include <vector>

#include "changeover/plan/job_request.hpp"
#include "io/request/search_options.hpp"
#include "plan/request/question.hpp"
#include "plan/sheet/benches/bench_calendar.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t strength_of_triples = 3;

// Costs that the objective and a model require.
void check_objective(const JobRequest& request, const Question& question) {
  const bool of_model = request.model.is_given();
  if (of_model ? request.objective == "makespan" : request.objective == "tests") {
    question.refuse("objective",
                    fmt::format("{} {} is for {}; choose another", question.key("objective"),
                                request.objective, of_model ? "several benches" : "a model"));
  }
  if (!of_model || request.objective == "tests") {
    return;
  }
  if (request.test_cost.empty()) {
    question.refuse(
        "test_cost",
        fmt::format("give {}, what it costs to run one test; or {} tests, which asks for no costs",
                    question.with_value("test_cost"), question.key("objective")));
  }
  if (request.change_cost.empty() && !request.change_costs.is_given()) {
    question.refuse(
        "change_cost",
        fmt::format(
            "give {}, what it costs to set a value, or {} for each; or {} tests, which asks "
            "for no costs",
            question.with_value("change_cost"), question.with_value("change_costs"),
            question.key("objective")));
  }
}

}  // namespace

void check_options(const JobRequest& request, Door door) {
  const Question question(request, door);
  const auto refuse = [&](std::string_view key, const std::string& line) {
    question.refuse(key, line);
  };
  const auto key = [&](std::string_view name) { return question.key(name); };
  if (!request.model.is_given() && request.parts.is_given() == request.items.has_value()) {
    refuse("items",
           question.door_of("items") == Door::command_line ? "give either a parts list or --items N"
           : request.items                                 ? "give either parts or items, not both"
                           : "parts is missing: write a number of parts, or an array of them");
  }
  check_rules(job_table(), request, question);
  check_threads(request, question);
  if (const auto number = request.benches.number;
      number && (*number < 1 || *number > max_benches)) {
    refuse("benches",
           fmt::format("{} {}: give a number from 1 to {}", key("benches"), *number, max_benches));
  }
  if (request.benches.is_given() && request.weights.is_given() && request.budget.empty()) {
    refuse("weights", fmt::format("{} with {} says which pairs a budget pays for; give {} too",
                                  key("weights"), key("benches"), question.with_value("budget")));
  }
  const bool of_triples = request.strength == strength_of_triples;
  if (request.strength.value_or(2) != 2 && !of_triples) {
    refuse("strength", fmt::format("{} {}: give 2, for pairs, or 3, for triples", key("strength"),
                                   *request.strength));
  }
  const std::vector<std::pair<std::string_view, bool>> of_pairs{
      {"pairs", request.pairs.is_given()},
      {"weights", request.weights.is_given()},
      {"shuffle", request.shuffle.has_value()},
      {"what_if", request.what_if},
      {"diagnose", request.diagnose}};
  for (const auto& [name, given] : of_pairs) {
    if (of_triples && given) {
      refuse(name, fmt::format("{} applies to pairs and has no meaning with {} 3", key(name),
                               key("strength")));
    }
  }
  if (const auto defect = text_defect(request.title)) {
    refuse("title", fmt::format("{}: {}", key("title"), *defect));
  }
  check_objective(request, question);
  if (request.model.is_given()) {
    static_cast<void>(question.amount("test_cost", request.test_cost));
    static_cast<void>(question.amount("change_cost", request.change_cost));
    static_cast<void>(question.amount("budget", request.budget));
    return;
  }
  const std::uint64_t least = of_triples ? strength_of_triples : 2;
  const bool benches_may_say = request.benches.is_given() && !request.benches.number;
  if (request.at_once.value_or(least) < least && !benches_may_say) {
    refuse("at_once", fmt::format("{} {}: no {} can meet; give at least {}", key("at_once"),
                                  *request.at_once, of_triples ? "triple" : "pair", least));
  }
  if (request.test_cost.empty()) {
    refuse("test_cost",
           fmt::format("give {}, what it costs to run one test", question.with_value("test_cost")));
  }
  static_cast<void>(question.amount("test_cost", request.test_cost));
  static_cast<void>(question.amount("change_cost", request.change_cost));
  static_cast<void>(question.amount("budget", request.budget));
  static_cast<void>(question.amount("hours", request.hours));
  if (!request.first_day.empty()) {
    question.value_of("first_day", [&] { return parse_day(request.first_day); });
  }
  if (!request.items) {
    return;
  }
  if (request.slots.is_given() || !request.slot.empty()) {
    refuse(
        request.slots.is_given() ? "slots" : "slot",
        fmt::format("{} and {} need a parts list with a column slot; {} says only how many parts",
                    key("slots"), key("slot"), key("items")));
  }
  if (request.header || request.no_header) {
    refuse(request.header ? "header" : "no_header",
           fmt::format("{} and {} need a parts list; {} says only how many parts", key("header"),
                       key("no_header"), key("items")));
  }
  if (!request.cost_column.empty()) {
    refuse("cost_column", fmt::format("{} needs a parts list; {} says only how many parts",
                                      key("cost_column"), key("items")));
  }
  if (request.change_cost.empty() && !request.change_costs.is_given()) {
    refuse("change_cost", fmt::format("give {}, what it costs to mount a part",
                                      question.with_value("change_cost")));
  }
}

}  // namespace changeover
