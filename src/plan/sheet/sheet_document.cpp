#include "plan/sheet/sheet_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>

#include "changeover/core/error.hpp"
#include "changeover/plan/model.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "io/request/request_rows.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/sheet/clock.hpp"
#include "plan/sheet/page_style.hpp"
#include "plan/sheet/sheet_words.hpp"
#include "plan/sheet/step_table.hpp"

namespace changeover {

void add_mounted(TableDocument& document, const Job& job, const Block& mounted) {
  if (!mounted.empty()) {
    document.lists.push_back("mounted all the time: " + joined(names_of(job, mounted)));
  }
}

std::vector<std::string> mounted_on_page(const Job& job, bool has_steps) {
  std::vector<std::string> lines;
  if (!job.mounted.empty()) {
    lines.push_back("Stay mounted: " + joined(names_of(job, job.mounted), " · "));
  }
  if (!job.start.empty() && has_steps) {
    lines.push_back("Mounted before the first step: " + joined(names_of(job, job.start), " · "));
  }
  return lines;
}

void set_lines(TableDocument& document, std::vector<std::string> lines) {
  document.headline = std::move(lines.front());
  lines.erase(lines.begin());
  document.lines = std::move(lines);
}

namespace {

std::vector<Figure> figures_of(const SheetDocument& document) {
  const Job& job = *document.job;
  const RunPlan& plan = *document.plan;
  const RunSheet& sheet = plan.sheet;
  const Money money(job, document.budget);
  const bool triples = is_of_triples(job);
  const std::string what = triples ? "Triples" : "Pairs";
  const std::uint64_t needed = triples ? sheet.triples_needed : sheet.pairs_needed;
  const std::uint64_t tested = triples ? sheet.triples_tested : sheet.pairs_tested;
  std::vector<Figure> figures;
  const auto count = [&](std::string name, std::uint64_t n, unsigned in = in_html | in_workbook) {
    figures.push_back({.name = std::move(name), .words = std::to_string(n), .in = in});
  };
  const auto amount = [&](std::string name, Amount a, unsigned in = in_html | in_workbook) {
    figures.push_back(
        {.name = std::move(name), .words = money(a), .kind = ColumnKind::cost, .in = in});
  };
  if (job.model == nullptr) {
    figures.push_back({.name = "Parts, at a time",
                       .words = fmt::format("{}, {}", parts_listed(job), job.at_once),
                       .in = in_html});
    count("Parts", parts_listed(job), in_workbook);
    count("At a time", job.at_once, in_workbook);
  } else {
    count("Parameters", job.slots.size());
    count("Values", job.parts());
  }
  count("Tests", sheet.steps.size());
  if (job.tests_done > 0) {
    count("Tests done before", job.tests_done, in_workbook);
  }
  count("Changes", sheet.changes);
  count(what + " needed", needed, in_workbook);
  count(what + " tested", tested, in_workbook);
  figures.push_back(
      {.name = what + " tested", .words = fmt::format("{} of {}", tested, needed), .in = in_html});
  amount("Cost of one test", job.test_cost, in_workbook);
  amount("Cost of tests", sheet.cost - sheet.change_cost);
  amount("Cost of changes", sheet.change_cost);
  amount("Total cost", sheet.cost);
  if (const Clock clock(job); clock.runs()) {
    figures.push_back({.name = "Clock at the end", .words = clock(sheet.cost)});
  }
  amount("Lower bound for all " + what_meets(job), plan.bound.cost, in_workbook);
  if (document.budget) {
    amount("Budget", *document.budget);
  }
  return figures;
}

const ColumnStyle remark{.kind = ColumnKind::remark};

Table compared(const SheetDocument& document) {
  const Job& job = *document.job;
  const Money money(job, document.budget);
  std::vector<std::vector<std::string>> rows;
  rows.reserve(document.plan->candidates.size());
  for (const Candidate& c : document.plan->candidates) {
    rows.push_back({c.name, std::to_string(c.tests()), std::to_string(c.changes), money(c.cost),
                    std::to_string(tested_by(job, c)), difference(document, c), c.how});
  }
  return table_of({{"plan", {}},
                   {"tests", number_column},
                   {"changes", number_column},
                   {"cost", cost_column},
                   {what_meets(job), number_column},
                   {"extra cost", number_column},
                   {"how", remark}},
                  std::move(rows));
}

// The cost of setting each value, in the format of --change-costs.
Table value_costs(const Job& job, const Money& money) {
  std::vector<std::vector<std::string>> rows;
  for (const ModelParameter& parameter : job.model->parameters) {
    for (std::size_t i = 0; i < parameter.values.size(); ++i) {
      rows.push_back({parameter.name, parameter.values[i].label,
                      money(job.change_costs[parameter.first + i])});
    }
  }
  return table_of({{"parameter", {}}, {"value", {}}, {"cost", cost_column}}, std::move(rows));
}

// Further pieces of a part are counted in its row.
Table parts(const Job& job, const Money& money) {
  const bool has_slots = !job.slots.empty();
  const bool has_quantities = !job.quantities.empty();
  std::vector<std::uint64_t> quantities = job.quantities;
  for (std::size_t i = 0; i < job.piece_of.size() && has_quantities; ++i) {
    const Element part = job.piece_of[i];
    quantities[part] += part == i || quantities[i] == enough_for_all ? 0 : quantities[i];
  }
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < job.names.size(); ++i) {
    if (!job.piece_of.empty() && job.piece_of[i] != i) {
      continue;
    }
    std::vector<std::string>& row = rows.emplace_back();
    row = {job.names[i], money(job.change_costs[i])};
    if (has_slots) {
      row.push_back(job.slot_of[i] == no_slot ? "" : job.slots[job.slot_of[i]].name);
    }
    if (has_quantities) {
      row.push_back(quantities[i] == enough_for_all ? "" : std::to_string(quantities[i]));
    }
  }
  const std::string_view unit = word_of(job.cost_unit);
  std::vector<std::pair<std::string, ColumnStyle>> heads{
      {"part", {}},
      {unit.empty() ? "change_cost" : fmt::format("change_cost ({})", unit), cost_column}};
  if (has_slots) {
    heads.emplace_back("slot", ColumnStyle{});
  }
  if (has_quantities) {
    heads.emplace_back("quantity", number_column);
  }
  return table_of(std::move(heads), std::move(rows));
}

// The limits of slots, in the format of read_slots().
Table slot_limits(const Job& job) {
  std::vector<std::vector<std::string>> rows;
  rows.reserve(job.slots.size());
  for (const Slot& slot : job.slots) {
    rows.push_back({slot.name, std::to_string(slot.least),
                    slot.most == Slot{}.most ? "" : std::to_string(slot.most)});
  }
  return table_of({{"slot", {}}, {"least", number_column}, {"most", number_column}},
                  std::move(rows));
}

// Forbidden pairs with reasons; further pieces of a part are left out.
Table forbidden_pairs(const Job& job) {
  std::vector<std::vector<std::string>> rows;
  job.never.for_each(all_of_them, [&](Element a, Element b) {
    const Element x = std::min(a, b);
    const Element y = std::max(a, b);
    if (job.piece_of.empty() || (job.piece_of[x] == x && job.piece_of[y] == y)) {
      rows.push_back({job.names[x], job.names[y], job.why_never(x, y)});
    }
  });
  return table_of({{"part 1", {}}, {"part 2", {}}, {"why", {.kind = ColumnKind::notes}}},
                  std::move(rows));
}

// Earlier tests, in the columns of the run sheet.
Table tests_done(const DoneRecord& done) {
  const bool on_benches = std::ranges::any_of(
      done.tests, [](const DoneRecord::Test& test) { return !test.bench.empty(); });
  std::vector<std::pair<std::string, ColumnStyle>> heads;
  if (on_benches) {
    heads.emplace_back("bench", ColumnStyle{});
  }
  heads.emplace_back("step", number_column);
  for (const DonePlace& place : done.places) {
    heads.emplace_back(
        fmt::format("slot_{}{}{}", place.number, place.slot.empty() ? "" : " ", place.slot),
        ColumnStyle{});
  }
  heads.emplace_back("result", ColumnStyle{});
  heads.emplace_back("notes", ColumnStyle{.kind = ColumnKind::notes});
  std::vector<std::vector<std::string>> rows;
  std::map<std::string, std::uint64_t> steps;  // by bench
  std::set<std::string> numbered;              // benches whose tests have numbers
  for (const DoneRecord::Test& test : done.tests) {
    if (test.step) {
      numbered.insert(test.bench);
    }
  }
  for (const DoneRecord::Test& test : done.tests) {
    std::vector<std::string>& row = rows.emplace_back();
    if (on_benches) {
      row.push_back(test.bench);
    }
    // A test that was added by hand belongs to the one above it.
    const bool is_counted = numbered.count(test.bench) == 0;
    row.push_back(test.step    ? std::to_string(*test.step)
                  : is_counted ? std::to_string(++steps[test.bench])
                               : "");
    const std::size_t places = row.size();
    row.insert(row.end(), test.parts.begin(), test.parts.end());
    row.resize(places + done.places.size());
    row.push_back(test.result);
    row.push_back(test.notes);
  }
  return table_of(std::move(heads), std::move(rows));
}

// The list of benches as it was given, as read_benches() reads it: the columns that say something,
// and one to put a bench down.
Table bench_list(const RequestList& benches) {
  const std::vector<std::string_view>& keys = row_keys(RowShape::benches);
  std::vector<std::vector<std::string>> given(benches.number.value_or(0),
                                              std::vector<std::string>(1));
  for (const ListRow& row : benches.rows.value_or(std::vector<ListRow>())) {
    given.push_back(row.fields);
  }
  std::vector<std::pair<std::string, ColumnStyle>> heads;
  std::vector<std::vector<std::string>> rows(given.size());
  for (std::size_t c = 0; c < keys.size(); ++c) {
    const bool is_said = std::ranges::any_of(
        given, [&](const auto& row) { return c < row.size() && !row[c].empty(); });
    const bool is_name = c == 0;
    const bool is_last = c + 1 == keys.size();
    if (!is_said && !is_name && !is_last) {
      continue;
    }
    std::string head(is_name ? "bench" : keys[c]);
    std::ranges::replace(head, '_', ' ');
    constexpr std::array<std::string_view, 4> numbers{"at_once", "test_cost", "change_factor",
                                                      "hours"};
    const bool is_number = std::ranges::find(numbers, keys[c]) != numbers.end();
    const ColumnStyle down{.kind = ColumnKind::choice,
                           .choices = {.words = {"yes"},
                                       .title = "Out of order",
                                       .message = "yes: no test is planned for this bench"}};
    heads.emplace_back(std::move(head), is_last ? down : is_number ? number_column : ColumnStyle{});
    for (std::size_t b = 0; b < given.size(); ++b) {
      const std::string said = c < given[b].size() ? given[b][c] : "";
      rows[b].push_back(is_name && said.empty() ? fmt::format("Bench {}", b + 1) : said);
    }
  }
  return table_of(std::move(heads), std::move(rows));
}

// Below its head, the document in pieces.
Table question_table(const std::vector<std::string>& question) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 1; i < question.size(); ++i) {
    rows.push_back({question[i]});
  }
  return table_of({{question.front(), {}}}, std::move(rows));
}

