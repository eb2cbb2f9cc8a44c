// Run sheets of a model that has lost a parameter since.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "changeover/core/error.hpp"
#include "changeover/plan/job.hpp"
#include "changeover/plan/model.hpp"
#include "plan/job/setups/setup_list.hpp"

namespace changeover::gone_parameters_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Job job(const std::string& model) {
  return job_of(read_model(*input_from_text(model, "m.txt")), {}, {});
}

DoneList read(const std::string& text, const std::string& model) {
  return read_done(*input_from_text(text, "d.csv"), job(model));
}

std::string fault(const std::string& text, const std::string& model) {
  try {
    static_cast<void>(read(text, model));
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return "none";
}

// As the program writes it of OS, Browser, Lang and Disk.
constexpr const char* sheet =
    "step,set,OS,Browser,Lang,Disk,new_pairs,cost,cost_so_far,result,notes\n"
    "1,\"OS: Arch, Browser: Edge, Lang: de, Disk: 1\",Arch,Edge,de,1,6,4,4,pass,\n"
    "2,\"OS: BSD, Lang: en\",BSD,Edge,en,1,5,3,7,fail,\n";

TEST(GoneParameters, AColumnOfOneIsNotReadAndItsTestsCount) {
  const DoneList list = read(sheet, "OS: Arch, BSD\nBrowser: Edge, Opera\nDisk: 1, 2\n");
  EXPECT_THAT(list.notes, ElementsAre("d.csv:1:21: the parameter 'Lang' is no longer in the "
                                      "model, so its column is not read"));
  ASSERT_EQ(list.rows.size(), 2U);
  EXPECT_THAT(list.rows[0].setup, ElementsAre(0, 2, 4));
  EXPECT_THAT(list.rows[1].setup, ElementsAre(1, 2, 4));
  EXPECT_EQ(list.rows[1].result, "fail");
  // What it had is kept for the sheet of tests that were done.
  EXPECT_THAT(list.rows[1].written, ElementsAre("BSD", "Edge", "en", "1"));
  ASSERT_EQ(list.places.size(), 4U);
  EXPECT_EQ(list.places[2].slot, "Lang");
  EXPECT_EQ(list.places[2].number, 4U);
}

TEST(GoneParameters, TheFirstAndTheLastOfThemAreFoundToo) {
  for (const std::string gone : {"OS", "Disk"}) {
    std::string model = "OS: Arch, BSD\nBrowser: Edge, Opera\nLang: de, en\nDisk: 1, 2\n";
    const std::size_t begin = model.find(gone + ":");
    model.erase(begin, model.find('\n', begin) + 1 - begin);
    EXPECT_THAT(read(sheet, model).notes,
                ElementsAre(HasSubstr("the parameter '" + gone + "' is no longer in the model")));
  }
}

TEST(GoneParameters, TheSheetOfTestsThatWereDoneHasThemAsPlaces) {
  const DoneList list =
      read("step,slot_1 OS,slot_3 Lang,slot_2 Browser,result\n1,Arch,de,Edge,pass\n",
           "OS: Arch, BSD\nBrowser: Edge, Opera\n");
  EXPECT_THAT(list.notes, ElementsAre(HasSubstr("d.csv:1:16: the parameter 'Lang' is no longer")));
  EXPECT_THAT(list.rows[0].setup, ElementsAre(0, 2));
}

TEST(GoneParameters, AMisspelledOneIsRefused) {
  const std::string model = "OS: Arch, BSD\nBrowser: Edge, Opera\nLang: de, en\nDisk: 1, 2\n";
  std::string text = sheet;
  text.replace(text.find("Browser"), 7, "Brwoser");
  EXPECT_EQ(fault(text, model),
            "d.csv:1:13: no parameter is called 'Brwoser'; did you mean 'Browser'? if it is "
            "another one, rename the column");
  EXPECT_EQ(fault(sheet, model), "none");
}

TEST(GoneParameters, OneWithTheValuesOfAnotherIsNotedWithIt) {
  const DoneList list = read(sheet,
                             "System: Arch, BSD\nBrowser: Edge, Opera\nLang: de, en\n"
                             "Disk: 1, 2\n");
  EXPECT_THAT(list.notes,
              ElementsAre("d.csv:1:10: the parameter 'OS' is no longer in the model, so its column "
                          "is not read; if it is 'System', whose values it has, head it so",
                          HasSubstr("no column has the values of 'System'")));
}

// What has the head of another column is no gone parameter, but the figures miss it.
TEST(GoneParameters, OneHeadedLikeAnotherColumnIsNamed) {
  const std::string model = "OS: Arch, BSD\nBrowser: Edge, Opera\n";
  for (const std::string head : {"Date", "Clock", "new pairs", "Verdict", "Test result"}) {
    std::string text = "step,set,OS,Browser," + head + ",new_pairs,cost,result,notes\n";
    text += "1,,Arch,Edge,1,3,4,pass,\n";
    const std::string why = fault(text, model);
    EXPECT_THAT(why, HasSubstr("3 new pairs, but the 2 parts here have only 1"));
    EXPECT_THAT(why, HasSubstr("; if '" + head +
                               "' is a parameter that the model had, head it "
                               "'slot_3 " +
                               head + "'"));
    text.insert(text.find(head), "slot_3 ");
    const DoneList list = read(text, model);
    EXPECT_THAT(list.rows[0].setup, ElementsAre(0, 2));
    EXPECT_EQ(list.rows[0].result, "pass");
    EXPECT_TRUE(list.rows[0].lacks);
    EXPECT_THAT(list.notes, ElementsAre(HasSubstr("the parameter '" + head + "' is no longer")));
  }
}

// No column is called result, and a parameter that is gone was: which one has the results?
TEST(GoneParameters, OneHeadedLikeResultsIsNotTakenForThem) {
  const std::string model = "OS: a, b, c\nC: p, q\n";
  const std::string rows = "a,ok,p,pass\nb,bad,p,fail\nc,ok,q,\n";
  EXPECT_EQ(fault("OS,Outcome,C,Ergebnis\n" + rows, model),
            "d.csv:4:3: 'ok' in the column 'Outcome', but the column 'Ergebnis' says nothing; name "
            "the column with the results 'result', and rename the other");
  EXPECT_EQ(fault("OS,Outcome,C,Ergebnis\na,ok,p,pass\nb,bad,p,fail\n", model), "none");
  // The one that is called so has them, whatever another one does not say.
  EXPECT_THAT(read("OS,result,C,Ergebnis\na,ok,p,pass\nb,bad,p,\n", model).notes,
              ElementsAre(HasSubstr("it says the same as that of the results, or nothing")));
  const DoneList list = read("OS,slot_3 Outcome,C,Ergebnis\n" + rows, model);
  EXPECT_EQ(list.rows[2].result, "");
  EXPECT_EQ(list.rows[1].result, "fail");
}

TEST(GoneParameters, InAListOfFirstTestsAHeadThatIsNoneIsRefusedOrNoted) {
  const Job all = job("OS: Arch, BSD\nBrowser: Edge, Opera\nLang: de, en\n");
  const auto first = [&](const std::string& text) {
    return read_list(*input_from_text(text, "f.csv"), all, 3, false);
  };
  EXPECT_THAT(first("OS,Tongue,Browser\nArch,de,Edge\n").notes,
              ElementsAre("f.csv:1:4: no parameter is called 'Tongue', so its column is not read, "
                          "and no column has the values of 'Lang'"));
  EXPECT_THAT(first("OS,Browser\nArch,Edge\n").notes, IsEmpty());
  EXPECT_THAT(first("OS,Browser,Lang,Who\nArch,Edge,de,Ann\n").notes, IsEmpty());
  try {
    static_cast<void>(first("OS,Langg,Browser\nArch,de,Edge\n"));
    ADD_FAILURE();
  } catch (const BadInput& bad) {
    EXPECT_THAT(bad.what(), HasSubstr("f.csv:1:4: no parameter is called 'Langg'; did you mean "
                                      "'Lang'?"));
  }
}

TEST(GoneParameters, InAListByHandAColumnInFrontMayBeOne) {
  const std::string model = "OS: Arch, BSD\nBrowser: Edge, Opera\n";
  const DoneList list = read(
      "Lang,OS,Browser,result,Rack\n~xx,Arch,Edge,pass,7\nde,Arch,Edge,pass,~2\n"
      "de,BSD,Edge,fail,2\n",
      model);
  EXPECT_THAT(list.notes,
              ElementsAre("d.csv:1:1: the column 'Lang' is not read; if it is a parameter "
                          "that the model had, head it 'slot_3 Lang'"));
  EXPECT_EQ(list.rows[0].hidden_by, "~xx");
  EXPECT_EQ(list.rows[1].hidden_by, "");  // behind the results
  EXPECT_EQ(list.rows[2].hidden_by, "");
  EXPECT_EQ(read("OS,Browser,Lang\nArch,Edge,~xx\n", model).rows[0].hidden_by, "~xx");
  for (const char* head : {"Nr", "Date", "Tester"}) {
    EXPECT_THAT(read(std::string(head) + ",OS,Browser,result\n1,Arch,Edge,pass\n", model).notes,
                Not(Contains(HasSubstr("a parameter"))));
  }
}

TEST(GoneParameters, WhatColumnsOfTheUserSayHidesNothing) {
  const std::string model = "OS: Arch, BSD\nBrowser: Edge, Opera\n";
  for (const std::string own : {"Duration", "Remark", "Date"}) {
    for (const std::string& text :
         {own + ",OS,Browser,result\n~5,Arch,Edge,pass\n",
          "OS,Browser,result," + own + "\nArch,Edge,pass,~5\n",
          "OS,Browser," + own + "\nArch,Edge,~5\n",
          "Rack," + own + ",OS,Browser,result\n~5 or so,~5,Arch,Edge,pass\n",
          "step,OS,Browser,result,Rack," + own + "\n1,Arch,Edge,pass,~5,~5\n"}) {
      EXPECT_EQ(read(text, model).rows[0].hidden_by, "") << text;
    }
  }
}

// Also between parameters; by hand, failures are then not blamed on what may be none.
TEST(GoneParameters, ColumnsOfTheUserAmongParametersAreNone) {
  const std::string model = "A: 1, 2\nB: x, y\nC: u, v\n";
  for (const std::string own : {"Operator", "Uhrzeit", "Comment", "Bemerkung", "Result note"}) {
    for (const std::string& text :
         {"A," + own + ",B,C,result\n1,~n,x,u,fail\n", "A,B,C," + own + ",result\n1,x,u,~n,fail\n",
          "step,A," + own + ",B,C,result\n1,1,~n,x,u,fail\n"}) {
      const DoneList list = read(text, model);
      EXPECT_THAT(list.notes, Not(Contains(HasSubstr("parameter")))) << text;
      EXPECT_FALSE(list.rows[0].lacks) << text;
      EXPECT_EQ(list.rows[0].hidden_by, "") << text;
      EXPECT_THAT(list.rows[0].setup, ElementsAre(0, 2, 4)) << text;
      EXPECT_EQ(list.rows[0].result, "fail") << text;
    }
  }
  DoneList list = read("A,Ticket,B,C,result\n1,40,x,u,fail\n", model);
  EXPECT_THAT(list.notes, ElementsAre("d.csv:1:3: the column 'Ticket' is not read; if it is a "
                                      "parameter that the model had, head it 'slot_4 Ticket'"));
  EXPECT_FALSE(list.rows[0].lacks);
  list = read("A,slot_4 Ticket,B,C,result\n1,40,x,u,fail\n", model);
  EXPECT_THAT(list.notes, ElementsAre(HasSubstr("the parameter 'Ticket' is no longer in the")));
  EXPECT_TRUE(list.rows[0].lacks);
}

TEST(GoneParameters, ColumnsOfTheUserAreNoParameters) {
  const std::string model = "OS: Arch, BSD\nBrowser: Edge, Opera\n";
  EXPECT_THAT(read("Tester,OS,Browser,result,Rack\nAnn,Arch,Edge,pass,7\n", model).notes,
              IsEmpty());
  EXPECT_THAT(read("OS,Browser,Remark\nArch,Edge,slow\n", model).notes, IsEmpty());
  EXPECT_THAT(
      read("step,set,OS,Browser,new_pairs,Tester,result\n1,,Arch,Edge,1,Ann,pass\n", model).notes,
      IsEmpty());
}

}  // namespace
}  // namespace changeover::gone_parameters_test
