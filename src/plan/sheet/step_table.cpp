// The table of the steps of a sheet, with the columns of each format.
#include "plan/sheet/step_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "changeover/io/tables.hpp"
#include "core/contains.hpp"
#include "plan/sheet/clock.hpp"
#include "plan/sheet/shown_values.hpp"

namespace changeover {
namespace {

constexpr const char* nothing_there = "–";

struct Line {
  std::size_t bench = 0;
  std::uint64_t number = 0;
  const RunStep* step = nullptr;
  const StepTime* time = nullptr;
  const MountedParts* before = nullptr;
  const MountedParts* now = nullptr;
  std::size_t at = 0;  // index in its list
  const std::vector<std::string>* hand_over = nullptr;
};

// The lines with the data that they refer to.
struct Steps {
  std::vector<ShownSheet> sheets;
  PlacedSheets placed;
  std::vector<Line> lines;
};

std::shared_ptr<const Steps> steps_of(const std::vector<ShownSheet>& sheets) {
  const auto made = std::make_shared<Steps>(Steps{sheets, placed(sheets), {}});
  for (std::size_t bench = 0; bench < sheets.size(); ++bench) {
    const auto& [job, sheet, name, times, hand_over] = sheets[bench];
    const PlacedSheet& list = made->placed.sheets[bench];
    const MountedParts* before = &list.before;
    for (std::size_t i = 0; i < list.steps.size(); ++i) {
      made->lines.push_back({bench, job->steps_before() + i + 1, &sheet->steps[i],
                             times == nullptr ? nullptr : &(*times)[i], before, &list.steps[i], i,
                             hand_over == nullptr ? nullptr : &(*hand_over)[i]});
      before = &list.steps[i];
    }
  }
  return made;
}

TableCell number_cell(std::uint64_t number) { return std::to_string(number); }

// Some places with their parts after a step, in order; places that are empty to the end of the row
// are left out. Permanently mounted parts are shown once, above the table.
struct SeenPlace {
  std::optional<Element> part;
  std::optional<Element> was;  // before the step, if that changed
  bool is_new = false;
};

std::vector<SeenPlace> seen(const Job& job, const Steps& steps, const Line& line,
                            std::optional<std::uint32_t> slot) {
  std::vector<SeenPlace> found;
  std::size_t last = 0;
  for (std::size_t i = 0; i < line.now->size(); ++i) {
    const auto& part = (*line.now)[i];
    const auto& before = (*line.before)[i];
    if ((slot && steps.placed.places[i].slot != *slot) || (part && contains(job.mounted, *part))) {
      continue;
    }
    found.push_back({part, part == before ? std::nullopt : before, part && part != before});
    last = part || found.back().was ? found.size() : last;
  }
  found.resize(last);
  return found;
}

// The parts by place, with new ones in bold; on request with what they replace: "Motor for Pump",
// "– Pump out".
TableCell place_cell(const Job& job, const std::vector<SeenPlace>& places, bool shows_replaced) {
  TableCell cell;
  for (const SeenPlace& place : places) {
    cell.words.emplace_back(place.part ? job.names[*place.part] : nothing_there);
    cell.bold.push_back(place.is_new);
    if (shows_replaced) {
      cell.remarks.push_back(!place.was   ? ""
                             : place.part ? "for " + job.names[*place.was]
                                          : job.names[*place.was] + " out");
    }
  }
  return cell;
}

// The same on a terminal, with a + before new parts; each slot on separate lines.
TableCell terminal_cell(const Job& job, const Steps& steps, const Line& line) {
  TableCell cell;
  for (std::size_t s = 0; s <= job.slots.size(); ++s) {
    const bool free = s == job.slots.size();
    std::vector<SeenPlace> places =
        seen(job, steps, line, free ? no_slot : static_cast<std::uint32_t>(s));
    while (!places.empty() && !places.back().part) {
      places.pop_back();
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      const bool first = i == 0 && !job.slots.empty();
      cell.words.push_back(fmt::format(
          "{}{}{}", first && !free ? job.slots[s].name + ": " : "", places[i].is_new ? "+" : "",
          places[i].part ? job.names[*places[i].part] : nothing_there));
      cell.breaks.push_back(first);
    }
  }
  return cell;
}

// Long names are shown one per line of a page, short ones side by side.
bool has_long_names(const Job& job) {
  constexpr std::size_t long_name = 8;
  return std::ranges::any_of(
      job.names, [](const std::string& name) { return display_width(name) > long_name; });
}

// Whether a sheet has a column for parts in no slot.
bool has_free_places(const Steps& steps) {
  return std::ranges::any_of(steps.placed.places,
                             [](const MountedPlace& place) { return place.slot == no_slot; });
}

// With more columns a line becomes unreadable.
constexpr std::size_t most_value_columns = 10;

// Whether a column of this parameter is shown to people.
bool is_column(const Job& job, std::size_t p, bool compact) {
  return !compact && job.model->parameters.size() <= most_value_columns &&
         std::ranges::none_of(job.mounted, [&](Element x) { return job.slot_of[x] == p; });
}

// A text within quotes of a style sheet, escaped.
std::string css_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                       (static_cast<unsigned char>(c) & 0x80U) != 0;
    escaped += plain ? std::string(1, c) : fmt::format("\\{:x} ", static_cast<unsigned>(c));
  }
  return escaped;
}

