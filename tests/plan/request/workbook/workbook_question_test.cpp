// Workbooks as the whole question: lists on their sheets, and run sheets that come back filled in.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

#include "changeover/core/error.hpp"
#include "changeover/plan/job_request.hpp"
#include "damage.hpp"
#include "io/workbook/workbook_sheet.hpp"
#include "plan/request/workbook/workbook_question.hpp"
#include "planned_workbook.hpp"
#include "run_workbooks.hpp"
#include "some_names.hpp"
#include "zip_files.hpp"

namespace changeover::workbook_question_test {
namespace {

using test::filled_in;
using test::opened;
using test::some_number;
using test::unzipped;
using test::with_row;
using test::workbook_of;
using test::zipped;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string row(const std::vector<std::string>& cells) {
  std::string xml = "<row>";
  for (const std::string& cell : cells) {
    xml += cell.empty() ? "<c/>" : "<c t='inlineStr'><is><t>" + cell + "</t></is></c>";
  }
  return xml + "</row>";
}

std::string rows(const std::vector<std::vector<std::string>>& all) {
  std::string xml;
  for (const auto& cells : all) {
    xml += row(cells);
  }
  return xml;
}

std::string fault_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& fault) {
    return fault.what();
  }
  return "none";
}

const std::string stock = rows({{"Component", "Slot", "Swap time (min)"},
                                {"Xeon", "CPU", "12"},
                                {"Epyc", "CPU", "9"},
                                {"E810", "NIC", "4"},
                                {"X710", "NIC", "3"},
                                {"PM9A3", "SSD", "2"},
                                {"D7", "SSD", "2"}});
const std::string limits =
    rows({{"Slot", "Min", "Max"}, {"CPU", "1", "1"}, {"NIC", "1", "2"}, {"SSD", "1", "1"}});
const std::string forbidden = rows({{"Part A", "Part B", "Why"}, {"Epyc", "X710", "no driver"}});

TEST(WorkbookQuestion, SlotsAndForbiddenPairsAreFoundByTheNamesOfTheirSheets) {
  const std::string bytes = zipped(workbook_of({{"A cover", rows({{"Lab 3"}})},
                                                {"Components", stock},
                                                {"Forbidden pairs", forbidden},
                                                {"SLOTS", limits}}));
  const OpenedRequest book = opened(bytes, {.test_cost = "25"});
  EXPECT_THAT(book.notes,
              ElementsAre("parts: parts from 'Components', forbidden pairs from 'Forbidden pairs', "
                          "slots from 'SLOTS', by the names of its sheets",
                          "parts: not read, since its name says no list: 'A cover'; rules are read "
                          "from sheets called Slots, Never, Priorities, Change costs and Benches"));
  const CheckedJobRequest asked = checked_job(book, Door::document);
  EXPECT_EQ(asked->job->parts(), 6U);
  EXPECT_EQ(asked->job->at_once, 4U);
  EXPECT_EQ(asked->job->cost_unit, CostUnit::minutes);
  EXPECT_TRUE(asked->job->never.contains(1, 3));
  EXPECT_EQ(asked->job->why_never(1, 3), "no driver");
  EXPECT_EQ(asked->notes.front(), book.notes.front());
  EXPECT_THAT(asked->notes, Contains("4 parts fit at once, as many as the slots hold"));
  EXPECT_THAT(asked->notes, Contains(HasSubstr("costs are minutes, by the list")));
}

TEST(WorkbookQuestion, WhatIsSaidWinsOverSheets) {
  const std::string bytes =
      zipped(workbook_of({{"Parts", stock}, {"Never", forbidden}, {"Slots", limits}}));
  JobRequest request{.test_cost = "25"};
  request.slot = "CPU=1,NIC=1,SSD=1";
  request.never.rows.emplace();
  OpenedRequest book = opened(bytes, request);
  EXPECT_THAT(book.notes, ElementsAre("parts: parts from 'Parts', by the names of its sheets"));
  CheckedJobRequest asked = checked_job(book, Door::document);
  EXPECT_EQ(asked->job->at_once, 3U);
  EXPECT_EQ(asked->job->never.size(), 0U);
  // A sheet that is named is all that is read.
  request = {.at_once = 2, .test_cost = "25"};
  request.parts.sheet = "Parts";
  EXPECT_THAT(opened(bytes, request).notes, IsEmpty());
}

