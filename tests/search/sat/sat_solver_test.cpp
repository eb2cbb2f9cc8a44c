#include "search/sat/sat_solver.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <string>

#include "changeover/core/error.hpp"
#include "changeover/proof/proof.hpp"
#include "changeover/run/control.hpp"
#include "message_of.hpp"
#include "run_program.hpp"
#include "search/exact/exact_encoding.hpp"

namespace changeover::sat_solver_test {
namespace {

// So many pigeons and one hole less.
Cnf pigeons(int count) {
  Cnf cnf;
  const auto in = [&](int pigeon, int hole) { return pigeon * (count - 1) + hole + 1; };
  for (int i = 0; i < count * (count - 1); ++i) {
    (void)cnf.new_variable();
  }
  for (int p = 0; p < count; ++p) {
    std::vector<Literal> somewhere;
    for (int h = 0; h + 1 < count; ++h) {
      somewhere.push_back(in(p, h));
      for (int q = 0; q < p; ++q) {
        cnf.add({-in(p, h), -in(q, h)});
      }
    }
    cnf.add(somewhere);
  }
  return cnf;
}

TEST(SatSolver, WritesAProofThatTheCheckerVerifies) {
  const test::TemporaryFolder folder;
  const Cnf cnf = pigeons(6);
  StringSink formula;
  write_dimacs(cnf, {}, {}, formula);
  test::spit(folder.file("a.cnf"), formula.text());
  RunControl control({});
  const SatResult result = solve_sat(cnf, {}, {.proof_path = folder.file("a.drat")}, control);
  EXPECT_EQ(result.outcome, Outcome::none);
  EXPECT_TRUE(check_proof_files(folder.file("a.cnf"), folder.file("a.drat")).verified());
}

TEST(SatSolver, GivesAModel) {
  Cnf cnf;
  const Literal a = cnf.new_variable();
  const Literal b = cnf.new_variable();
  (void)cnf.new_variable();  // in no clause
  cnf.add({a, b});
  cnf.add({-a, -b});
  RunControl control({});
  const SatResult result = solve_sat(cnf, std::vector<Literal>{-a}, {}, control);
  ASSERT_EQ(result.outcome, Outcome::found);
  EXPECT_FALSE(result.is_true(a));
  EXPECT_TRUE(result.is_true(-a));
  EXPECT_TRUE(result.is_true(b));
}

TEST(SatSolver, SolvesALargeFormulaToo) {
  Cnf cnf;
  for (int i = 0; i < 2000; ++i) {
    (void)cnf.new_variable();
  }
  for (Literal i = 0; i < 400'000; ++i) {
    cnf.add({i % 1999 + 1, i % 1999 + 2, -1});
  }
  const test::TemporaryFolder folder;
  for (const std::string& proof : {std::string(), folder.file("a.drat")}) {
    RunControl control({});
    EXPECT_EQ(solve_sat(cnf, {}, {.proof_path = proof}, control).outcome, Outcome::found);
  }
}

TEST(SatSolver, StopsWithItsControl) {
  RunControl control({.time = std::chrono::milliseconds(50)});
  EXPECT_EQ(solve_sat(pigeons(13), {}, {}, control).outcome, Outcome::unknown);
  EXPECT_EQ(control.why_stopped(), WhyStopped::time_limit);
}

TEST(SatSolver, SaysWhenTheProofCannotBeWritten) {
  RunControl control({});
  EXPECT_REFUSAL((void)solve_sat(pigeons(4), {}, {.proof_path = "/nowhere/a.drat"}, control),
                 MissingResource, "; free some space or name another directory");
  if (test::has_full_device()) {
    EXPECT_REFUSAL((void)solve_sat(pigeons(8), {}, {.proof_path = "/dev/full"}, control),
                   MissingResource, "; free some space or name another directory");
  }
}

TEST(SplitIntoCubes, LeavesNothingOutAndBalances) {
  const DesignFormula formula = encode_design({.v = 9, .k = 4, .change = 1}, 11);
  for (unsigned depth = 0; depth <= 5; ++depth) {
    const std::vector<Cube> cubes = split_into_cubes(formula.cnf(), 99, depth);
    EXPECT_TRUE(cubes_cover_everything(cubes));
    EXPECT_LE(cubes.size(), std::size_t{1} << depth);
    EXPECT_GT(2 * cubes.size(), std::size_t{1} << depth);
    EXPECT_EQ(cubes, split_into_cubes(formula.cnf(), 99, depth));
    for (const Cube& cube : cubes) {
      for (const Literal x : cube) {
        EXPECT_LE(x < 0 ? -x : x, 99);
      }
    }
  }
}

// The terminator is called by the solver, which is no place for an exception to pass through.
TEST(SatSolver, ThrowsOnWhatACallbackThrowsOnlyAfterwards) {
  RunControl control(
      {.on_progress = [](const Progress&) { throw std::runtime_error("a callback"); },
       .progress_interval = std::chrono::milliseconds(1)});
  EXPECT_THROW((void)solve_sat(pigeons(11), {}, {}, control), std::runtime_error);
}

TEST(SatSolver, SaysWhyTheProofCannotBeWritten) {
  RunControl control({});
  try {
    (void)solve_sat(pigeons(9), {}, {.proof_path = "/dev/full"}, control);
    FAIL() << "a full disk";
  } catch (const MissingResource& fault) {
    EXPECT_NE(std::string(fault.what()).find("No space left"), std::string::npos) << fault.what();
  }
}

TEST(SplitIntoCubes, StopsWithTheScope) {
  const DesignFormula formula = encode_design({.v = 30, .k = 5}, 70);
  RunControl control({.time = std::chrono::milliseconds(20)});
  const RunScope scope(control);
  const auto begin = RunControl::Clock::now();
  EXPECT_THROW((void)split_into_cubes(formula.cnf(), 30 * 70, 12), Stopped);
  EXPECT_LT(RunControl::Clock::now() - begin, std::chrono::seconds(10));
}

TEST(SplitIntoCubes, DoesNotSplitWhatIsRefutedOrHasNothingToSplitOn) {
  Cnf refuted;
  const Literal a = refuted.new_variable();
  refuted.add({a});
  refuted.add({-a});
  EXPECT_EQ(split_into_cubes(refuted, 1, 3), std::vector<Cube>{{}});
  Cnf decided;
  decided.add({decided.new_variable()});
  EXPECT_EQ(split_into_cubes(decided, 1, 3), std::vector<Cube>{{}});
  EXPECT_EQ(split_into_cubes(Cnf(), 0, 3), std::vector<Cube>{{}});
  EXPECT_THROW((void)split_into_cubes(Cnf(), 1, 3), InternalError);
}

}  // namespace
}  // namespace changeover::sat_solver_test
