#include "changeover/plan/benches.hpp"
#include "changeover/plan/diagnosis.hpp"
#include "changeover/plan/run_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "changeover/plan/job.hpp"
#include "message_of.hpp"

namespace changeover::sheet_formats_test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// Four parts, three at a time, the second set-up of two; candidates as a search would leave them.
class SheetFormats : public testing::Test {
 protected:
  SheetFormats() {
    job.names = {"Pump", "Valve, large", "<b>\"Motor\"</b>", "Fan | 4*"};
    job.change_costs[1] = parse_amount("0.75");
    const std::vector<Block> setups{{0, 1, 2}, {0, 1, 3}, {2, 3}};
    plan.sheet = run_sheet(job, setups);
    plan.bound = cost_bound(job);
    plan.candidates.push_back({.name = "local search",
                               .how = "any number of changes",
                               .setups = setups,
                               .changes = 5,
                               .change_cost = plan.sheet.change_cost,
                               .cost = plan.sheet.cost,
                               .pairs_tested = 6});
    plan.candidates.push_back(plan.candidates.front());
    plan.candidates.back().name = "greedy list";
    plan.candidates.back().cost += parse_amount("1.5");
  }

  Job job = make_job(4, 3, parse_amount("2"), parse_amount("1"));
  RunPlan plan;
  SheetDocument document{.job = &job, .plan = &plan, .title = "Bench & <Co>"};
};

TEST_F(SheetFormats, Csv) {
  EXPECT_EQ(written(document, "csv"),
            "step,take_out,put_in,slot_1,slot_2,slot_3,new_pairs,cost,cost_so_far,result\n"
            "1,,\"Pump, \"\"Valve, large\"\", \"\"<b>\"\"\"\"Motor\"\"\"\"</b>\"\"\","
            "Pump,\"Valve, large\",\"<b>\"\"Motor\"\"</b>\",3,4.75,4.75,\n"
            "2,\"\"\"<b>\"\"\"\"Motor\"\"\"\"</b>\"\"\",Fan | 4*,"
            "Pump,\"Valve, large\",Fan | 4*,2,3.00,7.75,\n"
            "3,\"Pump, \"\"Valve, large\"\"\",\"\"\"<b>\"\"\"\"Motor\"\"\"\"</b>\"\"\","
            "\"<b>\"\"Motor\"\"</b>\",,Fan | 4*,1,3.00,10.75,\n");
}

TEST_F(SheetFormats, CsvIsReadBackAsTestsThatWereDone) {
  const auto setups = read_setups(*input_from_text(written(document, "csv")), job.names);
  EXPECT_EQ(setups, plan.candidates.front().setups);
  mark_done(job, setups);
  EXPECT_EQ(job.needed.size(), 0U);
  EXPECT_EQ(job.tests_done, 3U);
}

TEST_F(SheetFormats, Table) {
  const std::string text = written(document, "table", 200);
  EXPECT_THAT(text,
              StartsWith("Bench & <Co>\n4 parts, 3 at a time: 3 tests, 5 changes, cost 10.75\n"
                         "6 of 6 needed pairs tested"));
  EXPECT_THAT(text, HasSubstr("best: the local search; next the greedy list, +1.50 (14.0 %)\n"));
  EXPECT_THAT(text, HasSubstr("   3  Pump, Valve, large  <b>\"Motor\"</b>"));
  EXPECT_THAT(text, HasSubstr("\ngreedy list       3        5  12.25      6  +1.50 (14.0 %)"));
  EXPECT_THAT(text, Not(HasSubstr(" \n"))) << "blanks at the end of a line";
}

TEST_F(SheetFormats, TableBreaksListsBetweenPartsOnly) {
  const std::string text = written(document, "table", 60);
  EXPECT_THAT(text, HasSubstr("Valve, large,"));
  EXPECT_THAT(text, HasSubstr("<b>\"Motor\"</b>"));
}