TEST(WorkbookQuestion, SheetsThatAreWrongAreNamed) {
  const std::string bad = zipped(
      workbook_of({{"Parts", stock}, {"Never", rows({{"Epyc", "X71"}})}, {"Slots", limits}}));
  EXPECT_EQ(fault_of([&] { (void)checked_job(opened(bad, {.test_cost = "1"}), Door::document); }),
            "never:Never!B1: there is no part 'X71'; did you mean 'X710'?");
  // Once something broke, lists may be older than the parts list.
  JobRequest later{.test_cost = "1"};
  later.without = {"Epyc"};
  EXPECT_THAT(checked_job(opened(bad, later), Door::document)->notes,
              testing::Contains(HasSubstr("left out: X71 (never:Never!B1)")));
  EXPECT_THAT(
      fault_of([&] {
        (void)checked_job(
            opened(zipped(workbook_of({{"Parts", stock}, {"Slots", "<row>"}})), {.test_cost = "1"}),
            Door::document);
      }),
      HasSubstr("slots:"));
}

TEST(WorkbookQuestion, RoomIsNotKnownWherePartsAreInNoSlot) {
  const std::string bytes = zipped(workbook_of(
      {{"Parts",
        rows({{"part", "slot", "cost"}, {"A", "x", "1"}, {"B", "x", "1"}, {"Cable", "", "1"}})},
       {"Slots", rows({{"slot", "min", "max"}, {"x", "1", ""}})}}));
  EXPECT_THAT(
      fault_of([&] { (void)checked_job(opened(bytes, {.test_cost = "1"}), Door::document); }),
      HasSubstr("give at_once, how many parts fit at once: Cable is in no slot"));
  const CheckedJobRequest asked =
      checked_job(opened(bytes, {.at_once = 3, .test_cost = "1"}), Door::document);
  EXPECT_EQ(asked->job->at_once, 3U);
}

TEST(WorkbookQuestion, SeveralPiecesOfAPartFillASlot) {
  const std::string bytes =
      zipped(workbook_of({{"Parts", rows({{"part", "slot", "min", "qty"},
                                          {"A", "DIMM", "2", "4"},
                                          {"B", "DIMM", "3", "1"},
                                          {"C", "CPU", "9", "1"}})},
                          {"Slots", rows({{"slot", "quantity"}, {"DIMM", "3"}, {"CPU", "1"}})}}));
  JobRequest request{.test_cost = "1"};
  request.change_cost = "1";
  const OpenedRequest book = opened(bytes, request);
  const CheckedJobRequest asked = checked_job(book, Door::document);
  EXPECT_THAT(asked->job->names, ElementsAre("A", "B", "C", "A #2", "A #3"));
  EXPECT_EQ(asked->job->at_once, 4U);
  EXPECT_EQ(asked->job->needed.size(), 3U) << "nothing has to meet further pieces";
  EXPECT_THAT(asked->notes,
              Contains(HasSubstr("2 further pieces may fill slots that need several: A #2, A #3")));
  RunControl control({.threads = 1});
  const PlanAnswer answer = answer_to(asked, control);
  EXPECT_EQ(answer.plan->sheet.steps.size(), 1U);
  EXPECT_EQ(answer.plan->sheet.steps[0].setup, (Block{0, 1, 2, 3}));
  EXPECT_EQ(answer.plan->candidates.front().cost, answer.plan->sheet.cost);
  // The workbook lists parts, not pieces.
  const std::string run = written(asked, answer, "xlsx");
  const CheckedJobRequest again = checked_job(opened(run), Door::document);
  EXPECT_EQ(again->job->names, asked->job->names);
  EXPECT_EQ(again->job->needed.size(), 3U);
}

