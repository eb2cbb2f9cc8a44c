#include "changeover/search/exact.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "changeover/core/error.hpp"
#include "changeover/proof/proof.hpp"
#include "message_of.hpp"
#include "naive_verdict.hpp"
#include "run_program.hpp"
#include "search/exact/exact_encoding.hpp"

namespace changeover::exact_test {
namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;
using testing::HasSubstr;

const Parameters sccd_9_4{.v = 9, .k = 4, .change = 1};

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

TEST(Decide, FindsAVerifiedDesignAndLeavesNoFile) {
  const test::TemporaryFolder folder;
  RunControl control({});
  const Decision decision =
      decide(sccd_9_4, 12, {.proof_directory = folder.path().string()}, control);
  EXPECT_EQ(decision.outcome, Outcome::found);
  EXPECT_EQ(decision.why_stopped, WhyStopped::found);
  ASSERT_TRUE(decision.design.has_value());
  EXPECT_EQ(decision.design->block_count(), 12U);
  EXPECT_TRUE(test::naive_verdict(*decision.design).valid);
  EXPECT_TRUE(decision.parts.empty());
  EXPECT_TRUE(names_in(folder.path()).empty());
  EXPECT_EQ(control.why_stopped(), WhyStopped::running);  // only this question is answered
}

TEST(Decide, ProvesThatThereIsNoneAndKeepsBothFiles) {
  const test::TemporaryFolder folder;
  RunControl control({});
  const Decision decision = decide(sccd_9_4, 11, {.proof_directory = folder.file("a/b")}, control);
  EXPECT_TRUE(decision.excluded());
  EXPECT_EQ(decision.why_stopped, WhyStopped::exhausted);
  EXPECT_FALSE(decision.design.has_value());
  ASSERT_EQ(decision.parts.size(), 1U);
  const CheckedPart& part = decision.parts.front();
  EXPECT_EQ(part.cnf_path, folder.file("a/b/linear-m1-v9-k4-b11.cnf"));
  EXPECT_EQ(names_in(folder.file("a/b")),
            (std::set<std::string>{"linear-m1-v9-k4-b11.cnf", "linear-m1-v9-k4-b11.drat"}));
  EXPECT_EQ(part.proof_bytes, fs::file_size(part.proof_path));
  EXPECT_GT(part.proof_steps, 0U);
  const ProofVerdict verdict = check_proof_files(part.cnf_path, part.proof_path);
  EXPECT_TRUE(verdict.verified()) << verdict.reason;
  EXPECT_EQ(verdict.clauses, part.clauses);
  EXPECT_EQ(verdict.variables, part.variables);
}

TEST(Decide, GivesTheSameProofEveryTime) {
  const test::TemporaryFolder one;
  const test::TemporaryFolder two;
  for (const test::TemporaryFolder* folder : {&one, &two}) {
    RunControl control({});
    (void)decide(sccd_9_4, 11, {.proof_directory = folder->path().string()}, control);
  }
  EXPECT_GT(names_in(one.path()).size(), 0U);
  for (const std::string& name : names_in(one.path())) {
    EXPECT_EQ(test::slurp(one.file(name)), test::slurp(two.file(name)));
  }
}

// A proof is of one formula: neither another one nor a damaged proof passes.
TEST(Decide, WritesProofsThatFailWhenTheyAreMutated) {
  const test::TemporaryFolder folder;
  RunControl control({});
  const Decision decision =
      decide(sccd_9_4, 11, {.proof_directory = folder.path().string()}, control);
  ASSERT_TRUE(decision.excluded());
  const std::string cnf = test::slurp(decision.parts.front().cnf_path);
  const std::string proof = test::slurp(decision.parts.front().proof_path);
  const auto verdict_on = [](const std::string& formula, const std::string& steps) {
    std::istringstream a(formula);
    std::istringstream b(steps);
    return check_proof(a, "cnf", b, "drat");
  };
  ASSERT_TRUE(verdict_on(cnf, proof).verified());
  EXPECT_FALSE(verdict_on(cnf, "").verified());
  EXPECT_FALSE(verdict_on(cnf, proof.substr(0, proof.find('\n', proof.size() / 2) + 1)).verified());

  // The same proof for another formula, which has a solution.
  StringSink other;
  write_dimacs(encode_design(sccd_9_4, 12).cnf(), {}, {}, other);
  EXPECT_FALSE(verdict_on(other.text(), proof).verified());

  // With a literal flipped; a clause that is not needed may be lost without harm.
  std::size_t refused = 0;
  std::size_t tried = 0;
  std::vector<std::string> steps;
  std::istringstream text(proof);
  for (std::string line; std::getline(text, line);) {
    steps.push_back(line);
  }
  for (std::size_t at = 0; at < steps.size(); at += steps.size() / 40 + 1) {
    if (steps[at][0] == 'd') {
      continue;
    }
    std::vector<std::string> mutated = steps;
    mutated[at] = mutated[at][0] == '-' ? mutated[at].substr(1) : "-" + mutated[at];
    std::string all;
    for (const std::string& line : mutated) {
      all += line + "\n";
    }
    ++tried;
    refused += verdict_on(cnf, all).verified() ? 0U : 1U;
  }
  EXPECT_GT(tried, 10U);
  EXPECT_GT(2 * refused, tried) << refused << " of " << tried;
}

TEST(Decide, SaysNoneWithoutProofOnlyAsThat) {
  RunControl control({});
  const Decision unproved = decide(sccd_9_4, 11, {.prove = false}, control);
  EXPECT_EQ(unproved.outcome, Outcome::none);
  EXPECT_FALSE(unproved.proved || unproved.excluded());
  EXPECT_EQ(decide(sccd_9_4, 12, {.prove = false}, control).outcome, Outcome::found);
}

TEST(Decide, StopsWhenTheTimeIsUp) {
  RunControl none({.time = seconds(0)});
  const Decision stopped = decide(sccd_9_4, 11, {}, none);
  EXPECT_EQ(stopped.outcome, Outcome::unknown);
  EXPECT_EQ(stopped.why_stopped, WhyStopped::time_limit);
  EXPECT_TRUE(stopped.parts.empty());

  const test::TemporaryFolder folder;
  RunControl control({});
  const Decision step = decide(
      {.v = 16, .k = 5, .change = 1}, 29,
      {.proof_directory = folder.path().string(), .time_per_step = std::chrono::milliseconds(200)},
      control);
  EXPECT_EQ(step.outcome, Outcome::unknown);
  EXPECT_EQ(step.why_stopped, WhyStopped::time_limit);
  EXPECT_EQ(control.why_stopped(), WhyStopped::running);
  EXPECT_TRUE(names_in(folder.path()).empty());
}

TEST(Decide, StopsAfterSoManyConflicts) {
  const Parameters p{.v = 13, .k = 5};
  for (const bool prove : {true, false}) {
    RunControl control({});
    const Decision decision = decide(p, 11, {.prove = prove, .conflicts_per_step = 100}, control);
    EXPECT_EQ(decision.outcome, Outcome::unknown);
    EXPECT_EQ(decision.why_stopped, WhyStopped::step_limit);
  }
}

TEST(Decide, StopsWhenTheUserSaysSo) {
  std::atomic<bool> interrupted = false;
  RunControl control({.interrupted = &interrupted,
                      .on_progress = [&](const Progress&) { interrupted = true; },
                      .progress_interval = std::chrono::duration<double>(0)});
  const Decision decision = decide({.v = 16, .k = 5, .change = 1}, 29, {}, control);
  EXPECT_EQ(decision.outcome, Outcome::unknown);
  EXPECT_EQ(decision.why_stopped, WhyStopped::interrupted);
}

TEST(Decide, HandsOnWhatACallbackThrows) {
  RunControl control({.on_progress = [](const Progress&) { throw BadInput("enough"); },
                      .progress_interval = std::chrono::duration<double>(0)});
  EXPECT_THROW((void)decide({.v = 16, .k = 5, .change = 1}, 29, {}, control), BadInput);
}

TEST(Decide, GivesTheSameAnswersWithTwoThreads) {
  const test::TemporaryFolder folder;
  for (const std::uint64_t b : {11U, 12U}) {
    RunControl control({.threads = 2});
    const Decision decision =
        decide(sccd_9_4, b, {.proof_directory = folder.path().string()}, control);
    EXPECT_EQ(decision.outcome, b == 11 ? Outcome::none : Outcome::found);
    EXPECT_EQ(decision.excluded(), b == 11);
    if (b == 12) {
      EXPECT_TRUE(test::naive_verdict(*decision.design).valid);
      continue;
    }
    EXPECT_GT(decision.cubes, 1U);
    EXPECT_EQ(decision.parts.size(), decision.cubes);
    std::vector<Cube> cubes;
    for (const CheckedPart& part : decision.parts) {
      cubes.push_back(part.cube);
      EXPECT_TRUE(check_proof_files(part.cnf_path, part.proof_path).verified());
    }
    EXPECT_TRUE(cubes_cover_everything(cubes));
    std::ifstream list(decision.cubes_path);
    std::size_t lines = 0;
    for (std::string line; std::getline(list, line);) {
      lines += line.rfind("a ", 0) == 0 && line.substr(line.size() - 2) == " 0" ? 1U : 0U;
    }
    EXPECT_EQ(lines, decision.cubes);
    EXPECT_EQ(names_in(folder.path()).size(), 2 * decision.cubes + 1);
  }
  // The design was found: only the files of the other question are there.
  for (const std::string& name : names_in(folder.path())) {
    EXPECT_THAT(name, HasSubstr("-b11"));
  }
}

TEST(Decide, SharesTheCubesBetweenProcesses) {
  std::vector<Cube> cubes;
  constexpr std::uint64_t processes = 3;
  for (std::uint64_t index = 0; index < processes; ++index) {
    RunControl control({.share = {index, processes}});
    const Decision decision = decide(sccd_9_4, 11, {}, control);
    EXPECT_EQ(decision.outcome, Outcome::none);
    EXPECT_TRUE(decision.proved && decision.in_share && !decision.excluded());
    for (const CheckedPart& part : decision.parts) {
      cubes.push_back(part.cube);
    }
  }
  EXPECT_TRUE(cubes_cover_everything(cubes));
  RunControl wrong({.share = {3, 3}});
  EXPECT_REFUSAL((void)decide(sccd_9_4, 11, {}, wrong), BadInput,
                 "share 3 of 3: the index must be below the number of shares");
}

TEST(Decide, DividesSharesOfTheSameCubesFurther) {
  const auto excluded = [](std::uint64_t index, std::uint64_t of) {
    RunControl control({.share = {index, of}});
    const Decision decision = decide(sccd_9_4, 11, {.cubes = 16}, control);
    EXPECT_EQ(decision.outcome, Outcome::none);
    std::set<Cube> cubes;
    for (const CheckedPart& part : decision.parts) {
      cubes.insert(part.cube);
    }
    return cubes;
  };
  for (std::uint64_t index = 0; index < 2; ++index) {
    std::set<Cube> halves = excluded(index, 4);
    halves.merge(excluded(index + 2, 4));
    EXPECT_EQ(excluded(index, 2), halves);
  }
  EXPECT_TRUE(excluded(5000, 5001).empty());  // more shares than cubes
  RunControl whole({});
  EXPECT_TRUE(decide(sccd_9_4, 11, {.cubes = 16}, whole).excluded());
}

TEST(Decide, KnowsTheCornerCases) {
  RunControl control({});
  const auto outcome = [&](const Parameters& p, std::uint64_t b) {
    return decide(p, b, {}, control).outcome;
  };
  for (const Kind kind : {Kind::linear, Kind::circular}) {
    EXPECT_EQ(outcome({.v = 4, .k = 4, .kind = kind}, 1), Outcome::found);
    EXPECT_EQ(outcome({.v = 4, .k = 4, .kind = kind}, 2), Outcome::none);
    EXPECT_EQ(outcome({.v = 5, .k = 4, .change = 1, .kind = kind}, 1), Outcome::none);
    EXPECT_EQ(outcome({.v = 5, .k = 4, .change = 1, .kind = kind}, 3), Outcome::found);
    EXPECT_EQ(outcome({.v = 4, .k = 2, .kind = kind}, 6), Outcome::none);
  }
  EXPECT_THROW((void)outcome({.v = 5, .k = 4, .change = 1}, 0), BadInput);
  EXPECT_THROW((void)outcome({.v = 3, .k = 4, .change = 1}, 2), ImpossibleParameters);
}

TEST(Decide, RefusesAFormulaThatTheMemoryDoesNotHold) {
  RunControl control({.memory_bytes = 1'000'000});
  try {
    (void)decide({.v = 60, .k = 5}, 300, {}, control);
    FAIL() << "some gigabytes";
  } catch (const MissingResource& fault) {
    EXPECT_THAT(fault.what(), HasSubstr("the formula of linear DCCD(60,5) with 300 blocks"));
    EXPECT_THAT(fault.what(), HasSubstr("GB"));
  }
  EXPECT_EQ(decide({.v = 5, .k = 4, .change = 1}, 3, {}, control).outcome, Outcome::found);
}

TEST(Decide, TakesFewerThreadsWhereMemoryIsShort) {
  const Parameters p{.v = 9, .k = 4, .change = 1};
  const CnfSize size = design_formula_size(p, 11);
  const SolvingNeeds two{.split = true, .threads = 2};
  RunControl control({.memory_bytes = solving_bytes(size, two), .threads = 8});
  EXPECT_EQ(require_room(p, 11, {}, control), 2U);
  EXPECT_TRUE(decide(p, 11, {}, control).excluded());
}

// Building the formula, splitting it, writing it, handing it to the solver, solving: wherever it is
// then.
TEST(Decide, StopsInTimeWhereverItIs) {
  for (const auto time : {0, 50, 300, 1000}) {
    for (const unsigned threads : {1U, 2U}) {
      RunControl control({.time = std::chrono::milliseconds(time), .threads = threads});
      const auto begin = RunControl::Clock::now();
      const Decision decision = decide({.v = 40, .k = 5}, 130, {}, control);
      EXPECT_EQ(decision.outcome, Outcome::unknown);
      EXPECT_EQ(decision.why_stopped, WhyStopped::time_limit);
      EXPECT_LT(RunControl::Clock::now() - begin, seconds(10)) << time << " ms";
    }
  }
}

TEST(Decide, NamesFilesByParameters) {
  EXPECT_EQ(file_stem({.v = 61, .k = 4, .kind = Kind::circular}, 366), "circular-m2-v61-k4-b366");
  EXPECT_EQ(file_stem({.v = 61, .k = 4}, std::nullopt), "linear-m2-v61-k4");
  EXPECT_EQ(file_stem({.v = 8, .k = 5, .change = 1, .strength = 3}, 9), "linear-m1-v8-k5-t3-b9");
}

TEST(Decide, SaysWhenFilesCannotBeWritten) {
  const test::TemporaryFolder folder;
  test::spit(folder.file("file"), "");
  RunControl control({});
  try {
    (void)decide(sccd_9_4, 11, {.proof_directory = folder.file("file")}, control);
    FAIL() << "a file is no directory";
  } catch (const MissingResource& fault) {
    EXPECT_THAT(fault.what(), HasSubstr(folder.file("file")));
  }
  EXPECT_THROW((void)decide(sccd_9_4, 11, {.proof_directory = folder.file("file/below")}, control),
               MissingResource);
}

TEST(Decide, SaysWhenTheDiskIsFull) {
  if (!test::has_full_device()) {
    GTEST_SKIP() << "no /dev/full";
  }
  for (const char* ending : {".cnf", ".drat"}) {
    const test::TemporaryFolder folder;
    fs::create_symlink("/dev/full", folder.file("linear-m1-v9-k4-b11" + std::string(ending)));
    RunControl control({});
    try {
      (void)decide(sccd_9_4, 11, {.proof_directory = folder.path().string()}, control);
      FAIL() << ending;
    } catch (const MissingResource& fault) {
      EXPECT_THAT(fault.what(), HasSubstr("No space left"));
      EXPECT_EQ(std::string(fault.what()).find('\n'), std::string::npos);
    }
    EXPECT_EQ(names_in(folder.path()).size(), 1U);  // the link
  }
}

// The limit of file sizes is a disk that gets full while the solver runs.
TEST(Decide, SaysWhenTheDiskGetsFullOnTheWay) {
  const test::TemporaryFolder folder;
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1 << 20, 1 << 20};
    setrlimit(RLIMIT_FSIZE, &limit);
    int code = 0;
    try {
      RunControl control({});
      (void)decide({.v = 11, .k = 5}, 8, {.proof_directory = folder.path().string()}, control);
    } catch (const MissingResource&) {
      code = 17;
    } catch (...) {
      code = 18;
    }
    _exit(code);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 17);
  EXPECT_TRUE(names_in(folder.path()).empty());
}

}  // namespace
}  // namespace changeover::exact_test
