// Run sheets as CSV, JSON and Markdown.
#include <fmt/format.h>

#include <optional>

#include "changeover/plan/job.hpp"
#include "io/write/csv_cell.hpp"
#include "io/write/json_writer.hpp"
#include "plan/sheet/sheet_words.hpp"
#include "plan/sheet/slot_columns.hpp"

namespace changeover {
namespace {

void write_candidate(JsonWriter& json, const Money& money, const Candidate& candidate) {
  json.begin_object().key("name").value(candidate.name).key("how").value(candidate.how);
  json.key("tests").value(candidate.tests()).key("changes").value(candidate.changes);
  json.key("cost").raw(money(candidate.cost));
  json.key("pairs_tested").value(candidate.pairs_tested);
  json.key("triples_tested").value(candidate.triples_tested);
  json.key("weight").raw(to_string(candidate.weight)).end_object();
}

void write_ratio(JsonWriter& json, const std::optional<Ratio>& ratio) {
  ratio ? json.value(static_cast<double>(ratio->over) / static_cast<double>(ratio->under))
        : json.null();
}

std::string ratio_text(const std::optional<Ratio>& ratio) {
  return ratio ? ratio->to_string() : std::string();
}

std::string markdown_list(const Job& job, const Block& parts) {
  return markdown(joined(names_of(job, parts)));
}

}  // namespace

std::string markdown(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view("\\`*_{}[]<>#|~&").find(c) != std::string_view::npos) {
      escaped += '\\';
    }
    escaped += c;
  }
  return escaped;
}

std::string sheet_as_csv(const SheetDocument& document) {
  const Job& job = *document.job;
  const Money money(job, document.budget);
  const SlotColumns columns(job, document.plan->sheet);
  std::vector<std::string> cells;  // by part: made once, for a part may be in every set-up
  cells.reserve(job.names.size());
  for (const std::string& name : job.names) {
    cells.push_back("," + csv_cell(name));
  }
  std::string text = "step,take_out,put_in";
  for (const std::string& head : columns.heads()) {
    text += "," + csv_cell(head);
  }
  const bool weighs = !job.weights.empty();
  text += fmt::format(",new_{},cost,cost_so_far{},result\n", what_meets(job),
                      weighs ? ",weight_so_far" : "");
  std::uint64_t number = job.tests_done;
  for (const RunStep& step : document.plan->sheet.steps) {
    text += fmt::format("{},{},{}", ++number, csv_cell(parts_text(step.take_out, job.names)),
                        csv_cell(parts_text(step.put_in, job.names)));
    for (const std::optional<Element> x : columns.row(step.setup)) {
      text += x ? cells[*x] : ",";
    }
    text += fmt::format(",{},{},{}{},\n", new_here(job, step), money(step.cost),
                        money(step.cost_so_far),
                        weighs ? "," + to_string(step.weight_so_far) : std::string());
  }
  return text;
}

std::string sheet_as_json(const SheetDocument& document) {
  const Job& job = *document.job;
  const RunPlan& plan = *document.plan;
  const RunSheet& sheet = plan.sheet;
  const Money money(job, document.budget);
  JsonWriter json;
  json.begin_object().key("format").value("changeover-plan/1").key("title").value(document.title);
  json.key("parts").begin_array();
  for (std::size_t i = 0; i < job.names.size(); ++i) {
    json.begin_object().key("name").value(job.names[i]);
    json.key("change_cost").raw(money(job.change_costs[i]));
    if (!job.slots.empty()) {
      json.key("slot");
      job.slot_of[i] == no_slot ? json.null() : json.value(job.slots[job.slot_of[i]].name);
    }
    json.end_object();
  }
  json.end_array().key("at_once").value(job.at_once).key("slots").begin_array();
  for (const Slot& slot : job.slots) {
    json.begin_object().key("name").value(slot.name).key("least").value(slot.least).key("most");
    slot.most < job.at_once ? json.value(slot.most) : json.value(job.at_once);
    json.end_object();
  }
  json.end_array();
  json.key("test_cost").raw(money(job.test_cost));
  if (job.replaces()) {
    json.key("replace_costs").begin_array();
    for (Element out = 0; out < job.parts(); ++out) {
      json.begin_array();
      for (Element in = 0; in < job.parts(); ++in) {
        in == out ? json.null() : json.raw(money(job.replace_cost(out, in)));
      }
      json.end_array();
    }
    json.end_array();
  }
  json.key("mounted").value(names_of(job, job.mounted));
  json.key("start").value(names_of(job, job.start));
  json.key("first").begin_array();
  for (const Block& setup : job.first) {
    json.value(names_of(job, setup));
  }
  json.end_array().key("tests_done").value(job.tests_done);
  json.key("met_only_in_failed").value(job.met_only_in_failed);
  json.key("trust_failed").value(job.trust_failed);
  json.key("tests").value(sheet.steps.size()).key("changes").value(sheet.changes);
  json.key("cost").raw(money(sheet.cost)).key("pairs_needed").value(sheet.pairs_needed);
  json.key("pairs_tested").value(sheet.pairs_tested);
  json.key("proved_cheapest").value(plan.proved_cheapest());
  json.key("lower_bound").begin_object().key("cost").raw(money(plan.bound.cost));
  json.key("tests").value(plan.bound.tests).key("changes").value(plan.bound.introductions);
  json.key("reason").value(plan.bound.reason).end_object().key("budget");
  document.budget ? json.raw(money(*document.budget)) : json.null();
  json.key("triples_needed").value(sheet.triples_needed);
  json.key("triples_tested").value(sheet.triples_tested).key("weight");
  if (job.weights.empty()) {
    json.null();
  } else {
    json.begin_object().key("needed").raw(to_string(sheet.weight_needed));
    json.key("tested").raw(to_string(sheet.weight_tested)).key("most");
    plan.most_weight ? json.raw(to_string(*plan.most_weight)) : json.null();
    json.end_object();
  }
  json.key("steps").begin_array();
  std::uint64_t number = job.tests_done;
  for (const RunStep& step : sheet.steps) {
    json.begin_object().key("step").value(++number);
    json.key("take_out").value(names_of(job, step.take_out));
    json.key("put_in").value(names_of(job, step.put_in));
    json.key("set_up").value(names_of(job, step.setup)).key("new_pairs").begin_array();
    for (const auto& [x, y] : step.new_pairs) {
      json.value(names_of(job, {x, y}));
    }
    if (!job.triples.empty()) {
      json.end_array().key("new_triples").begin_array();
      for (const Triple& t : step.new_triples) {
        json.value(names_of(job, {t.begin(), t.end()}));
      }
    }
    if (job.replaces()) {
      json.end_array().key("replaced").begin_array();
      for (const auto& [out, in] : step.replaced) {
        json.value(names_of(job, {out, in}));
      }
    }
    json.end_array().key("cost").raw(money(step.cost));
    json.key("cost_so_far").raw(money(step.cost_so_far));
    if (!job.weights.empty()) {
      json.key("weight_so_far").raw(to_string(step.weight_so_far));
    }
    json.end_object();
  }
  json.end_array().key("candidates").begin_array();
  for (const Candidate& candidate : plan.candidates) {
    write_candidate(json, money, candidate);
  }
  json.end_array().key("notes").value(document.notes).end_object();
  return json.take() + "\n";
}

