// A workbook of a model on several benches: its lists count as they are edited.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "changeover/plan/job_request.hpp"
#include "changeover/plan/model.hpp"
#include "message_of.hpp"
#include "planned_workbook.hpp"
#include "run_program.hpp"
#include "run_workbooks.hpp"

namespace changeover::model_workbook_test {
namespace {

using test::filled_in;
using test::opened;
using test::with_row;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class ModelWorkbook : public test::PlannedWorkbook {
 protected:
  ModelWorkbook() {
    request.model.text = "OS: Debian, Fedora, ARM\nBrowser: Firefox, Edge\nLocale: de, en\n";
    request.test_cost = "2";
    request.change_costs.text =
        "OS,3\nOS,Debian,Fedora,5\nOS,ARM,quantity,1\nBrowser,1\nLocale,1\n";
    request.steps = 1000;
    request.benches.text = "bench,without,mounted,down\nX,ARM,,\nY,,,\n";
  }
};

constexpr const char* question =
    "parts: the question is that of its hidden sheet changeover-question";

TEST_F(ModelWorkbook, IsAskedAgainAsItWasIfNothingWasEdited) {
  const std::string bytes = planned();
  const std::string before = written(*checked, answer, "csv");
  const OpenedRequest again = opened(bytes);
  EXPECT_THAT(again.notes, ElementsAre(question));
  planned(again);
  EXPECT_EQ(written(*checked, answer, "csv"), before);
}

TEST_F(ModelWorkbook, ABenchThatIsMarkedDownHasNoTests) {
  const std::string bytes = planned();
  ASSERT_FALSE(answer.benches->sheets[1].steps.empty());
  const OpenedRequest again = opened(filled_in(bytes, {"", "yes"}, "Benches", "down"));
  EXPECT_THAT(
      again.notes,
      ElementsAre(question, "parts: benches from 'Benches', changed since the plan was made"));
  planned(again);
  EXPECT_FALSE(asked.benches[0].down);
  EXPECT_TRUE(asked.benches[1].down);
  EXPECT_THAT(answer.benches->sheets[1].steps, IsEmpty());
  EXPECT_THAT(asked.notes, Contains(HasSubstr("cannot meet on any bench that works")));
}

TEST_F(ModelWorkbook, CostsCountAsTheyAreEditedAndWhatTheirSheetDoesNotSayStays) {
  const std::string bytes = planned();
  const OpenedRequest again = opened(with_row(bytes, "Costs", {"OS", "Fedora", "7.5"}));
  EXPECT_THAT(again.notes,
              ElementsAre(question, "parts: costs from 'Costs', changed since the plan was made"));
  planned(again);
  const Job& job = *asked.job;
  EXPECT_EQ(to_string(job.change_costs[1]), "7.50");
  EXPECT_EQ(to_string(job.change_costs[0]), "3");
  EXPECT_EQ(to_string(job.replace_cost(0, 1)), "5");     // as before
  EXPECT_EQ(to_string(job.replace_cost(2, 1)), "7.50");  // as any other
  EXPECT_EQ(to_string(job.replace_cost(1, 0)), "3");
  EXPECT_EQ(job.quantities[2], 1U);
  // Again, from the workbook of that.
  const OpenedRequest third = opened(planned(again));
  EXPECT_THAT(third.notes, ElementsAre(question));
  planned(third);
  EXPECT_EQ(to_string(asked.job->replace_cost(2, 1)), "7.50");
  EXPECT_EQ(asked.job->quantities[2], 1U);
}

TEST_F(ModelWorkbook, AWrongCostIsSaidWithItsPlace) {
  const std::string bytes = planned();
  EXPECT_THAT(message_of([&] {
                (void)opened(with_row(bytes, "Costs", {"OS", "Arch", "7.5"}));
              }),
              HasSubstr("parts:Costs!B9: OS has no value 'Arch'"));
}

// Everything in the workbook names what the model has no more: costs, pairs, benches, results.
TEST_F(ModelWorkbook, AParameterThatWasTakenOutOfTheModelIsLeftOut) {
  request.change_costs.text = "OS,3\nOS,ARM,quantity,1\nBrowser,1\nLocale,1\nLocale,de,en,4\n";
  request.never.text = "de,ARM\nen,Edge\nDebian,Edge\n";
  request.benches.text = "bench,without,mounted,down\nX,\"ARM,de\",,\nY,,en,\n";
  const std::string bytes = filled_in(planned(), {"pass", "pass", "fail"}, "X");
  JobRequest other;
  other.model.text = "OS: Debian, Fedora, ARM\nBrowser: Firefox, Edge\n";
  const OpenedRequest again = opened(bytes, other);
  EXPECT_THAT(again.notes, Contains("parts: no longer in the model, and left out: Locale: de, "
                                    "Locale: en, Locale"));
  planned(again);
  EXPECT_THAT(asked.notes,
              Contains(HasSubstr("the parameter 'Locale' is no longer in the model, so its")));
  const Job& job = *asked.job;
  EXPECT_EQ(job.parts(), 5U);
  EXPECT_EQ(job.never.size(), 1U);
  ASSERT_FALSE(asked.done.empty());
  EXPECT_EQ(asked.benches[0].tests_done, asked.done.size());
  // The state of the bench is that of its last test, and Y has nothing any more that stays.
  const auto& last = asked.done.back().setup;
  EXPECT_EQ(last.size(), 2U);
  EXPECT_EQ(asked.benches[0].start, last);
  EXPECT_THAT(asked.benches[1].mounted.value_or(Block()), IsEmpty());
}

// A short name may mean two values of the other model.
TEST_F(ModelWorkbook, ItsListsMeanTheSameValuesInAnotherModel) {
  request.benches = {};
  request.change_costs = {};
  request.change_cost = "1";
  request.model.text = "A: 1, 2, 3\nB: x, y, z\nC: u, v\n";
  request.pairs.text = "1,z\n2,x\n2,u\n";
  const std::string bytes = planned();
  JobRequest other;
  other.model.text = "A: 1, 2, 3\nB: x, y, z, 1\nC: u, v\n";
  const OpenedRequest again = opened(bytes, other);
  EXPECT_THAT(again.notes, Not(Contains(HasSubstr("no longer"))));
  planned(again);
  EXPECT_EQ(asked.job->needed.size(), 3U);
  EXPECT_TRUE(asked.job->needed.contains(0, 5));  // 1 of A and z
}

TEST_F(ModelWorkbook, ItsPairsMayAllBeGoneFromTheModel) {
  request.benches = {};
  request.change_costs = {};
  request.change_cost = "1";
  request.model.text = "A: 1, 2, 3\nB: x, y, z\nC: u, v\n";
  request.pairs.text = "1,z\n";
  const std::string bytes = planned();
  JobRequest other;
  other.model.text = "A: 1, 2, 3\nB: x, y\nC: u, v\n";
  EXPECT_EQ(message_of([&] { (void)opened(bytes, other); }),
            "parts: each of the pairs that were to be tested, as '1', 'z', has a value that is "
            "no longer in the model; list other pairs");
  other.pairs.text = "1,x\n";
  planned(opened(bytes, other));
  EXPECT_EQ(asked.job->needed.size(), 1U);
}

TEST_F(ModelWorkbook, AFileOfTheOtherModelIsReadOnce) {
  const std::string bytes = planned();
  const test::TemporaryFolder folder;
  JobRequest other;
  other.model.file = folder.file("m.txt");
  test::spit(other.model.file, "OS: Debian, Fedora, ARM\nBrowser: Firefox, Edge\n");
  const OpenedRequest again = opened(bytes, other);
  std::filesystem::remove(other.model.file);
  planned(again);
  EXPECT_EQ(asked.job->parts(), 5U);
  // Its name stays in messages, and it is at fault, not an option.
  test::spit(other.model.file, "OS: Debian\nBrowser: Edge\n[OS] = \"x\";\n");
  EXPECT_THAT(message_of([&] { planned(opened(bytes, other)); }),
              HasSubstr(other.model.file + ":3:"));
}

TEST_F(ModelWorkbook, ValuesThatWereLeftOutBeforeMayBeGoneFromTheModel) {
  request.benches = {};
  request.without = {"Locale: en"};
  request.start = {"Debian", "de"};
  const std::string bytes = planned();
  JobRequest other;
  other.model.text = "OS: Debian, Fedora, ARM\nBrowser: Firefox, Edge\n";
  planned(opened(bytes, other));
  EXPECT_THAT(asked.job->start, ElementsAre(0));
}

}  // namespace
}  // namespace changeover::model_workbook_test
