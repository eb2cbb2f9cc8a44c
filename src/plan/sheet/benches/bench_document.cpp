// The sheets of several benches as documents.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "core/each.hpp"
#include "core/words.hpp"
#include "plan/sheet/benches/bench_words.hpp"
#include "plan/sheet/places.hpp"
#include "plan/sheet/sheet_document.hpp"
#include "plan/sheet/step_table.hpp"

namespace changeover {
namespace {

Table compared_benches(const BenchDocument& document, const Money& money) {
  const Job& job = *document.job;
  const bool all = !document.plan->complete;
  std::vector<std::vector<std::string>> rows;
  rows.reserve(document.plan->candidates.size());
  for (const BenchCandidate& c : document.plan->candidates) {
    rows.push_back({c.name, std::to_string(c.tests), std::to_string(c.changes), money(c.makespan),
                    money(c.cost),
                    std::to_string(job.triples.empty() ? c.pairs_tested : c.triples_tested),
                    c.how});
  }
  Table table = table_of({{"plan", {}},
                          {"tests", number_column},
                          {"changes", number_column},
                          {"largest", cost_column},
                          {"together", cost_column},
                          {what_meets(job), number_column},
                          {"how", {.kind = ColumnKind::remark}}},
                         std::move(rows));
  if (all) {  // every plan tests everything
    table.columns.erase(table.columns.end() - 2);
  }
  return table;
}

// The totals of each bench.
Table bench_table(const BenchDocument& document, const Money& money) {
  const BenchPlan& plan = *document.plan;
  std::vector<std::vector<std::string>> rows;
  for (std::size_t b = 0; b < plan.sheets.size(); ++b) {
    const RunSheet& sheet = plan.sheets[b];
    rows.push_back({name_of(plan.benches, b), std::to_string(sheet.steps.size()),
                    std::to_string(sheet.changes), money(sheet.cost),
                    plan.times[b].empty() ? "" : money(plan.times[b].back().end)});
  }
  return table_of({{"bench", {}},
                   {"tests", number_column},
                   {"changes", number_column},
                   {"cost", cost_column},
                   {"end", cost_column}},
                  std::move(rows));
}

// The job as shown on the sheet of a bench.
Job shown_job(const Job& job, const Bench& bench) {
  Job own = job;
  own.mounted = bench.mounted.value_or(job.mounted);
  own.start = bench.start.value_or(job.start);
  own.places = bench.places;
  own.tests_done = bench.tests_done;
  return own;
}

// The name of a sheet of a workbook: at most 31 characters, without some signs, and unique.
std::string sheet_name(const std::string& name, std::set<std::string>& taken) {
  constexpr std::size_t longest = 31;
  std::string clean;
  for (const char c : name) {
    const bool plain =
        (c >= ' ' && c <= '~') && std::string_view("[]:*?/\\'").find(c) == std::string_view::npos;
    clean += plain ? c : '_';
  }
  clean.resize(std::min(clean.size(), longest));
  for (std::size_t number = 2; !taken.insert(lower_case(clean)).second; ++number) {
    const std::string end = fmt::format(" {}", number);
    clean.resize(std::min(clean.size(), longest - end.size()));
    clean += end;
  }
  return clean;
}

}  // namespace

std::vector<Job> jobs_on_sheets(const BenchDocument& document) {
  const BenchPlan& plan = *document.plan;
  std::vector<Job> jobs;
  jobs.reserve(plan.benches.size());
  for (const Bench& bench : plan.benches) {
    jobs.push_back(shown_job(*document.job, bench));
  }
  std::vector<const Job*> all;
  std::vector<const RunSheet*> sheets;
  for (std::size_t b = 0; b < jobs.size(); ++b) {
    all.push_back(&jobs[b]);
    sheets.push_back(&plan.sheets[b]);
  }
  const std::vector<MountedPlace> places = placed(all, sheets).places;
  for (Job& job : jobs) {
    const std::vector<MountedPlace> known = std::exchange(job.places, places);
    for (const MountedPlace& one : known) {
      std::ranges::find(job.places, one.number, &MountedPlace::number)->part = one.part;
    }
  }
  return jobs;
}

Table bench_step_table(const BenchDocument& document) {
  const auto jobs = std::make_shared<const std::vector<Job>>(jobs_on_sheets(document));
  StepTableOptions options;
  std::vector<const RunSheet*> sheets;
  for (std::size_t b = 0; b < jobs->size(); ++b) {
    options.benches.push_back(name_of(document.plan->benches, b));
    options.jobs.push_back(&(*jobs)[b]);
    sheets.push_back(&document.plan->sheets[b]);
  }
  return kept_with(step_table(*document.job, sheets, money_of(document), options), jobs);
}

TableDocument table_document(const BenchDocument& document) {
  const BenchPlan& plan = *document.plan;
  const Money money = money_of(document);
  const BenchCalendar calendar = calendar_of(document);
  const bool timed = calendar.has_days() || some_bench_waits(plan);
  // Data that the tables refer to live as long as the tables.
  const auto jobs = std::make_shared<const std::vector<Job>>(jobs_on_sheets(document));
  TableDocument made{.title = document.title, .style = style_of(*document.job), .overview = "Plan"};
  set_lines(made, bench_summary(document));
  if (!document.job->mounted.empty()) {
    made.lists.push_back("mounted all the time: " +
                         joined(names_of(*document.job, document.job->mounted)));
  }
  made.sections.push_back(
      {.heading = "Compared", .table = compared_benches(document, money), .in = in_html});
  std::vector<const RunSheet*> all;
  StepTableOptions whole;
  std::set<std::string> taken{
      "plan",      "parts",  "slots", "never", "done", "benches", "changeover-question",
      "run sheet", "history"};  // Excel has a use for the last
  for (std::size_t b = 0; b < plan.sheets.size(); ++b) {
    const RunSheet& sheet = plan.sheets[b];
    const std::string name = name_of(plan.benches, b);
    const Job& job = (*jobs)[b];
    StepTableOptions options{.benches = {name}};
    if (timed) {
      options.times = {&plan.times[b]};
      options.calendar = calendar.has_days() ? &calendar : nullptr;
    }
    all.push_back(&sheet);
    whole.benches.push_back(plan.benches[b].name.empty() ? std::to_string(b + 1) : name);
    whole.jobs.push_back(&job);
    whole.times.push_back(&plan.times[b]);
    std::vector<std::string> lines = mounted_on_page(job);
    if (!job.start.empty() && !sheet.steps.empty()) {
      lines.push_back("Mounted before the first step: " + joined(names_of(job, job.start), " · "));
    }
    made.sections.push_back(
        {.heading = fmt::format("{}: {}, {}, cost {}", name, count_of(sheet.steps.size(), "test"),
                                count_of(sheet.changes, "change"), money(sheet.cost)),
         .page_lines = std::move(lines),
         .table = kept_with(step_table(job, {&sheet}, money, options), jobs),
         .in = everywhere & ~in_csv,
         .css = "bench",
         .sheet = sheet_name(name, taken),
         .sheet_head = fmt::format("{}: {}", document.title, name)});
  }
  whole.calendar = calendar.has_days() ? &calendar : nullptr;
  if (!timed) {
    whole.times.clear();
  }
  made.sections.push_back({.table = step_table(*document.job, all, money, whole), .in = in_csv});
  made.sections.push_back({.table = bench_table(document, money), .in = in_workbook});
  made.sections.push_back({.heading = "Compared",
                           .table = compared_benches(document, money),
                           .in = everywhere & ~in_csv & ~in_html});
  add_what_goes_on(made, *document.job, money, document.done, document.question, document.list);
  return made;
}

}  // namespace changeover