class RunSheetWorkbook : public test::PlannedWorkbook {
 protected:
  RunSheetWorkbook() {
    request.at_once = 4;
    request.test_cost = "5";
    request.steps = 2000;
    request.title = "Bench 3";
    request.parts.rows = {{{{"Xeon", "12.50", "CPU"}},
                           {{"Epyc", "9", "CPU"}},
                           {{"E810", "4", "NIC"}},
                           {{"X710", "3", "NIC"}},
                           {{"PM9A3", "2", ""}},
                           {{"D7", "2", ""}}}};
    request.slots.rows = {{{{"CPU", "1", "1"}}, {{"NIC", "1", "1"}}}};
    request.never.rows = {{{{"Epyc", "X710", "no driver"}}}};
  }
};

TEST_F(RunSheetWorkbook, AsksTheSameQuestionAgain) {
  const std::string bytes = planned();
  const std::string before = written(*checked, answer, "csv");
  const OpenedRequest again = opened(bytes);
  EXPECT_THAT(again.notes,
              ElementsAre("parts: the question is that of its hidden sheet changeover-question"));
  EXPECT_FALSE(again.request.done.is_given()) << "nothing was filled in";
  planned(again);
  EXPECT_EQ(written(*checked, answer, "csv"), before);
  EXPECT_EQ(asked.job->why_never(1, 3), "no driver");
}

TEST_F(RunSheetWorkbook, IsPlannedAnewWithItsResultsAgainAndAgain) {
  std::string bytes = planned();
  const std::uint64_t all = asked.job->needed.size();
  std::vector<std::string> results{"pass", "FAILED - hang"};
  std::uint64_t done = 0;
  for (int day = 0; day < 4 && !answer.plan->sheet.steps.empty(); ++day) {
    const std::size_t today =
        std::min<std::size_t>(results.size(), answer.plan->sheet.steps.size());
    const RunSheet before = answer.plan->sheet;
    bytes = filled_in(bytes, results);
    const OpenedRequest again = opened(bytes);
    EXPECT_TRUE(again.request.done.is_given());
    bytes = planned(again);
    done += today;
    EXPECT_EQ(asked.job->tests_done, done);
    EXPECT_EQ(asked.record.tests.size(), done);
    EXPECT_EQ(asked.record.tests.back().result, results[today - 1]);
    EXPECT_EQ(asked.job->start.size(), before.steps[today - 1].setup.size());
    EXPECT_EQ(again.request.title, "Bench 3");
    results = {"pass"};
  }
  EXPECT_LT(asked.job->needed.size(), all);
  const auto sheets = workbook_sheets(bytes, "f");
  EXPECT_THAT(sheets, Contains(SheetName{"Done", false}));
  EXPECT_THAT(sheets, Contains(SheetName{"changeover-question", true}));
}

TEST_F(RunSheetWorkbook, OptionsWinOverItsQuestion) {
  const std::string bytes = filled_in(planned(), {"fail"});
  JobRequest more{.test_cost = "7"};
  more.slot = "CPU=1,NIC=1..2";
  more.trust_failed = true;
  const OpenedRequest again = opened(bytes, more);
  EXPECT_EQ(again.request.test_cost, "7");
  EXPECT_EQ(again.request.at_once, 4U);
  EXPECT_FALSE(again.request.slots.is_given());
  EXPECT_THAT(again.notes.front(), HasSubstr("but for what is asked now"));
  const CheckedJobRequest asked_now = checked_job(again, Door::document);
  EXPECT_EQ(asked_now->job->slots[1].most, 2U);
  EXPECT_TRUE(asked_now->job->trust_failed);
  // Other tests that were done are those that count.
  JobRequest other;
  other.done.rows.emplace();
  other.done.rows->push_back({{"Xeon", "E810"}});
  EXPECT_EQ(checked_job(opened(bytes, other), Door::document)->record.tests.size(), 1U);
}

