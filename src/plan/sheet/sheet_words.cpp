#include "plan/sheet/sheet_words.hpp"
#include "changeover/plan/model.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "plan/sheet/clock.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace changeover {
namespace {

// The average number of changes of the same tests in a random order, rounded: each ordered pair of
// tests is adjacent with the same probability.
std::uint64_t changes_in_random_order(const Job& job, const RunSheet& sheet) {
  const std::uint64_t tests = sheet.steps.size();
  std::vector<std::uint64_t> times(job.names.size(), 0);
  std::vector<bool> at_start(job.names.size(), false);
  for (const Element x : job.start) {
    at_start[x] = true;
  }
  std::uint64_t sum = 0;
  for (const RunStep& step : sheet.steps) {
    for (const Element x : step.setup) {
      ++times[x];
      sum += at_start[x] ? 0U : 1U;
    }
  }
  for (const std::uint64_t t : times) {
    sum += t * (tests - t);
  }
  return tests == 0 ? 0 : (sum + tests / 2) / tests;
}

// How much of the weight is met, or how soon.
std::string weight_line(const Job& job, const RunPlan& plan, const Money& money) {
  const RunSheet& sheet = plan.sheet;
  if (sheet.weight_needed.millionths == 0) {
    return "no needed pair weighs anything";
  }
  std::string met = weight_words(sheet.weight_tested, sheet.weight_needed, plan.most_weight);
  if (plan.most_weight) {
    return met;
  }
  const auto reached = [&](double share) {
    for (std::size_t i = 0; i < sheet.steps.size(); ++i) {
      const RunStep& step = sheet.steps[i];
      if (static_cast<double>(step.weight_so_far.millionths) >=
          share * static_cast<double>(sheet.weight_needed.millionths)) {
        return fmt::format("after step {} (cost {})", i + 1 + job.steps_before(),
                           money(step.cost_so_far));
      }
    }
    return std::string("never");
  };
  if (sheet.steps.empty()) {
    return met;
  }
  constexpr double half = 0.5;
  constexpr double most = 0.9;
  return fmt::format("{}; half of it {}, nine tenths {}", met, reached(half), reached(most));
}

}  // namespace

std::string fewest_tests_line(std::uint64_t tests, std::optional<std::uint64_t> of_all,
                              std::uint64_t bound, const std::string& all) {
  if (of_all) {
    return fmt::format("no plan for {} has fewer than {} (one with {} was found)", all,
                       count_of(bound, "test"), *of_all);
  }
  if (tests == bound) {
    return fmt::format("no plan for {} has fewer tests: this is the lower bound", all);
  }
  return fmt::format("no plan for {} has fewer than {} (this one has at most {} more)", all,
                     count_of(bound, "test"), tests - bound);
}

std::string failed_line(const Job& job) {
  const bool one = job.met_only_in_failed == 1;
  return fmt::format("{} met only in tests that failed or whose result is not understood: {} {}",
                     count_of(job.met_only_in_failed, is_of_triples(job) ? "triple" : "pair"),
                     one ? "it" : "they",
                     job.trust_failed ? (one ? "counts as tested" : "count as tested")
                                      : (one ? "is needed again" : "are needed again"));
}

std::string weight_words(Amount tested, Amount needed, std::optional<Amount> most) {
  return fmt::format(
      "weight of the pairs tested: {} of {}{}", to_string(tested), to_string(needed),
      !most || tested == needed ? ""
      : *most >= needed         ? "; no bound is known"
      : *most == tested
          ? "; no plan within the budget tests more"
          : fmt::format("; no plan within the budget tests more than {}", to_string(*most)));
}

std::string per_cent_above(Amount a, Amount b) {
  return fmt::format("{:.1f} %", 100.0 * static_cast<double>((a - b).millionths) /
                                     static_cast<double>(b.millionths));
}

Money::Money(const Job& job, std::optional<Amount> budget) {
  decimals_ = decimals_needed(job.test_cost);
  for (const Amount cost : job.change_costs) {
    decimals_ = std::max(decimals_, decimals_needed(cost));
  }
  for (const Amount cost : job.replace_costs) {
    decimals_ = std::max(decimals_, decimals_needed(cost));
  }
  decimals_ = std::max(decimals_, decimals_needed(budget.value_or(Amount{})));
}

std::vector<std::string> what_if_notes(const Job& job, const WhatIf& answer) {
  std::vector<std::string> lines;
  if (job.met_only_in_failed > 0) {
    lines.push_back(failed_line(job));
  }
  lines.insert(lines.end(), answer.notes.begin(), answer.notes.end());
  return lines;
}

std::uint64_t parts_listed(const Job& job) {
  std::uint64_t listed = 0;
  for (std::size_t i = 0; i < job.names.size(); ++i) {
    listed += job.piece_of.empty() || job.piece_of[i] == i ? 1U : 0U;
  }
  return listed;
}

std::string with_unit(const Money& money, Amount amount, std::string_view unit) {
  constexpr Amount one{1'000'000};
  if (amount == one && unit.ends_with('s')) {
    unit.remove_suffix(1);
  }
  return fmt::format("{} {}", money(amount), unit);
}

std::string cost_words(const Job& job, const Money& money, Amount cost) {
  const Clock clock(job);
  return clock.runs() ? fmt::format("cost {}, {} on the clock",
                                    with_unit(money, cost, word_of(job.cost_unit)), clock(cost))
                      : fmt::format("cost {}", money(cost));
}

