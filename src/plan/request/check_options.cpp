// Checks ranges and combinations of keys; no rule of the table is what depends on how large a
// number is, and on how a text is read.
#include <fmt/format.h>

#include "changeover/plan/job_request.hpp"
#include "io/request/search_options.hpp"
#include "plan/request/question.hpp"
#include "plan/sheet/benches/bench_calendar.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t strength_of_triples = 3;

}  // namespace

void check_options(const JobRequest& request, Door door) {
  const Question question(request, door);
  const auto refuse = [&](std::string_view key, const std::string& line) {
    question.refuse(key, line);
  };
  const auto key = [&](std::string_view name) { return question.key(name); };
  check_rules(job_table(), request, question);
  check_threads(request, question);
  if (const auto number = request.benches.number;
      number && (*number < 1 || *number > max_benches)) {
    refuse("benches",
           fmt::format("{} {}: give a number from 1 to {}", key("benches"), *number, max_benches));
  }
  const bool of_triples = request.strength == strength_of_triples;
  if (request.strength.value_or(2) != 2 && !of_triples) {
    refuse("strength", fmt::format("{} {}: give 2, for pairs, or 3, for triples", key("strength"),
                                   *request.strength));
  }
  if (const auto defect = text_defect(request.title)) {
    refuse("title", fmt::format("{}: {}", key("title"), *defect));
  }
  const std::uint64_t least = of_triples ? strength_of_triples : 2;
  const bool benches_may_say = request.benches.is_given() && !request.benches.number;
  if (!request.model.is_given() && request.at_once.value_or(least) < least && !benches_may_say) {
    refuse("at_once", fmt::format("{} {}: no {} can meet; give at least {}", key("at_once"),
                                  *request.at_once, of_triples ? "triple" : "pair", least));
  }
  static_cast<void>(question.amount("test_cost", request.test_cost));
  static_cast<void>(question.amount("change_cost", request.change_cost));
  static_cast<void>(question.amount("budget", request.budget));
  static_cast<void>(question.amount("hours", request.hours));
  if (!request.first_day.empty()) {
    question.value_of("first_day", [&] { return parse_day(request.first_day); });
  }
}

}  // namespace changeover