// Merged cells side by side keep one part; those of a title are none of a test.
TEST_F(RunSheetWorkbook, MergedCellsOfPartsAreRefusedOrCount) {
  const std::string bytes = filled_in(planned(), {"pass", "pass"});
  const auto merged = [&](const std::string& book, const std::string& range) {
    test::Members members = test::unzipped(book);
    std::string& sheet = members[test::member_of(book, "Run sheet")];
    const std::string end = "</sheetData>";
    sheet.insert(sheet.find(end) + end.size(),
                 "<mergeCells><mergeCell ref=\"" + range + "\"/></mergeCells>");
    return test::zipped(members);
  };
  const auto without = [](const std::string& book, const std::string& place) {
    test::Members members = test::unzipped(book);
    std::string& sheet = members[test::member_of(book, "Run sheet")];
    const std::size_t begin = sheet.find("<c r=\"" + place + "\"");
    sheet.erase(begin, sheet.find("</c>", begin) + 4 - begin);
    return test::zipped(members);
  };
  try {
    static_cast<void>(checked_job(opened(merged(without(bytes, "C2"), "B2:C2")), Door::document));
    ADD_FAILURE() << "a part is lost";
  } catch (const BadInput& bad) {
    EXPECT_THAT(bad.what(), HasSubstr("Run sheet!C2: the cells B2:C2 are merged, so this one is "
                                      "empty; separate them, and write what belongs here"));
  }
  // One result for two tests.
  const CheckedJobRequest again =
      checked_job(opened(merged(without(bytes, "I3"), "I2:I3")), Door::document);
  EXPECT_EQ(again->record.tests.size(), 2U);
}

// A place broke: what was tested counts, and new tests have one part less.
TEST_F(RunSheetWorkbook, TestsWithMorePartsThanFitNowCount) {
  const std::string bytes = filled_in(planned(), {"pass"});
  const Block first = answer.plan->sheet.steps[0].setup;
  ASSERT_EQ(first.size(), 4U);
  const CheckedJobRequest same = checked_job(opened(bytes), Door::document);
  JobRequest less;
  less.at_once = 3;
  const OpenedRequest again = opened(bytes, less);
  const CheckedJobRequest now = checked_job(again, Door::document);
  EXPECT_EQ(now->job->tests_done, 1U);
  EXPECT_EQ(now->job->needed.size(), same->job->needed.size());
  EXPECT_EQ(now->job->start.size(), 3U);
  EXPECT_THAT(now->notes,
              testing::Contains(HasSubstr("1 test had more parts than fit at once now, as that in "
                                          "row 2 with 4; it counts as done")));
  EXPECT_THAT(now->notes, testing::Contains(HasSubstr("of the last test had no room any more")));
  planned(again);
  for (const RunStep& step : answer.plan->sheet.steps) {
    EXPECT_LE(step.setup.size(), 3U);
  }
  EXPECT_TRUE(answer.plan->sheet.does_the_job());
}

// As long as nothing is done there is nothing to trust; the wish is kept for then.
TEST_F(RunSheetWorkbook, TrustsTestsThatFailFromWorkbookToWorkbook) {
  request.trust_failed = true;
  request.done.text = "result,set_up\nnot run,\"Xeon,E810\"\n";
  const std::string bytes = planned();
  EXPECT_TRUE(asked.record.tests.empty());
  const OpenedRequest again = opened(bytes);
  EXPECT_FALSE(again.request.done.is_given());
  const std::string same = planned(again);
  const std::uint64_t all = asked.job->needed.size();
  for (const std::string& book : {bytes, same}) {
    const std::string next = planned(opened(filled_in(book, {"fail"})));
    EXPECT_TRUE(asked.job->trust_failed);
    EXPECT_LT(asked.job->needed.size(), all) << "what met in it counts as tested";
    planned(opened(next));  // with a sheet of what was done
    EXPECT_TRUE(asked.job->trust_failed);
    EXPECT_EQ(asked.job->tests_done, 1U);
  }
  JobRequest more;
  more.diagnose = true;
  planned(opened(filled_in(bytes, {"fail"}), more));
  EXPECT_TRUE(asked.question.trust_failed) << "a plan after the diagnosis has use for it";
}

