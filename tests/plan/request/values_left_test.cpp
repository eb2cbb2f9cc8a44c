// Values of a model that broke: no test has them from then on, and what was done stays done.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "changeover/plan/model.hpp"
#include "request/workbook/planned_workbook.hpp"
#include "run_workbooks.hpp"

namespace changeover::values_left_test {
namespace {

using test::filled_in;
using test::opened;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class ValuesLeft : public test::PlannedWorkbook {
 protected:
  ValuesLeft() {
    request.test_cost = "1";
    request.change_cost = "2";
    request.steps = 500;
    request.model.text =
        "OS: Debian, Fedora, Windows\nBrowser: Firefox, Edge, Opera\nLog: on, off\n"
        "IF [Browser] = \"Edge\" THEN [OS] = \"Windows\";\n";
  }

  void expect_no_test_with(const std::string& value) {
    EXPECT_THAT(asked.job->names, Not(Contains(value)));
    for (const RunStep& step : answer.plan->sheet.steps) {
      EXPECT_TRUE(follows(*asked.job->model, step.setup));
    }
    EXPECT_EQ(written(*checked, answer, "csv").find(value), std::string::npos);
  }

  std::string fault(const std::vector<std::string>& without) {
    request.without = without;
    try {
      static_cast<void>(checked_job(request, Door::document));
    } catch (const Error& bad) {
      return bad.what();
    }
    return "none";
  }
};

TEST_F(ValuesLeft, AreAllThatIsPlanned) {
  planned();
  const std::uint64_t all = asked.job->needed.size();
  request.without = {"OS: Fedora", "opera"};
  planned();
  EXPECT_THAT(asked.job->names, ElementsAre("Debian", "Windows", "Firefox", "Edge", "on", "off"));
  EXPECT_LT(asked.job->needed.size(), all);
  EXPECT_THAT(asked.notes, Contains("without: left out from now on: Fedora, Opera"));
  expect_no_test_with("Fedora");
}

TEST_F(ValuesLeft, StayLeftOutFromWorkbookToWorkbook) {
  const std::string bytes = planned();
  const std::string with_fedora = written(*checked, answer, "csv");
  ASSERT_NE(with_fedora.find("Fedora"), std::string::npos);
  JobRequest more;
  more.without = {"Fedora"};
  const std::string next = planned(opened(filled_in(bytes, {"pass", "pass", "pass"}), more));
  EXPECT_EQ(asked.job->tests_done, 3U);
  expect_no_test_with("Fedora");
  // It is not said again, and another value breaks.
  planned(opened(next));
  expect_no_test_with("Fedora");
  more.without = {"Opera"};
  planned(opened(filled_in(next, {"pass"}), more));
  expect_no_test_with("Fedora");
  expect_no_test_with("Opera");
}

// Of values that two parameters share, the sheet of what was done has the whole names.
TEST_F(ValuesLeft, SharedNamesCountFromWorkbookToWorkbook) {
  request.model.text = "OS: Win, Deb, Mac\nLog: On, Off\nRetry: On, Off\n";
  std::string bytes = planned(opened(filled_in(planned(), {"pass", "pass", "pass"})));
  const std::uint64_t left = asked.job->needed.size();
  for (int round = 0; round < 2; ++round) {
    bytes = planned(opened(bytes));
    EXPECT_EQ(asked.job->tests_done, 3U);
    EXPECT_EQ(asked.job->needed.size(), left);
  }
}

TEST_F(ValuesLeft, OtherListsMayNameThoseThatBroke) {
  request.without = {"Fedora"};
  request.never.rows = {{{{"Fedora", "Opera"}}, {{"Debian", "Opera"}}}};
  request.change_costs.rows = {{{{"OS", "Fedora", "5"}}, {{"OS", "Debian", "7"}}}};
  request.done.rows = {{{{"Fedora", "Firefox", "on"}}, {{"Debian", "Firefox", "off"}}}};
  planned();
  EXPECT_EQ(asked.job->tests_done, 2U);
  EXPECT_EQ(asked.job->never.size(), 1U);
  EXPECT_EQ(to_string(asked.job->change_costs.front()), "7");
  expect_no_test_with("Fedora");
}

TEST_F(ValuesLeft, AParameterNeedsOne) {
  EXPECT_THAT(fault({"on", "off"}), HasSubstr("no value of 'Log' is left; leave one"));
  EXPECT_THAT(fault({"Solaris"}), HasSubstr("no parameter has the value 'Solaris'"));
}

}  // namespace
}  // namespace changeover::values_left_test
