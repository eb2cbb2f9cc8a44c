#include "plan/request/workbook/workbook_question.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/plan/job_request.hpp"
#include "core/contains.hpp"
#include "core/each.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/request/request_document.hpp"
#include "io/scan/place.hpp"
#include "io/scan/row_reader.hpp"
#include "io/workbook/workbook_sheet.hpp"
#include "plan/job/bench_jobs.hpp"
#include "plan/job/bench_list.hpp"
#include "plan/job/parts/heading_words.hpp"
#include "plan/job/setups/results.hpp"
#include "plan/job/setups/step_numbers.hpp"
#include "plan/request/asked_benches.hpp"
#include "plan/request/parts_left.hpp"
#include "plan/request/workbook/bench_tabs.hpp"
#include "plan/request/workbook/changed_lists.hpp"
#include "plan/request/workbook/changed_model.hpp"
#include "plan/request/workbook/emptied_places.hpp"
#include "plan/request/workbook/run_workbook.hpp"
#include "plan/request/workbook/sheets_agree.hpp"
#include "plan/sheet/benches/bench_calendar.hpp"
#include "plan/sheet/sheet_document.hpp"

namespace changeover {
namespace {

constexpr std::string_view marker = "changeover-";

// What the hidden sheet says, in one piece.
std::string document_in(const RunWorkbook& book) {
  WorkbookSheet sheet = book.rows(std::string(question_sheet));
  const auto fail = [&](std::uint64_t row, const std::string& what) {
    throw BadInput(
        fmt::format("{}: {}; delete the sheet {} and give the options, or save the "
                    "workbook again from the one that was made",
                    sheet.place(0, row), what, question_sheet));
  };
  const auto head = sheet.next();
  const std::string said = head && head->cells.front().column == 0 ? head->cells.front().text : "";
  if (said != job_table().format) {
    fail(head ? head->number : 1,
         said.starts_with(marker) ? fmt::format("{} is a question of another kind or version, and "
                                                "this program reads {}",
                                                shown(said), job_table().format)
                                  : "the sheet does not contain the request of a plan");
  }
  std::string document;
  std::uint64_t row = head->number;
  while (const auto next = sheet.next()) {
    if (next->number != row + 1 || next->cells.front().column != 0) {
      fail(row + 1, "a part of the request is missing");
    }
    row = next->number;
    document += next->cells.front().text;
  }
  return document;
}

JobRequest question_in(const RunWorkbook& book) {
  const std::string where = fmt::format("{}:{}", book.name, question_sheet);
  JobRequest question;
  try {
    question = job_request(document_in(book));
  } catch (const BadInput& fault) {
    const std::string what = fault.what();
    throw BadInput(what.starts_with(where)
                       ? what
                       : fmt::format("{}: the question is damaged: {}; delete the sheet {} and "
                                     "give the options",
                                     where, what, question_sheet));
  }
  // A workbook from elsewhere must not cause files of this machine to be read.
  for (const auto& option : job_table().options) {
    const auto* const field = std::get_if<RequestList JobRequest::*>(&option.field);
    if (field != nullptr && (!(question.**field).file.empty() || (question.**field).workbook)) {
      throw BadInput(
          fmt::format("{}: {} names a file, which the question of a workbook may not; "
                      "delete the sheet {} and give the options",
                      where, option.record.key, question_sheet));
    }
  }
  if (question.done.is_given() ||
      !(question.parts.is_given() || question.items || question.model.is_given())) {
    throw BadInput(
        fmt::format("{}: the question has no parts, or has tests that were done; delete "
                    "the sheet {} and give the options",
                    where, question_sheet));
  }
  return question;
}

// Moves keys of the stored request that do not fit the requested mode to those that are kept for
// the next workbook.
void put_aside_what_does_not_fit(JobRequest& question, const JobRequest& request,
                                 JobRequest& kept) {
  const auto put_aside = [&](auto... fields) {
    ((kept.*fields = std::exchange(question.*fields, {})), ...);
  };
  if (!request.slot.empty() || request.slots.is_given()) {
    question.slot.clear();
    question.slots = {};
  }
  if (request.benches.number && request.hours.empty() && question.hours.empty()) {
    question.first_day.clear();
    question.weekends = false;
  }
  if (request.diagnose || request.what_if) {
    put_aside(&JobRequest::budget, &JobRequest::title, &JobRequest::compact, &JobRequest::shuffle,
              &JobRequest::weights);
  }
  if (request.what_if) {
    put_aside(&JobRequest::benches, &JobRequest::objective, &JobRequest::hours,
              &JobRequest::first_day, &JobRequest::weekends);
  }
  if (request.diagnose) {
    put_aside(&JobRequest::steps, &JobRequest::first, &JobRequest::trust_failed,
              &JobRequest::what_if);
  }
}

// What is written on the run sheets of a workbook, and the job that they were made for.
struct Written {
  CheckedJobRequest before;  // after the tests on the sheet of those that were done
  std::vector<DoneList> lists;

