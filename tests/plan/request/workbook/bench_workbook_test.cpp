// A workbook of several benches is the whole question: it comes back filled in, and is planned
// again with nothing else.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "changeover/plan/job_request.hpp"
#include "planned_workbook.hpp"
#include "run_workbooks.hpp"
#include "some_names.hpp"
#include "zip_files.hpp"

namespace changeover::bench_workbook_test {
namespace {

using test::filled_in;
using test::opened;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class BenchWorkbook : public test::PlannedWorkbook {
 protected:
  BenchWorkbook() {
    request.at_once = 3;
    request.test_cost = "1.5";
    request.steps = 2000;
    request.title = "Week 12";
    request.parts.rows = {{{{"H100", "0.5", "GPU", "1"}},
                           {{"A40", "0.25", "GPU", "2"}},
                           {{"L4", "0.25", "GPU", "2"}},
                           {{"Epyc", "1", "CPU", "1"}},
                           {{"Xeon", "1", "CPU", "2"}},
                           {{"NVMe", "0.1", "", "2"}},
                           {{"Disk, old", "0.1", "", "3"}}}};
    request.slots.rows = {{{{"GPU", "1", "2"}}, {{"CPU", "1", "1"}}}};
    request.never.rows = {{{{"L4", "Epyc", "no driver"}}}};
    request.benches.text =
        "bench,hours,at once,without,start,slots,own,test cost,change factor,mounted,down\n"
        "North,8,,,\"H100, Epyc\",,,,,,\n"
        "South,10,,H100,,GPU=1..1,Epyc,2,1.5,,\n"
        "\"West, old\",,,,,,,,,,yes\n";
    request.hours = "6";
    request.first_day = "2025-03-31";
  }

  [[nodiscard]] std::uint64_t done_on(std::size_t bench) const {
    return asked.benches.at(bench).tests_done;
  }
};

TEST_F(BenchWorkbook, AsksTheSameQuestionAgain) {
  const std::string bytes = planned();
  const std::string before = written(*checked, answer, "csv");
  const std::vector<Bench> benches = asked.benches;
  const OpenedRequest again = opened(bytes);
  EXPECT_THAT(again.notes,
              ElementsAre("parts: the question is that of its hidden sheet changeover-question"));
  EXPECT_FALSE(again.request.done.is_given()) << "nothing was filled in";
  EXPECT_EQ(again.request.title, "Week 12");
  planned(again);
  EXPECT_EQ(asked.benches, benches);
  EXPECT_EQ(written(*checked, answer, "csv"), before);
}

TEST_F(BenchWorkbook, IsPlannedAnewWithTheResultsOfEachBenchAgainAndAgain) {
  std::string bytes = planned();
  std::uint64_t north = 0;
  std::uint64_t south = 0;
  for (int day = 0; day < 3; ++day) {
    ASSERT_GE(answer.benches->sheets[0].steps.size(), 1U);
    const Block last_of_north = answer.benches->sheets[0].steps[0].setup;
    bytes = filled_in(bytes, {"pass"}, "North");
    const bool goes_on = answer.benches->sheets[1].steps.size() >= 2 && day < 2;
    if (goes_on) {
      bytes = filled_in(bytes, {"pass", "FAILED - hang"}, "South");
      south += 2;
    }
    north += 1;
    const OpenedRequest again = opened(bytes);
    EXPECT_TRUE(again.request.done.is_given());
    bytes = planned(again);
    EXPECT_EQ(done_on(0), north);
    EXPECT_EQ(done_on(1), south);
    EXPECT_EQ(asked.done.size(), north + south);
    Block start = asked.benches[0].start.value();
    std::sort(start.begin(), start.end());
    Block last = last_of_north;
    std::sort(last.begin(), last.end());
    EXPECT_EQ(start, last);
    EXPECT_TRUE(asked.benches[2].down);
    EXPECT_TRUE(answer.benches->does_the_job());
  }
  EXPECT_GT(south, 0U);
  EXPECT_THAT(workbook_sheets(bytes, "f"), Contains(SheetName{"Done", false}));
  EXPECT_THAT(workbook_sheets(bytes, "f"), Contains(SheetName{"changeover-question", true}));
}

TEST_F(BenchWorkbook, ALostSheetIsNoted) {
  const std::string bytes = filled_in(planned(), {"pass"}, "North");
  EXPECT_THAT(opened(bytes).notes, Not(Contains(HasSubstr("put back"))));
  test::Members members = test::unzipped(bytes);
  std::string& sheets = members["xl/workbook.xml"];
  const std::size_t begin = sheets.find("<sheet name=\"North\"");
  ASSERT_NE(begin, std::string::npos);
  sheets.erase(begin, sheets.find("/>", begin) + 2 - begin);
  EXPECT_THAT(opened(test::zipped(members)).notes,
              Contains("parts: 2 sheets for 3 benches, none with tests of North; put back a sheet "
                       "that had results"));
}

// A copy of another bench's sheet does not make up for it.
TEST_F(BenchWorkbook, ALostSheetIsNotedBesideACopyOfAnother) {
  test::Members members = test::unzipped(filled_in(planned(), {"pass"}, "South"));
  std::string& sheets = members["xl/workbook.xml"];
  const auto tab = [&](const std::string& name) {
    const std::size_t begin = sheets.find("<sheet name=\"" + name + "\"");
    return sheets.substr(begin, sheets.find("/>", begin) + 2 - begin);
  };
  std::string copy = tab("South");
  copy.replace(copy.find("South"), 5, "Copy of South");
  const std::string north = tab("North");
  sheets.replace(sheets.find(north), north.size(), copy);
  EXPECT_THAT(opened(test::zipped(members)).notes,
              Contains("parts: 3 sheets for 3 benches, none with tests of North; put back a sheet "
                       "that had results"));
}

// The column bench is gone: the tabs say it.
TEST_F(BenchWorkbook, TabsSayWhoseTestsTheyHave) {
  const std::string bytes = filled_in(planned(), {"pass"}, "South");
  test::Members members = test::unzipped(bytes);
  std::string& sheet = members[test::member_of(bytes, "South")];
  for (std::size_t at = 0; (at = sheet.find("<c r=\"A", at)) != std::string::npos;) {
    sheet.erase(at, sheet.find("</c>", at) + 4 - at);
  }
  const CheckedJobRequest again = checked_job(opened(test::zipped(members)), Door::document);
  ASSERT_EQ(again->record.tests.size(), 1U);
  EXPECT_EQ(again->record.tests[0].bench, "South");
  EXPECT_THAT(again->notes,
              Contains(HasSubstr(":South: tests without a bench are those of South")));
}

TEST_F(BenchWorkbook, ResultsStandWithTheirBench) {
  const std::string bytes =
      filled_in(filled_in(planned(), {"pass"}, "North"), {"fail", "ok"}, "South");
  const CheckedJobRequest again = checked_job(opened(bytes), Door::document);
  ASSERT_EQ(again->record.tests.size(), 3U);
  std::vector<std::string> said;
  for (const DoneRecord::Test& test : again->record.tests) {
    said.push_back(test.bench + ": " + test.result);
  }
  EXPECT_THAT(said, ElementsAre("North: pass", "South: fail", "South: ok"));
}

TEST_F(BenchWorkbook, OtherBenchesWinOverItsQuestion) {
  request.hours.clear();
  const std::string bytes = filled_in(planned(), {"pass"}, "North");
  JobRequest more;
  more.benches.number = 2;
  planned(opened(bytes, more));
  EXPECT_EQ(asked.benches.size(), 2U);
  EXPECT_EQ(asked.done.size(), 1U);
}

TEST_F(BenchWorkbook, WhenAllIsDoneNothingIsLeft) {
  std::string bytes = planned();
  for (std::size_t b = 0; b < 2; ++b) {
    const std::vector<std::string> all(answer.benches->sheets[b].steps.size(), "pass");
    bytes = filled_in(bytes, all, b == 0 ? "North" : "South");
  }
  planned(opened(bytes));
  EXPECT_EQ(answer.benches->tests, 0U);
  EXPECT_TRUE(answer.benches->does_the_job());
}

TEST_F(BenchWorkbook, ABenchThatFailsIsPutDownOnItsSheetOfBenches) {
  const std::string bytes = filled_in(planned(), {"pass"}, "South");
  const std::string down = filled_in(bytes, {"", "yes"}, "Benches", "down");
  const OpenedRequest again = opened(down);
  EXPECT_THAT(again.notes.back(), HasSubstr("benches from 'Benches', changed since the plan"));
  std::string next = planned(again);
  EXPECT_TRUE(asked.benches[1].down);
  EXPECT_EQ(done_on(1), 1U);
  EXPECT_THAT(answer.benches->sheets[1].steps, IsEmpty());
  // It stays so in what comes after, until the sheet says otherwise.
  next = planned(opened(filled_in(next, {"pass"}, "North")));
  EXPECT_TRUE(asked.benches[1].down);
  EXPECT_EQ(asked.done.size(), 2U);
}

TEST_F(BenchWorkbook, APartThatBrokeIsLeftOut) {
  std::string bytes = filled_in(planned(), {"pass"}, "North");
  JobRequest more;
  more.without = {"A40"};
  bytes = planned(opened(bytes, more));
  EXPECT_EQ(asked.done.size(), 1U);
  EXPECT_THAT(asked.job->names, Not(Contains("A40")));
  const CheckedJobRequest again =
      checked_job(opened(filled_in(bytes, {"pass"}, "North")), Door::document);
  EXPECT_THAT(again->job->names, Not(Contains("A40")));
  EXPECT_EQ(again->done.size(), 2U);
}

TEST_F(BenchWorkbook, HoldsEveryListOfItsQuestion) {
  request.pairs.text = "H100,Epyc\nA40,Xeon\nL4,Xeon\nNVMe,Xeon\n";
  request.first.rows = {{{{"A40", "Xeon", "NVMe"}, {}, "North"}, {{"L4", "Xeon"}, {}, "2"}}};
  request.weights.text = "A40,Xeon,3\n";
  request.budget = "40";
  request.mounted = {};
  const std::string bytes = planned();
  const CheckedJobRequest again = checked_job(opened(bytes), Door::document);
  EXPECT_EQ(again->benches, asked.benches);
  EXPECT_EQ(again->job->names, asked.job->names);
  EXPECT_EQ(again->job->change_costs, asked.job->change_costs);
  EXPECT_EQ(again->job->quantities, asked.job->quantities);
  EXPECT_EQ(again->job->needed.size(), asked.job->needed.size());
  EXPECT_EQ(to_json(again->question), to_json(asked.question));
  ASSERT_TRUE(again->benches[0].first);
  EXPECT_EQ(again->benches[0].first->size(), 1U);
  EXPECT_EQ(again->benches[1].first->size(), 1U);
}

TEST_F(BenchWorkbook, ABudgetIsLessByWhatWasDoneOnEachBench) {
  request.budget = "30";
  const std::string bytes = filled_in(filled_in(planned(), {"pass"}, "North"), {"pass"}, "South");
  ASSERT_FALSE(answer.benches->sheets[1].steps.empty());
  const Amount spent =
      answer.benches->sheets[0].steps[0].cost + answer.benches->sheets[1].steps[0].cost;
  const OpenedRequest again = opened(bytes);
  EXPECT_EQ(parse_amount(again.request.budget), parse_amount("30") - spent);
  EXPECT_THAT(again.notes, Contains(HasSubstr("of the budget of 30 is spent on 2 tests")));
}

TEST_F(BenchWorkbook, TheRestBeginsOnTheDayAfterWhatWasDone) {
  const std::string bytes = planned();
  const auto steps = answer.benches->sheets[0].steps.size();
  ASSERT_GE(steps, 1U);
  // All of the first day is done, on each bench.
  const auto first_day_of = [&](std::size_t bench, const std::string& hours) {
    std::vector<std::string> results;
    for (const StepTime& time : answer.benches->times[bench]) {
      if (time.end <= parse_amount(hours)) {
        results.emplace_back("pass");
      }
    }
    return results;
  };
  const std::string filled =
      filled_in(filled_in(bytes, first_day_of(0, "8"), "North"), first_day_of(1, "10"), "South");
  const OpenedRequest again = opened(filled);
  if (checked_job(again, Door::document)->done.size() < answer.benches->tests) {
    EXPECT_EQ(again.request.first_day, "2025-04-01");
    EXPECT_THAT(again.notes, Contains(HasSubstr("the rest begins on 2025-04-01")));
  }
  JobRequest more;
  more.first_day = "2025-04-07";
  EXPECT_EQ(opened(filled, more).request.first_day, "2025-04-07");
  EXPECT_EQ(opened(bytes).request.first_day, "2025-03-31");
}

// Ratios are those of one list: benches have none.
TEST_F(BenchWorkbook, ItsRatiosAreThoseOfOneBench) {
  const std::string bytes = filled_in(planned(), {"pass"}, "North");
  JobRequest more;
  more.what_if = true;
  const OpenedRequest again = opened(bytes, more);
  check_options(again.request, Door::document);
  EXPECT_THAT(again.notes, Contains(HasSubstr("all tests on one bench")));
  const CheckedJobRequest left = checked_job(again, Door::document);
  EXPECT_EQ(left->done.size(), 1U);
  RunControl control({.threads = 1});
  EXPECT_FALSE(answer_to(left, control).what_if->ranges.empty());
}

TEST_F(BenchWorkbook, IsDiagnosedAndGoesOn) {
  // Little has passed, so much is suspect.
  std::string bytes = filled_in(filled_in(planned(), {"fail"}, "North"), {"pass"}, "South");
  JobRequest more;
  more.diagnose = true;
  for (std::uint64_t round = 2; round < 4; ++round) {
    const OpenedRequest again = opened(bytes, more);
    check_options(again.request, Door::document);
    const CheckedJobRequest of_results = checked_job(again, Door::document);
    EXPECT_EQ(of_results->results.size(), round);
    RunControl control({.threads = 1});
    const PlanAnswer found = answer_to(of_results, control);
    ASSERT_TRUE(found.diagnosis->next);
    // The next test is on a sheet to fill in, and its result counts for its bench.
    bytes = filled_in(written(of_results, found, "xlsx"), {"pass"});
  }
  planned(opened(bytes));
  EXPECT_EQ(asked.question.title, "Week 12");
  EXPECT_EQ(asked.done.size(), 4U);
  EXPECT_EQ(done_on(0) + done_on(1), 4U);
  EXPECT_FALSE(asked.benches[0].rest.empty()) << "what was planned is a candidate";
}

TEST_F(BenchWorkbook, SoManyBenchesThatAreAlike) {
  request.benches = {};
  request.benches.number = 2;
  request.hours.clear();
  request.first_day.clear();
  const std::string bytes = planned();
  const OpenedRequest again = opened(filled_in(bytes, {"pass"}, "Bench 1"));
  EXPECT_EQ(again.request.benches.number, 2U);
  planned(again);
  EXPECT_EQ(done_on(0), 1U);
  // One of them fails.
  const OpenedRequest down = opened(filled_in(bytes, {"", "yes"}, "Benches", "down"));
  planned(down);
  EXPECT_TRUE(asked.benches[1].down);
}

// Given as tests that were done, all its sheets are read, from bytes and with slots, too.
TEST_F(BenchWorkbook, AsTestsThatWereDone) {
  const std::string bytes =
      filled_in(filled_in(planned(), {"pass"}, "North"), {"fail", "ok"}, "South");
  JobRequest with = request;
  with.done.workbook = bytes;
  const CheckedJobRequest read = checked_job(with, Door::document);
  EXPECT_EQ(read->benches[0].tests_done, 1U);
  EXPECT_EQ(read->benches[1].tests_done, 2U);
  // On one bench all of them count.
  with.benches = {};
  with.hours.clear();
  with.first_day.clear();
  EXPECT_EQ(checked_job(with, Door::document)->done.size(), 3U);
}

// Whatever the names.
RC_GTEST_PROP(BenchWorkbookProperty, NamesComeBack, ()) {
  JobRequest request{.at_once = 3, .test_cost = "1", .change_cost = "2", .steps = 50};
  request.parts.rows.emplace();
  const std::vector<std::string> parts = test::some_names(4 + test::some_number(4));
  for (const std::string& name : parts) {
    request.parts.rows->push_back({{name}});
  }
  request.benches.rows.emplace();
  for (const std::string& name : test::some_names(2 + test::some_number(3))) {
    request.benches.rows->push_back({{name}});
  }
  CheckedJobRequest asked = checked_job(request, Door::document);
  RunControl control({.threads = 1});
  const PlanAnswer answer = answer_to(asked, control);
  const std::string bytes = written(asked, answer, "xlsx");
  const auto sheets = workbook_sheets(bytes, "f");
  const CheckedJobRequest again =
      checked_job(opened(filled_in(bytes, {"pass", "fail"}, sheets.front().name)), Door::document);
  RC_ASSERT(again->job->names == asked->job->names);
  RC_ASSERT(again->benches.size() == asked->benches.size());
  for (std::size_t b = 0; b < asked->benches.size(); ++b) {
    RC_ASSERT(again->benches[b].name == asked->benches[b].name);
  }
  RC_ASSERT(again->benches[0].tests_done ==
            std::min<std::uint64_t>(2, answer.benches->sheets[0].steps.size()));
}

}  // namespace
}  // namespace changeover::bench_workbook_test
