#include "plan/request/run_workbook.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/plan/job_request.hpp"
#include "core/words.hpp"
#include "io/request/request_document.hpp"
#include "io/scan/peeked_input.hpp"
#include "io/scan/row_reader.hpp"

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

bool RunWorkbook::heads_steps_of_benches(const std::string& wanted) const {
  try {
    const auto head = rows(wanted).next();
    const auto has = [&](std::string_view word) {
      return std::ranges::find(head->cells, word, &SheetCell::text) != head->cells.end();
    };
    return head && has("bench") && has("step") && has("result");
  } catch (const BadInput&) {
    return false;  // What is wrong on a sheet is said where it is read.
  }
}

std::vector<std::string> RunWorkbook::run_sheets() const {
  std::vector<std::string> found;
  for (const SheetName& each : sheets) {
    if (each.hidden || lower_case(each.name) == lower_case(done_sheet)) {
      continue;
    }
    if (lower_case(each.name) == lower_case(steps_sheet)) {
      found.push_back(each.name);
      continue;
    }
    if (heads_steps_of_benches(each.name)) {
      found.push_back(each.name);
    }
  }
  return found;
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
    if (!run.empty() && book->sheet(done_sheet) != nullptr) {
      inputs.push_back(book->open(done_sheet));
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
