// changeover plan --model, as it is run.
#include <gmock/gmock.h>

#include "cases.hpp"

namespace changeover::test::model_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string few = " --quiet --threads 1 --steps 20000";
const std::string browsers =
    "OS: Debian, Fedora, Windows\nBrowser: Firefox, Chrome, Edge\nLocale: de, en, ja\n"
    "IF [Browser] = \"Edge\" THEN [OS] = \"Windows\";\n";

std::string data(const std::string& file) {
  return std::string(CHANGEOVER_TEST_DATA) + "/model/" + file;
}

nlohmann::json answer_of(const std::string& command, const TemporaryFolder& folder) {
  const Outcome outcome = run(command, folder.path());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return nlohmann::json::parse(outcome.out);
}

TEST(ModelUsage, EachTestHasAValueOfEachParameter) {
  const TemporaryFolder folder;
  spit(folder.file("m.txt"), browsers);
  const auto plan = answer_of(
      "$changeover plan --model m.txt --test-cost 5 --change-cost 1 --json" + few, folder);
  EXPECT_EQ(plan.at("pairs_needed"), 25);
  EXPECT_EQ(plan.at("objective"), "cost");
  EXPECT_EQ(plan.at("rules"), 1);
  EXPECT_EQ(plan.at("parameters").at(1).at("name"), "Browser");
  EXPECT_EQ(plan.at("parameters").at(1).at("values").at(2).at("part"), "Edge");
  EXPECT_THAT(plan.at("notes").at(0).get<std::string>(),
              HasSubstr("2 pairs cannot meet by the rules and need not"));
  ASSERT_FALSE(plan.at("steps").empty());
  for (const auto& step : plan.at("steps")) {
    const auto& values = step.at("values");
    EXPECT_EQ(values.size(), 3U);
    if (values.at("Browser") == "Edge") {
      EXPECT_EQ(values.at("OS"), "Windows");
    }
    for (const auto& part : step.at("set_up")) {
      EXPECT_TRUE(values.at("OS") == part || values.at("Browser") == part ||
                  values.at("Locale") == part);
    }
  }
}

TEST(ModelUsage, TheFewestTestsNeedNoCosts) {
  const TemporaryFolder folder;
  const auto plan = answer_of(
      "$changeover plan --model " + data("ranges.txt") + " --objective tests --json" + few, folder);
  EXPECT_EQ(plan.at("test_cost"), 0);
  EXPECT_EQ(plan.at("cost"), plan.at("changes"));
  EXPECT_EQ(plan.at("tests"), 18);
  EXPECT_EQ(plan.at("proved_fewest_tests"), true);
  EXPECT_EQ(plan.at("lower_bound").at("tests"), 18);
}

TEST(ModelUsage, TheFewestTestsAreSharedByBenches) {
  const TemporaryFolder folder;
  const std::string ask =
      "$changeover plan --model " + data("ranges.txt") + " --objective tests --benches 3";
  const auto plan = answer_of(ask + " --json" + few, folder);
  EXPECT_EQ(plan.at("objective"), "tests");
  EXPECT_EQ(plan.at("tests"), 18);
  EXPECT_EQ(plan.at("lower_bound").at("tests"), 18);
  EXPECT_EQ(plan.at("proved_fewest_tests"), true);
  std::size_t together = 0;
  for (const auto& sheet : plan.at("sheets")) {
    together += sheet.at("steps").size();
    EXPECT_GT(sheet.at("steps").size(), 0U);
  }
  EXPECT_EQ(together, 18U);
  expect({{ask + few, 0, "no plan for all pairs has fewer tests: this is the lower bound"},
          {ask + " --budget 9" + few, 0,
           "no plan for all pairs has fewer than 18 tests (one with 18 was found)"},
          {"$changeover plan --model " + data("ranges.txt") + " --objective tests --budget 9" + few,
           0, "no plan for all pairs has fewer than 18 tests (one with 18 was found)"}},
         folder);
}

