// Tests that come first: of a model on several machines, each of which sets what they leave open.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "changeover/plan/model.hpp"
#include "request/workbook/planned_workbook.hpp"

namespace changeover::first_lists_test {
namespace {

using test::opened;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class FirstLists : public test::PlannedWorkbook {
 protected:
  FirstLists() {
    request.test_cost = "5";
    request.change_cost = "1";
    request.steps = 500;
    request.model.text =
        "OS: Debian, Fedora, ARM\nBrowser: Firefox, Edge, Chrome\nLocale: de, en\n"
        "IF [OS] = \"ARM\" THEN [Browser] <> \"Edge\";\n";
    request.benches.text = "name,without,down\nA,\"ARM, Fedora\",\nB,Debian,\nC,,yes\n";
  }

  // Whether the bench begins with these values, and has the rest as well.
  void expect_first(std::size_t bench, std::size_t at, const std::vector<std::string>& values) {
    const Block& setup = answer.benches->sheets[bench].steps.at(at).setup;
    for (const std::string& value : values) {
      EXPECT_TRUE(
          std::ranges::any_of(setup, [&](Element x) { return asked.job->names[x] == value; }))
          << bench << ' ' << at << ' ' << value;
    }
    EXPECT_THAT(setup, SizeIs(3));
    EXPECT_TRUE(follows(*asked.job->model, setup));
  }

  std::string fault(const std::string& first) {
    request.first.text = first;
    try {
      planned();
    } catch (const BadInput& bad) {
      return bad.what();
    }
    return "none";
  }
};

TEST_F(FirstLists, EachMachineSetsWhatATestLeavesOpen) {
  request.first.text = "OS,Browser,Locale,bench\n,Edge,,\nFedora,Chrome,de,B\n,Edge,en,\n";
  const std::string bytes = planned();
  const auto expect_all = [&] {
    expect_first(0, 0, {"Debian", "Edge"});
    expect_first(0, 1, {"Debian", "Edge", "en"});
    expect_first(1, 0, {"Fedora", "Edge"});  // ARM has no Edge, and B no Debian
    expect_first(1, 1, {"Fedora", "Edge", "en"});
    expect_first(1, 2, {"Fedora", "Chrome", "de"});
    EXPECT_THAT(answer.benches->sheets[2].steps, IsEmpty());
  };
  expect_all();
  const auto steps = answer.benches->sheets[1].steps.at(0).setup;
  planned(opened(bytes));  // the whole question is in the workbook
  expect_all();
  EXPECT_EQ(answer.benches->sheets[1].steps.at(0).setup, steps);
}

TEST_F(FirstLists, WhatOneMachineCannotHaveIsRefused) {
  EXPECT_THAT(fault("OS,bench\nFedora,\n"),
              HasSubstr("2:1: bench A: no test of the model has all of these values; change one, "
                        "or leave it open"));
  EXPECT_EQ(fault("OS,bench\nFedora,B\n"), "none");
  EXPECT_THAT(fault("OS,Browser,Locale,bench\nDebian,Edge,de,B\n"),
              HasSubstr("2:1: bench B: Debian cannot be set here; change it"));
  EXPECT_THAT(fault("OS,Browser,Locale\nARM,Edge,de\n"), HasSubstr("2:1: bench A: "));
  EXPECT_THAT(fault("OS,bench\nFedora,D\n"),
              HasSubstr("there is no bench 'D'; give the name or the number of one"));
  request.benches = {};
  EXPECT_THAT(fault("OS,bench\nFedora,D\n"),
              HasSubstr("the test is on bench 'D', but there are no benches; give them too"));
}

}  // namespace
}  // namespace changeover::first_lists_test
