#include "plan/job/setups/other_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "core/contains.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "plan/job/parts/heading_words.hpp"
#include "plan/job/setups/results.hpp"

namespace changeover {

void OtherResults::find(const Row& header, const SetupColumns& columns) {
  for (std::size_t i = 0; i < header.size(); ++i) {
    // Remarks on results are none.
    if (columns.have(i) || heads_remarks(header[i].text) ||
        own_head(lower_case(header[i].text)) != nullptr) {
      continue;
    }
    (columns.result && heads_results(header[i].text) ? columns_ : unread_).push_back(i);
  }
}

void OtherResults::check(const Row& row, const DoneRow& done, const Row& header,
                         const SetupColumns& columns, const RowReader& reader) {
  check_unread(row, header, columns, reader);
  for (const std::size_t i : columns_) {
    const TestResult said = i < row.size() ? result_of(row[i].text) : TestResult::none;
    if (said == TestResult::none && was_run(done.result)) {
      silent_.emplace(i, Silence{row[*columns.result], done.result});
    }
    if (said != TestResult::pass && said != TestResult::fail) {
      continue;
    }
    said_ = said_.value_or(i);
    if (said != result_of(done.result)) {
      const std::string& result = header[*columns.result].text;
      reader.fail(row[i], fmt::format("{} in the column {}, but the column {} says {}; keep one "
                                      "column of results",
                                      shown(row[i].text), shown(header[i].text), shown(result),
                                      done.result.empty() ? "nothing" : shown(done.result)));
    }
  }
}

// Without a column of results all tests of the list would count as passed.
void OtherResults::check_unread(const Row& row, const Row& header, const SetupColumns& columns,
                                const RowReader& reader) {
  for (const std::size_t i : unread_) {
    const TestResult said = i < row.size() ? result_of(row[i].text) : TestResult::none;
    if (said != TestResult::pass && said != TestResult::fail) {
      continue;
    }
    if (!columns.result && !reader.is_given() && !reader.is_workbook()) {
      reader.fail(row[i],
                  fmt::format("{} in the column {}, and no column is called result; call it so if "
                              "it has the results, or remove it",
                              shown(row[i].text), shown(header[i].text)));
    }
    strange_ = strange_.value_or(i);
  }
}

void OtherResults::say(DoneList& list, const Row& header, const SetupColumns& columns,
                       const RowReader& reader) const {
  const auto silence = said_ ? silent_.find(*said_) : silent_.end();
  if (silence != silent_.end()) {
    const std::string& head = header[*columns.result].text;
    if (lower_case(head) != "result") {
      reader.fail(
          silence->second.at,
          fmt::format("{} in the column {}, but the column {} says nothing; name "
                      "the column with the results 'result', and rename the other",
                      shown(silence->second.result), shown(head), shown(header[*said_].text)));
    }
  }
  if (said_) {
    list.notes.push_back(
        fmt::format("{}: the column {} is not read; it says the same as that of the results{}",
                    reader.place(header[*said_]), shown(header[*said_].text),
                    silence == silent_.end() ? "" : ", or nothing"));
  }
  if (strange_ && !list.has_results()) {
    list.notes.push_back(fmt::format(
        "{}: the column {} says pass or fail, but that of the results is empty and counts; write "
        "the results there",
        reader.place(header[*strange_]), shown(header[*strange_].text)));
  }
}

}  // namespace changeover
