// Run sheets as people change them: tabs and heads renamed, rows sorted, titles above, copies.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "changeover/io/input.hpp"
#include "changeover/plan/job_request.hpp"
#include "io/workbook/workbook_sheet.hpp"
#include "planned_workbook.hpp"
#include "run_workbooks.hpp"
#include "zip_files.hpp"

namespace changeover::changed_sheets_test {
namespace {

using test::filled_in;
using test::Members;
using test::opened;
using test::unzipped;
using test::zipped;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* book_of_sheets = "xl/workbook.xml";

// The workbook with this text of a member replaced, everywhere.
std::string replaced(const std::string& bytes, const std::string& member, const std::string& from,
                     const std::string& to) {
  Members members = unzipped(bytes);
  std::string& xml = members.at(member);
  std::size_t at = xml.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  for (; at != std::string::npos; at = xml.find(from, at + to.size())) {
    xml.replace(at, from.size(), to);
  }
  return zipped(members);
}

std::string with_tab(const std::string& bytes, const std::string& from, const std::string& to) {
  return replaced(bytes, book_of_sheets, "name=\"" + from + "\"", "name=\"" + to + "\"");
}

std::string with_head(const std::string& bytes, const std::string& from, const std::string& to) {
  return replaced(bytes, "xl/sharedStrings.xml", ">" + from + "<", ">" + to + "<");
}

// One more sheet with the cells of that one.
std::string with_copy(const std::string& bytes, const std::string& copied,
                      const std::string& name) {
  Members members = unzipped(bytes);
  const std::string xml = members.at(test::member_of(bytes, copied));
  members["xl/worksheets/sheet99.xml"] = xml;
  const auto insert = [&](const std::string& member, const std::string& before,
                          const std::string& text) {
    std::string& where = members.at(member);
    where.insert(where.find(before), text);
  };
  insert(book_of_sheets, "</sheets>",
         "<sheet name=\"" + name + "\" sheetId=\"99\" r:id=\"rId99\"/>");
  insert("xl/_rels/workbook.xml.rels", "</Relationships>",
         "<Relationship Id=\"rId99\" Type=\"http://schemas.openxmlformats.org/officeDocument/2006/"
         "relationships/worksheet\" Target=\"worksheets/sheet99.xml\"/>");
  return zipped(members);
}

// The run sheet with another number in this cell.
std::string with_number(const std::string& bytes, const std::string& cell,
                        const std::string& number) {
  Members members = unzipped(bytes);
  std::string& xml = members.at(test::member_of(bytes, "Run sheet"));
  const std::size_t begin = xml.find("<v>", xml.find("<c r=\"" + cell + "\"")) + 3;
  xml.replace(begin, xml.find("</v>", begin) - begin, number);
  return zipped(members);
}

class ChangedSheets : public test::PlannedWorkbook {
 protected:
  ChangedSheets() {
    request.at_once = 3;
    request.test_cost = "1";
    request.change_cost = "5";
    request.steps = 500;
    request.parts.rows.emplace();
    for (const char* name : {"A", "B", "C", "D", "E", "F"}) {
      request.parts.rows->push_back({{name}});
    }
    bytes = planned();
    sheet = answer.plan->sheet;
    filled = filled_in(bytes, {"pass", "pass", "fail"});
  }

  // How many tests of it count as done; its notes are kept.
  std::uint64_t done_in(const std::string& book) {
    const OpenedRequest again = opened(book);
    now = *checked_job(again, Door::document);
    return now.job->tests_done;
  }