std::vector<std::string> names_of(const Job& job, const Block& parts) {
  return each_of<std::string>(parts, [&](Element x) { return job.names[x]; });
}

std::vector<std::string> put_in_words(const Job& job, const RunStep& step) {
  std::vector<std::string> words;
  for (const Element in : step.put_in) {
    const auto found =
        std::ranges::find_if(step.replaced, [&](const auto& pair) { return pair.second == in; });
    words.push_back(found == step.replaced.end()
                        ? job.names[in]
                        : fmt::format("{} for {}", job.names[in], job.names[found->first]));
  }
  return words;
}

std::string what_meets(const Job& job) { return is_of_triples(job) ? "triples" : "pairs"; }

std::string budget_line(const Job& job, const Money& money, std::optional<Amount> budget,
                        Amount cost) {
  return fmt::format("budget {}: testing all {} would cost {}", money(budget.value_or(Amount{})),
                     what_meets(job), money(cost));
}

std::uint64_t new_here(const Job& job, const RunStep& step) {
  return is_of_triples(job) ? step.new_triples.size() : step.new_pairs.size();
}

std::string what_there_is(const Job& job) {
  return job.model == nullptr
             ? fmt::format("{}, {} at a time", count_of(parts_listed(job), "part"), job.at_once)
             : fmt::format("{} with {}", count_of(job.slots.size(), "parameter"),
                           count_of(job.parts(), "value"));
}

std::optional<std::string> rules_line(const Job& job) {
  if (job.model == nullptr || job.model->constraints.empty()) {
    return std::nullopt;
  }
  return fmt::format("all tests follow {}, checked as they are written",
                     count_of(job.model->constraints.size(), "rule"));
}

std::vector<std::string> summary(const SheetDocument& document) {
  const Job& job = *document.job;
  const RunPlan& plan = *document.plan;
  const RunSheet& sheet = plan.sheet;
  const Money money(job, document.budget);
  const std::string all = "all " + what_meets(job);
  std::vector<std::string> lines{
      fmt::format("{}: {}, {}, {}", what_there_is(job), count_of(sheet.steps.size(), "test"),
                  count_of(sheet.changes, "change"), cost_words(job, money, sheet.cost)),
      tested_line(job, sheet, "")};
  if (auto rules = rules_line(job)) {
    lines.push_back(*std::move(rules));
  }
  if (job.met_only_in_failed > 0) {
    lines.push_back(failed_line(job));
  }
  if (job.tests_done > 0) {
    lines.front() += fmt::format(", after {} done", count_of(job.tests_done, "test"));
  }
  if (!job.first.empty()) {
    const RunSheet first = run_sheet(job, job.first);
    lines.push_back(fmt::format(
        "the first {} given: cost {}, {} of the needed {}",
        job.first.size() == 1 ? "test is" : fmt::format("{} tests are", job.first.size()),
        money(first.cost), tested_by(job, first), what_meets(job)));
  }
  const std::uint64_t in_random_order = changes_in_random_order(job, sheet);
  if (in_random_order > sheet.changes) {
    lines.push_back(fmt::format("{}, {} fewer than these tests need in a random order",
                                count_of(sheet.changes, "change"),
                                in_random_order - sheet.changes));
  }
  if (plan.candidates.size() > 1) {
    const Candidate& best = plan.candidates[0];
    const Candidate& next = plan.candidates[1];
    const std::string by = difference(document, next);
    lines.push_back(fmt::format("best: the {}{}", best.name,
                                plan.complete ? ""
                                : by.empty()  ? fmt::format("; the {} costs as much", next.name)
                                              : fmt::format("; next the {}, {}", next.name, by)));
  }
  if (plan.complete) {
    lines.push_back(budget_line(job, money, document.budget, plan.complete->cost));
  }
  if (!job.weights.empty()) {
    lines.push_back(weight_line(job, plan, money));
  }
  if (plan.objective == PlanObjective::tests) {
    lines.push_back(fewest_tests_line(
        sheet.steps.size(), plan.complete ? std::optional(plan.complete->tests()) : std::nullopt,
        plan.bound.tests, all));
  }
  const Amount cheapest = plan.complete ? plan.complete->cost : sheet.cost;
  const CostBound& bound = plan.bound;
  if (cheapest == bound.cost) {
    lines.push_back(fmt::format("no plan for {} is cheaper{}", all,
                                plan.complete ? " than that" : ": this is the lower bound"));
  } else {
    lines.push_back(fmt::format("lower bound for {}: {}{}", all, money(bound.cost),
                                bound.cost.millionths == 0
                                    ? ""
                                    : fmt::format(" ({} at most {} above the least possible)",
                                                  plan.complete ? "that is" : "this plan is",
                                                  per_cent_above(cheapest, bound.cost))));
  }
  lines.push_back("because " + bound.reason);
  lines.insert(lines.end(), document.notes.begin(), document.notes.end());
  return lines;
}

std::string difference(const SheetDocument& document, const Candidate& candidate) {
  const Amount least = document.plan->candidates.front().cost;
  if (document.plan->complete || candidate.cost <= least) {
    return "";
  }
  const Money money(*document.job, document.budget);
  std::string text = "+" + money(candidate.cost - least);
  return least.millionths == 0 ? text : text + " (" + per_cent_above(candidate.cost, least) + ")";
}

}  // namespace changeover
