#include "plan/sheet/benches/bench_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/each.hpp"
#include "core/words.hpp"

namespace changeover {
namespace {

// "day 3 (Wed 2025-03-05) after 4.50 hours".
std::string day_words(const BenchCalendar& calendar, const Money& money, Amount end) {
  const std::uint64_t day = calendar.last_day(end);
  const std::string date = calendar.date(day);
  return fmt::format("day {}{} after {}", day, date.empty() ? "" : " (" + date + ")",
                     with_unit(money, calendar.last_hour(end), calendar.unit() + "s"));
}

// "H100 (1), Epyc 9124 (2)".
std::string scarce_parts(const BenchDocument& document) {
  const Job& job = *document.job;
  const std::vector<Bench>& benches = document.plan->benches;
  std::vector<std::string> scarce;
  for (Element x = 0; x < job.quantities.size(); ++x) {
    const auto sharing =
        static_cast<std::uint64_t>(std::ranges::count_if(benches, [&](const Bench& b) {
          const auto has = [&](const Block& parts) {
            return std::ranges::find(parts, x) != parts.end();
          };
          return !b.down && !has(b.own) && !has(b.without);
        }));
    if (job.quantities[x] < sharing) {
      scarce.push_back(fmt::format("{} ({})", job.names[x], job.quantities[x]));
    }
  }
  constexpr std::size_t few = 12;
  const std::size_t more = scarce.size() - std::min(scarce.size(), few);
  scarce.resize(scarce.size() - more);
  return joined(scarce) + (more > 0 ? fmt::format(" and {} more", more) : "");
}

std::string headline(const BenchDocument& document) {
  const Job& job = *document.job;
  const BenchPlan& plan = *document.plan;
  const auto down =
      std::ranges::count_if(plan.benches, [](const Bench& bench) { return bench.down; });
  const std::uint64_t done = tests_done_of(document);
  return fmt::format("{}, on {}{}: {}, {}{}", what_there_is(job),
                     count_of(plan.sheets.size(), "bench", "benches"),
                     down == 0   ? ""
                     : down == 1 ? ", one of them down"
                                 : fmt::format(", {} of them down", down),
                     count_of(plan.tests, "test"), count_of(plan.changes, "change"),
                     done == 0 ? "" : fmt::format(", after {} done", count_of(done, "test")));
}

// The end of the plan and its cost.
std::string end_line(const BenchDocument& document, const BenchCalendar& calendar,
                     const Money& money) {
  const BenchPlan& plan = *document.plan;
  if (plan.tests == 0) {
    return plan.complete && plan.complete->tests > 0 ? "no test was found within the budget"
                                                     : "nothing is left to do";
  }
  if (calendar.has_days()) {
    return fmt::format("done on {}; {} of work together", day_words(calendar, money, plan.makespan),
                       with_unit(money, plan.cost, calendar.unit() + "s"));
  }
  return some_bench_waits(plan)
             ? fmt::format(
                   "the last test ends at {}, since benches wait for scarce parts; {} together",
                   money(plan.makespan), money(plan.cost))
             : fmt::format("{} on the bench that costs most, {} together", money(plan.makespan),
                           money(plan.cost));
}

// What bounds are of, if the plan is of less: the budget does not suffice for all.
std::string for_all_of(const BenchDocument& document) {
  return document.plan->complete ? " for all " + what_meets(*document.job) : "";
}

std::string makespan_line(const BenchDocument& document, const BenchCalendar& calendar,
                          const Money& money) {
  const BenchPlan& plan = *document.plan;
  const Amount found = plan.complete ? plan.complete->makespan : plan.makespan;
  const Amount bound = plan.makespan_bound;
  const std::string all = "all " + what_meets(*document.job);
  const std::string for_all = for_all_of(document);
  // Within a budget, the bounds are of a plan that tests all.
  const std::string_view this_plan =
      plan.complete ? "such a plan was found that is" : "this plan is";
  if (calendar.has_days()) {
    return fmt::format(
        "no plan for {} is done before {}{}{}", all, day_words(calendar, money, bound),
        found == bound          ? ": "
        : bound.millionths == 0 ? ", since "
                                : fmt::format(" ({} at most {} above the least "
                                              "possible), since ",
                                              this_plan, per_cent_above(found, bound)),
        plan.makespan_reason);
  }
  if (found == bound) {
    return fmt::format("no plan{} is done for less than {} on each bench: {}", for_all,
                       money(bound), plan.makespan_reason);
  }
  return fmt::format(
      "lower bound{} for the bench that costs most: {}{}, since {}", for_all, money(bound),
      bound.millionths == 0 ? ""
                            : fmt::format(" ({} at most {} above the least possible)", this_plan,
                                          per_cent_above(found, bound)),
      plan.makespan_reason);
}

const char* best_for(BenchObjective objective) {
  switch (objective) {
    case BenchObjective::cost:
      return "the least cost together";
    case BenchObjective::tests:
      return "the fewest tests together";
    case BenchObjective::makespan:
      break;
  }
  return "the least largest cost";
}

bool all_alike(const BenchDocument& document) {
  const std::vector<Bench>& benches = document.plan->benches;
  for (std::size_t b = 0; b < benches.size(); ++b) {
    if (!bench_facts(document, b).empty()) {
      return false;
    }
  }
  return document.job->start.empty() && document.job->first.empty() &&
         scarce_parts(document).empty();
}

}  // namespace

std::uint64_t tests_done_of(const BenchDocument& document) {
  std::uint64_t done = document.job->tests_done;
  for (const Bench& bench : document.plan->benches) {
    done += bench.tests_done;
  }
  return done;
}

BenchCalendar calendar_of(const BenchDocument& document) {
  return {*document.job, document.plan->benches,
          document.first_day.empty() ? std::nullopt : std::optional(parse_day(document.first_day)),
          document.weekends};
}

Money money_of(const BenchDocument& document) {
  Money money(*document.job, document.budget);
  for (const Bench& bench : document.plan->benches) {
    money.widen(bench.test_cost.value_or(Amount{}));
  }
  for (const RunSheet& sheet : document.plan->sheets) {
    for (const RunStep& step : sheet.steps) {
      money.widen(step.cost);
    }
  }
  for (const std::vector<StepTime>& times : document.plan->times) {
    for (const StepTime& time : times) {
      money.widen(time.begin);
    }
  }
  money.widen(document.plan->makespan_bound);
  return money;
}

bool some_bench_waits(const BenchPlan& plan) {
  return std::ranges::any_of(plan.times, [](const std::vector<StepTime>& times) {
    Amount free;
    for (const StepTime& time : times) {
      if (time.begin > free) {
        return true;
      }
      free = time.end;
    }
    return false;
  });
}

std::vector<std::string> bench_facts(const BenchDocument& document, std::size_t bench) {
  const Job& job = *document.job;
  const Bench& b = document.plan->benches[bench];
  const Money money = money_of(document);
  std::vector<std::string> facts;
  if (b.down) {
    return {"out of order"};
  }
  if (b.at_once) {
    facts.push_back(fmt::format("{} at a time", *b.at_once));
  }
  if (b.test_cost) {
    facts.push_back("a test costs " + money(*b.test_cost));
  }
  if (b.change_factor != Amount{1'000'000}) {
    facts.push_back(fmt::format("changes cost {} times as much", to_string(b.change_factor)));
  }
  for (const Slot& slot : b.slots) {
    facts.push_back(slot.most == Slot{}.most
                        ? fmt::format("at least {} of slot {}", slot.least, slot.name)
                        : fmt::format("{} to {} of slot {}", slot.least, slot.most, slot.name));
  }
  const auto list = [&](const std::string& what, const Block& parts) {
    if (!parts.empty()) {
      facts.push_back(fmt::format("{}: {}", what, joined(names_of(job, parts))));
    }
  };
  const bool of_model = job.model != nullptr;
  // What the job says is said once for all benches, unless one of them says something else.
  const bool some_say = std::ranges::any_of(
      document.plan->benches, [](const Bench& each) { return !each.down && each.mounted; });
  list(of_model ? "always set" : "stays mounted",
       b.mounted.value_or(some_say ? job.mounted : Block()));
  list(of_model ? "set at the start" : "mounted at the start", b.start.value_or(Block()));
  list("has its own", b.own);
  list("cannot have", b.without);
  if (b.first && !b.first->empty()) {
    facts.push_back(b.first->size() == 1
                        ? "its first test is given"
                        : fmt::format("its first {} tests are given", b.first->size()));
  }
  if (b.hours) {
    const bool one = b.hours->millionths == 1'000'000;
    facts.push_back(fmt::format("{} {} a day", to_string(*b.hours), one ? "hour" : "hours"));
  }
  if (b.tests_done > 0) {
    facts.push_back(fmt::format("{} done before", count_of(b.tests_done, "test")));
  }
  return facts;
}

std::vector<std::string> bench_summary(const BenchDocument& document) {
  const Job& job = *document.job;
  const BenchPlan& plan = *document.plan;
  const Money money = money_of(document);
  const BenchCalendar calendar = calendar_of(document);
  std::vector<std::string> lines{headline(document), end_line(document, calendar, money),
                                 tested_line(job, plan, " on some bench")};
  if (auto rules = rules_line(job)) {
    lines.push_back(*std::move(rules));
  }
  if (job.met_only_in_failed > 0) {
    lines.push_back(failed_line(job));
  }
  if (!plan.complete) {
    lines.push_back(
        fmt::format("best for {}: {}", best_for(document.objective), plan.candidates.front().name));
  } else {
    lines.push_back(fmt::format("best within the budget: {}", plan.candidates.front().name));
    lines.push_back(budget_line(job, money, document.budget, plan.complete->cost));
  }
  if (!job.weights.empty()) {
    lines.push_back(weight_words(plan.weight_tested, plan.weight_needed,
                                 plan.most_weight.value_or(plan.weight_needed)));
  }
  if (document.objective == BenchObjective::tests) {
    lines.push_back(fewest_tests_line(
        plan.tests, plan.complete ? std::optional(plan.complete->tests) : std::nullopt,
        plan.bound.tests, "all " + what_meets(job)));
  }
  if (plan.bound.cost.millionths > 0) {
    lines.push_back(makespan_line(document, calendar, money));
    lines.push_back(plan.makespan_reason == plan.bound.reason
                        ? fmt::format("lower bound{} for all benches together: {}",
                                      for_all_of(document), money(plan.bound.cost))
                        : fmt::format("lower bound{} for all benches together: {}, since {}",
                                      for_all_of(document), money(plan.bound.cost),
                                      plan.bound.reason));
  }
  if (all_alike(document)) {
    lines.push_back(fmt::format("every bench begins empty, and every bench can have every {}",
                                job.model == nullptr ? "part" : "value"));
  }
  if (const std::string scarce = scarce_parts(document); !scarce.empty()) {
    lines.push_back("scarce, on no more benches at a time: " + scarce);
  }
  for (std::size_t b = 0; b < plan.benches.size(); ++b) {
    if (const std::vector<std::string> facts = bench_facts(document, b); !facts.empty()) {
      lines.push_back(fmt::format("{}: {}", name_of(plan.benches, b), joined(facts, "; ")));
    }
  }
  lines.insert(lines.end(), document.notes.begin(), document.notes.end());
  return lines;
}

}  // namespace changeover