void add_question(TableDocument& document, const std::vector<std::string>& question) {
  if (!question.empty()) {
    document.sections.push_back({.table = question_table(question),
                                 .in = in_workbook,
                                 .sheet = "changeover-question",
                                 .hidden = true});
  }
}

}  // namespace

std::string style_of(const Job& job, bool compact) {
  const bool wide = !compact && has_many_slots(job);
  return job.model != nullptr ? std::string(page_style) + value_style(job, compact)
                              : std::string(page_style) + std::string(wide ? wide_page_style : "");
}

void add_lists_of_job(TableDocument& document, const Job& job, const Money& money,
                      const RequestList& benches) {
  if (job.model != nullptr) {
    document.sections.push_back(
        {.table = value_costs(job, money), .in = in_workbook, .sheet = "Costs"});
  } else {
    document.sections.push_back({.table = parts(job, money), .in = in_workbook, .sheet = "Parts"});
  }
  if (!job.slots.empty() && job.model == nullptr) {
    document.sections.push_back({.table = slot_limits(job), .in = in_workbook, .sheet = "Slots"});
  }
  if (job.never.size() > 0) {
    document.sections.push_back({.heading = "Never together",
                                 .table = forbidden_pairs(job),
                                 .in = in_html | in_workbook,
                                 .sheet = "Never"});
  }
  if (benches.rows || benches.number) {
    document.sections.push_back(
        {.table = bench_list(benches), .in = in_workbook, .sheet = "Benches"});
  }
}

