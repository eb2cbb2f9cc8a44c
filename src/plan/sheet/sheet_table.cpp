// Run sheets for terminals.
#include <fmt/format.h>

#include "changeover/plan/job.hpp"
#include "plan/sheet/layout.hpp"
#include "plan/sheet/sheet_words.hpp"

namespace changeover {
namespace {

Cell one(const std::string& word) { return {word}; }

}  // namespace

std::string sheet_as_table(const SheetDocument& document, std::size_t width) {
  const Job& job = *document.job;
  const RunPlan& plan = *document.plan;
  const Money money(job, document.budget);
  std::string text = document.title + "\n";
  for (const std::string& line : summary(document)) {
    text += line + "\n";
  }
  text += mounted_line(job);
  std::vector<std::vector<Cell>> rows;
  rows.reserve(plan.sheet.steps.size());
  std::uint64_t number = job.tests_done;
  for (const RunStep& step : plan.sheet.steps) {
    rows.push_back({one(fmt::format("{}", ++number)), names_of(job, step.take_out),
                    put_in_words(job, step),
                    names_of(job, document.compact ? Block{} : without_mounted(job, step.setup)),
                    one(fmt::format("{}", new_here(job, step)))});
    if (job.replaces()) {
      rows.back().push_back(one(money(step.cost)));
    }
    rows.back().push_back(one(money(step.cost_so_far)));
    if (!job.weights.empty()) {
      rows.back().push_back(one(to_string(step.weight_so_far)));
    }
  }
  if (!rows.empty()) {
    std::vector<Column> columns{
        {"step", true}, {"take out"}, {"put in"}, {"set-up"}, {"new " + what_meets(job), true}};
    if (job.replaces()) {
      columns.push_back({"cost", true});
    }
    columns.push_back({"cost so far", true});
    if (!job.weights.empty()) {
      columns.push_back({"weight so far", true});
    }
    if (document.compact) {
      constexpr std::ptrdiff_t setup = 3;
      columns.erase(columns.begin() + setup);
      for (std::vector<Cell>& row : rows) {
        row.erase(row.begin() + setup);
      }
    }
    text += "\n" + laid_out(columns, rows, width);
  }
  rows.clear();
  for (const Candidate& candidate : plan.candidates) {
    rows.push_back({one(candidate.name), one(fmt::format("{}", candidate.tests())),
                    one(fmt::format("{}", candidate.changes)), one(money(candidate.cost)),
                    one(fmt::format("{}", tested_by(job, candidate))),
                    one(difference(document, candidate)), one(candidate.how)});
  }
  text += "\nCompared\n" + laid_out({{"plan"},
                                     {"tests", true},
                                     {"changes", true},
                                     {"cost", true},
                                     {what_meets(job), true},
                                     {"dearer by", true},
                                     {"how"}},
                                    rows, width);
  return text;
}

std::string what_if_as_table(const Job& job, const WhatIf& answer) {
  std::string text =
      answer.by_factor
          ? "If all change costs are multiplied by a factor, the cheapest plan that is known has\n"
          : "At a ratio of change cost to test cost, the cheapest plan that is known has\n";
  std::vector<std::vector<Cell>> rows;
  rows.reserve(answer.ranges.size());
  for (const WhatIf::Range& range : answer.ranges) {
    rows.push_back({one(range.from ? range.from->to_string() : "0"),
                    one(range.to ? range.to->to_string() : "any"),
                    one(fmt::format("{}", range.plan.tests())),
                    one(fmt::format("{}", range.plan.changes)), one(range.plan.name)});
  }
  text += laid_out({{"from", true}, {"to", true}, {"tests", true}, {"changes", true}, {"plan"}},
                   rows, 200);
  if (answer.asked) {
    text += fmt::format(
        "{} {}.\n",
        answer.by_factor ? "Your costs are at the factor" : "Your costs are at the ratio",
        answer.asked->to_string());
  }
  text += job.needed.size() == 0 ? "Nothing is left to test.\n" : "";
  for (const std::string& line : what_if_notes(job, answer)) {
    text += line + "\n";
  }
  return text;
}

}  // namespace changeover