std::string sheet_as_markdown(const SheetDocument& document) {
  const Job& job = *document.job;
  const RunPlan& plan = *document.plan;
  const Money money(job, document.budget);
  std::string text = "# " + markdown(document.title) + "\n\n";
  for (const std::string& line : summary(document)) {
    text += "- " + line + "\n";
  }
  if (!job.mounted.empty()) {
    text += "- " + markdown(mounted_line(job));
  }
  text += fmt::format(
      "\n| step | take out | put in | set-up | new {} | {}cost so far |\n"
      "|---:|:---|:---|:---|---:|{}---:|\n",
      what_meets(job), job.replaces() ? "cost | " : "", job.replaces() ? "---:|" : "");
  std::uint64_t number = job.tests_done;
  for (const RunStep& step : plan.sheet.steps) {
    text +=
        fmt::format("| {} | {} | {} | {} | {} | {}{} |\n", ++number,
                    markdown_list(job, step.take_out), markdown(joined(put_in_words(job, step))),
                    markdown_list(job, without_mounted(job, step.setup)), new_here(job, step),
                    job.replaces() ? money(step.cost) + " | " : "", money(step.cost_so_far));
  }
  text += fmt::format(
      "\n| plan | tests | changes | cost | {} | dearer by | how |\n"
      "|:---|---:|---:|---:|---:|---:|:---|\n",
      what_meets(job));
  for (const Candidate& candidate : plan.candidates) {
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", candidate.name, candidate.tests(),
                        candidate.changes, money(candidate.cost), tested_by(job, candidate),
                        difference(document, candidate), candidate.how);
  }
  return text;
}

std::string what_if_as_csv(const Job& job, const WhatIf& answer) {
  const Money money(job);
  std::string text = "from,to,tests,changes,change_cost,plan\n";
  for (const WhatIf::Range& range : answer.ranges) {
    text += fmt::format("{},{},{},{},{},{}\n", ratio_text(range.from), ratio_text(range.to),
                        range.plan.tests(), range.plan.changes, money(range.plan.change_cost),
                        csv_cell(range.plan.name));
  }
  return text;
}

std::string what_if_as_json(const Job& job, const WhatIf& answer) {
  const Money money(job);
  JsonWriter json;
  json.begin_object().key("format").value("changeover-what-if/1");
  json.key("by").value(answer.by_factor ? "factor of all change costs"
                                        : "ratio of change cost to test cost");
  json.key("asked");
  write_ratio(json, answer.asked);
  json.key("ranges").begin_array();
  for (const WhatIf::Range& range : answer.ranges) {
    json.begin_object().key("from");
    write_ratio(json, range.from);
    json.key("to");
    write_ratio(json, range.to);
    json.key("plan");
    write_candidate(json, money, range.plan);
    json.end_object();
  }
  json.end_array().key("met_only_in_failed").value(job.met_only_in_failed);
  json.key("trust_failed").value(job.trust_failed).key("notes").value(answer.notes).end_object();
  return json.take() + "\n";
}

std::string what_if_as_markdown(const Job& job, const WhatIf& answer) {
  std::string text = "| from | to | tests | changes | plan |\n|---:|---:|---:|---:|:---|\n";
  for (const WhatIf::Range& range : answer.ranges) {
    text += fmt::format("| {} | {} | {} | {} | {} |\n", range.from ? range.from->to_string() : "0",
                        range.to ? range.to->to_string() : "any", range.plan.tests(),
                        range.plan.changes, range.plan.name);
  }
  const std::vector<std::string> notes = what_if_notes(job, answer);
  for (std::size_t i = 0; i < notes.size(); ++i) {
    text += (i == 0 ? "\n- " : "- ") + markdown(notes[i]) + "\n";
  }
  return text;
}

}  // namespace changeover
