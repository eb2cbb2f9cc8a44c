// changeover plan, as it is run.
#include <gmock/gmock.h>

#include "cases.hpp"

namespace changeover::test::plan_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string fast = " --quiet --threads 1 --steps 20000";

TEST(Plan, CostsOfThePaper) {
  const TemporaryFolder folder;
  const std::string nine = "$changeover plan --items 9 -k 3 --quiet --test-cost ";
  const std::string costly_changes = nine + "1 --change-cost 5 --steps 200000";
  const std::string costly_tests = nine + "10 --change-cost 1 --threads 1 --steps 20000";
  expect({{costly_changes, 0, "17 tests, 20 changes, cost 117\n"},
          {costly_changes, 0, "SCCD(9,3) with 18"},
          {costly_changes, 0, "  118 "},
          {costly_changes, 0, "  137 "},
          {costly_changes, 0, "no plan for all pairs is"},
          {costly_tests, 0, "cost 145\n"},
          {costly_tests, 0, "  200 "}},
         folder);
}

TEST(Plan, TheSameAgainForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const Outcome outcome = run(
      "for t in 1 2 1; do $changeover plan --items 12 -k 4 --test-cost 2 --change-cost 1 --quiet "
      "--steps 30000 --threads $t --json > $t.$RANDOM.json; done; md5sum *.json | cut -c1-32 | "
      "uniq "
      "| wc -l",
      folder.path());
  EXPECT_EQ(outcome.out, "1\n") << outcome.err;
}

TEST(Plan, GoesOnFromTheSheetThatItWrote) {
  const TemporaryFolder folder;
  spit(folder.file("parts.csv"),
       "component,change cost\nPump,2\n\"Valve, large\",1\nFan,1\nBelt,3.5\n"
       "Motor,2\nHose,0.5\n");
  const Outcome outcome =
      run("$changeover plan parts.csv -k 3 --test-cost 4 --format csv -o sheet.csv" + fast +
              " && $changeover plan parts.csv -k 3 --test-cost 4 --done sheet.csv --done-first 3 "
              "--format csv -o rest.csv" +
              fast + " && head -n 4 sheet.csv > all.csv && tail -n +2 rest.csv >> all.csv && " +
              "$changeover plan parts.csv -k 3 --test-cost 4 --done all.csv" + fast +
              " && sed -n 2p rest.csv",
          folder.path());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("nothing is left to test"));
  EXPECT_THAT(outcome.out, HasSubstr("\n4,"));
}

TEST(Plan, WritesEveryFormat) {
  const TemporaryFolder folder;
  const std::string plan =
      "$changeover plan --items 6 -k 3 --test-cost 1 --change-cost 1.25" + fast;
  expect({{plan + " --json", 0, "{\"format\":\"changeover-plan/1\""},
          {plan + " --format csv", 0, "step,take_out"},
          {plan + " --format markdown --title Bench", 0, "# Bench\n"},
          {plan + " --format html -o s.html && cat s.html", 0, "<!DOCTYPE html>"},
          {"cat s.html", 0, "class=\"box\""},
          {plan + " --what-if", 0, "Your costs are at the ratio"},
          {plan + " --what-if --json", 0, "changeover-what-if/1"},
          {plan + " --compact --format html", 0, "class=\"compact two\""},
          {plan + " --compact", 0, "take out  put in"},
          {plan + " --compact --format csv", 2, "--compact has no meaning with --format csv"},
          {plan + " --shuffle 7", 0, "shuffled with seed 7"},
          {plan + " --shuffle 7 --what-if", 2, "--shuffle SEED has no meaning with --what-if"},
          {plan, 0, "fewer than these tests need in a random order"},
          {plan + " --budget 9", 0, "budget 9.00"}},
         folder);
}