TEST(ModelUsage, ModelsOfEveryKindAreRead) {
  const TemporaryFolder folder;
  for (const char* const file :
       {"partition.txt", "two_machines.txt", "ranges.txt", "same_room.txt"}) {
    expect({{"$changeover plan --objective tests --model " + data(file) + few, 0,
             "tested, checked by an independent count"},
            {"$changeover plan --test-cost 2 --change-cost 1 --model " + data(file) + few, 0,
             "lower bound"}},
           folder);
  }
  // Where Mode changes at almost every test, its values take turns with their names.
  spit(folder.file("costs.csv"), "Mode,1\nDepth,9\nRetry,9\nLog,9\n");
  const auto ranges = answer_of(
      "$changeover plan --test-cost 0 --change-costs costs.csv --json "
      "--model " +
          data("ranges.txt") + few,
      folder);
  std::set<std::string> names;
  for (const auto& step : ranges.at("steps")) {
    names.insert(step.at("values").at("Mode").get<std::string>());
    const int out = (step.at("values").at("Depth").get<std::string>().front() == '~' ? 1 : 0) +
                    (step.at("values").at("Mode") == "~delete" ? 1 : 0);
    EXPECT_LE(out, 1);
  }
  for (const char* const name : {"read", "load", "write", "store", "~delete"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

TEST(ModelUsage, ASheetIsReadBackInEveryFormat) {
  const TemporaryFolder folder;
  spit(folder.file("m.txt"), browsers + "# two columns of a sheet\n");
  spit(folder.file("n.txt"), "step: 1, 2\nresult: pass, =fail\ncost: ~1, 2\nnotes: a, b\n");
  for (const std::string& model :
       {std::string("m.txt"), std::string("n.txt"), data("ranges.txt")}) {
    const std::string plan =
        "$changeover plan --test-cost 3 --change-cost 1 --model " + model + few;
    const Outcome outcome =
        run(plan + " -o s.csv && " + plan + " -o s.xlsx && " + plan + " --done s.csv && " + plan +
                " --done s.xlsx:'Run sheet'; rm -f s.csv s.xlsx",
            folder.path());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(count(outcome.out, "0 tests, 0 changes"), 2U) << model << outcome.out;
  }
}

TEST(ModelUsage, ColumnsAreParameters) {
  const TemporaryFolder folder;
  spit(folder.file("m.txt"),
       "OS: Debian, Windows\ncost: low, high\nLog: On, Off\nRetry: On, Off\n");
  const std::string plan = "$changeover plan --model m.txt --objective tests" + few;
  expect(
      {{plan + " --format csv | head -n 1", 0,
        "step,set,OS,slot_2 cost,Log,Retry,new_pairs,cost,cost_so_far,result\n"},
       {plan, 0, "4 parameters with 8 values: "},
       {plan, 0, "no plan for all pairs has fewer tests: this is the lower bound"},
       {plan + " --format markdown", 0, "| OS | cost | Log | Retry |"},
       {plan + " --format html", 0, "<th>Retry</th>"},
       {plan + " --mounted 'Log: On'", 0, "mounted all the time: Log: On"},
       {plan + " --mounted 'log=on'", 0, "mounted all the time: Log: On"},
       {plan + " --mounted On", 2, "--mounted: 'On' is a value of Log and of Retry; write Log: On"},
       {plan + " --mounted OS=BSD", 2, "OS has no value 'BSD'"},
       {plan + " --mounted 3", 2, "no parameter has the value '3'"}},
      folder);
}

TEST(ModelUsage, CostsByParameterByValueAndByWhatIsReplaced) {
  const TemporaryFolder folder;
  spit(folder.file("m.txt"), "OS: Debian, Fedora\nDB: MySQL, SQLite\n");
  spit(folder.file("c.csv"),
       "parameter,value,cost\nOS,20\nOS,Fedora,25\nDB,2.50\nOS,Debian,Fedora,4\n");
  spit(folder.file("t.csv"), "OS;Fedora;Debian\nFedora;;7\nDebian;4;\nDB;1,5\nOS;9\n");
  spit(folder.file("one.csv"), "OS,20\nDB,MySQL,1\n");
  spit(folder.file("bad.csv"), "OS,20\nDB,Oracle,1\n");
  const std::string plan =
      "$changeover plan --model m.txt --test-cost 1" + few + " --change-costs ";
  const auto costs = answer_of(plan + "c.csv --json", folder);
  EXPECT_EQ(costs.at("parts").at(0).at("change_cost"), 20);
  EXPECT_EQ(costs.at("replace_costs").at(0).at(1), 4);
  EXPECT_EQ(costs.at("replace_costs").at(1).at(0), 20);
  EXPECT_TRUE(costs.at("replace_costs").at(0).at(2).is_null());
  expect({{plan + "t.csv", 0, "4 of 4 needed pairs tested"},
          {plan + "one.csv", 2,
           "SQLite has no cost in one.csv; give --change-cost Y for values without one"},
          {plan + "one.csv --change-cost 3", 0, "4 of 4 needed pairs tested"},
          {plan + "bad.csv", 3, "bad.csv:2:4: DB has no value 'Oracle'"}},
         folder);
}

TEST(ModelUsage, WhatWasDoneIsTakenFromSeedsAndSheets) {
  const TemporaryFolder folder;
  const std::string plan =
      "$changeover plan --test-cost 2 --change-cost 1 --model " + data("partition.txt") + few;
  expect({{plan + " --first " + data("seeds.tsv"), 0, "the first 2 tests are given"},
          {plan + " --done " + data("seeds.tsv"), 0, "after 2 tests done"}},
         folder);
  spit(folder.file("m.txt"), browsers);
  spit(
      folder.file("done.csv"),
      "OS,Browser,Locale,result\nDebian,Firefox,de,pass\nFedora,Opera,en,pass\nWindows,Edge,ja,fail\n");
  const std::string shop = "$changeover plan --test-cost 2 --change-cost 1 --model m.txt" + few;
  expect(
      {{shop + " --done done.csv", 0, "no longer in the model, and left out: Browser: Opera"},
       {shop + " --done done.csv", 0, "3 pairs met only in tests that failed"},
       {"$changeover plan --test-cost 2 --change-cost 1 --model m.txt --quiet --done done.csv --diagnose",
        0, "Diagnosis of 3 tests"},
       {shop + " --first done.csv", 3, "done.csv:3:8: Browser has no value 'Opera'"},
       {shop + " --budget 20", 0, "budget 20: testing all pairs would cost"},
       {shop + " --what-if", 0, "Your costs are at the ratio 0.5."},
       {"printf 'OS\\tBrowser\\nDebian\\tEdge\\n' | " + shop + " --first -", 3,
        "<stdin>:2:1: no test of the model has all of these values"}},
      folder);
}

TEST(ModelUsage, WhatMeansNothingIsRefused) {
  const TemporaryFolder folder;
  spit(folder.file("m.txt"), browsers);
  spit(folder.file("sub.txt"), browsers.substr(0, browsers.find("IF")) + "{ OS, Browser } @ 2\n");
  spit(folder.file("none.txt"), browsers + "[Browser] = \"Edge\";\n[OS] <> \"Windows\";\n");
  const std::string plan = "$changeover plan --model m.txt --test-cost 1 --change-cost 1" + few;
  expect(
      {{plan + " --items 5 -k 3", 2, "--items N has no meaning with --model; leave it out"},
       {plan + " -k 3", 2, "--at-once K has no meaning with --model"},
       {"$changeover plan --items 6 -k 3 --test-cost 1 --benches 2 --objective tests", 2,
        "--objective tests is for a model"},
       {plan + " --shuffle 3", 2, "--shuffle SEED has no meaning with --model"},
       {plan + " --objective makespan", 2, "--objective makespan is for several benches"},
       {plan + " --strength 4", 2, "--strength 4: give 2, for pairs, or 3, for triples"},
       {plan + " --strength 3", 0, "needed triples tested"},
       {"$changeover plan --model missing.txt --objective tests", 4, "missing.txt"},
       {"$changeover plan --model sub.txt --objective tests", 3,
        "sub.txt:4:1: sub-models are not supported"},
       {"$changeover plan --model none.txt --objective tests", 3,
        "none.txt:6: no test obeys this rule and those before it: [OS] <> \"Windows\"; change one of them"},
       {"$changeover plan --model m.txt --objective tests -o m.txt", 2, "m.txt"}},
      folder);
}

// What only a test with a value out of range could have of a triple is no pair that is needed.
TEST(ModelUsage, TriplesWithAValueOutOfRangeAreTested) {
  const TemporaryFolder folder;
  spit(folder.file("m.txt"),
       "A: a, b\nB: c, d\nC: e, ~f\nIF [A] = \"a\" AND [B] = \"c\" THEN [C] <> \"e\";\n");
  expect({{"$changeover plan --model m.txt --test-cost 1 --change-cost 1 --strength 3" + few, 0,
           "7 of 7 needed triples tested"}},
         folder);
}

// Machines of a model: their sheets, what they lack, results, and a machine that is down.
TEST(ModelUsage, TestsAreSharedBetweenMachines) {
  const TemporaryFolder folder;
  spit(folder.file("m.txt"), browsers);
  spit(folder.file("b.csv"),
       "bench,without,start\nNorth,Windows,\nSouth,\"OS: Debian\",\"Fedora,Edge\"\n");
  const std::string plan =
      "$changeover plan --model m.txt --test-cost 2 --change-cost 1 --benches b.csv" + few + " ";
  const auto first = answer_of(plan + "--json", folder);
  EXPECT_EQ(first["pairs_tested"], first["pairs_needed"]);
  EXPECT_EQ(first["rules"], 1);
  for (const auto& sheet : first["sheets"]) {
    for (const auto& step : sheet["steps"]) {
      EXPECT_NE(step["values"]["OS"], sheet["name"] == "North" ? "Windows" : "Debian");
      EXPECT_TRUE(step["values"]["Browser"] != "Edge" || step["values"]["OS"] == "Windows");
    }
  }
  expect({{plan, 0, "South: set at the start: Fedora, Edge; cannot have: Debian"},
          {plan + "--format csv -o run.csv && sed -e '2s/,$/,pass/' run.csv > done.csv && " + plan +
               "--done done.csv",
           0, "North: set at the start: "},
          {"printf 'OS,Fedora,quantity,1\\n' > one.csv && " + plan +
               "--change-costs one.csv -o run.xlsx && $changeover plan run.xlsx" + few,
           0, "scarce, on no more benches at a time: Fedora (1)"},
          {plan + "-o run.xlsx && $changeover plan run.xlsx" + few, 0,
           "run.xlsx: the question is that of its hidden sheet"},
          {"sed -e '1s/$/,down/' -e '2s/$/,yes/' -e '3s/$/,/' b.csv > down.csv && "
           "$changeover plan --model m.txt --test-cost 2 --change-cost 1 --benches down.csv" +
               few,
           0, "pairs cannot meet on any bench that works and need not: Debian and "}},
         folder);
}

// A bench has its own values that stay: those of the job are of the others only.
TEST(ModelUsage, WhatStaysOnOneMachineBarsNothingOnAnother) {
  const TemporaryFolder folder;
  spit(folder.file("m.txt"), browsers);
  spit(folder.file("b.csv"), "bench,mounted\nNorth,\nSouth,Fedora\n");
  const std::string plan = "$changeover plan --model m.txt --test-cost 2 --change-cost 1" + few;
  const std::string both = plan + " --benches b.csv --mounted \"OS: Debian\" ";
  const auto answer = answer_of(both + "--json", folder);
  EXPECT_EQ(answer["pairs_needed"], 16);
  expect({{both, 0, "South: always set: Fedora"},
          {both, 0, "North: always set: Debian"},
          {both + "| grep -c 'mounted all the time' || true", 0, "0\n"},
          {both, 0, "2 pairs cannot meet by the rules and need not: "},
          {both, 0, " cannot meet on any bench that works and need not: "},
          {plan + " --mounted \"OS: Debian\"", 0,
           " cannot meet beside what is always set and need not: "},
          {both + "--without Fedora", 3,
           "b.csv: bench 'South' always has Fedora, which is left out from now on; mark the bench "
           "down, or change what is mounted there"},
          {"printf 'bench,mounted,down\nNorth,,\nSouth,Fedora,yes\n' > b.csv && " + both +
               "--without Fedora",
           0, "South: out of order"}},
         folder);
}

// Within a budget, the bounds are of plans that test all, and no test is not the end of the work.
TEST(ModelUsage, BoundsWithinABudgetOfMachinesAreForAllPairs) {
  const TemporaryFolder folder;
  spit(folder.file("m.txt"), browsers);
  const std::string plan =
      "$changeover plan --model m.txt --test-cost 2 --change-cost 1 --benches 2" + few;
  expect(
      {{plan + " --budget 0", 0, "\nno test was found within the budget\n"},
       {plan + " --budget 20", 0, " for all pairs for all benches together: "},
       {plan +
            " --budget 20 | grep -c '^no plan is\\|^lower bound for the bench\\|nothing is left' "
            "|| true",
        0, "0\n"}},
      folder);
}

TEST(ModelUsage, TheSameAtEveryNumberOfThreads) {
  const TemporaryFolder folder;
  const Outcome outcome = run(
      "for t in 1 2 1; do $changeover plan --model " + data("partition.txt") +
          " --test-cost 2 --change-cost 1 --quiet --steps 5000 --threads $t --json | md5sum; done | uniq | wc -l",
      folder.path());
  EXPECT_EQ(outcome.out, "1\n") << outcome.err;
}

TEST(ModelUsage, AsADocument) {
  const TemporaryFolder folder;
  spit(folder.file("m.txt"), browsers);
  const Outcome shown =
      run("$changeover plan --model m.txt --objective tests --show-request", folder.path());
  EXPECT_EQ(
      shown.out,
      "{\"format\":\"changeover-job/1\",\"model\":{\"file\":\"m.txt\"},\"objective\":\"tests\"}\n");
  spit(folder.file("job.json"),
       nlohmann::json{
           {"model", browsers},
           {"test_cost", 2},
           {"change_costs", {{"OS", 5}, {"Browser", "1"}, {"Locale", "ja", 2}}},
           {"change_cost", 1},
           {"first", nlohmann::json::array({nlohmann::json::array({"Edge", "OS: Windows"})})},
           {"steps", 2000},
           {"done", {{{"parts", {"Debian", "Firefox", "de"}}, {"result", "pass"}}}}}
           .dump());
  const auto plan = answer_of("$changeover plan --request job.json --quiet --json", folder);
  EXPECT_EQ(plan.at("steps").at(0).at("values").at("Browser"), "Edge");
  EXPECT_EQ(plan.at("tests_done"), 1);
  spit(folder.file("bad.json"), "{\"model\":[\"OS: a\"],\"objective\":\"tests\"}");
  expect(
      {{"printf %s '{\"model\":\"A: a\\nB b\",\"objective\":\"tests\"}' | $changeover plan --request -",
        3, "model:2:1: 'B b' is not a parameter"}},
      folder);
}

TEST(ModelUsage, TheExampleOfTheLabIsItsSheet) {
  const TemporaryFolder folder;
  const std::string lab = std::string(CHANGEOVER_TEST_DATA) + "/../../examples/lab/";
  const std::string plan = "$changeover plan --model " + lab +
                           "web_shop/model.txt --test-cost 6 --change-costs " + lab +
                           "web_shop/costs.csv --quiet ";
  const auto rest = answer_of(plan + "--json --done " + lab + "web_shop/sheet.csv", folder);
  EXPECT_EQ(rest.at("pairs_needed"), 0);
  const Outcome sheet = run("tail -n 1 " + lab + "web_shop/sheet.csv | tail -c 8", folder.path());
  const auto plan_again = answer_of(plan + "--json --threads 2", folder);
  EXPECT_THAT(sheet.out, HasSubstr("," + plan_again.at("cost").dump() + ","));
}

}  // namespace
}  // namespace changeover::test::model_test
