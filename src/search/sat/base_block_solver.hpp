// A formula that grows, and a solver that keeps up with it; with the few constraints that base blocks
// and orderings need beyond search/sat/cardinality.hpp.
//
//     Formula formula;
//     const Literal x = formula.cnf.new_variable(), y = formula.cnf.new_variable();
//     at_most_one(formula.cnf, {{x, y}});
//     formula.solve(control, 100'000);            // then add clauses and solve again
//
// Answers of unsatisfiability are the solver's word: no proof is written here.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "changeover/run/control.hpp"
#include "search/sat/cnf.hpp"

namespace changeover {

/// At most one of the literals. Pairwise if they are few, else by a chain of new variables.
void at_most_one(Cnf& cnf, std::span<const Literal> literals);

/// a ≥ b as numbers in base 2, the first literal being the highest digit; of the same length.
void require_not_less(Cnf& cnf, std::span<const Literal> a, std::span<const Literal> b);

/// Clauses with an incremental CaDiCaL solver behind them.
class Formula {
 public:
  enum class Answer : std::uint8_t { satisfiable, unsatisfiable, unknown };

  explicit Formula(std::uint64_t seed = 0);
  ~Formula();
  Formula(const Formula&) = delete;
  Formula& operator=(const Formula&) = delete;

  Cnf cnf;

  /// Looks for a model of all clauses until the control wants to stop or `conflicts` more conflicts have
  /// been had. What the control's callback throws is thrown when the solver has ended.
  [[nodiscard]] Answer solve(RunControl& control, std::optional<std::uint64_t> conflicts);

  /// Whether the literal holds in the model of the last solve().
  [[nodiscard]] bool holds(Literal literal) const;

  [[nodiscard]] std::uint64_t conflicts() const;  ///< had so far

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
  std::size_t handed_over_ = 0;  // literals
};

}  // namespace changeover