class StepTable {
 public:
  StepTable(const std::vector<ShownSheet>& sheets, const Money& money,
            const StepTableOptions& options)
      : job_(sheets.front().job), money_(money), options_(options), steps_(steps_of(sheets)) {
    const Job& job = *job_;
    const bool long_names = has_long_names(job);
    // One name per line would make a step as high as a third of a page.
    constexpr std::uint64_t most_lines = 6;
    flows_ = !options.compact && long_names && job.slots.empty() && job.room() > most_lines;
    table_.rows = steps_->lines.size();
    if (options.compact) {
      table_.frame = long_names ? "compact" : "compact two";
    }
    table_.css = std::string("steps") +
                 (options.compact ? ""
                  : long_names    ? " whole lines"
                                  : " whole") +
                 (flows_ || (has_many_slots(job) && job.model == nullptr) ? " many" : "") +
                 (job.model == nullptr ? "" : " values");
    for (const ShownSheet& shown : sheets) {
      if (job.model != nullptr) {
        values_.emplace_back(*shown.job, *shown.sheet);  // each bench has its own start
      }
    }
  }

  Table made() {
    add_heads();
    if (job_->model != nullptr) {
      add_values();
    } else {
      add_changes();
      add_setups();
    }
    add_figures();
    add_room_for_results();
    return std::move(table_);
  }

 private:
  // A column that is computed from the steps.
  template <typename Cell>
  void add(std::string head, Cell&& cell, ColumnStyle style) {
    table_.columns.push_back({std::move(head),
                              [steps = steps_, cell](std::size_t row) -> TableCell {
                                return cell(steps->lines.at(row));
                              },
                              std::move(style)});
  }

  void add_heads() {
    add("Pass Fail", [](const Line&) { return TableCell(); },
        {.kind = ColumnKind::choice, .in = in_html, .css = "verdict"});
    const ShownSheet& first = steps_->sheets.front();
    if (!first.bench.empty()) {
      add("bench",
          [&steps = *steps_](const Line& line) {
            return TableCell(steps.sheets[line.bench].bench);
          },
          {.in = for_programs});
    }
    add("step", [](const Line& line) { return number_cell(line.number); },
        {.kind = ColumnKind::number, .css = "step"});
    if (first.times != nullptr) {
      options_.calendar == nullptr ? add_times() : add_days(*options_.calendar);
    }
  }

  // Begin and end of a step.
  void add_times() {
    add("from", [money = money_](const Line& line) { return TableCell(money(line.time->begin)); },
        {.kind = ColumnKind::number, .name = "begin"});
    add("to", [money = money_](const Line& line) { return TableCell(money(line.time->end)); },
        {.kind = ColumnKind::number, .name = "end"});
  }

  // The same as days, with hours of a day.
  void add_days(const BenchCalendar& days) {
    add("day", [days](const Line& line) { return number_cell(days.day(line.time->begin)); },
        {.kind = ColumnKind::number});
    if (!days.iso_date(1).empty()) {
      add("date",
          [days](const Line& line) { return TableCell(days.iso_date(days.day(line.time->begin))); },
          {.in = for_programs});
      add("date",
          [days](const Line& line) { return TableCell(days.date(days.day(line.time->begin))); },
          {.in = for_people});
    }
    add("from\n" + days.unit(),
        [days, money = money_](const Line& line) {
          return TableCell(money(days.hour(line.time->begin)));
        },
        {.kind = ColumnKind::number, .name = "from_" + days.unit()});
    add("to\n" + days.unit(),
        [days, money = money_](const Line& line) {
          const std::uint64_t day = days.last_day(line.time->end);
          const std::string hour = money(days.last_hour(line.time->end));
          const bool same = day == days.day(line.time->begin);
          return TableCell(same ? hour : fmt::format("{} on day {}", hour, day));
        },
        {.kind = ColumnKind::number, .name = "to_" + days.unit()});
  }

