#include "plan/request/workbook_question.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/utf8.hpp"
#include "core/words.hpp"
#include "io/request/request_document.hpp"
#include "io/scan/place.hpp"
#include "io/scan/row_reader.hpp"
#include "io/workbook/workbook_sheet.hpp"
#include "plan/job/parts/heading_words.hpp"
#include "plan/request/done_tests.hpp"
#include "plan/sheet/sheet_document.hpp"

namespace changeover {
namespace {

constexpr std::size_t most_bytes_of_a_workbook = std::size_t{1} << 26;
constexpr std::string_view how_to_mend = "save only the sheets that are needed";
constexpr std::string_view marker = "changeover-";

// A workbook in memory, and the names of lists on its sheets.
struct Book {
  std::string bytes;
  std::string name;  // for messages
  std::vector<SheetName> sheets;
  RequestList list;  // as it was given

  [[nodiscard]] const SheetName* sheet(std::string_view wanted) const {
    const auto found = std::ranges::find_if(
        sheets, [&](const SheetName& each) { return lower(each.name) == lower(wanted); });
    return found == sheets.end() ? nullptr : &*found;
  }
  [[nodiscard]] RequestList on_sheet(const std::string& wanted) const {
    RequestList on = list;
    list.workbook ? on.sheet = wanted : on.file += ":" + wanted;
    return on;
  }
};

// The workbook of a list, if no sheet of it is named. A file that can be read only once is not
// opened.
std::optional<Book> book_of(const RequestList& list, const std::string& spelled) {
  Book book{.bytes = {}, .name = spelled, .sheets = {}, .list = list};
  if (list.workbook && list.sheet.empty()) {
    book.bytes = *list.workbook;
  } else {
    std::error_code ignored;
    if (list.file.empty() || !std::filesystem::is_regular_file(list.file, ignored)) {
      return std::nullopt;
    }
    const auto input = open_input(list.file);
    constexpr std::size_t mark = 8;
    PeekedInput peeked(*input, mark);
    if (!begins_like_a_workbook(peeked.beginning())) {
      return std::nullopt;
    }
    book.bytes = read_to_end(peeked, most_bytes_of_a_workbook, how_to_mend);
    book.name = input->name();
  }
  book.sheets = workbook_sheets(book.bytes, book.name);
  return book;
}

// The content of the hidden sheet, in one piece.
std::string document_in(const Book& book) {
  WorkbookSheet sheet(book.bytes, book.name, std::string(question_sheet));
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
                                  : "this is not the question of a plan");
  }
  std::string document;
  std::uint64_t row = head->number;
  while (const auto next = sheet.next()) {
    if (next->number != row + 1 || next->cells.front().column != 0) {
      fail(row + 1, "a piece of the question is missing");
    }
    row = next->number;
    document += next->cells.front().text;
  }
  return document;
}

JobRequest question_in(const Book& book) {
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

// Removes keys of the stored request that do not fit the requested mode.
void drop_what_does_not_fit(JobRequest& question, const JobRequest& request) {
  if (!request.slot.empty() || request.slots.is_given()) {
    question.slot.clear();
    question.slots = {};
  }
  if (request.diagnose || request.what_if) {
    question.budget.clear();
    question.title.clear();
    question.compact = false;
    question.shuffle.reset();
    question.weights = {};
  }
  if (request.diagnose) {
    question.steps.reset();
    question.first = {};
    question.trust_failed = false;
    question.what_if = false;
  }
}

// Deducts the cost of tests on the run sheet that have a result from the budget.
void take_off_budget(JobRequest& question, const Book& book, const ParsedJob& before,
                     std::vector<std::string>& notes) {
  SheetInput sheet(input_from_text(book.bytes, book.name), std::string(steps_sheet));
  const DoneList list = read_done(sheet, *before.job);
  std::vector<Block> done;
  for (std::size_t i = 0; i < list.setups.size(); ++i) {
    const TestResult result = result_of(list.results[i]);
    if (result != TestResult::none && result != TestResult::not_run) {
      done.push_back(list.setups[i]);
    }
  }
  const Amount all = parse_amount(question.budget);
  const Amount spent = run_sheet(*before.job, done).cost;
  const Amount left = spent < all ? all - spent : Amount{};
  notes.push_back(fmt::format("{}: {} of the budget of {} is spent on {}, {} is left", book.name,
                              to_string(spent), to_string(all), count_of(done.size(), "test"),
                              to_string(left)));
  question.budget = to_string(left);
}

bool is_one_of(const std::string& name, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, lower(name)) != words.end();
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

const std::array<KnownSheet, 4>& known_sheets() {
  static const std::array<KnownSheet, 4> known{
      {{"slots", &JobRequest::slots, "slots", {"slots", "slot", "slot limits", "sockets", "bays"}},
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
         "cleaning times", "rüstkosten", "reinigung"}}}};
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

// Whether two cells have the same text or number: spreadsheets format them differently.
bool is_same(const std::string& one, const std::string& other) {
  if (one == other) {
    return true;
  }
  try {
    return parse_amount(one) == parse_amount(other);
  } catch (const Error&) {
    return false;
  }
}

