#include "plan/sheet/step_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "changeover/io/tables.hpp"
#include "plan/sheet/slot_columns.hpp"

namespace changeover {
namespace {

struct Line {
  std::size_t bench = 0;
  std::uint64_t number = 0;
  const RunStep* step = nullptr;
};

std::vector<Line> lines_of(const Job& job, const std::vector<const RunSheet*>& sheets) {
  std::vector<Line> lines;
  for (std::size_t bench = 0; bench < sheets.size(); ++bench) {
    std::uint64_t number = job.tests_done;
    for (const RunStep& step : sheets[bench]->steps) {
      lines.push_back({bench, ++number, &step});
    }
  }
  return lines;
}

TableCell number_cell(std::uint64_t number) { return std::to_string(number); }

// The names of some parts; those that are marked are bold.
TableCell parts_cell(const Job& job, const Block& parts, const Block& marked) {
  std::vector<bool> bold;
  for (const Element x : parts) {
    bold.push_back(std::find(marked.begin(), marked.end(), x) != marked.end());
  }
  return {names_of(job, parts), std::move(bold)};
}

// Long names stand one a line of a page, short ones side by side.
bool has_long_names(const Job& job) {
  constexpr std::size_t long_name = 8;
  return std::any_of(job.names.begin(), job.names.end(),
                     [](const std::string& name) { return display_width(name) > long_name; });
}

}  // namespace

Table step_table(const Job& job, const std::vector<const RunSheet*>& sheets, const Money& money,
                 const StepTableOptions& options) {
  const auto lines = std::make_shared<const std::vector<Line>>(lines_of(job, sheets));
  const auto slots = std::make_shared<const SlotColumns>(job, sheets);
  const bool long_names = has_long_names(job);
  // One name a line would make a step as high as a third of a page.
  constexpr std::uint64_t most_lines = 6;
  const bool flows = !options.compact && long_names && job.room() > most_lines;
  Table table{.rows = lines->size(), .columns = {}};
  if (options.compact) {
    table.frame = long_names ? "compact" : "compact two";
  }
  table.css = std::string("steps") +
              (options.compact ? ""
               : long_names    ? " whole lines"
                               : " whole") +
              (flows ? " many" : "");
  // A column that is made of the steps.
  const auto add = [&](std::string head, auto cell, ColumnStyle style) {
    table.columns.push_back(
        {std::move(head),
         [lines, cell](std::size_t row) -> TableCell { return cell(lines->at(row)); },
         std::move(style)});
  };
  const Job* const of = &job;
  const auto nothing = [](const Line&) { return TableCell(); };
  add("Pass Fail", nothing, {.kind = ColumnKind::choice, .in = in_html, .css = "verdict"});
  if (options.benches) {
    add("bench", [](const Line& line) { return number_cell(line.bench + 1); },
        {.kind = ColumnKind::number, .in = for_programs});
  }
  add("step", [](const Line& line) { return number_cell(line.number); },
      {.kind = ColumnKind::number});
  add("take out", [of](const Line& line) { return parts_cell(*of, line.step->take_out, {}); },
      {.kind = ColumnKind::list, .name = "take_out"});
  if (job.replaces()) {
    add("put in",
        [of](const Line& line) {
          std::vector<std::string> words = put_in_words(*of, *line.step);
          std::vector<bool> bold(words.size(), true);
          return TableCell(std::move(words), std::move(bold));
        },
        {.kind = ColumnKind::list, .in = for_people});
  }
  add("put in",
      [of](const Line& line) { return parts_cell(*of, line.step->put_in, line.step->put_in); },
      {.kind = ColumnKind::list,
       .in = job.replaces() ? for_programs : everywhere,
       .name = "put_in"});
  add("set-up",
      [of](const Line& line) {
        return parts_cell(*of, without_mounted(*of, line.step->setup), line.step->put_in);
      },
      {.kind = ColumnKind::list,
       .in = options.compact ? in_markdown : for_people,
       .css = flows ? "flow" : "",
       .head_css = "setup"});
  for (std::size_t c = 0; c < slots->heads().size(); ++c) {
    add(slots->heads()[c],
        [of, slots, c](const Line& line) {
          const std::optional<Element> x = slots->part(line.step->setup, c);
          return x ? parts_cell(*of, {*x}, line.step->put_in) : TableCell();
        },
        {.in = for_programs});
  }
  const unsigned unless_compact = options.compact ? everywhere & ~in_html : everywhere;
  add("new\n" + what_meets(job),
      [of](const Line& line) { return number_cell(new_here(*of, *line.step)); },
      {.kind = ColumnKind::number, .in = unless_compact, .name = "new_" + what_meets(job)});
  add("cost", [money](const Line& line) { return TableCell(money(line.step->cost)); },
      {.kind = ColumnKind::cost, .in = job.replaces() ? unless_compact : for_programs});
  add("cost\nso far",
      [money](const Line& line) { return TableCell(money(line.step->cost_so_far)); },
      {.kind = ColumnKind::cost, .in = unless_compact, .name = "cost_so_far"});
  if (!job.weights.empty()) {
    add("weight\nso far",
        [](const Line& line) { return TableCell(to_string(line.step->weight_so_far)); },
        {.kind = ColumnKind::number, .in = unless_compact, .name = "weight_so_far"});
  }
  add("result", nothing,
      {.kind = ColumnKind::choice,
       .in = for_programs,
       .choices = {
           .words = {"pass", "fail", "unclear"},
           .title = "Result",
           .message = "pass and fail are used to find the faulty part; other words are kept"}});
  add("notes", nothing,
      {.kind = ColumnKind::notes, .in = in_html | in_workbook, .head_css = "notes"});
  return table;
}

}  // namespace changeover