TEST(Plan, SaysInOneLineWhatIsWrong) {
  const TemporaryFolder folder;
  spit(folder.file("parts.csv"), "A,1\nB,2\nC,3\nD\n");
  spit(folder.file("costs.csv"), "A,1\nB,2\nC,3\nD,4\n");
  spit(folder.file("bad.csv"), "A,1\nB,two2\n");
  spit(folder.file("twice.csv"), "A,1\nA,2\n");
  spit(folder.file("ab.csv"), "A,B\n");
  spit(folder.file("cd.csv"), "C,D\n");
  spit(folder.file("all.csv"), "A,B\nA,C\nA,D\nB,C\nB,D\nC,D\n");
  const std::string costs = " costs.csv -k 3 --test-cost 1 ";
  for (const Case& c : std::vector<Case>{
           {"", 2, "PARTS is missing; give a list of parts"},
           {"costs.csv --items 3", 2, "give either PARTS or --items N, not both"},
           {"costs.csv", 2, "give --test-cost X"},
           {"costs.csv --test-cost 1", 2, "give --at-once K, how many parts fit at once"},
           {"--items 3 --test-cost 1 --change-cost 1", 2, "--items N needs --at-once K"},
           {"costs.csv -k 1 --test-cost 1", 2, "no pair can meet"},
           {"costs.csv -k 3", 2, "give --test-cost X"},
           {"costs.csv -k 3 --test-cost -1", 2, "negative"},
           {"costs.csv -k 3 --test-cost 1e3", 2, "is not a cost"},
           {"parts.csv -k 3 --test-cost 1", 2, "D has no change cost"},
           {"--items 5 -k 3 --test-cost 1", 2, "give --change-cost Y"},
           {"--items 5000 -k 3 --test-cost 1 --change-cost 1", 2, "at most 1000"},
           {"--items 1 -k 3 --test-cost 1 --change-cost 1", 2, "two parts"},
           {costs + "--mounted A,X", 2, "there is no part 'X'"},
           {costs + "--start A,A", 2, "twice"},
           {costs + "--budget much", 2, "--budget: "},
           {costs + "--done-first 3", 2, "--done-first N is for --done"},
           {costs + "--what-if --format html", 2, "--what-if has no meaning with --format html"},
           {costs + "--what-if --title T", 2, "--title TEXT has no meaning with --what-if"},
           {costs + "--what-if --budget 9", 2, "--budget Z has no meaning with --what-if"},
           {costs + "--title T --format csv", 2, "--title has no meaning with --format csv"},
           {"bad.csv -k 2 --test-cost 1", 3, "bad.csv:2:3: "},
           {"twice.csv -k 2 --test-cost 1", 3, "twice.csv:2:1: "},
           {costs + "--never ab.csv --pairs ab.csv", 3, "must meet and must never"},
           {costs + "--never all.csv", 3, "all.csv: no two parts can be in one set-up"},
           {costs + "--never ab.csv --mounted A,B", 3, "both stay mounted"},
           {costs + "--never ab.csv --mounted A", 3, "B must never be in one set-up with A"},
           {costs + "--mounted A,B", 3, "no room for both"},
           {costs + "--start A,B,C,D", 3, "4 parts are mounted at the start"},
           {costs + "--pairs missing.csv", 4, "missing.csv"},
           {costs + "-o nowhere/sheet.csv", 4, "nowhere"},
       }) {
    expect({{"timeout 20 $changeover plan " + c.command + fast, c.code, c.says}}, folder);
  }
}

TEST(Plan, HonoursForbiddenPairsAndMountedParts) {
  const TemporaryFolder folder;
  spit(folder.file("costs.csv"), "A,1\nB,2\nC,3\nD,4\nE,5\n");
  spit(folder.file("never.csv"), "A,B\nC,D\n");
  const Outcome outcome = run(
      "$changeover plan costs.csv -k 4 --test-cost 1 --never never.csv --mounted E --json" + fast,
      folder.path());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("\"pairs_needed\":8,\"pairs_tested\":8"),
                                 HasSubstr("\"mounted\":[\"E\"]")));
}

TEST(Plan, AbsurdNumbersAreRefusedOrAnsweredAtOnce) {
  const TemporaryFolder folder;
  const std::string ten_to_400 = "1" + std::string(400, '0');
  const auto plan = [&](const std::string& arguments) {
    return run("timeout 20 $changeover plan --time 100ms --quiet --json " + arguments,
               folder.path());
  };
  for (const std::string& number :
       {std::string("0"), std::string("-1"), std::string("2147483648"), std::string("4294967296"),
        std::string("9223372036854775807"), std::string("9223372036854775808"),
        std::string("18446744073709551615"), std::string("18446744073709551616"),
        std::string("nan"), std::string("1e308"), std::string("9,00"), ten_to_400}) {
    const std::string costs = " --test-cost 1 --change-cost 1";
    for (const std::string& arguments :
         {"--items " + number + " -k 3" + costs, "--items 9 -k " + number + costs,
          "--items 9 -k 3 --change-cost 1 --test-cost " + number,
          "--items 9 -k 3 --test-cost 1 --change-cost " + number,
          "--items 9 -k 3 --budget " + number + costs, "--items 9 -k 3 --seed " + number + costs,
          "--items 9 -k 3 --steps " + number + costs}) {
      const Outcome outcome = plan(arguments);
      const bool refused =
          outcome.code == 2 && outcome.out.empty() && count(outcome.err, "\n") == 1;
      const bool answered = outcome.code == 0 && outcome.err.empty() && !outcome.out.empty();
      EXPECT_TRUE(refused || answered) << arguments << '\n' << outcome.code << outcome.err;
    }
  }
  EXPECT_THAT(plan("--items 9 -k 9223372036854775807 --test-cost 1 --change-cost 5").out,
              HasSubstr("\"tests\":1,\"changes\":9,\"cost\":46,"));
}