// A test keeps the names of its parts that are gone: it is no row without a set-up, and no other
// part is to blame.
TEST_F(RunSheetWorkbook, TestsWithPartsThatAreGoneAreReadAgain) {
  request.done.text =
      "result,set_up\nfail,\"P4,A100\"\nfail,\"Epyc,D7\"\nfail,\"Xeon,D7\"\npass,Xeon\n";
  request.without = {"Epyc", "D7"};
  std::string bytes = planned();
  const auto parts_of = [&](std::size_t test) {  // in whichever of the columns they are
    std::vector<std::string> parts = asked.record.tests.at(test).parts;
    std::erase(parts, "");
    return parts;
  };
  for (int time = 0; time < 3; ++time) {
    EXPECT_THAT(parts_of(0), ElementsAre("P4", "A100"));
    EXPECT_THAT(parts_of(1), ElementsAre("Epyc", "D7"));
    EXPECT_THAT(parts_of(2), ElementsAre("Xeon", "D7"));
    EXPECT_EQ(asked.results.size(), 1U) << "only the last test says something of parts there are";
    EXPECT_EQ(asked.job->tests_done, 4U);
    bytes = planned(opened(bytes));
  }
}

TEST_F(RunSheetWorkbook, ListsThatWereChangedOnItsSheetsCount) {
  const std::string bytes = filled_in(planned(), {"pass"});
  const std::uint64_t parts = request.parts.rows->size();
  const CheckedJobRequest same = checked_job(opened(bytes), Door::document);
  const std::string with_part = with_row(bytes, "Parts", {"P5800", "2.5"});
  const OpenedRequest more = opened(with_part);
  EXPECT_THAT(more.notes.back(), HasSubstr("parts from 'Parts', slots from 'Slots', forbidden "
                                           "pairs from 'Never', changed since the plan was made"));
  const CheckedJobRequest with_more = checked_job(more, Door::document);
  EXPECT_EQ(with_more->job->parts(), parts + 1);
  EXPECT_EQ(to_string(with_more->job->change_costs.back()), "2.50");
  EXPECT_EQ(with_more->job->needed.size(), same->job->needed.size() + parts);
  EXPECT_EQ(with_more->job->tests_done, 1U);
  EXPECT_EQ(with_more->job->why_never(1, 3), "no driver");
  const OpenedRequest apart = opened(with_row(bytes, "Never", {"Xeon", "PM9A3", "too hot"}));
  EXPECT_THAT(apart.notes.back(), HasSubstr(": forbidden pairs from 'Never', changed since"));
  EXPECT_EQ(checked_job(apart, Door::document)->job->why_never(0, 4), "too hot");
  // What is asked for wins, and what is wrong there is named with its place.
  JobRequest other;
  other.never.rows.emplace();
  other.never.rows->push_back({{"Epyc", "D7"}});
  EXPECT_EQ(checked_job(opened(with_row(bytes, "Never", {"Xeon", "PM9A3"}), other), Door::document)
                ->job->never.size(),
            1U);
  EXPECT_THAT(checked_job(opened(with_row(bytes, "Never", {"Xeon", "P4"})), Door::document)->notes,
              testing::Contains(HasSubstr("no longer in the parts list, and left out: P4")));
  // The question goes on with them.
  planned(more);
  EXPECT_EQ(checked_job(opened(planned(more)), Door::document)->job->parts(), parts + 1);
}