  // Columns of changes, if each slot or place has a column.
  void add_changes() {
    const Job* const job = job_;
    const bool by_slot = !job->slots.empty() && !options_.compact;
    const unsigned in = by_slot ? in_text | in_csv : everywhere + 0U;
    const unsigned put_in = by_slot ? in_csv + 0U : in;
    add("take out",
        [job](const Line& line) { return TableCell(names_of(*job, line.step->take_out)); },
        {.kind = ColumnKind::list, .in = in, .name = "take_out"});
    if (job->replaces()) {
      add("put in", [job](const Line& line) { return TableCell(put_in_words(*job, *line.step)); },
          {.kind = ColumnKind::list, .in = in & for_people, .css = "in"});
    }
    add("put in", [job](const Line& line) { return TableCell(names_of(*job, line.step->put_in)); },
        {.kind = ColumnKind::list,
         .in = job->replaces() ? put_in & for_programs : put_in,
         .name = "put_in",
         .css = "in"});
    if (steps_->sheets.front().hand_over != nullptr) {
      add("hand over", [](const Line& line) { return TableCell(*line.hand_over); },
          {.kind = ColumnKind::list, .name = "hand_over"});
    }
  }

  void add_setups() {
    const Job* const job = job_;
    const auto& steps = *steps_;  // the cells refer to it
    if (!options_.compact) {
      add("set-up", [job, &steps](const Line& line) { return terminal_cell(*job, steps, line); },
          {.kind = ColumnKind::list, .in = in_text});
    }
    if (job->slots.empty()) {
      add("set-up",
          [job, &steps](const Line& line) {
            std::vector<SeenPlace> places = seen(*job, steps, line, std::nullopt);
            while (!places.empty() && !places.back().part) {
              places.pop_back();
            }
            return place_cell(*job, places, false);
          },
          {.kind = ColumnKind::list,
           .in = options_.compact ? in_markdown : in_markdown | in_html | in_latex,
           .css = flows_ ? "flow" : "",
           .head_css = "setup"});
    } else if (!options_.compact) {
      for (std::size_t s = 0; s <= job->slots.size(); ++s) {
        const bool free = s == job->slots.size();
        if (free && !has_free_places(steps)) {
          continue;
        }
        const std::uint32_t slot = free ? no_slot : static_cast<std::uint32_t>(s);
        add(free ? "others" : job->slots[s].name,
            [job, &steps, slot](const Line& line) {
              return place_cell(*job, seen(*job, steps, line, slot), true);
            },
            {.kind = ColumnKind::list,
             .in = in_markdown | in_html | in_latex,
             .css = "places",
             .head_is_a_name = !free});
      }
    }
    std::optional<std::uint32_t> before;
    for (std::size_t c = 0; c < steps.placed.places.size(); ++c) {
      const std::uint32_t slot = steps.placed.places[c].slot;
      add(steps.placed.head(*job, c),
          [job, c](const Line& line) {
            const auto& part = (*line.now)[c];
            return part ? TableCell({job->names[*part]}, {part != (*line.before)[c]}) : TableCell();
          },
          {.in = for_programs, .begins_group = before != slot});
      before = slot;
    }
  }

