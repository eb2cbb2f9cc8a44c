// Run sheets of several benches.
#include <fmt/format.h>

#include <algorithm>

#include "changeover/plan/benches.hpp"
#include "io/write/csv_cell.hpp"
#include "io/write/json_writer.hpp"
#include "plan/sheet/layout.hpp"
#include "plan/sheet/sheet_html.hpp"
#include "plan/sheet/sheet_words.hpp"

namespace changeover {
namespace {

std::string bench_line(const Money& money, std::size_t bench, const RunSheet& sheet) {
  return fmt::format("Bench {}: {}, {}, cost {}", bench + 1, count_of(sheet.steps.size(), "test"),
                     count_of(sheet.changes, "change"), money(sheet.cost));
}

Cell one(const std::string& word) { return {word}; }

std::string plain_list(const Job& job, const Block& parts) { return joined(names_of(job, parts)); }

}  // namespace

std::vector<std::string> bench_summary(const BenchDocument& document) {
  const Job& job = *document.job;
  const BenchPlan& plan = *document.plan;
  const Money money(job);
  const bool triples = !job.triples.empty();
  std::vector<std::string> lines{
      fmt::format(
          "{}, {} at a time, on {}: {}, {}", count_of(job.parts(), "part"), job.at_once,
          plan.sheets.size() == 1 ? "1 bench" : fmt::format("{} benches", plan.sheets.size()),
          count_of(plan.tests, "test"), count_of(plan.changes, "change")),
      fmt::format("{} on the bench that costs most, {} together", money(plan.largest),
                  money(plan.cost)),
      fmt::format("{} of {} tested on some bench, checked by an independent count",
                  triples ? plan.triples_tested : plan.pairs_tested,
                  triples ? count_of(plan.triples_needed, "needed triple")
                          : count_of(plan.pairs_needed, "needed pair")),
      fmt::format("best for {}: {}",
                  document.objective == BenchObjective::cost ? "the least cost together"
                                                             : "the least largest cost",
                  plan.candidates.front().name)};
  lines.push_back(plan.largest == plan.largest_bound
                      ? fmt::format("no plan is done for less than {} on each bench: {}",
                                    money(plan.largest), plan.largest_reason)
                      : fmt::format("lower bound for the bench that costs most: {}, since {}",
                                    money(plan.largest_bound), plan.largest_reason));
  lines.push_back(
      fmt::format("lower bound for all benches together: {}, since their lists end to end are one "
                  "list",
                  money(plan.bound.cost)));
  lines.push_back("every bench begins empty, and every bench can have every part");
  lines.insert(lines.end(), document.notes.begin(), document.notes.end());
  return lines;
}

std::string benches_as_table(const BenchDocument& document, std::size_t width) {
  const Job& job = *document.job;
  const BenchPlan& plan = *document.plan;
  const Money money(job);
  std::string text = document.title + "\n";
  for (const std::string& line : bench_summary(document)) {
    text += line + "\n";
  }
  text += mounted_line(job);
  for (std::size_t bench = 0; bench < plan.sheets.size(); ++bench) {
    const RunSheet& sheet = plan.sheets[bench];
    text += "\n" + bench_line(money, bench, sheet) + "\n";
    std::vector<std::vector<Cell>> rows;
    for (const RunStep& step : sheet.steps) {
      rows.push_back({one(fmt::format("{}", rows.size() + 1)), names_of(job, step.take_out),
                      put_in_words(job, step), names_of(job, without_mounted(job, step.setup)),
                      one(fmt::format("{}", new_here(job, step))), one(money(step.cost)),
                      one(money(step.cost_so_far))});
      if (!job.replaces()) {
        rows.back().erase(rows.back().end() - 2);
      }
    }
    if (!rows.empty()) {
      std::vector<Column> columns{{"step", true},
                                  {"take out"},
                                  {"put in"},
                                  {"set-up"},
                                  {"new " + what_meets(job), true},
                                  {"cost", true},
                                  {"cost so far", true}};
      if (!job.replaces()) {
        columns.erase(columns.end() - 2);
      }
      text += laid_out(columns, rows, width);
    }
  }
  std::vector<std::vector<Cell>> rows;
  for (const BenchCandidate& c : plan.candidates) {
    rows.push_back({one(c.name), one(fmt::format("{}", c.tests)), one(fmt::format("{}", c.changes)),
                    one(money(c.largest)), one(money(c.cost)), one(c.how)});
  }
  return text + "\nCompared\n" +
         laid_out({{"plan"},
                   {"tests", true},
                   {"changes", true},
                   {"largest", true},
                   {"together", true},
                   {"how"}},
                  rows, width);
}

std::string benches_as_csv(const BenchDocument& document) {
  const Job& job = *document.job;
  const Money money(job);
  std::size_t columns = 0;
  for (const RunSheet& sheet : document.plan->sheets) {
    for (const RunStep& step : sheet.steps) {
      columns = std::max(columns, step.setup.size());
    }
  }
  std::string text = "bench,step,take_out,put_in";
  for (std::size_t i = 1; i <= columns; ++i) {
    text += fmt::format(",slot_{}", i);
  }
  text += fmt::format(",new_{},cost,cost_so_far,result\n", what_meets(job));
  for (std::size_t bench = 0; bench < document.plan->sheets.size(); ++bench) {
    std::uint64_t number = 0;
    for (const RunStep& step : document.plan->sheets[bench].steps) {
      text += fmt::format("{},{},{},{}", bench + 1, ++number,
                          csv_cell(parts_text(step.take_out, job.names)),
                          csv_cell(parts_text(step.put_in, job.names)));
      for (std::size_t i = 0; i < columns; ++i) {
        text += i < step.setup.size() ? "," + csv_cell(job.names[step.setup[i]]) : ",";
      }
      text += fmt::format(",{},{},{},\n", new_here(job, step), money(step.cost),
                          money(step.cost_so_far));
    }
  }
  return text;
}

std::string benches_as_json(const BenchDocument& document) {
  const Job& job = *document.job;
  const BenchPlan& plan = *document.plan;
  const Money money(job);
  JsonWriter json;
  json.begin_object().key("format").value("changeover-benches/1");
  json.key("title").value(document.title).key("benches").value(plan.sheets.size());
  json.key("objective").value(document.objective == BenchObjective::cost ? "cost" : "makespan");
  json.key("cost").raw(money(plan.cost)).key("makespan").raw(money(plan.largest));
  json.key("tests").value(plan.tests).key("changes").value(plan.changes);
  json.key("pairs_needed").value(plan.pairs_needed).key("pairs_tested").value(plan.pairs_tested);
  json.key("triples_needed").value(plan.triples_needed);
  json.key("triples_tested").value(plan.triples_tested);
  json.key("lower_bound").begin_object().key("cost").raw(money(plan.bound.cost));
  json.key("makespan").raw(money(plan.largest_bound));
  json.key("cost_reason").value(plan.bound.reason);
  json.key("makespan_reason").value(plan.largest_reason).end_object();
  json.key("sheets").begin_array();
  for (std::size_t bench = 0; bench < plan.sheets.size(); ++bench) {
    const RunSheet& sheet = plan.sheets[bench];
    json.begin_object().key("bench").value(bench + 1).key("tests").value(sheet.steps.size());
    json.key("changes").value(sheet.changes).key("cost").raw(money(sheet.cost));
    json.key("steps").begin_array();
    std::uint64_t number = 0;
    for (const RunStep& step : sheet.steps) {
      json.begin_object().key("step").value(++number);
      json.key("take_out").value(names_of(job, step.take_out));
      json.key("put_in").value(names_of(job, step.put_in));
      json.key("set_up").value(names_of(job, step.setup));
      json.key("new_" + what_meets(job)).value(new_here(job, step));
      if (job.replaces()) {
        json.key("replaced").begin_array();
        for (const auto& [out, in] : step.replaced) {
          json.value(names_of(job, {out, in}));
        }
        json.end_array();
      }
      json.key("cost").raw(money(step.cost));
      json.key("cost_so_far").raw(money(step.cost_so_far)).end_object();
    }
    json.end_array().end_object();
  }
  json.end_array().key("candidates").begin_array();
  for (const BenchCandidate& c : plan.candidates) {
    json.begin_object().key("name").value(c.name).key("how").value(c.how);
    json.key("tests").value(c.tests).key("changes").value(c.changes);
    json.key("cost").raw(money(c.cost)).key("makespan").raw(money(c.largest)).end_object();
  }
  json.end_array().key("notes").value(document.notes).end_object();
  return json.take() + "\n";
}

std::string benches_as_html(const BenchDocument& document) {
  const Job& job = *document.job;
  const BenchPlan& plan = *document.plan;
  const Money money(job);
  std::string body;
  for (const std::string& line : bench_summary(document)) {
    body += "<p class=\"small\">" + html_text(line) + "</p>\n";
  }
  body +=
      "<h2>Compared</h2>\n<table>\n<thead><tr><th>Plan</th><th class=\"n\">Tests</th>"
      "<th class=\"n\">Changes</th><th class=\"n\">Largest</th><th class=\"n\">Together</th>"
      "</tr></thead>\n<tbody>\n";
  for (const BenchCandidate& c : plan.candidates) {
    body += fmt::format(
        "<tr><td>{}<br><span class=\"small\">{}</span></td><td class=\"n\">{}</td>"
        "<td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td></tr>\n",
        html_text(c.name), html_text(c.how), c.tests, c.changes, money(c.largest), money(c.cost));
  }
  body += "</tbody>\n</table>\n";
  for (std::size_t bench = 0; bench < plan.sheets.size(); ++bench) {
    RunPlan one;
    one.sheet = plan.sheets[bench];
    body += fmt::format("<h2 class=\"bench\">{}</h2>\n{}{}",
                        html_text(bench_line(money, bench, one.sheet)),
                        job.mounted.empty() ? "" : "<p>" + html_text(mounted_line(job)) + "</p>\n",
                        html_steps({.job = &job, .plan = &one}));
  }
  return html_page(document.title, body);
}

std::string benches_as_markdown(const BenchDocument& document) {
  const Job& job = *document.job;
  const BenchPlan& plan = *document.plan;
  const Money money(job);
  std::string text = "# " + markdown(document.title) + "\n\n";
  for (const std::string& line : bench_summary(document)) {
    text += "- " + markdown(line) + "\n";
  }
  if (!job.mounted.empty()) {
    text += "- " + markdown(mounted_line(job));
  }
  for (std::size_t bench = 0; bench < plan.sheets.size(); ++bench) {
    text += fmt::format(
        "\n## {}\n\n| step | take out | put in | set-up | new {} | cost so far |\n"
        "|---:|:---|:---|:---|---:|---:|\n",
        bench_line(money, bench, plan.sheets[bench]), what_meets(job));
    std::uint64_t number = 0;
    for (const RunStep& step : plan.sheets[bench].steps) {
      text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", ++number,
                          markdown(plain_list(job, step.take_out)),
                          markdown(joined(put_in_words(job, step))),
                          markdown(plain_list(job, without_mounted(job, step.setup))),
                          new_here(job, step), money(step.cost_so_far));
    }
  }
  text +=
      "\n| plan | tests | changes | largest | together | how |\n|:---|---:|---:|---:|---:|:---|\n";
  for (const BenchCandidate& c : plan.candidates) {
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", c.name, c.tests, c.changes,
                        money(c.largest), money(c.cost), markdown(c.how));
  }
  return text;
}

}  // namespace changeover