void add_what_goes_on(TableDocument& document, const Job& job, const Money& money,
                      const DoneRecord* done, const std::vector<std::string>& question,
                      const RequestList& benches) {
  if (done != nullptr && !done->tests.empty()) {
    document.sections.push_back({.table = tests_done(*done), .in = in_workbook, .sheet = "Done"});
  }
  add_lists_of_job(document, job, money, benches);
  add_question(document, question);
}

TableDocument table_document(const SheetDocument& document) {
  const Job& job = *document.job;
  const Money money(job, document.budget);
  TableDocument made{.title = document.title,
                     .figures = figures_of(document),
                     .page_lines = mounted_on_page(job),
                     .style = style_of(job, document.compact),
                     .overview = "Plan"};
  set_lines(made, summary(document));
  add_mounted(made, job, job.mounted);
  if (job.tests_done > 0) {
    made.page_lines.push_back(fmt::format("{} done before.", count_of(job.tests_done, "test")));
  }
  made.sections = {
      {.table = step_table({{&job, &document.plan->sheet}}, money, {.compact = document.compact}),
       .sheet = "Run sheet"},
      {.heading = "Compared", .table = compared(document), .in = everywhere & ~in_csv}};
  add_what_goes_on(made, job, money, document.done, document.question);
  return made;
}

