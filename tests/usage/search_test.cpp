// changeover search, run as its users run it: alone, under Ctrl-C, killed, and as four processes.
#include "cases.hpp"

namespace changeover::test::search_test {
namespace {

TEST(Search, WhatItProvesIsPartOfTheVerdict) {
  const TemporaryFolder folder;
  expect({{"$changeover search 9 5 --linear --exact --quiet", 10,
           "6 blocks: minimum (its 6 blocks are the lower bound: proved by this search)"},
          {"$changeover search 6 4 -t 3 --exact --quiet", 10,
           "6 blocks: minimum (its 6 blocks are the lower bound: proved by this search)"},
          {"$changeover search 9 5 --linear --exact --json --quiet", 10,
           "\"verdict\":{\"valid\":true,\"tight\":false,\"economical\":false,\"b\":6,\"lower_"
           "bound\":6,"
           "\"minimum\":\"proved\"},\"bound\":{\"name\":\"proved by this search\""}},
         folder);
}

TEST(Search, ATableThatItDidNotProveIsNamed) {
  const TemporaryFolder folder;
  expect({{"$changeover search 9 5 --linear --exact --blocks 6 --quiet", 10,
           "minimum (its 6 blocks are the lower bound: tables of checked proofs, not this "
           "search)"},
          {"$changeover search 9 5 --linear --exact --blocks 7 --quiet", 10,
           "over the lower bound 6 (tables of checked proofs, not this search)"}},
         folder);
}

TEST(Search, AFormulaThatIsTooLargeIsRefused) {
  const TemporaryFolder folder;
  for (const std::string what :
       {"65535 4", "65535 4 -b 100", "10 4 -b 65536", "9 4 -b 18446744073709551615"}) {
    expect(
        {{"$changeover search " + what + " --exact --time 60", 4, "changeover: the formula of "}},
        folder);
  }
}

TEST(Search, FindsTheMinimumAndKeepsTheProofs) {
  const TemporaryFolder folder;
  expect({{"$changeover search 9 5 --linear --exact --proof proofs --json --threads 1", 10,
           "\"minimum\":6,\"proof\":\""}},
         folder);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "proofs/linear-m2-v9-k5-b5.drat"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "proofs/linear-m2-v9-k5-b5.cnf"));
}

TEST(Search, WhatItFindsCanBeStoredAndVerified) {
  const TemporaryFolder folder;
  expect({{"$changeover search 13 5 --time 20s --threads 1 --json -o found.json --quiet; "
           "grep -q provenance found.json && $changeover verify found.json",
           0, "valid: "}},
         folder);
}

// The recipe's provenance names all options that decide what was looked for, and is accepted again.
TEST(Search, ProvenanceCanBeTypedAgain) {
  const TemporaryFolder folder;
  for (const std::string typed :
       {"16 4 --change 2 --circular --base-blocks --tight --cycle 3",
        "20 4 --change 2 --circular --blocks 39 --base-blocks --cycle 3 --fixed-points 2",
        "9 4 --change 1 --linear --first 0,1,2,3"}) {
    const std::string rest = " --time 20s --quiet --json";
    const Outcome first = run("$changeover search " + typed + rest, folder.path());
    EXPECT_EQ(first.code, 10) << typed << first.err;
    const std::string before = "\"provenance\":\"changeover ";
    const std::size_t at = first.out.find("search", first.out.find(before));
    ASSERT_NE(at, std::string::npos) << typed;
    const std::string again = first.out.substr(at, first.out.find('"', at) - at);
    EXPECT_TRUE(again.starts_with("search " + typed)) << again;
    EXPECT_EQ(run("$changeover " + again + " --quiet --json", folder.path()).code, 10) << again;
  }
}

TEST(Search, WithLockedCellsSaysWhatCannotBe) {
  const TemporaryFolder folder;
  const std::string search = "$changeover search --linear -m 1 --quiet ";
  expect(
      {{"$changeover search 9 6 -m 3 --linear --expansion-set --blocks 3 --quiet", 20,
        "with 3 blocks has what is wanted: 3 unchanged subsets of 3 in a partition take as many steps, so 4 blocks"},
       {"$changeover search 9 6 -m 3 --circular --expansion-set --blocks 3 --quiet", 10,
        "  ^   ^   ^"},
       {search + "12 4 --first 0,1 --blocks 3", 20,
        "No linear SCCD(12,4) with 3 blocks: the first block covers"},
       {search + "12 4 --first 0,1 --blocks 99999999 --time 60s", 10, "12,4), 2"},
       {search + "65535 400 --first 0", 3, "from k+1 = 401 to 4096, not 65535"},
       {search + "4000 3 --first 0 --memory 1G", 4, "more than the 1.0 GB allowed"}},
      folder);
}