  [[nodiscard]] bool has_results() const {
    return std::ranges::any_of(lists, &DoneList::has_results);
  }
};

Written written_on(const RunWorkbook& book, const std::vector<std::string>& run,
                   const JobRequest& question) {
  JobRequest before = question;
  if (const auto done = book.tests_done(); !done.empty()) {
    before.done = book.on_sheet(done.front());
  }
  Written written{.before = checked_job(before, Door::document), .lists = {}};
  const Job& job = *written.before->job;
  std::vector<std::unique_ptr<Input>> inputs;
  for (const std::string& sheet : run) {
    const auto& input = inputs.emplace_back(book.open(sheet));
    written.lists.push_back(
        job.model != nullptr
            ? read_done(*input, job)
            : read_done(*input, job.names, most_at_once(job, written.before->benches)));
  }
  std::vector<std::string> said_later;
  take_benches_of_tabs(inputs, written.before->benches, written.lists, said_later);
  make_agree(inputs, written.lists, said_later);
  return written;
}

// A bench whose sheet was taken out of the workbook takes its results along.
void note_lost_sheets(const RunWorkbook& book, const std::vector<std::string>& run,
                      const Written& written, std::vector<std::string>& notes) {
  const std::vector<Bench>& benches = written.before->benches;
  std::vector<bool> named(benches.size(), false);
  for (const std::string& tab : run) {  // the sheet of a bench without tests is empty
    if (const auto bench = bench_of_tab(benches, tab)) {
      named[*bench] = true;
    }
  }
  for (const DoneList& list : written.lists) {
    for (const DoneRow& row : list.rows) {
      if (const auto bench = find_bench(benches, row.bench)) {
        named[*bench] = true;
      }
    }
  }
  std::string without;
  for (std::size_t b = 0; b < benches.size(); ++b) {
    if (!named[b] && !benches[b].down) {
      without += (without.empty() ? "" : ", ") + name_of(benches, b);
    }
  }
  if (!without.empty()) {
    notes.push_back(fmt::format(
        "{}: {} for {}, none with tests of {}; put back a sheet that had results", book.name,
        count_of(run.size(), "sheet"), count_of(benches.size(), "bench", "benches"), without));
  }
}

// Why no result was found on run sheets: no column for them, or what their reader says.
void note_no_results(const RunWorkbook& book, const std::vector<std::string>& run,
                     const Written& written, std::vector<std::string>& notes) {
  for (std::size_t i = 0; i < run.size(); ++i) {
    notes.insert(notes.end(), written.lists[i].notes.begin(), written.lists[i].notes.end());
    WorkbookSheet sheet = book.rows(run[i]);
    const auto head = head_row(sheet);
    if (!head || !result_column(head->heads)) {
      notes.push_back(fmt::format(
          "{}: the sheet has no column of results, so none are read; give it the head result again",
          sheet.place(0, head ? head->number : 1)));
    }
  }
}

// What tests on run sheets cost that have a result: so much of the budget is gone.
void take_off_budget(JobRequest& question, const std::string& name, const Written& written,
                     std::vector<std::string>& notes) {
  const Job& job = *written.before->job;
  const std::vector<Bench>& benches = written.before->benches;
  std::vector<std::vector<Block>> done(std::max<std::size_t>(1, benches.size()));
  std::uint64_t tests = 0;
  std::vector<DoneRow> rows;
  std::vector<std::size_t> begins;
  for (const DoneList& list : written.lists) {
    begins.push_back(rows.size());
    rows.insert(rows.end(), list.rows.begin(), list.rows.end());
  }
  put_sheets_in_order(rows, begins);
  for (const DoneRow& row : rows) {
    if (was_run(row.result)) {
      done[find_bench(benches, row.bench).value_or(0)].push_back(row.setup);
      ++tests;
    }
  }
  Amount spent;
  for (std::size_t b = 0; b < done.size(); ++b) {
    if (!done[b].empty()) {
      spent += run_sheet(benches.empty() ? job : job_of_bench(job, benches[b]), done[b]).cost;
    }
  }
  const Amount all = parse_amount(question.budget);
  const Amount left = spent < all ? all - spent : Amount{};
  notes.push_back(fmt::format("{}: {} of the budget of {} is spent on {}, {} is left", name,
                              to_string(spent), to_string(all), count_of(tests, "test"),
                              to_string(left)));
  question.budget = to_string(left);
}

bool is_day(const std::string& text) {
  try {
    static_cast<void>(parse_day(text));
    return true;
  } catch (const BadInput&) {
    return false;
  }
}

// The day of the next tests, as the sheets of benches have it: that of the first test without a
// result, but no day before that of a test with one.
void begin_where_it_ends(JobRequest& question, const RunWorkbook& book,
                         const std::vector<std::string>& run, std::vector<std::string>& notes) {
  std::string last_done;
  std::string first_left;
  for (const std::string& name : run) {
    WorkbookSheet sheet = book.rows(name);
    const auto head = head_row(sheet);
    const auto found = head ? std::ranges::find(head->heads, "date") : Heads::const_iterator();
    const auto result = head ? result_column(head->heads) : std::nullopt;
    const bool is_dated = head && found != head->heads.end() && result;
    while (const auto row = is_dated ? sheet.next() : std::nullopt) {
      const auto date = static_cast<std::size_t>(found - head->heads.begin());
      const std::string day = cell_text(*row, date);
      if (!is_day(day)) {
        continue;
      }
      if (was_run(cell_text(*row, *result))) {
        last_done = std::max(last_done, day);
      } else if (first_left.empty() || day < first_left) {
        first_left = day;
      }
    }
  }
  const std::string day = std::max(last_done, first_left);
  if (day > question.first_day) {
    notes.push_back(fmt::format(
        "{}: the rest begins on {}, by its sheets; give another first day if it does not",
        book.name, day));
    question.first_day = day;
  }
}

bool is_one_of(const std::string& name, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, lower_case(name)) != words.end();
}

bool has_parts(const std::string& name) {
  return heads_parts(name) ||
         is_one_of(name, {"inventory", "bom", "stock", "parts list", "part list", "stückliste",
                          "bestand", "materials", "reagents", "hardware"});
}

// A list and the sheet names (in lower case) by which it is recognised.
struct KnownSheet {
  std::string_view key;
  RequestList JobRequest::*list;
  std::string_view what;
  std::initializer_list<std::string_view> names;
};

const std::array<KnownSheet, 5>& known_sheets() {
  static const std::array<KnownSheet, 5> known{
      {{"slots",
        &JobRequest::slots,
        "slots",
        {"slots", "slot", "slot limits", "sockets", "bays", "steckplätze"}},
       {"never",
        &JobRequest::never,
        "forbidden pairs",
        {"never", "never together", "not together", "forbidden", "forbidden pairs", "incompatible",
         "incompatibilities", "exclusions", "excluded", "conflicts", "verboten", "unverträglich",
         "incompatibles", "incompatibilités", "incompatibilidades", "prohibido", "vietato"}},
       {"weights",
        &JobRequest::weights,
        "priorities",
        {"priority", "priorities", "weights", "prioritäten", "priorités", "prioridades"}},
       {"change_costs",
        &JobRequest::change_costs,
        "costs by what is replaced",
        {"change costs", "changeover costs", "changeover times", "cleaning", "cleaning costs",
         "cleaning times", "rüstkosten", "reinigung"}},
       {"benches", &JobRequest::benches, "benches", {"benches", "test benches", "prüfstände"}}}};
  return known;
}

// The list of a sheet, by its name; null if unknown.
const KnownSheet* known_as(const SheetName& sheet) {
  const auto found = std::ranges::find_if(
      known_sheets(), [&](const KnownSheet& known) { return is_one_of(sheet.name, known.names); });
  return found == known_sheets().end() ? nullptr : &*found;
}

// Whether a request already has the list of such a sheet.
bool says(const JobRequest& request, const KnownSheet& known) {
  return (request.*known.list).is_given() || (known.key == "slots" && !request.slot.empty());
}

// Text such as "slots from 'Slots', forbidden pairs from 'Never'".
void add_taken(std::string& taken, std::string_view what, const std::string& sheet) {
  taken += fmt::format("{}{} from {}", taken.empty() ? "" : ", ", what, shown(sheet));
}

// Takes the lists that the user changed on the sheets of a workbook since it was written for a job.
void take_changed_sheets(JobRequest& request, JobRequest& question, const RunWorkbook& book,
                         const Job& job, std::vector<std::string>& notes) {
  TableDocument document;
  add_lists_of_job(document, job, Money(job), question.benches);
  const auto section = [&](const SheetName& sheet) -> const TableSection* {
    const auto found = std::ranges::find_if(document.sections, [&](const TableSection& each) {
      return lower_case(each.sheet) == lower_case(sheet.name);
    });
    return found == document.sections.end() ? nullptr : &*found;
  };
  std::string taken;
  const bool of_model = job.model != nullptr;  // its values and rules are in its text
  const SheetName* const parts = book.sheet(of_model ? costs_sheet : parts_sheet);
  const TableSection* const as_made = parts == nullptr ? nullptr : section(*parts);
  const bool is_changed =
      as_made != nullptr && !parts->hidden && !is_as_written(book, parts->name, as_made->table);
  if (is_changed && of_model && !request.change_costs.is_given()) {
    add_taken(taken, "costs", parts->name);
    request.change_costs = changed_costs(*book.open(parts->name), job);
  }
  const bool parts_changed = is_changed && !of_model;
  if (parts_changed) {
    add_taken(taken, "parts", parts->name);
    request.parts = book.on_sheet(parts->name);
    question.parts = {};
    question.items.reset();
  }
  for (const SheetName& sheet : book.sheets) {
    const KnownSheet* const known = known_as(sheet);
    if (sheet.hidden || known == nullptr || says(request, *known) ||
        (of_model && known->key == "slots")) {
      continue;
    }
    const TableSection* const written = section(sheet);
    // If parts were removed, reading the sheet reports them with their place.
    if (written == nullptr || parts_changed || !is_as_written(book, sheet.name, written->table)) {
      add_taken(taken, known->what, sheet.name);
      request.*known->list = book.on_sheet(sheet.name);
    }
  }
  if (!taken.empty()) {
    notes.push_back(fmt::format("{}: {}, changed since the plan was made", book.name, taken));
  }
}

// The question of the workbook comes first, then what was filled in.
JobRequest with_question(JobRequest request, const RunWorkbook& book,
                         std::vector<std::string>& notes, JobRequest& kept) {
  JobRequest question = question_in(book);
  // It is about tests that were done, which are not in the question.
  const bool trusts_failed = std::exchange(question.trust_failed, false);
  JobRequest plain = request;
  plain.parts = {};
  plain.places = {};
  plain.steps.reset();  // how long is searched, and how, is no part of the question
  plain.seconds.reset();
  plain.threads.reset();
  plain.seed.reset();
  notes.push_back(fmt::format("{}: the question is that of its hidden sheet {}{}", book.name,
                              question_sheet,
                              plain == JobRequest() ? "" : ", but for what is asked now"));
  request.parts = {};
  const std::vector<std::string> run = book.run_sheets(request.done.is_given() ? nullptr : &notes);
  const bool has_done = !book.tests_done().empty();
  if (!request.done.is_given()) {
    book.note_unread_results(notes);
  }
  if (has_done && run.empty() && !request.done.is_given()) {
    request.done = book.list;
  }
  if (!request.done.is_given() && run.empty()) {
    notes.push_back(book.name +
                    ": none of its sheets has the columns of a run sheet, so no results "
                    "are read; give that sheet its heads step and slot_1, slot_2, … again");
  }
  if (!run.empty() && !request.done.is_given()) {
    const Written written = written_on(book, run, question);
    const bool has_results = written.has_results();
    for (std::size_t i = 0; i < run.size(); ++i) {
      refuse_emptied_places(book.name + ":" + run[i], written.lists[i], *written.before->job,
                            written.before->benches);
    }
    note_lost_sheets(book, run, written, notes);
    if (written.before->benches.empty()) {
      note_lost_steps(book.name, written.before->job->last_step, written.lists, notes);
    }
    if (has_results || has_done || request.diagnose) {
      request.done = book.list;
    } else {
      note_no_results(book, run, written, notes);
    }
    if (has_results) {
      if (!question.budget.empty() && request.budget.empty()) {
        take_off_budget(question, book.name, written, notes);
      }
      if (!question.first_day.empty() && request.first_day.empty()) {
        begin_where_it_ends(question, book, run, notes);
      }
      if (written.before->benches.empty()) {
        question.start.clear();  // that was before the first of them
      }
    }
  }
  const CheckedJobRequest as_made = checked_job(question, Door::document);
  const bool has_costs = request.change_costs.is_given();
  take_changed_sheets(request, question, book, *as_made->job, notes);
  if (request.model.is_given() && as_made->job->model != nullptr) {
    take_other_model(request, question, book.name, !has_costs, notes);
  }
  if (request.what_if && question.benches.is_given()) {
    notes.push_back(book.name +
                    ": its question is of several benches; the ratios are those of all "
                    "tests on one bench");
  }
  (request.done.is_given() ? question : kept).trust_failed = trusts_failed;
  // Values of a model that broke are in its text all the same.
  for (const std::string& value : question.without) {
    if (!request.without.empty() && !contains(request.without, value)) {
      request.without.push_back(value);
    }
  }
  put_aside_what_does_not_fit(question, request, kept);
  complete(request, std::move(question));
  return request;
}

// A sheet whose name says nothing may have rules that people count on.
void note_skipped_sheets(const RunWorkbook& book, const SheetName* parts,
                         std::vector<std::string>& notes) {
  const std::vector<std::string> run = book.run_sheets();
  const auto done = book.tests_done();
  std::vector<std::string> skipped;
  for (const SheetName& sheet : book.sheets) {
    const bool is_read_or_named = &sheet == parts || known_as(sheet) != nullptr ||
                                  contains(done, sheet.name) ||
                                  std::ranges::find(run, sheet.name) != run.end();
    if (!sheet.hidden && !is_read_or_named) {
      skipped.push_back(sheet.name);
    }
  }
  if (!skipped.empty()) {
    notes.push_back(fmt::format(
        "{}: not read, since {}: {}; rules are read from sheets called "
        "Slots, Never, Priorities, Change costs and Benches",
        book.name, skipped.size() == 1 ? "its name says no list" : "their names say none",
        joined(skipped, shown)));
  }
}

JobRequest with_other_sheets(JobRequest request, const RunWorkbook& book,
                             std::vector<std::string>& notes) {
  std::string taken;
  const SheetName* parts = nullptr;
  const SheetName* first = nullptr;
  for (const SheetName& sheet : book.sheets) {
    if (!sheet.hidden) {
      first = first == nullptr ? &sheet : first;
      const bool better = parts == nullptr || (!has_parts(parts->name) && has_parts(sheet.name));
      parts = known_as(sheet) == nullptr && better ? &sheet : parts;
    }
  }
  if (parts != nullptr && parts != first) {
    add_taken(taken, "parts", parts->name);
    request.parts = book.on_sheet(parts->name);
  }
  for (const SheetName& sheet : book.sheets) {
    const KnownSheet* const known = known_as(sheet);
    if (!sheet.hidden && &sheet != parts && known != nullptr && !says(request, *known)) {
      add_taken(taken, known->what, sheet.name);
      request.*known->list = book.on_sheet(sheet.name);
    }
  }
  if (!taken.empty()) {
    notes.push_back(fmt::format("{}: {}, by the names of its sheets", book.name, taken));
  }
  note_skipped_sheets(book, parts, notes);
  // Without results they count as a plan and not as tests, so they are not taken unasked.
  const std::vector<std::string> run =
      request.done.is_given() ? std::vector<std::string>() : book.run_sheets();
  if (!run.empty()) {
    notes.push_back(
        fmt::format("{}: results on its run sheets '{}' are not read; give the "
                    "workbook as done tests, too, if there are any",
                    book.name, fmt::join(run, "', '")));
  }
  return request;
}

}  // namespace

std::vector<std::string> question_pieces(const std::string& document) {
  constexpr std::size_t most = 8000;
  std::vector<std::string> pieces;
  std::size_t begin = 0;
  while (begin < document.size()) {
    std::size_t end = begin;
    while (end < document.size() && end - begin < most) {
      end += first_code_point(std::string_view(document).substr(end)).bytes;
    }
    pieces.push_back(document.substr(begin, end - begin));
    begin = end;
  }
  return pieces;
}

OpenedRequest open_workbook(JobRequest request) {
  OpenedRequest opened{.request = std::move(request), .notes = {}};
  const auto book = run_workbook(opened.request.parts, "parts");
  if (!book) {
    return opened;
  }
  opened.request = book->sheet(question_sheet) != nullptr
                       ? with_question(std::move(opened.request), *book, opened.notes, opened.kept)
                       : with_other_sheets(std::move(opened.request), *book, opened.notes);
  return opened;
}

}  // namespace changeover
