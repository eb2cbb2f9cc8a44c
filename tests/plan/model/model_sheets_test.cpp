// Sheets of plans for models: what they show, and that they are read as written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "changeover/plan/benches.hpp"
#include "changeover/plan/run_plan.hpp"
#include "core/each.hpp"
#include "message_of.hpp"
#include "plan/job/bench_list.hpp"
#include "random_models.hpp"

namespace changeover::model_sheets_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

RunPlan planned(const Job& job) {
  RunControl control({.threads = 1});
  return make_run_plan(job, {.objective = PlanObjective::tests, .steps = 1000, .attempts = 1},
                       control);
}

// A sheet of these tests, with the bound of the job.
std::string sheet_of(const Job& job, const std::vector<Block>& setups, const std::string& format) {
  RunPlan plan;
  plan.sheet = run_sheet(job, setups);
  plan.candidates = {{.name = "given", .how = "", .setups = setups}};
  plan.candidates.front().take_figures(plan.sheet);
  return written({.job = &job, .plan = &plan}, format, 100);
}

TEST(ModelSheets, SayWhatToSetAndTheWholeTest) {
  const Job job = test::job_of_text(
      "OS: Debian, Windows\nMode: read | load, write | store | save\nRetry: On, Off\nLog: On, Off\n");
  const std::vector<Block> setups{{0, 2, 4, 6}, {1, 3, 4, 7}, {1, 2, 5, 7}, {0, 3, 5, 6}};
  EXPECT_EQ(sheet_of(job, setups, "csv"),
            "step,set,OS,Mode,Retry,Log,new_pairs,cost,cost_so_far,result\n"
            "1,\"OS: Debian, Mode: read, Retry: On, Log: On\",Debian,read,On,On,6,5,5,\n"
            "2,\"OS: Windows, Mode: write, Log: Off\",Windows,write,On,Off,6,4,9,\n"
            "3,\"Mode: load, Retry: Off\",Windows,load,Off,Off,5,3,12,\n"
            "4,\"OS: Debian, Mode: store, Log: On\",Debian,store,Off,On,5,4,16,\n");
  EXPECT_THAT(
      sheet_of(job, setups, "table"),
      HasSubstr("   3  Mode: load, Retry: Off                      Windows  load   Off    Off"));
  EXPECT_THAT(sheet_of(job, setups, "html"), HasSubstr("<td data-head=\"Mode\">store</td>"));
  EXPECT_THAT(
      sheet_of(job, setups, "markdown"),
      HasSubstr("| 3 | **Mode: load**, **Retry: Off** | Windows | **load** | **Off** | Off |"));
  const auto json = nlohmann::json::parse(sheet_of(job, setups, "json"));
  EXPECT_EQ(json["steps"][3]["values"].dump(),
            "{\"Log\":\"On\",\"Mode\":\"store\",\"OS\":\"Debian\",\"Retry\":\"Off\"}");
  EXPECT_EQ(json["steps"][3]["set_up"].dump(), "[\"Debian\",\"write\",\"Retry: Off\",\"Log: On\"]");
  EXPECT_EQ(
      json["parameters"][1]["values"][1].dump(),
      "{\"names\":[\"write\",\"store\",\"save\"],\"out_of_range\":false,\"part\":\"write\",\"value\":\"write\"}");
}

TEST(ModelSheets, ManyParametersAreAList) {
  std::string text;
  for (int i = 0; i < 12; ++i) {
    text += "P" + std::to_string(i) + ": a, b\n";
  }
  const Job job = test::job_of_text(text);
  const std::vector<Block> setups{{0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22}};
  EXPECT_THAT(sheet_of(job, setups, "table"), Not(HasSubstr("  P3  ")));
  EXPECT_THAT(sheet_of(job, setups, "html"), HasSubstr("P11: a"));
  EXPECT_THAT(sheet_of(job, setups, "csv"), HasSubstr(",P0,P1,P2,P3,"));
}

TEST(ModelSheets, NamesOnAPageAreNoStyle) {
  const Job job = test::job_of_text("a\"}</style>: x, y\nos: 1, 2\n");
  const std::string page = sheet_of(job, {{0, 2}}, "html");
  EXPECT_EQ(page.find("</style>", page.find("</style>") + 1), std::string::npos);
  EXPECT_THAT(page, HasSubstr("<th>os</th>"));
}

TEST(ModelSheets, AreReadAsWritten) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Job job = test::job_of_text(test::random_model_text(seed, 4, 4));
    const RunPlan plan = planned(job);
    std::vector<Block> setups =
        read_setups(*input_from_text(written({.job = &job, .plan = &plan}, "csv")), job);
    ASSERT_EQ(setups.size(), plan.sheet.steps.size());
    for (std::size_t i = 0; i < setups.size(); ++i) {
      std::sort(setups[i].begin(), setups[i].end());
      EXPECT_EQ(setups[i], plan.sheet.steps[i].setup);
    }
  }
}

// The cells of each row of a test in Markdown, without marks.
std::vector<std::vector<std::string>> rows_in_markdown(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1) {
    if (text[at] != '|' || text[at + 2] < '0' || text[at + 2] > '9') {
      continue;
    }
    std::vector<std::string>& cells = rows.emplace_back();
    for (const char c : text.substr(at, text.find('\n', at) - at)) {
      if (c == '|') {
        cells.emplace_back();
      } else if (c != '*' && c != '\\') {
        cells.back() += c;
      }
    }
    for (std::string& cell : cells) {
      cell.erase(0, cell.find_first_not_of(' '));
      cell.erase(cell.find_last_not_of(' ') + 1);
    }
  }
  return rows;
}

