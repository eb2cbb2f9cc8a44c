// Decides one formula, with a proof.
//
//     const SatResult result = solve_sat(cnf, {}, {.proof_path = "a.drat"}, control);
//     if (result.outcome == Outcome::found) { result.is_true(x); }
//     if (result.outcome == Outcome::none) { check_proof_files("a.cnf", "a.drat"); }
//
// Every call creates its own solver and adds the assumptions to the formula as unit clauses: the
// proofs of a solver that is used twice do not check. The proof is DRAT as text.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "changeover/proof/proof.hpp"
#include "changeover/run/control.hpp"
#include "search/sat/cnf.hpp"
#include "search/sat/sat_engine.hpp"

namespace changeover {

struct SatOptions {
  std::string proof_path = {};  ///< an existing file that the proof replaces; empty: no proof
  Progress progress = {};  ///< reported while solving; its steps are the kilobytes of the proof
  /// Limit for conflicts, which does not depend on the machine.
  std::optional<std::uint32_t> conflicts = {};
};

struct SatResult {
  Outcome outcome = Outcome::unknown;  ///< of the search for a model
  std::vector<bool> model;             ///< by variable, if found; index 0 is unused

  /// Whether the literal holds in the model; there must be one.
  [[nodiscard]] bool is_true(Literal x) const {
    return x > 0 ? model[static_cast<std::size_t>(x)] : !model[static_cast<std::size_t>(-x)];
  }
};

/// Decides a formula. Deterministic unless it is stopped. @throws MissingResource if the proof
/// cannot be written completely, or memory is too small; InternalError if the solver lacks an
/// option that proofs need; and what the control's callback throws. Time: that of the solver;
/// exponential in the worst case.
[[nodiscard]] SatResult solve_sat(const Cnf& cnf, std::span<const Literal> assumptions,
                                  const SatOptions& options, RunControl& control);

/// Splits a formula into at most 2^depth cubes that cover all cases. They are the leaves of a
/// binary tree whose inner nodes branch on one of the variables 1 … candidates: the one whose two
/// values fix most other variables by unit propagation (look-ahead
/// [HeuleKullmannWieringaBiere2011]). A branch ends early if every candidate is known or refuted.
/// Deterministic. @throws InternalError if there are fewer variables than candidates; Stopped as
/// stop_if_asked(). O(2^depth · candidates) propagations.
[[nodiscard]] std::vector<Cube> split_into_cubes(const Cnf& cnf, std::size_t candidates,
                                                 unsigned depth);

// A formula that grows, and a solver for it.
//
//     IncrementalSolver solver;
//     const Literal x = solver.cnf.new_variable(), y = solver.cnf.new_variable();
//     at_most_one(solver.cnf, {{x, y}});
//     solver.solve(control, 100'000);             // then add clauses and solve again
//
// That there is no model is the solver's statement: no proof is written here.

class IncrementalSolver {
 public:
  explicit IncrementalSolver(std::uint64_t seed = 0) {
    constexpr std::uint64_t seeds = 2'000'000'000;
    engine_.set("seed", static_cast<int>(seed % seeds));
    engine_.count_conflicts();
  }

  Cnf cnf;

  /// Like SatEngine::solve(), for all clauses so far.
  [[nodiscard]] Outcome solve(RunControl& control, std::optional<std::uint64_t> conflicts) {
    const auto progress = [this] {
      return Progress{.phase = "SAT solver", .steps = this->conflicts(), .unit = "conflicts"};
    };
    return engine_.add(cnf, control) ? engine_.solve(control, conflicts, {.progress = progress})
                                     : Outcome::unknown;
  }

  /// The same, once, where `assumed` must hold, too, and `preferred` literals are tried first.
  [[nodiscard]] Outcome solve_with(RunControl& control, std::span<const Literal> assumed,
                                   std::span<const Literal> preferred) {
    if (!engine_.add(cnf, control)) {
      return Outcome::unknown;
    }
    engine_.prefer(preferred);
    engine_.assume(assumed);
    return engine_.solve(control, std::nullopt, {.progress = [] { return Progress{}; }});
  }

  /// Whether the literal holds in the model of the last solve().
  [[nodiscard]] bool holds(Literal literal) const { return engine_.holds(literal); }

  [[nodiscard]] std::uint64_t conflicts() const { return engine_.conflicts(); }  ///< so far

 private:
  SatEngine engine_;
};

}  // namespace changeover