TEST_F(SheetFormats, Json) {
  const std::string text = written(document, "json");
  EXPECT_THAT(text, StartsWith("{\"format\":\"changeover-plan/1\",\"title\":\"Bench & <Co>\","
                               "\"parts\":[{\"name\":\"Pump\",\"change_cost\":1.00},"
                               "{\"name\":\"Valve, large\",\"change_cost\":0.75},"));
  EXPECT_THAT(text, HasSubstr("\"tests\":3,\"changes\":5,\"cost\":10.75,\"pairs_needed\":6,"
                              "\"pairs_tested\":6,\"proved_cheapest\":"));
  EXPECT_THAT(text,
              HasSubstr("{\"step\":3,\"take_out\":[\"Pump\",\"Valve, large\"],\"put_in\":["
                        "\"<b>\\\"Motor\\\"</b>\"],\"set_up\":[\"<b>\\\"Motor\\\"</b>\","
                        "\"Fan | 4*\"],\"places\":[\"<b>\\\"Motor\\\"</b>\",null,\"Fan | 4*\"],"
                        "\"new_pairs\":[[\"<b>\\\"Motor\\\"</b>\",\"Fan | 4*\"]],"
                        "\"cost\":3.00,\"cost_so_far\":10.75}"));
  EXPECT_THAT(text, HasSubstr("\"budget\":null"));
}

TEST_F(SheetFormats, MarkdownAndHtmlEscapeNames) {
  EXPECT_THAT(written(document, "markdown"),
              HasSubstr("| 3 | Pump, Valve, large | \\<b\\>\"Motor\"\\</b\\> | "
                        "**\\<b\\>\"Motor\"\\</b\\>**, –, Fan \\| 4\\* | 1 | 10.75 |\n"));
  const std::string page = written(document, "html");
  EXPECT_THAT(page, StartsWith("<!DOCTYPE html>"));
  EXPECT_THAT(page, HasSubstr("<title>Bench &amp; &lt;Co&gt;</title>"));
  EXPECT_THAT(page, HasSubstr("&lt;b&gt;&quot;Motor&quot;&lt;/b&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("<b>")));
  EXPECT_THAT(page, HasSubstr("table-header-group"));
  for (const char* outside : {"http", "src=", "href=", "<script"}) {
    EXPECT_THAT(page, Not(HasSubstr(outside)));
  }
  std::size_t boxes = 0;
  for (std::size_t at = page.find("class=\"box\""); at != std::string::npos;
       at = page.find("class=\"box\"", at + 1)) {
    ++boxes;
  }
  EXPECT_EQ(boxes, 6U) << "pass and fail of three steps";
}

TEST_F(SheetFormats, WhatStaysMountedIsSaidOnce) {
  job.mounted = {0};
  const std::vector<Block> setups{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}};
  plan.sheet = run_sheet(job, setups);
  const auto times = [](const std::string& text, const std::string& word) {
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
      ++count;
    }
    return count;
  };
  // Once as mounted, and once where it is put in.
  EXPECT_EQ(times(written(document, "table", 200), "Pump"), 2U);
  EXPECT_THAT(written(document, "table", 200), HasSubstr("mounted all the time: Pump\n"));
  EXPECT_EQ(times(written(document, "markdown"), "Pump"), 2U);
  EXPECT_EQ(times(written(document, "html"), "Pump"), 2U);
}

TEST_F(SheetFormats, TheCompactFormLeavesOutWholeSetUps) {
  document.compact = true;
  EXPECT_THAT(written(document, "table", 200), Not(HasSubstr("  set-up")));
  EXPECT_THAT(written(document, "table", 200),
              HasSubstr("   3  Pump, Valve, large  <b>\"Motor\"</b>"));
  EXPECT_THAT(written(document, "html"), HasSubstr("<div class=\"compact\">"));
  EXPECT_THAT(written(document, "html"), Not(HasSubstr("Set-up</th>")));
  job.names = {"1", "2", "3", "4"};
  EXPECT_THAT(written(document, "html"), HasSubstr("<div class=\"compact two\">"));
}

TEST_F(SheetFormats, LongListsOfLongNamesFlow) {
  EXPECT_THAT(written(document, "html"), Not(HasSubstr("class=\"flow\"")));
  EXPECT_THAT(written(document, "html"), HasSubstr("class=\"setup\">Set-up</th>"));
  job = make_job(9, 7, parse_amount("2"), parse_amount("1"));
  plan.sheet = run_sheet(job, {{0, 1, 2, 3, 4, 5, 6}});
  plan.bound = CostBound{};
  EXPECT_THAT(written(document, "html"), Not(HasSubstr("class=\"flow\"")));
  job.names[0] = "a name of some length";
  EXPECT_THAT(written(document, "html"), HasSubstr("<td class=\"flow\" data-head=\"Set-up\">"));
}

