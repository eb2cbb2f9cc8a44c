// A formula that grows, and a solver for it.
//
//     IncrementalSolver solver;
//     const Literal x = solver.cnf.new_variable(), y = solver.cnf.new_variable();
//     at_most_one(solver.cnf, {{x, y}});
//     solver.solve(control, 100'000);             // then add clauses and solve again
//
// That there is no model is the solver's statement: no proof is written here.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "search/sat/sat_engine.hpp"

namespace changeover {

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