// Whatever is asked for, there always is a plan.
TEST(Plan, StoppedAtOnceItIsWhole) {
  const TemporaryFolder folder;
  spit(folder.file("costs.csv"), ",A,B,C,D\nA,,1,5,2\nB,1,,3,4\nC,5,3,,1\nD,2,4,1,\n");
  spit(folder.file("parts.csv"), "A,1\nB,1\nC,1\nD,1\n");
  spit(folder.file("slotted.csv"), "part,slot\nA,X\nB,X\nC,Y\nD,Y\nE,\n");
  const std::string slotted = "slotted.csv -k 3 --test-cost 1 --change-cost 1 --slot X=1..2,Y=..2";
  const std::string triples = "--items 9 -k 4 --test-cost 1 --change-cost 1 --strength 3";
  const std::vector<std::string> jobs{
      triples,
      triples + " --budget 20",
      "parts.csv -k 3 --test-cost 1 --change-costs costs.csv",
      "parts.csv -k 3 --test-cost 1 --change-costs costs.csv --budget 7",
      slotted,
      slotted + " --benches 2",
      slotted + " --what-if",
      slotted + " --budget 5"};
  for (const std::string& job : jobs) {
    const Outcome outcome = run("$changeover plan " + job + " --time 0s --quiet", folder.path());
    EXPECT_EQ(outcome.code, 0) << job << outcome.err;
    EXPECT_EQ(outcome.err, "") << job;
  }
}

TEST(Plan, NeverWritesOverWhatItReads) {
  const TemporaryFolder folder;
  const std::string parts = "A,1\nB,2\nC,3\nD,4\n";
  spit(folder.file("parts.csv"), parts);
  spit(folder.file("pairs.csv"), "A,B\n");
  spit(folder.file("done.csv"), "A,C\n");
  const Outcome links =
      run("ln -s parts.csv soft.csv && ln parts.csv hard.csv && mkdir sub && "
          "ln -s .. sub/up",
          folder.path());
  ASSERT_EQ(links.code, 0) << links.err;
  for (const std::string output : {"parts.csv", "./parts.csv", "sub/../parts.csv",
                                   "sub/up/parts.csv", "soft.csv", "hard.csv"}) {
    const Outcome outcome =
        run("$changeover plan parts.csv -k 3 --test-cost 1 --format csv -o " + output + fast,
            folder.path());
    EXPECT_EQ(outcome.code, 2) << output;
    EXPECT_THAT(outcome.err, HasSubstr("is the same file as the parts list"));
    EXPECT_EQ(slurp(folder.file("parts.csv")), parts) << output;
  }
  for (const std::string option : {"--pairs pairs.csv", "--never pairs.csv", "--done done.csv"}) {
    const std::string file = option.substr(option.find(' ') + 1);
    const Outcome outcome =
        run("$changeover plan parts.csv -k 3 --test-cost 1 " + option + " -o ./" + file + fast,
            folder.path());
    EXPECT_EQ(outcome.code, 2) << option;
    EXPECT_THAT(outcome.err, HasSubstr("same file as " + option.substr(0, option.find(' '))));
  }
  EXPECT_EQ(
      run("$changeover plan - -k 3 --test-cost 1 -o parts.csv < parts.csv" + fast, folder.path())
          .code,
      2);
  EXPECT_EQ(slurp(folder.file("parts.csv")), parts);
  spit(folder.file("sheet.csv"), "an older sheet");
  EXPECT_EQ(
      run("$changeover plan parts.csv -k 3 --test-cost 1 -o sheet.csv" + fast, folder.path()).code,
      0);
}