  std::string bytes;
  std::string filled;
  RunSheet sheet;
  ReadJob now;
};

TEST_F(ChangedSheets, ARunSheetIsKnownWhateverItsTabIsCalled) {
  EXPECT_EQ(done_in(with_tab(filled, "Run sheet", "Bench 3")), 3U);
  EXPECT_THAT(now.notes, Contains(HasSubstr("3 of")));
  // What was done before is, too.
  const std::string next = filled_in(planned(opened(filled)), {"pass"});
  EXPECT_EQ(done_in(next), 4U);
  EXPECT_EQ(done_in(with_tab(with_tab(next, "Run sheet", "Week 13"), "Done", "Week 12")), 4U);
  EXPECT_EQ(now.record.tests.back().result, "pass");
}

TEST_F(ChangedSheets, ARunSheetIsKnownWithoutItsFigures) {
  const std::string renamed = with_tab(filled, "Run sheet", "Bench 3");
  EXPECT_EQ(done_in(with_head(renamed, "new_pairs", "x")), 3U);
  EXPECT_THAT(now.done.front().setup, sheet.steps[0].setup);
}

TEST_F(ChangedSheets, ResultsAreKnownWhateverTheirHeadIs) {
  for (const char* head :
       {"Ergebnis", "Result (pass/fail)", "RESULTS", "Testergebnis", "Resultado", "結果"}) {
    EXPECT_EQ(done_in(with_head(filled, "result", head)), 3U) << head;
    EXPECT_THAT(now.notes, Contains(HasSubstr("the results are those of the column"))) << head;
  }
  // Where results were written, whatever the word.
  EXPECT_EQ(done_in(with_head(filled, "result", "Meier")), 3U);
  EXPECT_THAT(now.notes, Contains(HasSubstr("the results are those of the column 'Meier'")));
  EXPECT_EQ(done_in(with_head(with_head(filled, "result", "Befund"), "step", "Test")), 3U);
}

TEST_F(ChangedSheets, NothingIsPlannedAnewWithoutAWord) {
  // No sheet looks like a run sheet.
  const std::string lost = with_head(with_head(filled, "new_pairs", "pairs"), "step", "x");
  const OpenedRequest none =
      opened(with_tab(with_head(lost, "result", "?"), "Run sheet", "Bench 3"));
  EXPECT_FALSE(none.request.done.is_given());
  EXPECT_THAT(none.notes, Contains(HasSubstr("none of its sheets has the columns of a run sheet")));
  // A run sheet without a column for results.
  EXPECT_THAT(opened(with_head(lost, "result", "?")).notes,
              Contains(HasSubstr(":Run sheet!A1: the sheet has no column of results")));
  // Results among the notes.
  EXPECT_THAT(opened(filled_in(bytes, {"pass"}, "Run sheet", "notes")).notes,
              Contains(HasSubstr("'pass' is among the notes, which are not results")));
  EXPECT_THAT(opened(bytes).notes, testing::SizeIs(1));
}

TEST_F(ChangedSheets, TheResultsOfCopiesCountTogether) {
  EXPECT_EQ(done_in(with_copy(filled, "Run sheet", "Run sheet (2)")), 3U);
  const std::string copy =
      filled_in(with_copy(bytes, "Run sheet", "Run sheet (2)"), {"pass", "fail"}, "Run sheet");
  EXPECT_EQ(done_in(copy), 2U);
  // The other way round, the copy is the one that was filled in.
  const std::string other =
      with_tab(with_tab(copy, "Run sheet", "x"), "Run sheet (2)", "Run sheet");
  EXPECT_EQ(done_in(other), 2U);
}

TEST_F(ChangedSheets, TestsAreInTheOrderOfTheirSteps) {
  // Steps 1 and 3 change places, as sorted rows do.
  const std::string sorted = with_number(with_number(filled, "A2", "3"), "A4", "1");
  EXPECT_EQ(done_in(sorted), 3U);
  EXPECT_EQ(now.done.back().setup.size(), 3U);
  EXPECT_EQ(now.done.front().setup, sheet.steps[2].setup);
  EXPECT_EQ(now.job->start, now.done.back().setup);
  EXPECT_EQ(now.job->start, sheet.steps[0].setup) << "that has the last step";
  EXPECT_THAT(now.notes, Contains(HasSubstr(":Run sheet!A1: the rows are not in the order")));
}

// Test 3 was skipped: the others keep their numbers, and new tests get new ones.
TEST_F(ChangedSheets, TestsKeepTheirNumbers) {
  std::string next = planned(opened(filled_in(bytes, {"pass", "pass", "skipped", "ok"})));
  const auto numbers = [&](const std::string& name) {
    std::vector<std::string> found;
    WorkbookSheet on(next, "f", name);
    static_cast<void>(on.next());
    while (const auto row = on.next()) {
      found.push_back(row->cells.front().text);
    }
    return found;
  };
  EXPECT_THAT(numbers("Done"), ElementsAre("1", "2", "4"));
  EXPECT_EQ(numbers("Run sheet").front(), "5");
  EXPECT_EQ(asked.job->tests_done, 3U);
  next = planned(opened(filled_in(next, {"pass"})));
  EXPECT_THAT(numbers("Done"), ElementsAre("1", "2", "4", "5"));
  EXPECT_EQ(numbers("Run sheet").front(), "6");
}

TEST_F(ChangedSheets, ATitleMayStandAboveTheHeads) {
  // All rows move down by two.
  Members members = unzipped(filled);
  const std::string member = test::member_of(filled, "Run sheet");
  std::string rows;
  WorkbookSheet old(filled, "f", "Run sheet");
  std::uint64_t at = 3;
  while (const auto row = old.next()) {
    rows += fmt::format("<row r=\"{}\">", at);
    for (const SheetCell& cell : row->cells) {
      rows += fmt::format("<c r=\"{}{}\" t=\"inlineStr\"><is><t>{}</t></is></c>",
                          static_cast<char>('A' + cell.column), at, cell.text);
    }
    rows += "</row>";
    ++at;
  }
  std::string& xml = members.at(member);
  const std::size_t begin = xml.find("<sheetData>") + 11;
  xml.replace(
      begin, xml.find("</sheetData>") - begin,
      "<row r=\"1\"><c r=\"A1\" t=\"inlineStr\"><is><t>Bench 3, week 12</t></is></c></row>" + rows);
  EXPECT_EQ(done_in(with_tab(zipped(members), "Run sheet", "Week 12")), 3U);
}

TEST(SheetHeads, AreReadTheSameFromAText) {
  const std::vector<std::string> names{"A", "B", "C"};
  const auto read = [&](const std::string& text) {
    return read_done(*input_from_text(text, "d.csv"), names);
  };
  DoneList list = read("Week 12\nstep,slot_1,slot_2,Ergebnis\n2,A,B,pass\n1,A,C,fail\n");
  EXPECT_THAT(list.setups(), ElementsAre(Block{0, 2}, Block{0, 1}));
  EXPECT_EQ(list.rows[0].result, "fail");
  EXPECT_THAT(list.notes, ElementsAre(HasSubstr("d.csv:2:20: the results are those of the column"),
                                      HasSubstr("d.csv:2:1: the rows are not in the order")));
  // Each bench has its own order; a number that is there twice says nothing.
  list = read("bench,step,slot_1,result\nN,2,A,\nS,1,B,\nN,1,C,\n");
  EXPECT_THAT(list.setups(), ElementsAre(Block{2}, Block{1}, Block{0}));
  list = read("step,slot_1,result\n2,A,\n1,B,\n1,C,\n");
  EXPECT_THAT(list.setups(), ElementsAre(Block{0}, Block{1}, Block{2}));
  EXPECT_THAT(list.notes, ElementsAre(HasSubstr("d.csv:4:1: step 1 is here a second time")));
  // A column of the user's own is no result unless its head says so.
  EXPECT_THAT(read("slot_1,slot_2,operator\nA,B,Meier\n").rows.front().result, "");
  // Parts in one field are no title.
  EXPECT_THAT(read("A B\nB\nC\n").setups(), ElementsAre(Block{0, 1}, Block{1}, Block{2}));
}

}  // namespace
}  // namespace changeover::changed_sheets_test