// What is proved is about designs that have what is wanted: others may have fewer blocks.
TEST(Search, ProvesWhatCannotBeHadBesides) {
  const TemporaryFolder folder;
  const std::string ends =
      "$changeover search 6 3 -m 1 --linear --exact --first 0,1 --last 1,0 --quiet ";
  const std::string words = " that begins with {0,1} and ends with {1,0}";
  expect({{ends, 10, "No linear SCCD(6,3)" + words + " has fewer than 8 blocks"},
          {ends, 10, "8 blocks: 1 block is over the lower bound 7"},
          {ends + "--blocks 7", 20, "7 blocks: none" + words + "; DRAT proof of "},
          {ends + "--json", 10, "\"fewest_as_wanted\":8"},
          {ends + "--json | grep -c minimum.:8", 1, "0"},
          {ends + "--proof proofs", 10, ", checked: proofs/linear-m1-v6-k3-b7-with-"},
          {"cat proofs/linear-m1-v6-k3-with-*-README.md", 0,
           "## No linear SCCD(6,3) with 7 blocks" + words},
          {"ls proofs/linear-m1-v6-k3-b7-with-*.drat && ls proofs | wc -l", 0, "3\n"}},
         folder);
  const std::string given = "printf '0 1 2\\n1 2 3\\n' > two.txt; $changeover search 5 3 -m 1 ";
  expect({{given + "--exact --circular --contains two.txt --quiet", 10, "that contains {0,1,2}, "},
          {given + "--exact --contains two.txt --blocks 2 --quiet", 20,
           "none that contains {0,1,2}, {1,2,3} one after another; DRAT proof"},
          {given + "--exact --contains two.txt --blocks 1 --quiet", 20,
           "with 1 block has what is wanted: 2 blocks are given"},
          {given + "--exact --first 0,4 --contains two.txt --quiet | head -n 1", 0, "SCCD(5,3)"},
          {"$changeover search 6 3 -m 1 --exact --expansion-set --first 1,3 --quiet", 10,
           "partition the other elements"},
          {"$changeover search 5 4 -t 3 -m 1 --exact --first 4 --quiet", 10,
           "t = 3 that begins with {4} has fewer than 4 blocks"}},
         folder);
}

TEST(Search, BeginsWithNoKnownDesignIfTold) {
  const TemporaryFolder folder;
  const std::string search =
      "$changeover search 12 4 -m 1 --first 0,1,2 --expansion-set --blocks 21 --threads 1 --quiet ";
  expect({{search, 10, "0 moves in "},
          {search, 10, "a known design has the properties"},
          {search + "--anew --json | grep -o 'expansion-set --anew'", 0, "--anew"},
          {search + "--anew | grep -c 'known design'", 1, "0\n"},
          {"$changeover search 9 4 -m 1 --exact --anew --quiet", 10, "12 blocks: found"},
          {"$changeover search 20 5 -m 1 --exact --first 0,1,2,3 --expansion-set --quiet", 10,
           "a known design has the properties"}},
         folder);
}

TEST(Search, IsDeterministicWithOneThread) {
  const TemporaryFolder folder;
  const Outcome first = run(
      "$changeover search 44 7 --blocks 88 --threads 1 --seed 5 --quiet -f text", folder.path());
  const Outcome second = run(
      "$changeover search 44 7 --blocks 88 --threads 1 --seed 5 --quiet -f text", folder.path());
  EXPECT_EQ(first.code, 10) << first.err;
  EXPECT_EQ(first.out, second.out);
}