TEST(Plan, SaysInOneLineWhichFileIsAtFault) {
  const TemporaryFolder folder;
  spit(folder.file("parts.csv"), "A,1\nB,2\nC,3\nD,4\n");
  spit(folder.file("one.csv"), "A,1\n");
  spit(folder.file("empty.csv"), "");
  spit(folder.file("large.csv"), "A,B\nA,B,C,D\n");
  spit(folder.file("escape.csv"), "A\x1b[2J,1\nB,2\n");
  spit(folder.file("latin.csv"),
       "Gr\xf6\xdf"
       "e,1\nB,2\n");
  ASSERT_EQ(run("ln -s loop.csv loop.csv", folder.path()).code, 0);
  const std::string costs = " -k 3 --test-cost 1 ";
  for (const Case& c : std::vector<Case>{
           {"one.csv" + costs, 3, "one.csv: one part is listed"},
           {"empty.csv" + costs, 3, "empty.csv:1:1: no part is listed"},
           {"parts.csv --pairs empty.csv" + costs, 3, "empty.csv: no pair is listed"},
           {"parts.csv --done large.csv --done-first 9 -k 4 --test-cost 1", 2,
            "large.csv has only 2 set-ups"},
           {"escape.csv" + costs, 3, "escape.csv:1:2: control byte 0x1b"},
           {"latin.csv" + costs, 3, "latin.csv:1:3: byte 0xf6 is not UTF-8"},
           {"parts.csv --title $'a\\e[2Jb'" + costs, 2, "--title: control byte 0x1b"},
           {"/dev/zero" + costs, 3, "/dev/zero:1:1: control byte 0x00"},
           {"/dev/null" + costs, 3, "/dev/null:1:1: no part is listed"},
           {". " + costs, 4, "directory"},
           {"loop.csv" + costs, 4, "loop.csv"},
           {"parts.csv --never ." + costs, 4, "directory"},
           {"parts.csv --done loop.csv" + costs, 4, "loop.csv"},
       }) {
    expect({{"timeout 20 $changeover plan " + c.command + fast, c.code, c.says}}, folder);
  }
}

TEST(Plan, TakesNoHeaderForAPart) {
  const TemporaryFolder folder;
  spit(folder.file("wines.csv"), "wine,price\nRiesling,9.50\nMerlot,11\nPinot,7\n");
  spit(folder.file("weine.csv"), "Wein;Preis\nRiesling;9,50\nMerlot;11\nPinot;7\n");
  spit(folder.file("wines.tsv"), "wine\tprice\nRiesling\t9,50\nMerlot\t11\nPinot\t7\n");
  spit(folder.file("crates.csv"), "crate\nX1\nX2\nX3\n");
  spit(folder.file("never.csv"), "part 1;part 2\nMerlot;Pinot\n");
  const auto plan = [](const std::string& rest) {
    return "$changeover plan " + rest + " -k 2 --test-cost 1" + fast;
  };
  expect({{plan("wines.csv"), 0, "3 parts, 2 at a time: 3 tests, 4 changes, cost 37.50"},
          {plan("wines.csv"), 0, "a header: names in 'wine', change costs in 'price'"},
          {plan("weine.csv"), 0, "cost 37.50"},
          {plan("wines.tsv"), 0, "cost 37.50"},
          {plan("wines.csv --never never.csv"), 0, "2 of 2 needed pairs"},
          {plan("crates.csv --change-cost 1"), 3, "crates.csv:1:1: 'crate' may be a header"},
          {plan("crates.csv --change-cost 1 --header"), 0, "3 parts, 2 at a time"},
          {plan("crates.csv --change-cost 1 --no-header"), 0, "4 parts, 2 at a time"},
          {plan("crates.csv --header --no-header"), 2, "exclude each other"},
          {plan("--items 4 --change-cost 1 --header"), 2, "--items says only how many parts"},
          {plan("wines.csv --format csv -o sheet.csv") + " && cat sheet.csv", 0, "step,take_out"},
          {plan("sheet.csv"), 3, "sheet.csv:1:1: this is a run sheet"}},
         folder);
}