TEST_F(RunSheetWorkbook, IsDiagnosed) {
  request.budget = "500";
  request.weights.text = "Xeon,E810,3\n";
  request.first.text = "Epyc,E810,PM9A3\n";
  const std::string bytes = filled_in(planned(), {"pass", "fail"});
  const JobRequest whole = asked.question;
  const Amount spent = answer.plan->sheet.steps[1].cost_so_far;
  JobRequest more;
  more.diagnose = true;
  const OpenedRequest again = opened(bytes, more);
  const CheckedJobRequest of_results = checked_job(again, Door::document);
  check_options(again.request, Door::document);
  RunControl control({.threads = 1});
  const PlanAnswer found = answer_to(of_results, control);
  EXPECT_EQ(found.diagnosis->failed, 1U);
  ASSERT_TRUE(found.diagnosis->next);
  // The next test is on a sheet to fill in, and its result counts.
  const std::string sheet = written(of_results, found, "xlsx");
  const OpenedRequest third = opened(filled_in(sheet, {"fail"}), more);
  const CheckedJobRequest then = checked_job(third, Door::document);
  EXPECT_EQ(then->results.size(), 3U);
  EXPECT_EQ(answer_to(then, control).diagnosis->failed, 2U);
  // What a diagnosis makes no use of is there for the plan that comes after it.
  const OpenedRequest plan = opened(sheet);
  EXPECT_EQ(plan.request.title, whole.title);
  EXPECT_EQ(parse_amount(plan.request.budget), parse_amount("500") - spent);
  EXPECT_EQ(plan.request.steps, whole.steps);
  planned(plan);
  EXPECT_EQ(asked.question.weights, whole.weights);
}

TEST_F(RunSheetWorkbook, ABudgetIsLessByWhatWasDone) {
  request.budget = "60";
  const std::string bytes = filled_in(planned(), {"pass", "pass"});
  const Amount spent = answer.plan->sheet.steps[1].cost_so_far;
  const OpenedRequest again = opened(bytes);
  EXPECT_EQ(parse_amount(again.request.budget), parse_amount("60") - spent);
  EXPECT_THAT(again.notes, Contains(HasSubstr("of the budget of 60 is spent on 2 tests")));
  planned(again);
  EXPECT_LE(answer.plan->sheet.cost, parse_amount("60") - spent);
  JobRequest more;
  more.budget = "100";
  EXPECT_EQ(opened(bytes, more).request.budget, "100");
}

TEST_F(RunSheetWorkbook, WhatIsMountedAtTheStartIsThatOfTheLastTest) {
  request.start = {"Epyc", "E810"};
  const std::string bytes = planned();
  EXPECT_THAT(opened(bytes).request.start, ElementsAre("Epyc", "E810"));
  const OpenedRequest again = opened(filled_in(bytes, {"pass"}));
  EXPECT_THAT(again.request.start, IsEmpty());
  EXPECT_EQ(checked_job(again, Door::document)->job->start.size(),
            answer.plan->sheet.steps[0].setup.size());
}

// Every list of a question comes back as it was: the job of the workbook is the job that was
// planned.
TEST_F(RunSheetWorkbook, HoldsEveryListOfItsQuestion) {
  request.pairs.text = "Xeon,E810\nEpyc,E810\nXeon,PM9A3\nPM9A3,D7\n";
  request.weights.text = "Xeon,E810,3\n";
  request.mounted = {"PM9A3"};
  request.first.text = "Epyc,E810,PM9A3\n";
  request.budget = "100";
  request.cost_unit = "hours";
  const std::string bytes = planned();
  const Job before = *asked.job;
  const CheckedJobRequest again = checked_job(opened(bytes), Door::document);
  const Job& after = *again->job;
  EXPECT_EQ(after.names, before.names);
  EXPECT_EQ(after.change_costs, before.change_costs);
  EXPECT_EQ(after.needed.size(), before.needed.size());
  before.needed.for_each(100,
                         [&](Element x, Element y) { EXPECT_TRUE(after.needed.contains(x, y)); });
  EXPECT_EQ(after.weights(0, 2), before.weights(0, 2));
  EXPECT_EQ(after.mounted, before.mounted);
  EXPECT_EQ(after.first, before.first);
  EXPECT_EQ(after.cost_unit, CostUnit::hours);
  EXPECT_EQ(to_json(again->question), to_json(asked.question));
}