TableDocument table_document(const Job& job, const WhatIf& answer) {
  const Money money(job);
  std::vector<std::vector<std::string>> rows;
  for (const WhatIf::Range& range : answer.ranges) {
    const std::string from = range.from ? range.from->to_string() : "";
    const std::string to = range.to ? range.to->to_string() : "";
    rows.push_back({range.from ? from : "0", range.to ? to : "any", from, to,
                    std::to_string(range.plan.tests()), std::to_string(range.plan.changes),
                    money(range.plan.change_cost), range.plan.name});
  }
  // In files for programs an open end is empty.
  const ColumnStyle shown{.kind = ColumnKind::number, .in = for_people};
  const ColumnStyle in_file{.kind = ColumnKind::number, .in = for_programs};
  TableSection section{
      .heading =
          answer.by_factor
              ? "If all change costs are multiplied by a factor, the cheapest plan that is "
                "known has"
              : "At a ratio of change cost to test cost, the cheapest plan that is known has",
      .table = table_of({{"from", shown},
                         {"to", shown},
                         {"from", in_file},
                         {"to", in_file},
                         {"tests", number_column},
                         {"changes", number_column},
                         {"change_cost", {.kind = ColumnKind::cost, .in = for_programs}},
                         {"plan", {}}},
                        std::move(rows))};
  if (answer.asked) {
    section.notes.push_back(fmt::format("Your costs are at the {} {}.",
                                        answer.by_factor ? "factor" : "ratio",
                                        answer.asked->to_string()));
  }
  if (job.needed.size() == 0) {
    section.notes.emplace_back("Nothing is left to test.");
  }
  for (std::string& line : what_if_notes(job, answer)) {
    section.notes.push_back(std::move(line));
  }
  return {.sections = {std::move(section)}};
}

namespace {

// Written in one of these formats; `what` names the document in the message for other formats.
std::string written_as(std::string_view format, std::initializer_list<std::string_view> formats,
                       std::string_view what, const TableDocument& document, std::size_t width) {
  const bool known = std::ranges::find(formats, format) != formats.end();
  const std::optional<std::string> text =
      known ? document_as(format, document, width) : std::nullopt;
  return text ? *text : throw BadOption(fmt::format("{} is not written as {}", what, format));
}

// A plan for one bench, or for several.
template <typename Document>
std::string plan_written(const Document& document, std::string_view format, std::size_t width) {
  return format == "json" ? json_of(document)
                          : written_as(format, {"table", "csv", "markdown", "html", "xlsx"},
                                       "a plan", table_document(document), width);
}

}  // namespace

std::string written(const SheetDocument& document, std::string_view format, std::size_t width) {
  return plan_written(document, format, width);
}

std::string written(const BenchDocument& document, std::string_view format, std::size_t width) {
  return plan_written(document, format, width);
}

std::string written(const Job& job, const WhatIf& answer, std::string_view format) {
  constexpr std::size_t wide = 200;
  return format == "json" ? json_of(job, answer)
                          : written_as(format, {"table", "csv", "markdown"}, "a table of ratios",
                                       table_document(job, answer), wide);
}

std::string written(const DiagnosisDocument& document, std::string_view format, std::size_t width) {
  return format == "json" ? json_of(document)
                          : written_as(format, {"table", "markdown", "html", "xlsx"}, "a diagnosis",
                                       table_document(document), width);
}

std::string written(const Job& job, const Diagnosis& found, std::string_view format,
                    std::size_t width) {
  return written(DiagnosisDocument{.job = &job, .found = &found}, format, width);
}

}  // namespace changeover