TEST_F(SheetFormats, CsvHasColumnsForEachSlot) {
  job.slots = {{"CPU, fast", 0, 1}, {"=disk", 0, 2}};
  job.slot_of = {no_slot, 1, 0, 1};
  plan.sheet = run_sheet(job, {{0, 1, 2}, {0, 1, 3}, {2, 3}});
  EXPECT_THAT(
      written(document, "csv"),
      StartsWith("step,take_out,put_in,\"slot_1 CPU, fast\",slot_2 =disk,slot_3 =disk,slot_4,"));
  EXPECT_THAT(written(document, "csv"), HasSubstr(",,\"Valve, large\",Fan | 4*,Pump,2,"));
  EXPECT_EQ(read_setups(*input_from_text(written(document, "csv")), job.names),
            (std::vector<Block>{{2, 1, 0}, {1, 3, 0}, {2, 3}}));
}

TEST_F(SheetFormats, SaysHowManyChangesARandomOrderNeeds) {
  job = make_job(6, 2, parse_amount("2"), parse_amount("1"));
  std::vector<Block> order{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}};
  plan.sheet = run_sheet(job, order);
  std::uint64_t sum = 0;
  std::sort(order.begin(), order.end());
  std::uint64_t orders = 0;
  do {
    sum += run_sheet(job, order).changes;
    ++orders;
  } while (std::next_permutation(order.begin(), order.end()));
  const std::uint64_t average = (sum + orders / 2) / orders;
  ASSERT_GT(average, plan.sheet.changes);
  EXPECT_THAT(written(document, "table", 200),
              HasSubstr(std::to_string(plan.sheet.changes) + " changes, " +
                        std::to_string(average - plan.sheet.changes) + " fewer than these tests"));
}

TEST_F(SheetFormats, StepsGoOnAfterTestsThatWereDone) {
  job.tests_done = 7;
  EXPECT_THAT(written(document, "csv"), HasSubstr("\n8,,"));
  EXPECT_THAT(written(document, "html"), HasSubstr("7 tests done before."));
}

TEST_F(SheetFormats, ABudgetIsNamed) {
  document.budget = parse_amount("8");
  plan.complete = plan.candidates.back();
  EXPECT_THAT(written(document, "table", 200),
              HasSubstr("budget 8.00: testing all pairs would cost 12.25\n"));
  EXPECT_THAT(written(document, "json"), HasSubstr("\"budget\":8.00"));
}

TEST_F(SheetFormats, NothingToDoIsSaid) {
  job.needed = PairSet(4);
  plan.sheet = run_sheet(job, {});
  plan.bound = cost_bound(job);
  plan.candidates.resize(1);
  plan.candidates.front() = Candidate{};
  plan.candidates.front().how = "nothing is left to test";
  for (const std::string& text : {written(document, "table", 80), written(document, "markdown"),
                                  written(document, "html"), written(document, "json")}) {
    EXPECT_THAT(text, HasSubstr("nothing is left to test"));
  }
}

TEST_F(SheetFormats, EveryFormatShowsTheWeightSoFar) {
  job.weights.set(0, 1, parse_amount("7"));
  RunControl control({.threads = 1});
  plan = make_run_plan(job, {.steps = 1000}, control);
  EXPECT_THAT(written(document, "table", 200), HasSubstr("weight so far"));
  EXPECT_THAT(written(document, "markdown"), HasSubstr("| cost so far | weight so far |"));
  EXPECT_THAT(written(document, "html"), HasSubstr("Weight<br>so far"));
  EXPECT_THAT(written(document, "csv"), HasSubstr(",cost_so_far,weight_so_far,result\n"));
}