TEST_F(RunSheetWorkbook, ADamagedOrForeignQuestionIsOneLine) {
  const auto fault = [&](const std::string& cells) {
    return fault_of([&] {
      (void)opened(zipped(workbook_of({{"Parts", stock}, {"changeover-question", cells}})));
    });
  };
  const std::string head = row({"changeover-job/1"});
  for (const auto& [cells, what] : std::vector<std::pair<std::string, std::string>>{
           {"", "changeover-question!A1: the sheet does not contain the request of a plan"},
           {row({"hello"}), "changeover-question!A1: the sheet does not contain the request"},
           {row({"", "changeover-job/1"}), "the sheet does not contain the request"},
           {row({"changeover-job/2"}) + row({"{}"}),
            "'changeover-job/2' is a question of another kind or version"},
           {row({"changeover-load-request/1"}), "of another kind or version"},
           {head, "the question is damaged"},
           {head + row({"{\"parts\":3,"}), "the question is damaged"},
           {head + row({"{\"parts\":3,"}) + "<row r='9'><c t='str'><v>}</v></c></row>",
            "A3: a part of the request is missing"},
           {head + row({"{}"}), "the question has no parts"},
           {head + row({"{\"parts\":3,\"spare\":1}"}), "unknown key 'spare'"},
           {head + row({"{\"parts\":{\"file\":\"/etc/passwd\"}}"}),
            "parts names a file, which the question of a workbook may not; delete the sheet "},
           {head + row({"{\"parts\":3,\"never\":{\"file\":\"/etc/passwd\"}}"}),
            "never names a file"}}) {
    const std::string said = fault(cells);
    EXPECT_THAT(said, HasSubstr(what)) << cells;
    EXPECT_THAT(said, HasSubstr("delete the sheet")) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos);
  }
}

TEST_F(RunSheetWorkbook, AnyWorkbookOfThisKindIsReadInItsWholeOrRefused) {
  const std::string good = filled_in(planned(), {"pass"});
  const std::string json = to_json(asked.question);
  test::Members members = unzipped(good);
  std::mt19937_64 random(3);
  int taken = 0;
  for (int i = 0; i < 200; ++i) {
    test::Members bad = members;
    auto member = bad.begin();
    std::advance(member, static_cast<std::ptrdiff_t>(random() % bad.size()));
    if (!member->second.empty()) {
      member->second[random() % member->second.size()] = "<>\"'a0{}"[random() % 8];
    }
    try {
      const CheckedJobRequest again = checked_job(opened(zipped(bad)), Door::document);
      ++taken;
      EXPECT_TRUE(defects(*again->job).empty());
    } catch (const BadInput& fault) {
      EXPECT_EQ(std::string(fault.what()).find('\n'), std::string::npos);
    }
  }
  EXPECT_GT(taken, 20);
}

TEST(WorkbookQuestion, PiecesAreWholeLetters) {
  std::string document;
  for (int i = 0; i < 9000; ++i) {
    document += i % 3 == 0 ? "é" : "漢";
  }
  const auto pieces = question_pieces(document);
  std::string together;
  for (const std::string& piece : pieces) {
    EXPECT_LE(piece.size(), 8100U);
    EXPECT_FALSE(text_defect(piece));
    together += piece;
  }
  EXPECT_EQ(together, document);
  EXPECT_GT(pieces.size(), 2U);
}

// Whatever the names.
RC_GTEST_PROP(WorkbookQuestionProperty, NamesComeBack, ()) {
  JobRequest request{.at_once = 3, .test_cost = "1", .change_cost = "2", .steps = 50};
  request.parts.rows.emplace();
  for (const std::string& name : test::some_names(4 + some_number(4))) {
    request.parts.rows->push_back({{name}});
  }
  CheckedJobRequest asked = checked_job(request, Door::document);
  RunControl control({.threads = 1});
  const PlanAnswer answer = answer_to(asked, control);
  const std::string bytes = written(asked, answer, "xlsx");
  const CheckedJobRequest again =
      checked_job(opened(filled_in(bytes, {"pass", "fail"})), Door::document);
  RC_ASSERT(again->job->names == asked->job->names);
  RC_ASSERT(again->job->tests_done == std::min<std::uint64_t>(2, answer.plan->sheet.steps.size()));
}

}  // namespace
}  // namespace changeover::workbook_question_test