TEST(Plan, FillsEverySlot) {
  const TemporaryFolder folder;
  spit(folder.file("server.csv"),
       "part,slot,cost\nXeon,CPU,9\nEpyc,CPU,9\nP500,PSU,4\nP700,PSU,4\nd1,disk,1\nd2,disk,1\n"
       "d3,disk,1\nd4,disk,1\nd5,disk,1\nfan,,2\n");
  spit(folder.file("upside.csv"), "CPU,1,1\nPSU,2,1\n");
  spit(folder.file("flat.csv"), "part,slot\nX,A\nY,A\nZ,A\n");
  spit(folder.file("slots.csv"), "slot,least,most\nCPU,1,1\nPSU,1,1\ndisk,2,3\n");
  spit(folder.file("pairs.csv"), "Xeon,Epyc\n");
  const auto plan = [](const std::string& rest) {
    return "$changeover plan server.csv -k 6 --test-cost 5 " + rest + fast;
  };
  expect(
      {{plan("--slots slots.csv"), 0, "2 pairs cannot meet within the slots and need not: Xeon"},
       {plan("--slot CPU=1,PSU=1,disk=2..3"), 0, "43 of 43 needed pairs"},
       {plan("--slot CPU=1,PSU=1,disk=2..3 --json"), 0, "\"slots\":[{\"name\":\"CPU\""},
       {plan("--slot CPU=1,PSU=1,disk=2..3 --budget 60"), 0, "budget 60"},
       {plan("--slot CPU=1,PSU=1,disk=2..3 --what-if"), 0, "Your costs are at the factor"},
       {plan("--slot CPU=1,PSU=1"), 3, "d1 is in slot 'disk', which has no limits"},
       {plan("--slot CPU=1,PSU=1,disk=2,GPU=1"), 3, "no part is in slot 'GPU'"},
       {plan("--slot CPU=1,PSU=1,disk=5..6"), 3, "the slots need 7 parts in every set-up"},
       {plan("--slot CPU=3,PSU=1,disk=1"), 3,
        "slot 'CPU' needs 3 parts in every set-up, but only 2"},
       {plan("--slot CPU=1,PSU=1,disk=2 --pairs pairs.csv"), 3, "Xeon and Epyc must meet, but no"},
       {plan("--slot CPU=1,PSU=1,disk=3..2"), 2, "--slot: 'disk=3..2': at least 3 and at most 2"},
       {plan("--slots upside.csv"), 3, "upside.csv:2:5: slot 'PSU' has at least 2 and at most 1"},
       {"$changeover plan flat.csv -k 3 --test-cost 1 --slot A=..1 --change-cost 1" + fast, 3,
        "no two parts can be in one set-up within the slots"},
       {plan("--slot CPU=1,PSU=1,disk=2..x"), 2, "--slot: 'disk=2..x' is not a slot"},
       {plan(""), 2, "has a column slot; give --slots FILE"},
       {plan("--slots slots.csv --slot CPU=1"), 2, "exclude each other"},
       {plan("--slots slots.csv -o slots.csv"), 2, "same file as --slots"},
       {"$changeover plan --items 4 -k 2 --test-cost 1 --change-cost 1 --slot CPU=1" + fast, 2,
        "--items says only how many parts"}},
      folder);
}

TEST(Plan, GoesOnWhenPartsDieOrComeAndResultsAreFilledIn) {
  const TemporaryFolder folder;
  spit(folder.file("parts.csv"), "A,1\nB,2\nC,3\nD,2\nE,1\nF,2\n");
  spit(folder.file("died.csv"), "A,1\nB,2\nC,3\nD,2\nF,2\n");
  spit(folder.file("came.csv"), "A,1\nB,2\nC,3\nD,2\nE,1\nF,2\nG,2\n");
  const auto plan = [](const std::string& rest) {
    return "$changeover plan " + rest + " -k 3 --test-cost 4" + fast;
  };
  expect({{plan("parts.csv --format csv -o sheet.csv") + " && cat sheet.csv", 0,
           "cost_so_far,result\n1,"},
          {plan("died.csv --done sheet.csv --done-first 2"), 0,
           "sheet.csv: no longer in the parts list, and left out: E"},
          {"sed -e '2s/$/fail/' -e '3s/$/pass/' -e '4s/$/fail: leak/' sheet.csv > smoke.csv && "
           "$changeover plan died.csv -k 3 --test-cost 4 --done smoke.csv --diagnose",
           0, "smoke.csv: 1 test failed with a part that is gone"},
          {plan("came.csv --done sheet.csv --done-first 2"), 0, "after 2 tests done"},
          {plan("parts.csv --mounted A,E --without E"), 0,
           "--mounted: left out from now on, by --without, so not mounted: E"},
          {"printf 'A,E,B\\nE\\n' | " + plan("parts.csv --first - --without E"), 0,
           "<stdin>: left out from now on, so not in its set-ups: E"},
          {"sed -e '2s/$/pass/' -e '3s/$/smoke/' sheet.csv > filled.csv && " +
               plan("parts.csv --done filled.csv"),
           0, "tests have a result and are done"},
          {plan("parts.csv --done filled.csv"), 0, "after 2 tests done"},
          {plan("parts.csv --done filled.csv --done-first 3"), 0, "after 3 tests done"},
          {plan("parts.csv --done sheet.csv"), 0, "nothing is left to test"},
          {"sed 's/,A,/,a,/' sheet.csv > slip.csv; " + plan("parts.csv --done slip.csv"), 3,
           "did you mean 'A'?"}},
         folder);
}