TEST(Search, CtrlCKeepsTheBest) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run("$changeover search 60 7 --time 10m --threads 1 --checkpoint state --json -o best.json & "
          "pid=$!; for i in $(seq 1200); do [[ -s state ]] && break; sleep 0.05; done; "
          "kill -INT $pid; wait $pid; echo \"code $?\"; $changeover verify best.json",
          folder.path());
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST(Search, ACheckpointSurvivesKill) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run("$changeover search 40 6 --time 10m --threads 1 --checkpoint state --quiet >/dev/null & "
          "pid=$!; for i in $(seq 1200); do [[ -e state ]] && break; sleep 0.05; done; "
          "kill -9 $pid; wait $pid 2>/dev/null; "
          "$changeover search 40 6 --time 1s --threads 1 --checkpoint state --json -o best.json "
          "--quiet; $changeover verify best.json",
          folder.path());
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST(Search, ACheckpointOfOtherParametersIsRefusedAndKept) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run("$changeover search 30 5 --time 1s --checkpoint state --quiet >/dev/null; "
          "cp state before; $changeover search 31 5 --time 1s --checkpoint state; code=$?; "
          "cmp state before && exit $code",
          folder.path());
  EXPECT_EQ(outcome.code, 3) << outcome.err;
  EXPECT_EQ(count(outcome.err, "\n"), 1U) << outcome.err;
}

TEST(Search, FourProcessesShareAProof) {
  const TemporaryFolder folder;
  if (!have_mpirun(folder)) {
    GTEST_SKIP() << "mpirun is not installed, or starts nothing here";
  }
  const Outcome outcome =
      run(mpirun + "-n 4 $changeover search 9 5 --linear --exact --json --quiet", folder.path());
  EXPECT_EQ(outcome.code, 10) << outcome.err;
  EXPECT_EQ(count(outcome.out, "\"minimum\":6"), 1U) << outcome.out;
}

TEST(Search, FourProcessesKnowWhereThePartsAre) {
  const TemporaryFolder folder;
  if (!have_mpirun(folder)) {
    GTEST_SKIP() << "mpirun is not installed, or starts nothing here";
  }
  const Outcome outcome =
      run(mpirun +
              "-n 4 $changeover search 6 3 -m 1 --exact --first 0,1 --expansion-set --anew --quiet",
          folder.path());
  EXPECT_EQ(outcome.code, 10) << outcome.err;
  EXPECT_EQ(count(outcome.out, "partition the other elements"), 1U) << outcome.out;
}

TEST(Search, FourProcessesStopWhenOneHasFound) {
  const TemporaryFolder folder;
  if (!have_mpirun(folder)) {
    GTEST_SKIP() << "mpirun is not installed, or starts nothing here";
  }
  const Outcome outcome = run(mpirun +
                                  "-n 4 $changeover search 16 4 --blocks 24 --time 5m --json "
                                  "--quiet > found.json; code=$?; "
                                  "$changeover verify found.json && exit $code",
                              folder.path());
  EXPECT_EQ(outcome.code, 10) << outcome.out << outcome.err;
}

TEST(Search, OrdersTheBlocksOfAFile) {
  const TemporaryFolder folder;
  spit(folder.file("fano.txt"), "0 1 3\n1 2 4\n2 3 5\n3 4 6\n4 5 0\n5 6 1\n6 0 2\n");
  const std::string order = "$changeover search --order fano.txt --quiet";
  expect({{order + " --change 2 --circular -f text", 10, "v=7 k=3 change=2 kind=circular"},
          {order + " --change 1 --circular", 20, "No circular order"},
          {order, 10, "15 elements introduced"}},
         folder);
}

TEST(Search, RepairsExtendsAndDevelops) {
  const TemporaryFolder folder;
  spit(folder.file("broken.txt"), "0 1 2\n3 4 2\n3 4 1\n3 5 6\n0 5 4\n");
  spit(folder.file("begun.txt"), "a b c\na d e\n");
  const std::string kept =
      " --json --quiet -o d.json; code=$?; $changeover verify d.json && exit $code";
  expect(
      {{"$changeover search --repair broken.txt -m 2 --linear" + kept, 10, "valid: "},
       {"$changeover search 5 3 --extend begun.txt -m 2 --linear --time 1s --json --quiet -o e.json; "
        "case $? in 10 | 30) $changeover verify e.json ;; esac",
        0, "valid: "},
       {"$changeover search 16 4 --base-blocks --tight" + kept, 10, "24 blocks"},
       {"grep -o '\"construction\":\"developed\"' d.json", 0, "developed"}},
      folder);
}

}  // namespace
}  // namespace changeover::test::search_test