// Whether a sheet still has the content of this table, which was written into the workbook.
bool is_as_written(const Book& book, const std::string& name, const Table& table) {
  WorkbookSheet sheet(book.bytes, book.name, name);
  const auto is_row = [&](const SheetRow& row, auto&& text_of) {
    std::size_t cell = 0;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      const bool is_there = cell < row.cells.size() && row.cells[cell].column == c;
      const std::string text = is_there ? row.cells[cell].text : "";
      cell += is_there ? 1U : 0U;
      if (!(c == 0 ? text == text_of(c) : is_same(text, text_of(c)))) {
        return false;
      }
    }
    return cell == row.cells.size();
  };
  const auto head = sheet.next();
  if (!head || !is_row(*head, [&](std::size_t c) { return table.columns[c].head; })) {
    return false;
  }
  for (std::size_t i = 0; i < table.rows; ++i) {
    const auto row = sheet.next();
    if (!row ||
        !is_row(*row, [&](std::size_t c) { return joined(table.columns[c].cell(i).words); })) {
      return false;
    }
  }
  return !sheet.next();
}

// Takes lists that the user changed on the sheets of a workbook since it was written for a job.
void take_changed_sheets(JobRequest& request, JobRequest& question, const Book& book,
                         const Job& job, std::vector<std::string>& notes) {
  if (job.model != nullptr) {
    return;  // its values and rules are in its text
  }
  TableDocument document;
  add_lists_of_job(document, job, Money(job));
  const auto section = [&](const SheetName& sheet) -> const TableSection* {
    const auto found = std::ranges::find_if(document.sections, [&](const TableSection& each) {
      return lower(each.sheet) == lower(sheet.name);
    });
    return found == document.sections.end() ? nullptr : &*found;
  };
  std::string taken;
  const SheetName* const parts = book.sheet(parts_sheet);
  const bool parts_changed = parts != nullptr && !parts->hidden &&
                             !is_as_written(book, parts->name, section(*parts)->table);
  if (parts_changed) {
    add_taken(taken, "parts", parts->name);
    request.parts = book.on_sheet(parts->name);
    question.parts = {};
    question.items.reset();
  }
  for (const SheetName& sheet : book.sheets) {
    const KnownSheet* const known = known_as(sheet);
    if (sheet.hidden || known == nullptr || says(request, *known)) {
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

// Completes the request from the workbook, and takes what was filled in.
JobRequest with_question(JobRequest request, const Book& book, std::vector<std::string>& notes) {
  JobRequest question = question_in(book);
  JobRequest plain = request;
  plain.parts = {};
  notes.push_back(fmt::format("{}: the question is that of its hidden sheet {}{}", book.name,
                              question_sheet,
                              plain == JobRequest() ? "" : ", but for what is asked now"));
  request.parts = {};
  const bool has_steps = book.sheet(steps_sheet) != nullptr;
  const bool has_done = book.sheet(done_sheet) != nullptr;
  if (has_done && !has_steps && !request.done.is_given()) {
    request.done = book.on_sheet(std::string(done_sheet));
  }
  if (has_steps && !request.done.is_given()) {
    JobRequest before = question;
    if (has_done) {
      before.done = book.on_sheet(std::string(done_sheet));
    }
    const ParsedJob asked = checked_job(before, Door::document);
    SheetInput steps(input_from_text(book.bytes, book.name), std::string(steps_sheet));
    const bool has_results = read_done(steps, *asked.job).has_results();
    if (has_results || has_done || request.diagnose) {
      request.done = book.list;
    }
    if (has_results) {
      if (!question.budget.empty() && request.budget.empty() && !request.diagnose) {
        take_off_budget(question, book, asked, notes);
      }
      question.start.clear();  // it was mounted before the first of these tests
    }
  }
  const ParsedJob as_made = checked_job(question, Door::document);
  take_changed_sheets(request, question, book, *as_made.job, notes);
  drop_what_does_not_fit(question, request);
  complete(request, std::move(question));
  return request;
}

JobRequest with_other_sheets(JobRequest request, const Book& book,
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
  // Without results they are a plan and no tests, so they are only taken on request.
  const std::vector<std::string> benches =
      request.done.is_given() ? std::vector<std::string>() : bench_sheets(book.list.file);
  if (!benches.empty()) {
    notes.push_back(
        fmt::format("{}: results on its run sheets '{}' are not read; give the "
                    "workbook as done tests, too, if there are any",
                    book.name, fmt::join(benches, "', '")));
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

std::vector<std::unique_ptr<Input>> open_done(const RequestList& list, const std::string& spelled) {
  std::vector<std::unique_ptr<Input>> inputs;
  if (const auto book = book_of(list, spelled);
      book && book->sheet(done_sheet) != nullptr && book->sheet(steps_sheet) != nullptr) {
    for (const std::string_view sheet : {done_sheet, steps_sheet}) {
      inputs.push_back(std::make_unique<SheetInput>(input_from_text(book->bytes, book->name),
                                                    std::string(sheet)));
    }
    return inputs;
  }
  inputs.push_back(open(list, option_of(job_table(), "done").record, spelled));
  return inputs;
}

OpenedRequest open_workbook(JobRequest request) {
  OpenedRequest opened{.request = std::move(request), .notes = {}};
  const auto book = book_of(opened.request.parts, "parts");
  if (!book) {
    return opened;
  }
  opened.request = book->sheet(question_sheet) != nullptr
                       ? with_question(std::move(opened.request), *book, opened.notes)
                       : with_other_sheets(std::move(opened.request), *book, opened.notes);
  return opened;
}

}  // namespace changeover