TEST_F(SheetFormats, ListsOfSeveralBenchesHaveAColumnForEachSlot) {
  job.slots = {{"drive", 0, 1}};
  job.slot_of = {0, no_slot, 0, no_slot};
  drop_needed(job, cannot_meet(job));
  RunControl control({.threads = 1});
  const BenchPlan benches = make_bench_plan(job, {.benches = 2, .plan = {.steps = 1000}}, control);
  const std::string csv = written(BenchDocument{.job = &job, .plan = &benches}, "csv");
  EXPECT_THAT(csv, HasSubstr("bench,step,take_out,put_in,slot_1 drive,slot_2,slot_3,new_pairs,"));
  EXPECT_EQ(read_setups(*input_from_text(csv), job.names).size(), benches.tests);
}

TEST_F(SheetFormats, AnotherFormatIsRefused) {
  EXPECT_REFUSAL(static_cast<void>(written(document, "latex")), BadOption,
                 "a plan is not written as latex");
  EXPECT_REFUSAL(static_cast<void>(written(job, WhatIf{}, "xlsx")), BadOption,
                 "a table of ratios is not written as xlsx");
  EXPECT_REFUSAL(static_cast<void>(written(job, Diagnosis{}, "csv")), BadOption,
                 "a diagnosis is not written as csv");
}

// The cells of a line of CSV, without their quotes.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells{""};
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      if (quoted && i + 1 < line.size() && line[i + 1] == '"') {
        cells.back() += line[++i];
      } else {
        quoted = !quoted;
      }
    } else if (line[i] == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += line[i];
    }
  }
  return cells;
}

TEST_F(SheetFormats, NoCellOfCsvIsAFormulaAndAllNamesComeBack) {
  const std::vector<std::vector<std::string>> hostile{
      {"=1+1", "C", "D", "E"},
      {"+x", "-x", "@SUM(A1)", "'=x"},
      {"''=x", "=x", "'x", " =x"},
      {"-1.5", "007", "2", "1"},
      {"step", "slot_1", "set_up", "#x"},
      {"=\"a,b\"", "-\"", "\"=", ";"},
      {"step", "take_out", "put_in", "cost_so_far"}};
  for (const std::vector<std::string>& names : hostile) {
    job.names = names;
    const std::string text = written(document, "csv");
    EXPECT_EQ(read_setups(*input_from_text(text), job.names), plan.candidates.front().setups)
        << text;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      for (const std::string& cell : cells_of(line)) {
        const bool number =
            !cell.empty() && cell.find_first_not_of("-.0123456789") == std::string::npos;
        EXPECT_TRUE(cell.empty() || number ||
                    std::string("=+-@\t\r").find(cell[0]) == std::string::npos)
            << cell;
      }
    }
  }
}

TEST_F(SheetFormats, SheetsWithAllPartsInOneCellAreStillRead) {
  const std::string old =
      "step,take_out,put_in,set_up,new_pairs,cost,cost_so_far\n"
      "1,,\"Pump, \"\"Valve, large\"\"\",\"Pump, \"\"Valve, large\"\"\",1,4.75,4.75\n"
      "2,,Fan | 4*,\"Pump, Fan | 4*\",2,3.00,7.75\n";
  EXPECT_EQ(read_setups(*input_from_text(old), job.names), (std::vector<Block>{{0, 1}, {0, 3}}));
}

TEST_F(SheetFormats, HtmlHoldsNoMarkupOfANameOrTitle) {
  job.names = {"<script>alert(1)</script>", "\" onload=\"x", "' onload='x", "a & b <img src=x>"};
  document.title = "</title><script>";
  const std::string page = written(document, "html");
  for (const char* markup : {"<script", "<img", "\" onload", "' onload", "& b"}) {
    EXPECT_THAT(page, Not(HasSubstr(markup)));
  }
  EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert(1)&lt;/script&gt;"));
  EXPECT_THAT(page, HasSubstr("&quot; onload=&quot;x"));
}

TEST_F(SheetFormats, TablesOfVeryLongListsAreLaidOutAtOnce) {
  constexpr std::size_t many = 1000;
  job = make_job(many, many, parse_amount("1"), parse_amount("1"));
  Block all;
  for (Element x = 0; x < many; ++x) {
    job.names[x] = std::to_string(x) + std::string(240, 'x');
    all.push_back(x);
  }
  plan.sheet = run_sheet(job, {all});
  EXPECT_GT(written(document, "table", 80).size(), many * 240);
}

}  // namespace
}  // namespace changeover::sheet_formats_test