TEST(Plan, TestsAgainWhatMetOnlyInFailedTests) {
  const TemporaryFolder folder;
  spit(folder.file("sheet.csv"),
       "step,slot_1,slot_2,slot_3,result\n1,1,2,3,pass\n2,3,4,5,FAILED - hang\n3,1,4,6,hot\n"
       "4,2,4,5,skipped\n5,2,5,6,\n");
  const auto plan = [](const std::string& rest) {
    return "$changeover plan --items 6 -k 3 --test-cost 4 --change-cost 1 --done sheet.csv" + fast +
           rest;
  };
  // 15 pairs, of which the first test has three.
  const std::string six = "6 pairs met only in tests that failed or whose result is not understood";
  expect({{plan(""), 0, six + ": they are needed again"},
          {plan(""), 0, "12 of 12 needed pairs tested"},
          {plan(""), 0, "after 3 tests done"},
          {plan(""), 0, "sheet.csv: 1 test was not run, by the column result, and is not done"},
          {plan(""), 0, "sheet.csv:4:9: the result 'hot' is not understood"},
          {plan(" --trust-failed"), 0, six + ": they count as tested"},
          {plan(" --trust-failed"), 0, "6 of 6 needed pairs tested"},
          {plan(" --json"), 0, R"("met_only_in_failed":6,"trust_failed":false)"},
          {plan(" --budget 12"), 0, "of 12 needed pairs tested"},
          {plan(" --what-if"), 0, six},
          {plan(" --what-if --json"), 0, R"("met_only_in_failed":6)"},
          {plan(" --what-if --format markdown"), 0, "- " + six},
          {plan(" --strength 3"), 0, "2 triples met only in tests that failed"},
          {plan(" --strength 3"), 0, "19 of 19 needed triples tested"},
          {plan(" --strength 3 --trust-failed"), 0, "17 of 17 needed triples tested"},
          {plan(" --done-first 2"), 0, "3 pairs met only in tests that failed"},
          {"$changeover plan --items 6 -k 3 --test-cost 4 --change-cost 1 --trust-failed", 2,
           "--trust-failed is for --done; give both"}},
         folder);
}

TEST(Plan, SaysWhatMayBeBroken) {
  const TemporaryFolder folder;
  spit(folder.file("parts.csv"), "A,1\nB,2\nC,3\nD,2\nE,1\nF,2\n");
  const auto plan = [](const std::string& rest) {
    return "$changeover plan parts.csv -k 3 --test-cost 4 --quiet " + rest;
  };
  spit(folder.file("sheet.csv"),
       "step,take_out,put_in,slot_1,slot_2,slot_3,new_pairs,cost,cost_so_far,result\n"
       "1,,,A,B,C,3,1,1,pass\n2,,,C,D,E,3,1,1,FAIL\n3,,,A,D,F,3,1,1,ok\n4,,,B,E,F,3,1,1,\n");
  expect({{plan("--done sheet.csv --diagnose"), 0, "one of these 4"},
          {plan("--done sheet.csv --diagnose"), 0, "pair C with D"},
          {plan("--done sheet.csv --diagnose --json"), 0, "changeover-diagnosis/1"},
          {plan("--done sheet.csv --diagnose -o d.txt") + " && cat d.txt", 0, "Next test, cost "},
          {"sed s/FAIL/pass/ sheet.csv > p.csv && " + plan("--done p.csv --diagnose"), 0,
           "No test failed"},
          {"sed 's/ok$/FAILED - hang/' sheet.csv > h.csv && " + plan("--done h.csv --diagnose"), 0,
           "1 passed, 2 failed"},
          {"sed 's/FAIL/hot/' sheet.csv > u.csv && " + plan("--done u.csv --diagnose"), 0,
           "u.csv:3:17: the result 'hot' is not understood; write pass or fail"},
          {plan("--done u.csv --diagnose"), 0, "2 passed, 0 failed, 1 not understood"},
          {plan("--done u.csv --diagnose | grep -c 'nothing is suspect\\|trust-failed' || true"), 0,
           "0\n"},
          {plan("--done u.csv --diagnose --json"), 0,
           R"("unread":1,"first_unread":[{"place":"u.csv:3:17","result":"hot"}])"},
          {plan("--done sheet.csv --diagnose --trust-failed"), 2,
           "--trust-failed has no meaning with --diagnose"},
          {"sed 's/pass$\\|FAIL$\\|ok$/hot/' sheet.csv > n.csv; " + plan("--done n.csv --diagnose"),
           3, "n.csv:2:17: 'hot' is neither pass nor fail"},
          {plan("--diagnose"), 2, "--diagnose is for --done"},
          {plan("--done sheet.csv --diagnose --format csv"), 2, "--diagnose has no meaning with"},
          {plan("--done sheet.csv --diagnose --what-if"), 2,
           "--what-if has no meaning with --diagnose"}},
         folder);
}