// What benches have at their start is no step, and each bench has its own: the tests on all sheets
// are those of the plan, also where nothing was set.
TEST(ModelSheets, OfBenchesThatHaveAStartSayTheSameInEveryFormat) {
  std::size_t kept = 0;  // values that stay from the start
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    std::string text =
        test::random_model_text(4000 + seed, 4, 3, false) + "More: u | v | w, x | y\n";
    text = text.substr(text.rfind("More")) + text.substr(0, text.rfind("More"));
    SCOPED_TRACE(text);
    const Job job = test::job_of_text(text);
    const std::vector<Block> rows = test::all_tests(*job.model);
    std::vector<Bench> benches(3);
    for (std::size_t b = 0; b < benches.size(); ++b) {
      benches[b].start = rows[(seed * 7 + b * 5) % rows.size()];
    }
    RunControl control({.threads = 1});
    const BenchPlan plan =
        make_bench_plan(job, {.plan = {.steps = 500, .attempts = 1}, .each = benches}, control);
    const BenchDocument document{.job = &job, .plan = &plan};
    const auto in_json = nlohmann::json::parse(written(document, "json", 100));
    const std::string csv = written(document, "csv", 100);
    const auto in_markdown = rows_in_markdown(written(document, "markdown", 100));
    const DoneList read = read_done(*input_from_text(csv, "p.csv"), job);
    ASSERT_EQ(read.rows.size(), plan.tests);
    ASSERT_EQ(in_markdown.size(), plan.tests);
    std::size_t row = 0;
    for (std::size_t b = 0; b < benches.size(); ++b) {
      const auto& steps = in_json["sheets"][b]["steps"];
      std::vector<bool> was_set(job.slots.size(), false);
      for (std::size_t i = 0; i < plan.sheets[b].steps.size(); ++i, ++row) {
        const Block& setup = plan.sheets[b].steps[i].setup;
        Block in_csv = read.rows[row].setup;
        std::ranges::sort(in_csv);
        EXPECT_EQ(in_csv, setup) << csv;
        EXPECT_EQ(find_bench(benches, read.rows[row].bench), b);
        for (const Element x : setup) {
          const std::size_t p = job.slot_of[x];
          const std::string shown = steps[i]["values"][job.model->parameters[p].name];
          const ModelValue& value = job.model->value(x);
          EXPECT_EQ(std::ranges::count(value.names, shown), 1) << shown;
          EXPECT_EQ(read.rows[row].written[p], shown);
          EXPECT_EQ(std::ranges::count(in_markdown[row], shown) > 0, true) << shown;
          for (const Element put : plan.sheets[b].steps[i].put_in) {
            was_set[p] = was_set[p] || job.slot_of[put] == p;
          }
          kept += was_set[p] ? 0U : 1U;
        }
      }
    }
  }
  EXPECT_GT(kept, 100U);
}

TEST(ModelSheets, SeedsHaveColumnsInAnyOrderAndOthersBesides) {
  const Job job =
      test::job_of_text("OS: Debian, Windows\nRange: ~-1, 0, 5\nLog: On, Off\nEmpty: , x\n");
  const auto read = [&](const std::string& text) {
    return read_setups(*input_from_text(text, "s.tsv"), job);
  };
  EXPECT_THAT(read("Log\tOS\tEmpty\tOther\tRANGE\nOff\tdebian\t\tz\t~-1\n\tWindows\t\t\t-1\n"),
              ElementsAre(Block{6, 0, 7, 2}, Block{1, 7, 2}));
  EXPECT_THAT(read("Log,OS,Range,Empty\nOff,Debian,5,x\n"), ElementsAre(Block{6, 0, 4, 8}));
  EXPECT_THAT(read("Debian,Log: Off\nOS=Windows,0,Log: On\n"),
              ElementsAre(Block{0, 6}, Block{1, 3, 5}));
  const auto complaint = [&](const std::string& text) -> std::string {
    return message_of([&] { (void)read(text); });
  };
  EXPECT_EQ(complaint("OS,Log\nArch,On\n"),
            "s.tsv:2:1: OS has no value 'Arch'; write it as the model does");
  EXPECT_EQ(complaint("OS,os\nDebian,Debian\n"),
            "s.tsv:1:4: two columns are called 'OS' and 'os'; rename or remove one");
  EXPECT_EQ(
      complaint("Arch,Debian\n"),
      "s.tsv:1:1: no parameter has the value 'Arch'; write it as the model does, or as Parameter: value");
  const DoneList done =
      read_done(*input_from_text("OS,Log,result\nArch,On,pass\nDebian,Off,fail\n", "d.csv"), job);
  EXPECT_THAT(done.gone, ElementsAre("OS: Arch"));
  EXPECT_THAT(each_of<std::string>(done.rows, &DoneRow::result), ElementsAre("pass", "fail"));
  EXPECT_TRUE(done.rows[0].lacks);
}

// A column says which parameter it is of, so that its cells need not; the value may be no text.
TEST(ModelSheets, TestsThatWereDoneAreKeptWithoutTheNamesOfParameters) {
  const Job job = test::job_of_text("Log: On, Off\nRetry: On, Off\nEmpty: , x\n");
  const DoneList done = read_done(
      *input_from_text(
          "step,Log,Retry,Empty,new_pairs,result\n1,Log: On,Off,,3,pass\n2,On,Retry=On,x,3,\n",
          "d.csv"),
      job);
  EXPECT_THAT(done.rows[0].written, ElementsAre("On", "Off", ""));
  EXPECT_THAT(done.rows[0].setup, ElementsAre(0, 3, 4));
  EXPECT_THAT(done.rows[1].written, ElementsAre("On", "On", "x"));
  EXPECT_THAT(done.notes, testing::IsEmpty());
}

}  // namespace
}  // namespace changeover::model_sheets_test
