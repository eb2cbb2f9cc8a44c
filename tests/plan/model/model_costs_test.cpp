// What setting values costs, read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "changeover/core/error.hpp"
#include "some_models.hpp"

namespace changeover::model_costs_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

Job job() {
  return test::job_of_text("OS: Debian, Fedora | RHEL\nN: 8, 16, ~-1\nOff: x, y\n", "1", "7");
}

std::vector<std::string> read(const std::string& text) {
  Job costs = job();
  (void)read_value_costs(*input_from_text(text, "c.csv"), costs);
  std::vector<std::string> all;
  for (const Amount each : costs.change_costs) {
    all.push_back(to_string(each));
  }
  return all;
}

// Costs by what is replaced, within a parameter.
std::string replaced(const std::string& text, Element out, Element in) {
  Job costs = job();
  (void)read_value_costs(*input_from_text(text, "c.csv"), costs);
  return costs.replace_costs.empty() ? "none" : to_string(costs.replace_cost(out, in));
}

std::string complaint(const std::string& text) {
  try {
    (void)read(text);
  } catch (const Error& fault) {
    return fault.what();
  }
  return "no complaint";
}

TEST(ModelCosts, OfParametersAndOfValues) {
  EXPECT_THAT(read("OS,5\n"), ElementsAre("5", "5", "7", "7", "7", "7", "7"));
  EXPECT_THAT(read("# a comment\nparameter,value,cost\nOS,5\nos,rhel,2.50\nN,-1,3\nN,8,4\n"),
              ElementsAre("5", "2.50", "4", "7", "3", "7", "7"));
  EXPECT_THAT(read("Parameter;Cost\nOS;5,5\nN;16;0,25\nOff;~x;1\n"),
              ElementsAre("5.50", "5.50", "7", "0.25", "7", "1", "7"));
  EXPECT_THAT(read("OS,Debian,9\nOS,5\n"), ElementsAre("5", "5", "7", "7", "7", "7", "7"));
  Job costs = job();
  EXPECT_THAT(read_value_costs(*input_from_text("OS,5\nN,16,2\n"), costs),
              ElementsAre(true, true, false, true, false, false, false));
}

TEST(ModelCosts, OfWhatIsReplaced) {
  const std::string rows = "OS,5\nOS,Debian,Fedora,2\nN,8,16,1\n";
  EXPECT_EQ(replaced(rows, 0, 1), "2");
  EXPECT_EQ(replaced(rows, 1, 0), "5");
  EXPECT_EQ(replaced(rows, 2, 3), "1");
  EXPECT_EQ(replaced(rows, 3, 2), "7");
  EXPECT_EQ(replaced("OS,5\n", 0, 1), "none");
  // Later rows win, also over what was said of one replacement.
  EXPECT_EQ(replaced("OS,Debian,Fedora,8\nOS,5\nN,8,16,1\n", 0, 1), "5");
  EXPECT_EQ(replaced("OS,Debian,Fedora,8\nOS,Debian,5\n", 0, 1), "8");
  EXPECT_EQ(replaced("OS,Debian,Fedora,8\nOS,5\n", 0, 1), "none");
  const std::string table = "OS,5\nN,16,8,-1\n8,1,,2\n16,,3,4\n-1,5,6,\nOff,x,y,9\n";
  EXPECT_EQ(replaced(table, 2, 3), "1");
  EXPECT_EQ(replaced(table, 2, 4), "2");
  EXPECT_EQ(replaced(table, 3, 2), "3");
  EXPECT_EQ(replaced(table, 4, 3), "5");
  EXPECT_EQ(replaced(table, 5, 6), "9");
  EXPECT_EQ(replaced(table, 0, 1), "5");
  // Values that look like costs: a table has an empty field in its second row.
  Job numbers = test::job_of_text("A: 1, 2\nB: x, y\n");
  (void)read_value_costs(*input_from_text("A,1,2\nB,3\n"), numbers);
  EXPECT_EQ(to_string(numbers.change_costs[0]), "2");
  EXPECT_FALSE(numbers.replaces());
}

TEST(ModelCosts, HowManyThereAreOfAValue) {
  Job some = job();
  const std::vector<bool> given =
      read_value_costs(*input_from_text("OS,2\nN,16,Quantity,3\nOS,rhel,quantity,1\n"), some);
  EXPECT_THAT(some.quantities, ElementsAre(enough_for_all, 1U, enough_for_all, 3U, enough_for_all,
                                           enough_for_all, enough_for_all));
  EXPECT_FALSE(given[3]);  // that is no cost
  EXPECT_THAT(read("OS,2\nN,16,quantity,3\n"), ElementsAre("2", "2", "7", "7", "7", "7", "7"));
  for (const char* number : {"0", "-1", "1.5", "many"}) {
    EXPECT_EQ(complaint(std::string("N,16,quantity,") + number + "\n"),
              "c.csv:1:15: '" + std::string(number) +
                  "' is not a quantity; write how many there are, 1 or more");
  }
  for (const char* row : {"N,16,quantity\n", "N,16,quantity,\n"}) {
    EXPECT_EQ(complaint(row),
              "c.csv:1:6: no quantity of 16; write how many there are, or leave out this row if "
              "there are enough");
  }
}

TEST(ModelCosts, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(complaint(""), StartsWith("c.csv:1:1: no cost is listed"));
  EXPECT_EQ(complaint("OS,5\nBrowser,2\n"),
            "c.csv:2:1: no parameter is called 'Browser'; write it as the model does");
  EXPECT_EQ(complaint("OS,Arch,2\n"),
            "c.csv:1:4: OS has no value 'Arch'; write it as the model does");
  EXPECT_EQ(complaint("OS,Debian,Arch,2\n"),
            "c.csv:1:11: OS has no value 'Arch'; write it as the model does");
  EXPECT_THAT(complaint("OS,Debian,debian,2\n"),
              StartsWith("c.csv:1:11: 'debian' does not replace itself"));
  EXPECT_THAT(complaint("OS,much\n"), StartsWith("c.csv:1:4: "));
  EXPECT_THAT(complaint("OS,-5\n"), StartsWith("c.csv:1:4: "));
  EXPECT_THAT(complaint("OS\n"), StartsWith("c.csv:1:1: expected a cost; write OS,12.50"));
  EXPECT_THAT(complaint("OS,a,b,c,5\n"), StartsWith("c.csv:1:1: expected a cost; write OS,12.50"));
  EXPECT_THAT(complaint("OS,Debian,Fedora\nDebian,,1\n"),
              StartsWith("c.csv:1:1: the table of OS has 1 row;"));
  EXPECT_THAT(complaint("OS,Debian,Fedora\nDebian,,1\nDebian,,1\n"),
              StartsWith("c.csv:3:1: 'Debian' heads two rows"));
  EXPECT_THAT(complaint("OS,Debian,Fedora\nDebian,,1\nFedora,,1\n"),
              StartsWith("c.csv:3:1: no cost of Debian in place of 'Fedora'"));
  EXPECT_THAT(complaint("OS,Debian,Fedora\nDebian,,1\nFedora,1,2\n"),
              StartsWith("c.csv:3:10: 'Fedora' does not replace itself"));
  EXPECT_THAT(complaint("OS,Debian,Fedora\nDebian,,1\nFedora,1,,3\n"),
              StartsWith("c.csv:3:11: more costs than the table has columns"));
}

}  // namespace
}  // namespace changeover::model_costs_test