  // For a model: what is set, and the whole test, with a column for each parameter or, if there are
  // many, a list for people.
  void add_values() {
    const auto shown = std::make_shared<const std::vector<ShownValues>>(std::move(values_));
    add("set",
        [shown](const Line& line) {
          std::vector<std::string> words = (*shown)[line.bench].set_in(line.at);
          std::vector<bool> bold(words.size(), true);
          return TableCell(std::move(words), std::move(bold));
        },
        {.kind = ColumnKind::list});
    const Model* const model = job_->model.get();
    const bool many = model->parameters.size() > most_value_columns;
    if (many && !options_.compact) {
      add("test",
          [shown, model](const Line& line) {
            std::vector<std::string> words;
            std::vector<bool> bold;
            for (std::size_t p = 0; p < model->parameters.size(); ++p) {
              const ShownValues& values = (*shown)[line.bench];
              words.push_back(model->parameters[p].name + ": " + values.value(line.at, p));
              bold.push_back(values.is_set(line.at, p));
            }
            return TableCell(std::move(words), std::move(bold));
          },
          {.kind = ColumnKind::list,
           .in = in_html | in_markdown,
           .css = "flow",
           .head_css = "setup"});
    }
    for (std::size_t p = 0; p < model->parameters.size(); ++p) {
      const unsigned in = is_column(*job_, p, options_.compact) ? everywhere : for_programs;
      add(model->parameters[p].name,
          [shown, p](const Line& line) {
            const ShownValues& values = (*shown)[line.bench];
            return TableCell({values.value(line.at, p)}, {values.is_set(line.at, p)});
          },
          {.in = in, .name = value_head(*model, p), .head_is_a_name = true});
    }
  }

  void add_figures() {
    const Job* const job = job_;
    const unsigned unless_compact = options_.compact ? everywhere & ~in_html : everywhere;
    const auto clock = std::make_shared<const Clock>(*job);
    add("new\n" + what_meets(*job),
        [job](const Line& line) { return number_cell(new_here(*job, *line.step)); },
        {.kind = ColumnKind::number, .in = unless_compact, .name = "new_" + what_meets(*job)});
    add("cost", [money = money_](const Line& line) { return TableCell(money(line.step->cost)); },
        {.kind = ColumnKind::cost, .in = job->replaces() ? unless_compact : for_programs});
    add("cost\nso far",
        [money = money_](const Line& line) { return TableCell(money(line.step->cost_so_far)); },
        {.kind = ColumnKind::cost,
         .in = clock->runs() ? in_csv + 0U : unless_compact,
         .name = "cost_so_far"});
    if (clock->runs()) {
      add("clock",
          [clock](const Line& line) { return TableCell((*clock)(line.step->cost_so_far)); },
          {.kind = ColumnKind::number, .in = unless_compact});
    }
    if (!job->weights.empty()) {
      add("weight\nso far",
          [](const Line& line) { return TableCell(to_string(line.step->weight_so_far)); },
          {.kind = ColumnKind::number, .in = unless_compact, .name = "weight_so_far"});
    }
  }

  void add_room_for_results() {
    const auto nothing = [](const Line&) { return TableCell(); };
    add("result", nothing,
        {.kind = ColumnKind::choice,
         .in = for_programs,
         .choices = {
             .words = {"pass", "fail", "unclear"},
             .title = "Result",
             .message = "pass and fail are used to find the faulty part; other words are kept"}});
    add("notes", nothing,
        {.kind = ColumnKind::notes, .in = in_html | in_workbook, .head_css = "notes"});
  }

  const Job* job_;
  Money money_;
  StepTableOptions options_;
  std::shared_ptr<const Steps> steps_;
  std::vector<ShownValues> values_;  // for a model, by sheet
  bool flows_ = false;
  Table table_;
};

}  // namespace

std::string value_style(const Job& job, bool compact) {
  if (job.model == nullptr) {
    return "";
  }
  std::vector<std::string> names{"Set"};
  if (job.model->parameters.size() > most_value_columns && !compact) {
    names.emplace_back("Test");
  }
  for (std::size_t p = 0; p < job.model->parameters.size(); ++p) {
    if (is_column(job, p, compact)) {
      names.push_back(job.model->parameters[p].name);
    }
  }
  if (!compact) {
    names.push_back("New " + what_meets(job));
    if (job.replaces()) {
      names.emplace_back("Cost");
    }
    names.emplace_back(Clock(job).runs() ? "Clock" : "Cost so far");
  }
  std::string style = "  @media screen and (max-width: 40rem) {\n";
  for (std::size_t i = 0; i < names.size(); ++i) {
    style +=
        fmt::format("    .values td:nth-child({})::before {{ content: \"{}: \" !important; }}\n",
                    i + 3, css_text(names[i]));
  }
  return style +
         fmt::format("    .values td:nth-child({})::before {{ content: none !important; }} }}\n",
                     names.size() + 3);
}

Table step_table(const std::vector<ShownSheet>& sheets, const Money& money,
                 const StepTableOptions& options) {
  return StepTable(sheets, money, options).made();
}

}  // namespace changeover
