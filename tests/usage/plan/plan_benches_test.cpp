// changeover plan on benches as they are, and without parts that broke, as it is run.
#include <gmock/gmock.h>

#include <filesystem>

#include "../cases.hpp"
#include "run_workbooks.hpp"

namespace changeover::test::plan_benches_test {
namespace {

const std::string costs = " -k 4 --test-cost 1 --change-cost 0.25 --quiet --threads 1 --steps 5000";

std::string plan(const std::string& rest) { return "$changeover plan " + rest + costs; }

// One H100 for two benches, of which one has hours, a start and no Arc.
void write_lab(const TemporaryFolder& folder) {
  spit(folder.file("parts.csv"),
       "part,change cost,qty\nH100,0.50,1\nA40,,2\nL4,,\nArc,,2\nEpyc,1,\nXeon,1,\nNVMe,,\n");
  spit(folder.file("benches.csv"),
       "bench,hours,start,without,at once\nNorth,8,\"H100, Epyc\",Arc,\nSouth,6,,,3\n");
}

TEST(PlanBenches, AsTheyAre) {
  const TemporaryFolder folder;
  write_lab(folder);
  spit(folder.file("down.csv"), "bench,down\nNorth,yes\nSouth,\n");
  spit(folder.file("first.csv"),
       "step,bench,take_out,put_in,cost_so_far,slot_1,slot_2\n"
       "1,South,,,,L4,NVMe\n");
  const std::string lab = "parts.csv --benches benches.csv ";
  expect(
      {{plan(lab), 0, "7 parts, 4 at a time, on 2 benches: "},
       {plan(lab), 0,
        "21 of 21 needed pairs tested on some bench, checked by an independent count"},
       {plan(lab), 0, "scarce, on no more benches at a time: H100 (1), L4 (1), Epyc (1)"},
       {plan(lab), 0, "North: mounted at the start: H100, Epyc; cannot have: Arc; 8 hours a day"},
       {plan(lab), 0, "South: 3 at a time; 6 hours a day"},
       {plan(lab + "--first-day 2025-03-07"), 0, "\ndone on day "},
       {plan(lab + "--first-day 2025-03-08 --json"), 0, "\"date\":\"2025-03-10\""},
       {plan(lab + "--first-day 2025-03-08 --weekends --json"), 0, "\"date\":\"2025-03-08\""},
       {plan(lab + "--first-day 9999-12-31"), 0, "\ndone on day 2 after "},
       {plan(lab + "--format csv --first-day 2025-03-10"), 0,
        "bench,step,day,date,from_hour,to_hour,take_out"},
       {plan(lab + "--budget 9"), 0, "best within the budget: "},
       {plan(lab + "--first first.csv"), 0, "South: 3 at a time; its first test is given"},
       {plan("parts.csv --benches down.csv"), 0, "on 2 benches, one of them down: "},
       {plan("parts.csv --benches 2 --start H100,A40"), 3, "H100 is mounted at the start on 2"},
       {plan("--items 9 --benches 2 --hours 8 --start 1,2"), 0, "on day 1 after "}},
      folder);
}

// Where each bench says how many parts fit, nothing else need say it.
TEST(PlanBenches, SayHowManyPartsFit) {
  const TemporaryFolder folder;
  write_lab(folder);
  spit(folder.file("each.csv"), "bench,at once\nNorth,4\nSouth,3\n");
  spit(folder.file("some.csv"), "bench,at once\nNorth,4\nSouth,\n");
  spit(folder.file("few.csv"), "bench,at once\nNorth,4\nSouth,1\n");
  const auto with = [&](const std::string& rest) {
    return "$changeover plan parts.csv --test-cost 1 --change-cost 1 --quiet --steps 500 " + rest;
  };
  expect({{with("--benches each.csv"), 0, "7 parts, 4 at a time, on 2 benches: "},
          {with("--benches each.csv -k 1"), 0, "7 parts, 4 at a time, on 2 benches: "},
          {with("--benches each.csv -k 3"), 0, "7 parts, 3 at a time, on 2 benches: "},
          {with("--benches each.csv --strength 3"), 0, "needed triples tested"},
          {with("--benches some.csv"), 2, "give --at-once K, how many parts fit at once"},
          {with("--benches some.csv -k 1"), 2, "--at-once 1: no pair can meet; give at least 2"},
          {with("--benches few.csv"), 3, "South: 1 at once: no pair can meet; give at least 2"}},
         folder);
}

TEST(PlanBenches, SayWhatIsWrong) {
  const TemporaryFolder folder;
  write_lab(folder);
  const auto bench = [&](const std::string& list) {
    static int number = 0;
    const std::string name = "b" + std::to_string(++number) + ".csv";
    spit(folder.file(name), list);
    return plan("parts.csv --benches " + name);
  };
  expect({{bench("bench,withuot\nNorth,L4\n"), 3, "no column 'withuot' of benches; did you mean"},
          {bench("bench,start\nNorth,h100\n"), 3, "did you mean 'H100'?"},
          {bench("bench,hours\nNorth,25\n"), 3, "North: 25 hours a day; give at most 24"},
          {bench("bench,hours\nNorth,soon\n"), 3, ".csv:2:7: "},
          {bench("bench,at_once\nNorth,many\n"), 3, "'many' is not a number of parts"},
          {bench("bench,down\nNorth,maybe\n"), 3, "write yes if the bench is down, or nothing"},
          {bench("bench,slots\nNorth,GPU=1\n"), 3, "there is no slot 'GPU'"},
          {bench("bench,own,without\nNorth,L4,L4\n"), 3,
           "North: 'L4' is both in own and in without; remove it from one"},
          {bench("bench\nNorth\nNorth\n"), 3, "two benches are called North; rename one"},
          {bench("bench,down\nNorth,yes\n"), 3, "all benches are down"},
          {bench("bench,hours\n"), 3, "no bench is listed"},
          {plan("parts.csv --benches none.csv"), 4, "none.csv"},
          {plan("parts.csv --benches benches.csv --first-day soon"), 2, "'soon' is not a day"},
          {plan("parts.csv --benches 2 --first-day 2025-03-31"), 2,
           "--first-day is for benches with hours of work a day; give --hours H too"},
          {plan("parts.csv --hours 8"), 2, "is for --benches"},
          {plan("parts.csv --benches 2 --done-first 2 --done parts.csv"), 2, "has no meaning with"},
          {plan("parts.csv --benches 2 --priority w.csv"), 2, "give --budget Z too"}},
         folder);
}

TEST(PlanBenches, GoOnAfterTheTestsOfEachBench) {
  const TemporaryFolder folder;
  write_lab(folder);
  const std::string lab = "parts.csv --benches benches.csv ";
  ASSERT_EQ(run(plan(lab + "-o plan.csv"), folder.path()).code, 0);
  // The first two tests of each bench passed.
  ASSERT_EQ(run("awk -F, 'BEGIN { OFS = \",\" } NR > 1 && $2 <= 2 { $0 = $0 \"pass\" } { print }' "
                "plan.csv > sheet.csv",
                folder.path())
                .code,
            0);
  spit(folder.file("other.csv"), "bench\nWest\nSouth\n");
  expect({{plan(lab + "--done sheet.csv"), 0, ", after 4 tests done"},
          {plan(lab + "--done sheet.csv"), 0, "8 hours a day; 2 tests done before"},
          {plan(lab + "--done sheet.csv --format csv"), 0, "\nSouth,3,"},
          {plan(lab + "--done sheet.csv --json"), 0, "\"tests_done\":4"},
          {plan("parts.csv --benches other.csv --done sheet.csv"), 0,
           "sheet.csv: 'North' is not one of the benches; what was tested there counts"},
          {plan(lab + "--done plan.csv"), 0, "nothing is left to do"},
          {"sed '2s/pass/fail/' sheet.csv > failed.csv; $changeover plan " + lab +
               "-k 4 --test-cost 1 --change-cost 1 --done failed.csv --diagnose",
           0, "\nnote: the next test is for "}},
         folder);
}

TEST(PlanBenches, ReadTheirWorkbookBack) {
  const TemporaryFolder folder;
  write_lab(folder);
  const std::string lab = "parts.csv --benches benches.csv ";
  ASSERT_EQ(run(plan(lab + "-o plan.xlsx"), folder.path()).code, 0);
  expect({{plan(lab + "--done plan.xlsx"), 0, "nothing is left to do"},
          {plan(lab + "--done plan.xlsx:South"), 0, "South: 3 at a time; "}},
         folder);
}

// The workbook is all that is needed to go on, and what was there stays if anything fails.
TEST(PlanBenches, GoOnWithTheirWorkbookAlone) {
  const TemporaryFolder folder;
  write_lab(folder);
  const std::string fast = " --quiet --threads 1 --steps 5000 ";
  ASSERT_EQ(run(plan("parts.csv --benches benches.csv -o week.xlsx"), folder.path()).code, 0);
  for (const char* const list : {"parts.csv", "benches.csv"}) {
    std::filesystem::remove(folder.file(list));
  }
  const std::string filled = filled_in(
      filled_in(slurp(folder.file("week.xlsx")), {"pass"}, "North"), {"pass", "fail"}, "South");
  spit(folder.file("monday.xlsx"), filled);
  spit(folder.file("down.xlsx"), filled_in(filled, {"yes"}, "Benches", "down"));
  spit(folder.file("wrong.xlsx"), filled_in(filled, {"perhaps"}, "Benches", "down"));
  const auto go_on = [&](const std::string& rest) { return "$changeover plan " + rest + fast; };
  expect(
      {{go_on("week.xlsx"), 0, "on 2 benches: "},
       {go_on("monday.xlsx"), 0, "3 of "},
       {go_on("monday.xlsx"), 0, ", after 3 tests done"},
       {go_on("monday.xlsx"), 0, "8 hours a day; 1 test done before"},
       {go_on("monday.xlsx --json"), 0, "\"tests_done\":3"},
       {go_on("down.xlsx"), 0, "on 2 benches, one of them down"},
       {go_on("down.xlsx"), 0, "benches from 'Benches', changed since the plan was made"},
       {go_on("monday.xlsx --without L4"), 0, "left out from now on: L4"},
       {"$changeover plan monday.xlsx --diagnose", 0, "Diagnosis of 3 tests: 2 passed, 1 failed"},
       {go_on("monday.xlsx -o tuesday.xlsx") + " && " + go_on("tuesday.xlsx"), 0,
        ", after 3 tests done"},
       {go_on("wrong.xlsx"), 3, "wrong.xlsx:Benches!"},
       {go_on("monday.xlsx -o monday.xlsx"), 2, "is the same file as"},
       {go_on("wrong.xlsx -o tuesday.xlsx"), 3, "write yes if the bench is down"}},
      folder);
  EXPECT_EQ(slurp(folder.file("monday.xlsx")), filled);
  EXPECT_THAT(run(go_on("tuesday.xlsx"), folder.path()).out,
              testing::HasSubstr(", after 3 tests done"))
      << "what was there stays";
}

// What stays mounted on every bench leaves no room for some pairs on any: as on one bench.
TEST(PlanBenches, PairsBesideWhatStaysMounted) {
  const TemporaryFolder folder;
  spit(folder.file("own.csv"), "bench,mounted\nNorth,\"1, 2, 3\"\nSouth,\n");
  spit(folder.file("wide.csv"), "bench,at once\nNorth,5\nSouth,\n");
  spit(folder.file("never.csv"), "1,4\n");
  spit(folder.file("slots.csv"), "part,slot\n1,x\n2,x\n3,y\n4,y\n5,y\n6,y\n");
  const std::string all = "--items 6 --mounted 1,2,3 ";
  const std::string refusal =
      "4 and 5 must meet, but beside the 3 that stay mounted there is no room for both (and 2 more "
      "like this); keep fewer parts mounted, or let more parts fit at once";
  const std::string never =
      "2 and 4 must meet, but 4 must never be in one set-up with 1, which stays mounted";
  expect({{plan(all), 2, refusal},
          {plan(all + "--benches 1"), 2, refusal},
          {plan(all + "--benches 2"), 2, refusal},
          {plan("--items 6 --mounted 1 --never never.csv"), 3, never},
          {plan("--items 6 --mounted 1 --never never.csv --benches 2"), 3, never},
          {plan(all + "--benches wide.csv"), 0, "15 of 15 needed pairs"},
          {plan("--items 6 --benches own.csv"), 0, "15 of 15 needed pairs"},
          {plan("slots.csv --slot x=1..2,y=1 --mounted 1 --benches 2"), 0, "cannot meet on any"}},
         folder);
}

TEST(PlanBenches, APartBreaks) {
  const TemporaryFolder folder;
  write_lab(folder);
  spit(folder.file("never.csv"), "L4,Xeon\n");
  spit(folder.file("first.csv"), "L4,A40\n");
  const std::string all = "parts.csv --never never.csv --first first.csv --start L4,Xeon ";
  expect({{plan(all), 0, "7 parts, 4 at a time: "},
          {plan(all + "--without L4"), 0, "6 parts, 4 at a time: "},
          {plan(all + "--without L4"), 0, "without: left out from now on: L4"},
          {plan(all + "--without L4"), 0, "15 of 15 needed pairs tested"},
          {plan("--items 6 --without 2,3 --format csv"), 0, "6"},
          {plan("--items 6 --without 2,3"), 0, "4 parts, 4 at a time: 1 test"},
          {plan("parts.csv --benches benches.csv --without H100"), 0, "15 of 15 needed pairs"},
          {plan("parts.csv --without H200"), 2, "--without: there is no part 'H200'"},
          {plan("--items 3 --without 2,3"), 2, "--without: one part is left; a pair needs two"}},
         folder);
}

}  // namespace
}  // namespace changeover::test::plan_benches_test
