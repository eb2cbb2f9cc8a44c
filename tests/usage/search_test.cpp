// changeover search, run as its users run it: alone, under Ctrl-C, killed, and as four processes.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "run_program.hpp"

namespace changeover::test {
namespace {

// Open MPI refuses to run as root, or with more processes than cores, unless told otherwise.
const std::string mpirun =
    "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1 "
    "OMPI_MCA_btl_vader_single_copy_mechanism=none mpirun -n 4 ";

// Installed, and able to start processes: it needs a network of its own and more.
bool have_mpirun(const TemporaryFolder& folder) {
  return run(mpirun + "true", folder.path()).code == 0;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++times;
  }
  return times;
}

TEST(Search, SaysMinimumWhereItsOwnProofsShowIt) {
  const TemporaryFolder folder;
  const Outcome outcome = run("$changeover search 6 4 -t 3 --exact --quiet", folder.path());
  EXPECT_EQ(outcome.code, 10);
  EXPECT_NE(outcome.out.find("6 blocks: minimum (its 6 blocks are the lower bound: proved"),
            std::string::npos)
      << outcome.out;
}

TEST(Search, AFormulaThatIsTooLargeIsRefusedInOneLine) {
  const TemporaryFolder folder;
  for (const char* what :
       {"65535 4", "65535 4 -b 100", "10 4 -b 65536", "9 4 -b 18446744073709551615"}) {
    const Outcome outcome =
        run("$changeover search " + std::string(what) + " --exact --time 60", folder.path());
    EXPECT_EQ(outcome.code, 4) << what;
    EXPECT_EQ(outcome.err.rfind("changeover: the formula of ", 0), 0U) << outcome.err;
    EXPECT_EQ(count(outcome.err, "\n"), 1U) << outcome.err;
    EXPECT_TRUE(outcome.out.empty());
  }
}

TEST(Search, FindsTheMinimumAndKeepsTheProofs) {
  const TemporaryFolder folder;
  const Outcome outcome = run(
      "$changeover search 9 4 --change 1 --exact --proof proofs --json --threads 1", folder.path());
  EXPECT_EQ(outcome.code, 10) << outcome.err;
  EXPECT_NE(outcome.out.find("\"minimum\":12"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\"proof\":\""), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "proofs/linear-m1-v9-k4-b11.drat"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "proofs/linear-m1-v9-k4-b11.cnf"));
}

TEST(Search, WhatItFindsCanBeStoredAndVerified) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run("$changeover search 13 5 --time 20s --threads 1 --json -o found.json --quiet; "
          "grep -q provenance found.json && $changeover verify found.json",
          folder.path());
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
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
      run("timeout -s INT 2 $changeover search 60 7 --time 10m --threads 1 --json -o best.json; "
          "echo \"code $?\"; $changeover verify best.json",
          folder.path());
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST(Search, ACheckpointSurvivesKill) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run("$changeover search 40 6 --time 10m --threads 1 --checkpoint state --quiet >/dev/null & "
          "pid=$!; for i in $(seq 100); do [[ -e state ]] && break; sleep 0.2; done; "
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
      run(mpirun + "$changeover search 9 4 --change 1 --exact --json --quiet", folder.path());
  EXPECT_EQ(outcome.code, 10) << outcome.err;
  EXPECT_EQ(count(outcome.out, "\"minimum\":12"), 1U) << outcome.out;
}

TEST(Search, FourProcessesStopWhenOneHasFound) {
  const TemporaryFolder folder;
  if (!have_mpirun(folder)) {
    GTEST_SKIP() << "mpirun is not installed, or starts nothing here";
  }
  const Outcome outcome =
      run(mpirun +
              "$changeover search 16 4 --blocks 24 --time 5m --json --quiet > found.json; code=$?; "
              "$changeover verify found.json && exit $code",
          folder.path());
  EXPECT_EQ(outcome.code, 10) << outcome.out << outcome.err;
}

TEST(Search, OrdersTheBlocksOfAFile) {
  const TemporaryFolder folder;
  spit(folder.file("fano.txt"), "0 1 3\n1 2 4\n2 3 5\n3 4 6\n4 5 0\n5 6 1\n6 0 2\n");
  const Outcome outcome =
      run("$changeover search --order fano.txt --change 2 --circular -f text", folder.path());
  EXPECT_EQ(outcome.code, 10) << outcome.err;
  const Outcome none =
      run("$changeover search --order fano.txt --change 1 --circular", folder.path());
  EXPECT_EQ(none.code, 20) << none.err;
  const Outcome least = run("$changeover search --order fano.txt", folder.path());
  EXPECT_EQ(least.code, 10) << least.err;
  EXPECT_NE(least.out.find("15 elements introduced"), std::string::npos) << least.out;
}

TEST(Search, RepairsAndExtendsAList) {
  const TemporaryFolder folder;
  spit(folder.file("broken.txt"), "0 1 2\n3 4 2\n3 4 1\n3 5 6\n0 5 4\n");
  const Outcome repaired =
      run("$changeover search --repair broken.txt -m 2 --linear --json --quiet -o design.json; "
          "code=$?; $changeover verify design.json && exit $code",
          folder.path());
  EXPECT_EQ(repaired.code, 10) << repaired.out << repaired.err;
  spit(folder.file("begun.txt"), "a b c\na d e\n");
  const Outcome extended =
      run("$changeover search 5 3 --extend begun.txt -m 2 --linear --json --quiet --time 5s -o "
          "design.json; code=$?; $changeover verify design.json && exit $code",
          folder.path());
  EXPECT_TRUE(extended.code == 10 || extended.code == 30) << extended.out << extended.err;
}

TEST(Search, FindsATightDesignFromBaseBlocks) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run("$changeover search 16 4 --base-blocks --tight --json --quiet -o tight.json; code=$?; "
          "grep -q '\"construction\":\"developed\"' tight.json && "
          "$changeover verify tight.json && exit $code",
          folder.path());
  EXPECT_EQ(outcome.code, 10) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("24 blocks"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("tight"), std::string::npos);
}

}  // namespace
}  // namespace changeover::test
