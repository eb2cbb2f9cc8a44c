// A workbook, from any bytes: those of the file, or the text of its members, each after a line
// "==== NAME", that are packed here. A sheet is read to its end or refused in one line, and so is a
// list of parts on it.
#include <zip.h>

#include "changeover/plan/job_request.hpp"
#include "io/workbook/cell_text.hpp"
#include "io/workbook/workbook_sheet.hpp"
#include "support/promises.hpp"
#include "zip_files.hpp"

namespace changeover::fuzz::workbook_fuzz {
namespace {

constexpr std::uint64_t most_parts_here = 40;

std::string packed(const std::string& text) {
  constexpr std::string_view mark = "==== ";
  test::Members members;
  std::string* member = nullptr;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    const std::string line = text.substr(at, end - at);
    at = end;
    if (line.starts_with(mark)) {
      std::string name = line.substr(mark.size());
      std::erase_if(name, [](char c) { return c == '\n' || c == '\0'; });
      member = name.empty() || !is_one_plain_line(name) ? nullptr : &members[name];
    } else if (member != nullptr) {
      *member += line;
    }
  }
  return members.empty() ? "" : test::zipped(members);
}

const Target target("workbook", [](const std::string& bytes) {
  const std::string workbook = begins_like_a_workbook(bytes) ? bytes : packed(bytes);
  if (workbook.empty()) {
    return;
  }
  for (const std::optional<std::string>& name :
       {std::optional<std::string>(), std::optional<std::string>("Costs")}) {
    accepts([&] {
      WorkbookSheet sheet(workbook, "parts.xlsx", name);
      std::uint64_t last_row = 0;
      while (const auto row = sheet.next()) {
        must(row->number > last_row && row->number <= most_sheet_rows, "rows increase");
        last_row = row->number;
        must(!row->cells.empty(), "a row has something in it");
        std::uint64_t next_column = 0;
        for (const SheetCell& cell : row->cells) {
          must(cell.column >= next_column && cell.column < most_sheet_columns, "columns increase");
          next_column = cell.column + 1;
          must(!cell.text.empty() && cell.text.find('\n') == std::string::npos,
               "a cell says something on one line");
        }
        must(is_one_plain_line(sheet.place(0, row->number)), "a place is one line");
      }
    });
  }
  if (!begins_like_a_workbook(workbook)) {
    return;
  }
  accepts([&] {
    const PartList list = read_parts(*input_from_text(workbook, "parts.xlsx"));
    must(!list.names.empty() && list.change_costs.size() == list.names.size(), "a list has parts");
  });
  // What its other sheets say, or the question that it was made for: the job is what the question
  // that is kept of it asks for.
  accepts([&] {
    JobRequest request;
    request.parts.workbook = workbook;
    OpenedRequest opened = open_workbook(request);
    opened.request.test_cost = opened.request.test_cost.empty() ? "1" : opened.request.test_cost;
    opened.request.change_cost =
        opened.request.change_cost.empty() ? "1" : opened.request.change_cost;
    opened.request.at_once = opened.request.at_once.value_or(3);
    if (opened.request.items.value_or(0) > most_parts_here) {
      return;
    }
    const CheckedJobRequest asked = checked_job(opened, Door::document);
    for (const std::string& note : asked->notes) {
      must(is_one_plain_line(note), "a note is one line");
    }
    must(!asked->question.parts.workbook && asked->question.parts.file.empty(),
         "the question stands by itself");
    const CheckedJobRequest again =
        checked_job(job_request(to_json(asked->question)), Door::document);
    must(again->job->names == asked->job->names &&
             again->job->never.size() == asked->job->never.size(),
         "the question asks for the same job");
  });
});

}  // namespace
}  // namespace changeover::fuzz::workbook_fuzz