TEST(Plan, BeginsWithWhatMustComeFirst) {
  const TemporaryFolder folder;
  spit(folder.file("first.csv"), "# smoke test\n4,6\n1,2,3\n");
  spit(folder.file("large.csv"), "1,2\n1,2,3,4\n");
  spit(folder.file("never.csv"), "6,4\n");
  spit(folder.file("done.csv"), "6,4\n");
  const auto plan = [](const std::string& rest) {
    return "$changeover plan --items 6 -k 3 --test-cost 2 --change-cost 1 --first first.csv " +
           rest + fast;
  };
  expect(
      {{plan(""), 0, "the first 2 tests are given: cost 9, 4 of the needed pairs"},
       {plan(""), 0, "15 of 15 needed pairs"},
       {plan("--format csv"), 0, "\n1,,\"4, 6\",4,6,,1,4,4,\n2,\"4, 6\",\"1, 2, 3\",1,2,3,3,5,9,"},
       {plan("--json"), 0, "\"first\":[[\"4\",\"6\"],[\"1\",\"2\",\"3\"]]"},
       {plan("--budget 12"), 0, "the first 2 tests are given"},
       {plan("--shuffle 3"), 0, "15 of 15 needed pairs"},
       {plan("--what-if"), 0, "Your costs are at the ratio"},
       {plan("--done done.csv"), 0, "first.csv: 1 of 2 set-ups done already"},
       {plan("--done done.csv"), 0, "the first test is given: cost 5, 3 of"},
       {plan("--budget 8"), 3, "budget of 8: the tests that come first alone cost 9"},
       {plan("--never never.csv"), 3,
        "first.csv:2:1: 4 and 6 must never be in one set-up; remove one"},
       {plan("--mounted 5"), 3, "first.csv:2:1: 5 stays mounted, but is not in this set-up"},
       {plan("-o first.csv"), 2, "same file as --first"},
       {"$changeover plan --items 6 -k 3 --test-cost 2 --change-cost 1 --first large.csv" + fast, 3,
        "large.csv:2:1: 4 parts, but only 3 fit"}},
      folder);
}

TEST(Plan, WeighsPairs) {
  const TemporaryFolder folder;
  spit(folder.file("heavy.csv"), "part,part,priority\n8,9,20\n1,5,10\n2,3,0\n");
  spit(folder.file("bad.csv"), "1,2,3\n4,5,x\n");
  spit(folder.file("huge.csv"), "1,2,9000000000000\n1,3,9000000000000\n");
  spit(folder.file("never.csv"), "1,5\n");
  const auto plan = [](const std::string& rest) {
    return "$changeover plan --items 9 -k 3 --test-cost 1 --change-cost 5 " + rest + fast;
  };
  const std::string heavy = "--priority heavy.csv ";
  expect({{plan(heavy), 0, "weight of the pairs tested: 63 of 63; half of it after step "},
          {plan(heavy), 0, "weight so far"},
          {plan(heavy + "--budget 40"), 0, "no plan within the budget tests more"},
          {plan(heavy + "--json"), 0, "\"weight\":{\"needed\":63,\"tested\":63,\"most\":null}"},
          {plan(heavy + "--format csv"), 0, "cost_so_far,weight_so_far,result\n"},
          {plan(heavy + "--format html"), 0, "weight of the pairs tested"},
          {plan(heavy + "--never never.csv"), 0,
           "heavy.csv: 1 pair need not meet, and its weight does not count"},
          {plan("--priority huge.csv"), 3, "huge.csv: the weights together exceed 9.2e12"},
          {plan("--priority bad.csv"), 3, "bad.csv:2:5: 'x' is not a weight"},
          {plan(heavy + "--what-if"), 2, "--priority FILE has no meaning with --what-if"},
          {plan(heavy + "--shuffle 1"), 2, "--priority FILE has no meaning with --shuffle"},
          {plan(heavy + "-o heavy.csv"), 2, "same file as --priority"}},
         folder);
}

