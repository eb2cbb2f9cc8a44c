// Cells of planned tests that were cleared on a workbook: its question says what every test has.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "changeover/plan/job_request.hpp"
#include "message_of.hpp"
#include "planned_workbook.hpp"
#include "run_workbooks.hpp"

namespace changeover::emptied_places_test {
namespace {

using test::filled_in;
using test::opened;
using testing::HasSubstr;

// The workbook without these cells of its run sheet.
std::string cleared(const std::string& bytes, std::initializer_list<std::string> cells) {
  test::Members members = test::unzipped(bytes);
  std::string& xml = members[test::member_of(bytes, "Run sheet")];
  for (const std::string& cell : cells) {
    const std::size_t begin = xml.find("<c r=\"" + cell + "\"");
    EXPECT_NE(begin, std::string::npos) << cell;
    xml.erase(begin, xml.find("</c>", begin) + 4 - begin);
  }
  return test::zipped(members);
}

class EmptiedPlaces : public test::PlannedWorkbook {
 protected:
  EmptiedPlaces() {
    request.test_cost = "2";
    request.change_cost = "1";
    request.steps = 1000;
  }
};

// Columns: step, set, OS, Browser, Locale. Without "set" nothing else says what was there.
TEST_F(EmptiedPlaces, EveryTestOfAModelHasAValueOfEachParameter) {
  request.model.text = "OS: Debian, Fedora, ARM\nBrowser: Firefox, Edge\nLocale: de, en\n";
  const std::string bytes = filled_in(planned(), {"pass", "pass"});
  EXPECT_EQ(message_of([&] { static_cast<void>(opened(bytes)); }), "");
  EXPECT_THAT(message_of([&] {
                static_cast<void>(opened(cleared(bytes, {"B1", "B2", "B3", "D3"})));
              }),
              HasSubstr("parts:Run sheet: row 3: a cell is empty, but every planned test has a "
                        "value of 'Browser'; write what was there, or remove the number of the "
                        "step if this was another test"));
  // A test of the user's own may leave it open, and what was not done has nothing to say.
  EXPECT_EQ(message_of([&] {
              static_cast<void>(opened(cleared(bytes, {"A3", "B1", "B2", "B3", "D3"})));
            }),
            "");
  EXPECT_EQ(message_of([&] {
              static_cast<void>(opened(cleared(bytes, {"B1", "B2", "B3", "B4", "D4"})));
            }),
            "");
}

TEST_F(EmptiedPlaces, AColumnThatWasDeletedIsMissedByTheQuestion) {
  request.model.text = "OS: Debian, Fedora, ARM\nBrowser: Firefox, Edge\nLocale: de, en\n";
  const std::string bytes = filled_in(planned(), {"pass", "pass"});
  // Its head, the figures and what is set are gone, too.
  EXPECT_THAT(
      message_of([&] {
        static_cast<void>(opened(cleared(bytes, {"B1", "B2", "B3", "E1", "E2", "E3", "F1"})));
      }),
      HasSubstr("row 2: the column of 'Locale' is missing, which every planned test has; put it "
                "back"));
}

TEST_F(EmptiedPlaces, EverySetUpHasTheLeastOfASlot) {
  request.parts.rows = {{{{"Xeon", "1", "CPU"}},
                         {{"Epyc", "1", "CPU"}},
                         {{"d1", "1", "disk"}},
                         {{"d2", "1", "disk"}},
                         {{"n1", "1", "NIC"}},
                         {{"n2", "1", "NIC"}}}};
  request.slots.rows = {{{{"CPU", "1", "1"}}, {{"disk", "1", "1"}}, {{"NIC", "0", "1"}}}};
  request.at_once = 3;
  const std::string bytes = filled_in(planned(), {"pass", "pass", "pass"});
  // Columns: step, and the slots of CPU, disk and NIC.
  const auto said = [&](const std::string& cell) {
    return message_of([&] { static_cast<void>(opened(cleared(bytes, {cell}))); });
  };
  EXPECT_THAT(said("C3"), HasSubstr("row 3: a cell is empty, but every planned test has a part in "
                                    "slot 'disk'"));
  EXPECT_EQ(said("D3"), "");  // that slot may be empty
}

}  // namespace
}  // namespace changeover::emptied_places_test
