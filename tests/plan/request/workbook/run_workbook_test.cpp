// Which sheets of a workbook have tests, by their heads and names.
#include "plan/request/workbook/run_workbook.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "zip_files.hpp"

namespace changeover::run_workbook_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using Sheet = std::vector<std::vector<std::string>>;

std::string xml_of(const Sheet& rows) {
  std::string xml;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    xml += fmt::format("<row r='{}'>", r + 1);
    for (const std::string& text : rows[r]) {
      xml += "<c t='inlineStr'><is><t>" + text + "</t></is></c>";
    }
    xml += "</row>";
  }
  return xml;
}

RunWorkbook book_of(const std::map<std::string, Sheet>& sheets) {
  std::map<std::string, std::string> xml;
  for (const auto& [name, rows] : sheets) {
    xml[name] = xml_of(rows);
  }
  RequestList list;
  list.workbook = test::zipped(test::workbook_of(xml));
  return run_workbook(list, "b.xlsx").value();
}

const Sheet steps{{"step", "put_in", "slot_1", "slot_2", "new_pairs", "result"},
                  {"1", "A, B", "A", "B", "1", "pass"}};
const Sheet own{{"slot_1", "slot_2", "result"}, {"A", "C", "pass"}};

TEST(RunWorkbook, SheetsOfTestsAreThoseWithPartsAndResults) {
  const RunWorkbook book = book_of({
      {"Run sheet", steps},
      {"done", own},
      {"Earlier", own},
      {"B2", {{"Tests of May"}, {"slot_1", "slot_2", "Ergebnis"}, {"A", "C", "ok"}}},
      {"Empty", {own[0]}},
      {"None", {own[0], {"A", "C", ""}}},
      {"Notes", {{"who", "result"}, {"Al", "pass"}}},
      {"Pairs", {{"slot_1", "slot_2"}, {"A", "C"}}},
  });
  EXPECT_THAT(book.tests_done(), ElementsAre("done", "B2", "Earlier"));
  EXPECT_THAT(book.run_sheets(), ElementsAre("Run sheet"));
  EXPECT_THAT(book.unread_results(), ElementsAre("Notes"));
}

TEST(RunWorkbook, AWorkbookWithoutTestsHasNone) {
  const RunWorkbook book = book_of({{"Parts", {{"part", "cost"}, {"A", "1"}}}});
  EXPECT_THAT(book.tests_done(), IsEmpty());
  EXPECT_THAT(book.run_sheets(), IsEmpty());
}

TEST(RunWorkbook, HeadsInAnotherCaseAndModelsWithoutTheirSetHeadRunSheets) {
  const RunWorkbook book = book_of({
      {"North", {{" STEP ", "SLOT_1", "Slot_2", "New pairs", "RESULT"}, {"1", "A", "B", "1", ""}}},
      {"South", {{"step", "OS", "Disk", "new_pairs", "result"}, {"1", "Linux", "SSD", "1", ""}}},
      {"Stock", {{"part", "cost", "result"}, {"A", "1", ""}}},
  });
  EXPECT_THAT(book.run_sheets(), ElementsAre("North", "South"));
}

}  // namespace
}  // namespace changeover::run_workbook_test
