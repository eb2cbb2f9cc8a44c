// The sheets of several benches as documents.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "core/contains.hpp"
#include "core/each.hpp"
#include "core/printable.hpp"
#include "core/small_letters.hpp"
#include "core/words.hpp"
#include "plan/sheet/benches/bench_words.hpp"
#include "plan/sheet/benches/handovers.hpp"
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
                    money(c.cost), std::to_string(tested_by(job, c)), c.how});
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

// The beginning of a text that has so many units of UTF-16.
std::string first_units(std::string_view text, std::size_t most) {
  constexpr char32_t last_of_one_unit = 0xffff;
  std::size_t bytes = 0;
  for (std::size_t units = 0; bytes < text.size();) {
    const CodePoint point = first_code_point(text.substr(bytes));
    units += point.value > last_of_one_unit ? 2U : 1U;
    if (units > most) {
      break;
    }
    bytes += point.bytes;
  }
  return std::string(text.substr(0, bytes));
}

// Whether a sheet may have it in its name, at the ends or within.
bool may_be_in_name(const CodePoint& point, bool is_at_end) {
  constexpr std::u32string_view signs = U"[]:*?/\\";
  const bool is_character = (point.value & 0xfffeU) != 0xfffeU;
  return is_printable(point) && is_character && signs.find(point.value) == signs.npos &&
         !(is_at_end && point.value == U'\'');
}

// The name of a sheet of a workbook: at most 31 units of UTF-16, without some signs, and unique.
std::string sheet_name(std::string_view name, std::set<std::u32string>& taken) {
  constexpr std::size_t longest = 31;
  const auto clean = [](std::string_view text) {
    std::string cleaned;
    for (std::size_t at = 0; at < text.size();) {
      const CodePoint point = first_code_point(text.substr(at));
      const bool is_at_end = at == 0 || at + point.bytes == text.size();
      cleaned += may_be_in_name(point, is_at_end) ? text.substr(at, point.bytes) : "_";
      at += point.bytes;
    }
    return cleaned;
  };
  std::string made = clean(first_units(name, longest));
  for (std::size_t number = 2; !taken.insert(in_small_letters(made)).second; ++number) {
    const std::string end = fmt::format(" {}", number);
    made = first_units(made, longest - end.size()) + end;
  }
  return made;
}

// What stays mounted on every bench that works.
Block mounted_everywhere(const BenchDocument& document) {
  Block mounted = document.job->mounted;
  for (const Bench& bench : document.plan->benches) {
    if (!bench.down && bench.mounted) {
      std::erase_if(mounted, [&](Element x) { return !contains(*bench.mounted, x); });
    }
  }
  return mounted;
}

}  // namespace

std::vector<std::string> bench_sheet_names(const std::vector<Bench>& benches) {
  std::set<std::u32string> taken{U"plan",      U"parts",  U"slots",   U"costs",
                                 U"never",     U"done",   U"benches", U"changeover-question",
                                 U"run sheet", U"history"};  // Excel has a use for the last
  std::vector<std::string> names;
  for (std::size_t b = 0; b < benches.size(); ++b) {
    names.push_back(sheet_name(name_of(benches, b), taken));
  }
  return names;
}

BenchSheets::BenchSheets(const BenchDocument& document)
    : jobs(document.plan->benches.size(), *document.job) {
  const BenchPlan& plan = *document.plan;
  for (std::size_t b = 0; b < jobs.size(); ++b) {
    const Bench& bench = plan.benches[b];
    jobs[b].mounted = bench.mounted.value_or(document.job->mounted);
    jobs[b].start = bench.start.value_or(document.job->start);
    jobs[b].places = bench.places;
    jobs[b].tests_done = bench.tests_done;
    jobs[b].last_step = bench.last_step;
    shown.push_back({&jobs[b], &plan.sheets[b], name_of(plan.benches, b)});
  }
  const std::vector<MountedPlace> places = placed(shown).places;
  for (Job& job : jobs) {
    const std::vector<MountedPlace> known = std::exchange(job.places, places);
    for (const MountedPlace& one : known) {
      std::ranges::find(job.places, one.number, &MountedPlace::number)->part = one.part;
    }
  }
}

Table bench_step_table(const BenchDocument& document) {
  const auto sheets = std::make_shared<const BenchSheets>(document);
  return kept_with(step_table(sheets->shown, money_of(document), {}), sheets);
}

TableDocument table_document(const BenchDocument& document) {
  const BenchPlan& plan = *document.plan;
  const Money money = money_of(document);
  const BenchCalendar calendar = calendar_of(document);
  const bool timed = calendar.has_days() || some_bench_waits(plan);
  const StepTableOptions options{.calendar = calendar.has_days() ? &calendar : nullptr};
  // Data that the tables refer to live as long as the tables.
  const auto sheets = std::make_shared<const BenchSheets>(document);
  const auto lines =
      std::make_shared<const HandoverLines>(handover_lines(*document.job, plan, money, calendar));
  const auto owner =
      std::make_shared<const std::pair<decltype(sheets), decltype(lines)>>(sheets, lines);
  const bool hands_over = std::ranges::any_of(*lines, [](const auto& bench) {
    return std::ranges::any_of(bench, [](const auto& step) { return !step.empty(); });
  });
  TableDocument made{.title = document.title, .style = style_of(*document.job), .overview = "Plan"};
  set_lines(made, bench_summary(document));
  add_mounted(made, *document.job, mounted_everywhere(document));
  made.sections.push_back(
      {.heading = "Compared", .table = compared_benches(document, money), .in = in_html});
  std::vector<ShownSheet> whole;
  const std::vector<std::string> tabs = bench_sheet_names(plan.benches);
  for (std::size_t b = 0; b < plan.sheets.size(); ++b) {
    const RunSheet& sheet = plan.sheets[b];
    ShownSheet shown = sheets->shown[b];
    shown.times = timed ? &plan.times[b] : nullptr;
    shown.hand_over = hands_over ? &(*lines)[b] : nullptr;
    made.sections.push_back(
        {.heading =
             fmt::format("{}: {}, {}, cost {}", shown.bench, count_of(sheet.steps.size(), "test"),
                         count_of(sheet.changes, "change"), money(sheet.cost)),
         .page_lines = mounted_on_page(*shown.job, !sheet.steps.empty()),
         .table = kept_with(step_table({shown}, money, options), owner),
         .in = everywhere & ~in_csv,
         .css = "bench",
         .sheet = tabs[b],
         .sheet_head = fmt::format("{}: {}", document.title, shown.bench)});
    if (plan.benches[b].name.empty()) {
      shown.bench = std::to_string(b + 1);
    }
    whole.push_back(std::move(shown));
  }
  made.sections.push_back(
      {.table = kept_with(step_table(whole, money, options), owner), .in = in_csv});
  made.sections.push_back({.table = bench_table(document, money), .in = in_workbook});
  made.sections.push_back({.heading = "Compared",
                           .table = compared_benches(document, money),
                           .in = everywhere & ~in_csv & ~in_html});
  add_what_goes_on(made, *document.job, money, document.done, document.question, document.list);
  return made;
}

}  // namespace changeover
