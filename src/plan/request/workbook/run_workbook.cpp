#include "plan/request/workbook/run_workbook.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/plan/job_request.hpp"
#include "core/each.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/request/request_document.hpp"
#include "io/scan/peeked_input.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/job/parts/heading_words.hpp"

namespace changeover {
namespace {

constexpr std::size_t most_bytes_of_a_workbook = std::size_t{1} << 26;
constexpr std::string_view how_to_mend = "save only the sheets that are needed";

// The bytes of a workbook as often as its sheets are read.
class SharedBytes final : public Input {
 public:
  SharedBytes(std::shared_ptr<const std::string> bytes, std::string name)
      : Input(std::move(name)), bytes_(std::move(bytes)) {}

  std::size_t read(std::span<char> buffer) override {
    const std::size_t count = bytes_->copy(buffer.data(), buffer.size(), next_);
    next_ += count;
    return count;
  }
  bool rewind() override {
    next_ = 0;
    return true;
  }

 private:
  std::shared_ptr<const std::string> bytes_;
  std::size_t next_ = 0;
};

}  // namespace

const SheetName* RunWorkbook::sheet(std::string_view wanted) const {
  const auto found = std::ranges::find_if(
      sheets, [&](const SheetName& each) { return lower_case(each.name) == lower_case(wanted); });
  return found == sheets.end() ? nullptr : &*found;
}

RequestList RunWorkbook::on_sheet(const std::string& wanted) const {
  RequestList on = list;
  list.workbook ? on.sheet = wanted : on.file += ":" + wanted;
  return on;
}

std::unique_ptr<Input> RunWorkbook::open(std::string_view wanted) const {
  return std::make_unique<SheetInput>(std::make_unique<SharedBytes>(bytes, name),
                                      std::string(wanted));
}

WorkbookSheet RunWorkbook::rows(const std::string& wanted) const {
  return WorkbookSheet(*bytes, name, wanted);
}

std::optional<HeadRow> head_row(WorkbookSheet& sheet) {
  for (std::size_t above = 0; above <= most_titles; ++above) {
    const auto row = sheet.next();
    if (!row) {
      return std::nullopt;
    }
    HeadRow head{.number = row->number, .heads = Heads(row->cells.back().column + 1)};
    for (const SheetCell& cell : row->cells) {
      const std::size_t begin = std::min(cell.text.find_first_not_of(' '), cell.text.size());
      head.heads[cell.column] =
          cell.text.substr(begin, cell.text.find_last_not_of(' ') + 1 - begin);
    }
    if (shape_of(head.heads) != SheetShape::other) {
      return head;
    }
    if (row->cells.size() > 1) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

std::string cell_text(const SheetRow& row, std::size_t column) {
  const auto found = std::ranges::find(row.cells, column, &SheetCell::column);
  return found == row.cells.end() ? std::string() : found->text;
}

SheetShape RunWorkbook::shape(const std::string& wanted) const {
  try {
    WorkbookSheet sheet = rows(wanted);
    const auto head = head_row(sheet);
    return head ? shape_of(head->heads) : SheetShape::other;
  } catch (const BadInput&) {
    return SheetShape::other;  // What is wrong on a sheet is said where it is read.
  }
}

namespace {

// What copies of a sheet share, and how many results this one has.
struct SheetOfSteps {
  std::string name;
  std::set<std::vector<std::string>> tests;  // bench, step and set-up of each
  std::size_t results = 0;
  bool is_numbered = false;
};

SheetOfSteps steps_on(const RunWorkbook& book, const std::string& name) {
  SheetOfSteps steps{.name = name, .tests = {}};
  try {
    WorkbookSheet sheet = book.rows(name);
    const auto head = head_row(sheet);
    const auto result = head ? result_column(head->heads) : std::nullopt;
    const auto step = head ? step_column(head->heads) : std::nullopt;
    steps.is_numbered = step.has_value();
    while (const auto row = head ? sheet.next() : std::nullopt) {
      std::vector<std::string> test;
      for (std::size_t c = 0; c < head->heads.size(); ++c) {
        if (c == step || place_in(head->heads[c]) || lower_case(head->heads[c]) == "bench") {
          test.push_back(cell_text(*row, c));
        }
      }
      steps.tests.insert(std::move(test));
      steps.results += result && !cell_text(*row, *result).empty() ? 1U : 0U;
    }
  } catch (const BadInput&) {
    steps.tests.clear();  // What is wrong on a sheet is said where it is read.
  }
  return steps;
}

// Whether one of the first rows has a head of results beside others.
bool has_head_of_results(const RunWorkbook& book, const SheetName& name) {
  try {
    WorkbookSheet sheet = book.rows(name.name);
    for (std::size_t above = 0; above <= most_titles; ++above) {
      const auto row = sheet.next();
      if (!row) {
        return false;
      }
      if (row->cells.size() > 1) {
        return std::ranges::any_of(row->cells,
                                   [](const SheetCell& cell) { return heads_results(cell.text); });
      }
    }
  } catch (const BadInput&) {
    return false;  // What is wrong on a sheet is said where it is read.
  }
  return false;
}

// Whether half of the tests of the shorter sheet are on both.
bool are_copies(const SheetOfSteps& one, const SheetOfSteps& other) {
  const auto shared = static_cast<std::size_t>(std::ranges::count_if(
      one.tests, [&](const auto& test) { return other.tests.count(test) != 0; }));
  return shared > 0 && 2 * shared >= std::min(one.tests.size(), other.tests.size());
}

// Leaves out copies of sheets that have fewer results. Steps with numbers are compared one by one.
std::vector<std::string> without_copies(const RunWorkbook& book,
                                        const std::vector<std::string>& found,
                                        std::vector<std::string>* notes) {
  std::vector<SheetOfSteps> kept;
  for (const std::string& name : found) {
    SheetOfSteps next = steps_on(book, name);
    const auto same = std::ranges::find_if(kept, [&](const SheetOfSteps& each) {
      return !(each.is_numbered && next.is_numbered) && are_copies(each, next);
    });
    if (same == kept.end()) {
      kept.push_back(std::move(next));
      continue;
    }
    if (next.results > same->results) {
      std::swap(*same, next);
    }
    if (notes != nullptr) {
      notes->push_back(fmt::format(
          "{}: {} is read, with {}, and not its copy {}, with {}; delete the one that is not meant",
          book.name, shown(same->name), count_of(same->results, "result"), shown(next.name),
          next.results));
    }
  }
  return each_of<std::string>(kept, &SheetOfSteps::name);
}

}  // namespace

std::vector<std::string> RunWorkbook::run_sheets(std::vector<std::string>* notes) const {
  std::vector<std::string> found;
  for (const SheetName& each : sheets) {
    if (!each.hidden && lower_case(each.name) != lower_case(done_sheet) &&
        (lower_case(each.name) == lower_case(steps_sheet) ||
         shape(each.name) == SheetShape::steps)) {
      found.push_back(each.name);
    }
  }
  return found.size() < 2 ? found : without_copies(*this, found, notes);
}

std::vector<std::string> RunWorkbook::tests_done() const {
  std::vector<std::string> found;
  const SheetName* const named = sheet(done_sheet);
  if (named != nullptr) {
    found.push_back(named->name);
  }
  for (const SheetName& each : sheets) {
    if (&each != named && !each.hidden && lower_case(each.name) != lower_case(steps_sheet) &&
        shape(each.name) == SheetShape::done && steps_on(*this, each.name).results > 0) {
      found.push_back(each.name);
    }
  }
  return found;
}

std::vector<std::string> RunWorkbook::unread_results() const {
  std::vector<std::string> found;
  for (const SheetName& each : sheets) {
    const bool is_known = each.hidden || lower_case(each.name) == lower_case(done_sheet) ||
                          lower_case(each.name) == lower_case(steps_sheet);
    if (!is_known && shape(each.name) == SheetShape::other && has_head_of_results(*this, each)) {
      found.push_back(each.name);
    }
  }
  return found;
}

std::vector<std::string> RunWorkbook::hidden_results() const {
  std::vector<std::string> found;
  for (const SheetName& each : sheets) {
    if (each.hidden && lower_case(each.name) != lower_case(done_sheet) &&
        lower_case(each.name) != lower_case(question_sheet) &&
        shape(each.name) != SheetShape::other && steps_on(*this, each.name).results > 0) {
      found.push_back(each.name);
    }
  }
  return found;
}

void RunWorkbook::note_unread_results(std::vector<std::string>& notes) const {
  if (const std::vector<std::string> unread = unread_results(); !unread.empty()) {
    notes.push_back(fmt::format(
        "{}: the results on {} are not read; give such a sheet the heads slot_1, slot_2, … above "
        "its parts",
        name, joined(unread, shown)));
  }
  if (const std::vector<std::string> hidden = hidden_results(); !hidden.empty()) {
    notes.push_back(fmt::format(
        "{}: the results on the hidden {} {} are not read; show what counts, and delete the rest",
        name, hidden.size() == 1 ? "sheet" : "sheets", joined(hidden, shown)));
  }
}

std::optional<RunWorkbook> run_workbook(const RequestList& list, const std::string& spelled) {
  RunWorkbook book{.bytes = {}, .name = spelled, .sheets = {}, .list = list};
  std::string bytes;
  if (list.workbook && list.sheet.empty()) {
    bytes = *list.workbook;
  } else {
    std::error_code ignored;
    if (list.file.empty() || !std::filesystem::is_regular_file(list.file, ignored)) {
      return std::nullopt;
    }
    const auto input = open_input(list.file);
    constexpr std::size_t mark = 8;
    PeekedInput peeked(*input, mark);
    if (peeked.beginning().empty() && lower_case(list.file).ends_with(".xlsx")) {
      throw BadInput(list.file + ": the file is empty; save the workbook again");
    }
    const bool is_cut =
        peeked.beginning().size() < mark && lower_case(list.file).ends_with(".xlsx");
    if (!begins_like_a_workbook(peeked.beginning()) && !is_cut) {
      return std::nullopt;
    }
    bytes = read_to_end(peeked, most_bytes_of_a_workbook, how_to_mend);
    book.name = input->name();
  }
  book.sheets = workbook_sheets(bytes, book.name);
  book.bytes = std::make_shared<const std::string>(std::move(bytes));
  return book;
}

std::vector<std::unique_ptr<Input>> open_done(const RequestList& list, const std::string& spelled) {
  std::vector<std::unique_ptr<Input>> inputs;
  if (const auto book = run_workbook(list, spelled)) {
    const std::vector<std::string> run = book->run_sheets();
    const bool is_ours = !run.empty() || book->sheet(question_sheet) != nullptr;
    for (const std::string& done : is_ours ? book->tests_done() : std::vector<std::string>()) {
      inputs.push_back(book->open(done));
    }
    for (const std::string& sheet : run) {
      inputs.push_back(book->open(sheet));
    }
  }
  if (inputs.empty()) {
    inputs.push_back(open(list, option_of(job_table(), "done").record, spelled));
  }
  return inputs;
}

}  // namespace changeover
