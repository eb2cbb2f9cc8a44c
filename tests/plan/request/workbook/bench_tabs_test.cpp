// Sheets of benches that lost their column bench: their tabs say whose they are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "changeover/core/error.hpp"
#include "io/scan/row_reader.hpp"
#include "plan/request/workbook/bench_tabs.hpp"
#include "plan/sheet/benches/bench_words.hpp"

namespace changeover::bench_tabs_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::vector<Bench> benches{{.name = "North/1"}, {.name = "South"}};

TEST(BenchTabs, AreAsTheProgramWritesThem) {
  EXPECT_EQ(bench_of_tab(benches, "North_1"), 0U);
  EXPECT_EQ(bench_of_tab(benches, "SOUTH"), 1U);
  EXPECT_EQ(bench_of_tab(benches, "2"), 1U);
  EXPECT_EQ(bench_of_tab(benches, "East"), std::nullopt);
  EXPECT_EQ(bench_of_tab({{}, {}}, "Bench 2"), 1U);
}

// As written where a workbook allows it: 31 units of UTF-16, without some signs, each name once.
TEST(BenchTabs, AreNamedAsTheBenchesAre) {
  const auto named = [](const std::vector<std::string>& names) {
    std::vector<Bench> all;
    for (const std::string& name : names) {
      all.push_back({.name = name});
    }
    const std::vector<std::string> tabs = bench_sheet_names(all);
    for (std::size_t b = 0; b < all.size(); ++b) {
      EXPECT_EQ(bench_of_tab(all, tabs[b]), b);
    }
    return tabs;
  };
  EXPECT_THAT(named({"Prüfstand Süd", "試験台", "O'Neill", "'quoted'", "a[1]:*?/\\"}),
              ElementsAre("Prüfstand Süd", "試験台", "O'Neill", "_quoted_", "a_1______"));
  EXPECT_THAT(named({"ÄÖ", "äö", "Ж", "ж", "Ψ", "ψ", "Ł", "ł", "Plan", "×", "÷"}),
              ElementsAre("ÄÖ", "äö 2", "Ж", "ж 2", "Ψ", "ψ 2", "Ł", "ł 2", "Plan 2", "×", "÷"));
  std::string umlauts;
  std::string faces;
  for (int i = 0; i < 32; ++i) {
    umlauts += "ü";
    faces += "😀";  // of two units
  }
  EXPECT_THAT(
      named({umlauts, umlauts + "!", faces}),
      ElementsAre(umlauts.substr(0, 62), umlauts.substr(0, 58) + " 2", faces.substr(0, 60)));
}

struct Sheet {
  std::vector<std::unique_ptr<Input>> inputs;
  std::vector<DoneList> lists;
  std::vector<std::string> notes;

  Sheet(const std::string& tab, const std::vector<std::string>& of_rows, const char* result) {
    inputs.push_back(std::make_unique<SheetInput>(input_from_text("", "b.xlsx"), tab));
    DoneList& list = lists.emplace_back();
    for (const std::string& bench : of_rows) {
      list.rows.push_back({.setup = {0, 1}, .result = result, .bench = bench});
    }
  }
  std::vector<std::string> taken() {
    take_benches_of_tabs(inputs, benches, lists, notes);
    std::vector<std::string> found;
    for (const DoneRow& row : lists[0].rows) {
      found.push_back(row.bench);
    }
    return found;
  }
  std::string fault() {
    try {
      static_cast<void>(taken());
    } catch (const BadInput& bad) {
      return bad.what();
    }
    return "none";
  }
};

TEST(BenchTabs, SayWhoseTestsASheetHas) {
  Sheet south("south", {"", ""}, "pass");
  EXPECT_THAT(south.taken(), ElementsAre("South", "South"));
  EXPECT_THAT(south.notes, ElementsAre("b.xlsx:south: tests without a bench are those of South, as "
                                       "the tab says"));
  Sheet some("North_1", {"1", ""}, "pass");
  EXPECT_THAT(some.taken(), ElementsAre("1", "North/1"));
  // The tests of several benches on one sheet are not those of its tab.
  Sheet both("South", {"North/1", ""}, "pass");
  EXPECT_THAT(both.taken(), ElementsAre("North/1", ""));
  EXPECT_THAT(both.notes, IsEmpty());
}

TEST(BenchTabs, ThatSayNothingAreRefusedIfThereAreResults) {
  EXPECT_EQ(Sheet("Monday", {"", ""}, "pass").fault(),
            "b.xlsx:Monday: nothing says on which bench its tests were; name its tab after the "
            "bench, as 'North_1' or 'South', or give it a column bench");
  EXPECT_EQ(Sheet("Monday", {"", ""}, "").fault(), "none");
  EXPECT_EQ(Sheet("Done", {"", ""}, "pass").fault(), "none") << "earlier tests may be of none";
}

TEST(BenchTabs, AColumnMayNameABenchInAnotherCase) {
  Sheet rows("Monday", {"NORTH/1", "south", "East"}, "pass");
  EXPECT_THAT(rows.taken(), ElementsAre("North/1", "South", "East"));
}

}  // namespace
}  // namespace changeover::bench_tabs_test