TEST(Plan, MakesTriplesMeet) {
  const TemporaryFolder folder;
  spit(folder.file("pairs.csv"), "1,2\n");
  const auto plan = [](const std::string& rest) {
    return "$changeover plan --items 8 -k 5 --test-cost 1 --change-cost 1 " + rest + fast;
  };
  expect(
      {{plan("--strength 3"), 0, "56 of 56 needed triples tested, checked by an independent"},
       {plan("--strength 3"), 0, "new triples"},
       {plan("--strength 3 --json"), 0, "\"triples_needed\":56,\"triples_tested\":56"},
       {plan("--strength 3 --format csv"), 0, ",new_triples,cost,"},
       {plan("--strength 3 --format html"), 0, "Triples tested"},
       {plan("--strength 3 --never pairs.csv"), 0, "6 triples cannot meet, for slots, forbidden"},
       {plan("--strength 3 --budget 9"), 0, "budget 9: testing all triples would cost"},
       {plan("--strength 2"), 0, "28 of 28 needed pairs"},
       {plan("--strength 4"), 2, "--strength 4: give 2, for pairs, or 3, for triples"},
       {plan("--strength 3 --pairs pairs.csv"), 2, "--pairs needs --strength 2; leave out"},
       {plan("--strength 3 --what-if"), 2, "--what-if needs --strength 2"},
       {"$changeover plan --items 8 -k 2 --test-cost 1 --change-cost 1 --strength 3" + fast, 2,
        "no triple can meet"},
       {"$changeover plan --items 101 -k 4 --test-cost 1 --change-cost 1 --strength 3" + fast, 2,
        "where triples must meet, at most 100"},
       {"$changeover plan --items 2 -k 4 --test-cost 1 --change-cost 1 --strength 3" + fast, 2,
        "a triple needs three parts; list three or more"},
       {plan("--mounted 1,2,3,4,5,6"), 2, "6 parts stay mounted, but only 5 fit"},
       {plan("--mounted 1,2,3,4"), 2, "there is no room for both"},
       {plan("--start 1,2,3,4,5,6"), 2, "6 parts are mounted at the start, but only 5 fit"},
       {plan("--mounted 1,2 --never pairs.csv"), 3, "must never be in one set-up"}},
      folder);
}

TEST(Plan, SharesTestsBetweenBenches) {
  const TemporaryFolder folder;
  const auto plan = [](const std::string& rest) {
    return "$changeover plan --items 8 -k 3 --test-cost 2 --change-cost 1 " + rest + fast;
  };
  expect({{plan("--benches 2"), 0, "28 of 28 needed pairs tested on some bench, checked by an"},
          {plan("--benches 2"), 0, "\nBench 2: "},
          {plan("--benches 2"), 0, "best for the least largest cost: "},
          {plan("--benches 2 --objective cost"), 0, "best for the least cost together: "},
          {plan("--benches 2 --json"), 0, "{\"format\":\"changeover-benches/1\""},
          {plan("--benches 2 --format csv"), 0, "bench,step,take_out,put_in,slot_1,slot_2,slot_3"},
          {plan("--benches 3 --format markdown --title Lab"), 0, "## Bench 3: "},
          {plan("--benches 2 --strength 3"), 0, "56 of 56 needed triples tested on some bench"},
          {plan("--benches 1"), 0, "on 1 bench: "},
          {plan("--benches 0"), 2, "--benches 0: give a number from 1 to 64"},
          {plan("--benches 2 --format html"), 0, "<h2 class=\"bench\">Bench 2: "},
          {plan("--benches 2 --budget 20"), 0, "best within the budget: "},
          {plan("--benches 2 --start 1"), 0, "28 of 28 needed pairs tested on some bench"},
          {plan("--benches 2 --what-if"), 2, "--what-if has no meaning with --benches"},
          {plan("--objective cost"), 2, "is for --benches"}},
         folder);
}

TEST(Plan, CtrlCDeliversTheBestSoFar) {
  const TemporaryFolder folder;
  // Once there are two threads, the search is under way.
  const Outcome outcome = run(
      "$changeover plan --items 400 -k 6 --test-cost 1 --change-cost 1 --time 10m --quiet --json "
      "--threads 2 -o plan.json & until [[ $(ls /proc/$!/task | wc -l) -ge 2 ]]; do sleep 0.02; "
      "done; kill -INT $!; wait $!; echo $?",
      folder.path());
  EXPECT_EQ(outcome.out, "0\n") << outcome.err;
  EXPECT_THAT(slurp(folder.file("plan.json")),
              HasSubstr("\"pairs_needed\":79800,\"pairs_tested\":79800"));
}

}  // namespace
}  // namespace changeover::test::plan_test
