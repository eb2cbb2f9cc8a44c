#include <gmock/gmock.h>

#include "changeover/plan/benches.hpp"
#include "changeover/plan/run_plan.hpp"
#include "io/scan/row_reader.hpp"
#include "zip_files.hpp"

namespace changeover::sheet_xlsx_test {
namespace {

using test::unzipped;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class SheetXlsx : public testing::Test {
 protected:
  SheetXlsx() {
    job.names = {"=1+1", "Valve, large", " x ", "0042"};
    job.change_costs[1] = parse_amount("0.75");
    job.change_costs[3] = parse_amount("8000000000000.123456");
    setups = {{0, 1, 2}, {0, 1, 3}, {2, 3}};
    plan.sheet = run_sheet(job, setups);
    plan.bound = cost_bound(job);
    Candidate& candidate = plan.candidates.emplace_back();
    candidate.name = "greedy list";
    candidate.setups = setups;
  }

  std::unique_ptr<Input> sheet(const std::string& name) const {
    return std::make_unique<SheetInput>(input_from_text(written(document, "xlsx"), "f.xlsx"), name);
  }

  Job job = make_job(4, 3, parse_amount("2"), parse_amount("1"));
  std::vector<Block> setups;
  RunPlan plan;
  SheetDocument document{.job = &job, .plan = &plan, .title = "Bench & Co"};
};

TEST_F(SheetXlsx, IsReadBack) {
  EXPECT_EQ(read_setups(*sheet("Run sheet"), job.names), setups);
  const PartList parts = read_parts(*sheet("Parts"));
  EXPECT_THAT(parts.names, ElementsAre("=1+1", "Valve, large", "x", "0042"));
  EXPECT_THAT(parts.change_costs, ElementsAre(job.change_costs[0], job.change_costs[1],
                                              job.change_costs[2], job.change_costs[3]));
}

TEST_F(SheetXlsx, HoldsNoFormula) {
  for (const auto& [name, text] : unzipped(written(document, "xlsx"))) {
    EXPECT_THAT(text, Not(HasSubstr("<f>"))) << name;
    EXPECT_THAT(text, Not(HasSubstr("hyperlink"))) << name;
  }
}

TEST_F(SheetXlsx, NumbersAreNumbersAndThePageIsSetUp) {
  auto members = unzipped(written(document, "xlsx"));
  const std::string& steps = members["xl/worksheets/sheet1.xml"];
  EXPECT_THAT(steps, HasSubstr("<v>4.75</v>"));
  EXPECT_THAT(steps, HasSubstr("state=\"frozen\""));
  EXPECT_THAT(steps, HasSubstr("fitToHeight=\"0\""));
  EXPECT_THAT(steps, HasSubstr("&amp;LBench &amp;&amp; Co"));
  EXPECT_THAT(steps, HasSubstr("Page &amp;P of &amp;N"));
  EXPECT_THAT(steps, HasSubstr("\"pass,fail,unclear\""));
  EXPECT_THAT(steps, HasSubstr("sqref=\"J2:J4\""));
  EXPECT_THAT(members["xl/workbook.xml"], HasSubstr("'Run sheet'!$1:$1"));
  EXPECT_THAT(members["xl/styles.xml"], HasSubstr("#,##0.000000"));
}

TEST_F(SheetXlsx, ANameThatLooksLikeAnEscapeIsShownAsItIs) {
  job.names[0] = "_x0041_";
  EXPECT_EQ(read_setups(*sheet("Run sheet"), job.names), setups);
  EXPECT_EQ(read_parts(*sheet("Parts")).names[0], "_x0041_");
}

TEST_F(SheetXlsx, TheSameAgain) { EXPECT_EQ(written(document, "xlsx"), written(document, "xlsx")); }

TEST_F(SheetXlsx, SlotsHaveColumnsOfTheirOwn) {
  set_slots(job, {"CPU", "disk", "disk", ""}, {{"CPU", 0, 1}, {"disk", 0, 2}});
  EXPECT_EQ(read_setups(*sheet("Run sheet"), job.names), setups);
  EXPECT_THAT(unzipped(written(document, "xlsx"))["xl/sharedStrings.xml"],
              HasSubstr("slot_3 disk"));
  EXPECT_THAT(read_parts(*sheet("Parts")).slots, ElementsAre("CPU", "disk", "disk", ""));
}

TEST_F(SheetXlsx, LongTitlesAndNoTest) {
  document.title.assign(300, '&');
  document.title += "\xE2\x88\x9E";
  plan.sheet = run_sheet(job, {});
  plan.bound = CostBound{};
  EXPECT_TRUE(read_setups(*sheet("Run sheet"), job.names).empty());
}

// Every bench can be read back as if its sheet were the only one; what a bench did is done.
TEST_F(SheetXlsx, SeveralBenchesHaveASheetEach) {
  job.change_costs[3] = parse_amount("3");
  BenchPlan benches;
  static_cast<BenchCount&>(benches) = count_benches(job, {{{0, 1, 2}, {0, 1, 3}}, {}, {{2, 3}}});
  benches.bound = cost_bound(job);
  benches.candidates.emplace_back().name = "by hand";
  const std::string bytes = written(BenchDocument{.job = &job, .plan = &benches}, "xlsx");
  EXPECT_EQ(bytes, written(BenchDocument{.job = &job, .plan = &benches}, "xlsx"));
  const auto named = [&](const std::string& name) {
    return std::make_unique<SheetInput>(input_from_text(bytes, "f.xlsx"), name);
  };
  EXPECT_EQ(read_setups(*named("Bench 1"), job.names), (std::vector<Block>{{0, 1, 2}, {0, 1, 3}}));
  EXPECT_EQ(read_setups(*named("Bench 2"), job.names), std::vector<Block>());
  EXPECT_EQ(read_setups(*named("Bench 3"), job.names), (std::vector<Block>{{2, 3}}));
  EXPECT_EQ(read_parts(*named("Parts")).names.size(), 4U);
  EXPECT_THAT(unzipped(bytes)["xl/sharedStrings.xml"], HasSubstr("by hand"));
  EXPECT_EQ(unzipped(bytes).count("xl/worksheets/sheet6.xml"), 0U);
}

}  // namespace
}  // namespace changeover::sheet_xlsx_test
